// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/recovery/recovery.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "solver/parts/row_hints.hpp"
#include "solver/recovery/full_cell_fit.hpp"
#include "solver/terms/solution_structure.hpp"
#include "solver/terms/stress.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

/// Weights of the squared misfit of a quadratic (or linear) displacement's stresses, 1 at the Gauss points of full cells, where
/// they are a whole order better than elsewhere: in cut cells, small enough not to spoil the fit beside them; between the Gauss
/// points, only to keep it unique in a single cell. (E3, E4: 1 for both doubles the errors of boundary stresses.) With higher
/// degrees all points are alike.
constexpr double weight_in_cut_cells = 0.01, weight_between = 0.001;

bool gauss_points_are_better(const SplineSpace& s) {
    return std::max(s.x.degree, s.y.degree) <= 2;
}

struct Samples {
    std::vector<Vec2> points;
    std::vector<double> weights;
};

struct Entry {
    int column, row;  // row >= column
    double value;
};

struct NormalEquations {
    std::vector<Entry> entries;
    Eigen::MatrixX3d rhs;
    Eigen::VectorXd rhs_zz;  // empty: zz follows from the others
    bool has_matrix = true;  // false: its factor is known
};

/// Values of an element's functions at points (points x functions).
Eigen::MatrixXd values_at(const SplineSpace& space, int element, const Extraction& extraction,
                          const std::vector<Vec2>& points) {
    Sampled sampled;
    sample(space, element, points, sampled);
    return extraction.identity ? std::move(sampled.value) : sampled.value * extraction.matrix;
}

/// Adds an element's matrix and right-hand side, of these functions.
void scatter(const std::vector<int>& functions, const Eigen::MatrixXd& matrix, const Eigen::MatrixX3d& rhs,
             NormalEquations& eq) {
    const auto n = static_cast<Index>(functions.size());
    for (Index j = 0; j < n; ++j) {
        const int column = functions[static_cast<std::size_t>(j)];
        eq.rhs.row(column) += rhs.row(j);
        for (Index i = 0; i < n && eq.has_matrix; ++i)
            if (const int row = functions[static_cast<std::size_t>(i)]; row >= column)
                eq.entries.push_back({column, row, matrix(i, j)});
    }
}

/// Adds one element's samples: dense within it, then its lower triangle.
void add_element(NormalEquations& eq, const SplineSpace& space, const StressOf& stress, int element, const Samples& samples) {
    const Extraction e = extraction(space, element);
    const std::vector<int>& functions = e.functions;
    const Eigen::MatrixXd b = values_at(space, element, e, samples.points);
    Eigen::MatrixX3d s(b.rows(), 3);
    const StressOf::OnElement stress_here(stress, element);
    for (std::size_t k = 0; k < samples.points.size(); ++k)
        s.row(static_cast<Index>(k)) = stress_here(samples.points[k]).transpose();
    const auto weight = Eigen::Map<const Eigen::VectorXd>(samples.weights.data(), b.rows()).asDiagonal();
    const Eigen::MatrixXd weighted = weight * b, m = eq.has_matrix ? b.transpose() * weighted : Eigen::MatrixXd();
    const Eigen::MatrixX3d r = weighted.transpose() * s;
    if (eq.rhs_zz.size() > 0) {
        Eigen::VectorXd zz(b.rows());
        for (Index k = 0; k < zz.size(); ++k) zz[k] = stress.zz(element, samples.points[static_cast<std::size_t>(k)]);
        eq.rhs_zz(functions) += weighted.transpose() * zz;
    }
    scatter(functions, m, r, eq);
}

/// The entries in the order of their columns, those of one column in the order in which they are given.
std::vector<Entry> sorted_by_column(const std::vector<Entry>& entries, int n) {
    std::vector<std::size_t> next(static_cast<std::size_t>(n) + 1, 0);
    for (const Entry& e : entries) ++next[static_cast<std::size_t>(e.column) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Entry> sorted(entries.size());
    for (const Entry& e : entries) sorted[next[static_cast<std::size_t>(e.column)]++] = e;
    return sorted;
}

SparseSymmetric assembled(const std::vector<Entry>& entries, int n) {
    const std::vector<Entry> sorted = sorted_by_column(entries, n);
    SparseSymmetric m;
    m.n = n;
    m.first.assign(1, 0);
    std::vector<double> sum(static_cast<std::size_t>(n));
    std::vector<int> last_column(static_cast<std::size_t>(n), -1);
    auto e = sorted.begin();
    for (int column = 0; column < n; ++column) {
        const std::size_t begin = m.row.size();
        for (; e != sorted.end() && e->column == column; ++e) {
            const auto row = static_cast<std::size_t>(e->row);
            if (std::exchange(last_column[row], column) != column) {
                sum[row] = 0;
                m.row.push_back(e->row);
            }
            sum[row] += e->value;
        }
        std::sort(m.row.begin() + static_cast<std::ptrdiff_t>(begin), m.row.end());
        for (std::size_t k = begin; k < m.row.size(); ++k) m.value.push_back(sum[static_cast<std::size_t>(m.row[k])]);
        m.first.push_back(static_cast<int>(m.row.size()));
    }
    return m;
}

void add(Samples& samples, const Vec2& x, double weight) {
    samples.points.push_back(x);
    samples.weights.push_back(weight);
}

/// The Gauss points and the corners; of low degrees the middles of the sides and the centre, too.
FullCellRule full_cell_rule(const SplineSpace& s, const std::vector<double>& inside) {
    if (gauss_points_are_better(s)) return {inside, {0, 0.5, 1}, weight_between};
    return {inside, {0, 1}, 1};
}

Samples full_cell_samples(const SplineSpace& s, int element, const FullCellRule& rule) {
    const Vec2 a = s.low_corner(element), size = s.cell_size(element);
    Samples samples;
    const auto add_all = [&](const std::vector<double>& abscissas, double weight) {
        for (double v : abscissas)
            for (double u : abscissas) add(samples, a + size.cwiseProduct(Vec2(u, v)), weight);
    };
    add_all(rule.inside, 1);
    add_all(rule.between, rule.between_weight);
    return samples;
}

/// All samples: of full cells by products where their functions are B-splines, else one by one.
void add_all_elements(NormalEquations& eq, const PartInput& input, const SplineSpace& space, const StressOf& stress,
                      const FullCellRule& rule, const std::vector<Samples>& cut) {
    const FullCellFit full(input.space, space, rule);
    const bool by_products = !input.structure && eq.rhs_zz.size() == 0;
    FullCellEquations cell;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        const int element = static_cast<int>(i);
        const bool is_full = input.space.fraction[i] == 1;
        if (is_full && by_products && cut[i].points.empty()) {
            if (const Extraction e = extraction(space, element); e.identity) {
                full.equations({stress, element}, element, cell);
                scatter(e.functions, cell.matrix, cell.rhs, eq);
                continue;
            }
        }
        Samples samples = is_full ? full_cell_samples(input.space, element, rule) : Samples{};
        for (std::size_t k = 0; k < cut[i].points.size(); ++k) add(samples, cut[i].points[k], cut[i].weights[k]);
        if (!samples.points.empty()) add_element(eq, space, stress, element, samples);
    }
}

/// Quadrature points as samples, their weights relative to the cell's area: they make the fit one in the mean square over the
/// part, which leaves no function open however little of the part it holds.
void add_rules(NormalEquations& eq, const PartInput& input, const SplineSpace& space, const StressOf& stress) {
    const std::vector<CellRule>& rules = input.structure ? input.structure->rules : input.cut_rules;
    for (const CellRule& rule : rules) {
        const double area = space.cell_size(rule.element).prod();
        Samples samples{rule.points, rule.weights};
        for (double& w : samples.weights) w /= area;
        add_element(eq, space, stress, rule.element, samples);
    }
}

/// One less than the displacement's, as its stresses have. But where they are a whole order better at the Gauss points, a
/// spline of one degree less would lose that again.
int stress_degree(int degree, bool gauss_points_are_better) {
    return gauss_points_are_better ? degree : std::max(1, degree - 1);
}

/// What is sampled of a displacement's stresses, and the equations of splines that fit them.
class StressFit {
public:
    StressFit(const PartInput& input, const Eigen::VectorXd& displacement, const std::vector<double>& inside,
              const std::vector<SamplePoint>& cut)
        : input_(input),
          stress_(input, displacement),
          full_(full_cell_rule(input.space, inside)),
          cut_(input.space.fraction.size()) {
        const double weight = gauss_points_are_better(input.space) ? weight_in_cut_cells : 1;
        for (const SamplePoint& p : cut) add(cut_[static_cast<std::size_t>(p.element)], p.x, weight);
    }

    /// Keeps the equations that it makes.
    StressFitFactor factorised() {
        StressFitFactor made{std::make_shared<const SplineSpace>(stress_space(input_.space)), {}};
        const SplineSpace& space = *made.space;
        if (!space.failure.empty()) return made;
        equations_ = equations(space, true);
        made.factor = factor_of(space);
        made.has_rules = !made.factor.ok();
        if (!made.has_rules) return made;  // but for parts of few cells, all cut, with hardly a sample in some
        add_rules(*equations_, input_, space, stress_);
        made.factor = factor_of(space);
        return made;
    }

    void solve(const StressFitFactor& made, StressField& field) {
        if (!equations_) {
            equations_ = equations(*made.space, false);
            if (made.has_rules) add_rules(*equations_, input_, *made.space, stress_);
        }
        field.coefficients.resize(made.space->n_functions, 3);
        for (Index k = 0; k < 3; ++k) field.coefficients.col(k) = made.factor.solve(equations_->rhs.col(k));
        if (equations_->rhs_zz.size() > 0) field.zz = made.factor.solve(equations_->rhs_zz);
    }

private:
    static SplineSpace stress_space(const SplineSpace& from) {
        const bool low = gauss_points_are_better(from);
        return make_space({clamped_knots(from.x.breakpoints, stress_degree(from.x.degree, low)),
                           clamped_knots(from.y.breakpoints, stress_degree(from.y.degree, low)),
                           from.fraction,
                           from.splits,
                           Basis::web,
                           {},
                           from.tree});
    }
    NormalEquations equations(const SplineSpace& space, bool has_matrix) const {
        NormalEquations eq{{}, Eigen::MatrixX3d::Zero(space.n_functions, 3), {}, has_matrix};
        if (has_own_zz(input_)) eq.rhs_zz = Eigen::VectorXd::Zero(space.n_functions);
        add_all_elements(eq, input_, space, stress_, full_, cut_);
        return eq;
    }
    Factorization factor_of(const SplineSpace& space) const {
        return Factorization(assembled(equations_->entries, space.n_functions), row_hints(space), input_.threads);
    }

    const PartInput& input_;
    StressOf stress_;
    FullCellRule full_;
    std::vector<Samples> cut_;  // by element
    std::optional<NormalEquations> equations_;
};

}  // namespace

StressField fit_stress(const PartInput& input, const Eigen::VectorXd& displacement, const std::vector<double>& inside,
                       const std::vector<SamplePoint>& cut, const Once<StressFitFactor>* common) {
    StressFit fit(input, displacement, inside, cut);
    const Once<StressFitFactor> own;
    const StressFitFactor& made = (common ? *common : own)([&] { return fit.factorised(); });
    StressField field{made.space, {}, input.elasticity.out_of_plane, {}, made.space->failure};
    if (field.failure.empty() && !made.factor.ok()) field.failure = "the stress fit is singular";
    if (field.failure.empty()) fit.solve(made, field);
    return field;
}

Eigen::Vector4d stress_at(const StressField& field, int element, const Vec2& x) {
    if (!field.failure.empty()) return Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN());
    return stress_at(field, local_stress(field, element), element, x);
}

Eigen::Vector4d stress_at(const StressField& field, const LocalSpline<3>& in_plane, int element, const Vec2& x) {
    const Eigen::Vector3d s = in_plane.value(x);
    if (field.zz.size() == 0) return {s[0], s[1], s[2], field.out_of_plane * (s[0] + s[1])};
    const LocalSpline<1> zz(*field.space, element, [&](int function) { return field.zz.segment<1>(function); });
    return {s[0], s[1], s[2], zz.value(x)[0]};
}

}  // namespace abut::solver
