// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/solution_structure.hpp"

#include <algorithm>
#include <utility>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The factors of an element's functions.
VectorXd factors_of(const VectorXd& scale, const std::vector<int>& functions) {
    VectorXd factors(static_cast<Index>(functions.size()));
    for (Index i = 0; i < factors.size(); ++i) factors[i] = scale[functions[static_cast<std::size_t>(i)]];
    return factors;
}

/// w N with its gradient, from N (product rule).
PointBasis weighted(const PointBasis& b, const SolutionStructure& s, std::size_t component, const Vec2& p) {
    if (!s.weight[component]) return b;
    const ScalarAt w = s.weight[component](p);
    PointBasis of{b.functions, w.value * b.value, w.value * b.dx + w.gradient.x() * b.value,
                  w.value * b.dy + w.gradient.y() * b.value};
    if (s.scale[component].size() == 0) return of;
    const VectorXd factors = factors_of(s.scale[component], b.functions);
    for (VectorXd* v : {&of.value, &of.dx, &of.dy}) *v = v->cwiseProduct(factors);
    return of;
}

DisplacementAt data_at(const SolutionStructure& s, const Vec2& p) {
    DisplacementAt d;
    for (int c = 0; c < 2; ++c) {
        if (!s.data[static_cast<std::size_t>(c)]) continue;
        const ScalarAt phi = s.data[static_cast<std::size_t>(c)](p);
        d.value[c] = phi.value;
        d.gradient.row(c) = phi.gradient;
    }
    return d;
}

/// Functions at all points of one element's rule: values and derivatives by component (points x functions).
struct ElementBasis {
    std::vector<int> functions;
    Sampled plain;
    std::array<Sampled, 2> of;
};

Sampled extracted(const Sampled& local, const Extraction& e) {
    if (e.identity) return local;
    return {local.value * e.matrix, local.dx * e.matrix, local.dy * e.matrix};
}

Sampled weighted(const Sampled& n, const ScalarField& weight, const std::vector<Vec2>& points) {
    if (!weight) return n;
    VectorXd w(n.value.rows()), wx(w.size()), wy(w.size());
    for (Index k = 0; k < w.size(); ++k) {
        const ScalarAt at = weight(points[static_cast<std::size_t>(k)]);
        w[k] = at.value;
        wx[k] = at.gradient.x();
        wy[k] = at.gradient.y();
    }
    return {w.asDiagonal() * n.value, w.asDiagonal() * n.dx + wx.asDiagonal() * n.value,
            w.asDiagonal() * n.dy + wy.asDiagonal() * n.value};
}

ElementBasis element_basis(const PartInput& input, const CellRule& rule) {
    const Extraction e = extraction(input.space, rule.element);
    Sampled local;
    sample(input.space, rule.element, rule.points, local);
    ElementBasis b{e.functions, extracted(local, e), {}};
    for (std::size_t c = 0; c < 2; ++c) {
        b.of[c] = weighted(b.plain, input.structure->weight[c], rule.points);
        const VectorXd& scale = input.structure->scale[c];
        if (scale.size() == 0) continue;
        const VectorXd factors = factors_of(scale, b.functions);
        for (MatrixXd* m : {&b.of[c].value, &b.of[c].dx, &b.of[c].dy}) *m = *m * factors.asDiagonal();
    }
    return b;
}

/// B' D B of an element, block (i, j) at j * n + i.
void stiffness_of(const ElementBasis& b, const VectorXd& w, const Elasticity& d, std::vector<Eigen::Matrix2d>& blocks) {
    const Sampled &x = b.of[0], &y = b.of[1];
    const MatrixXd wxx = w.asDiagonal() * x.dx, wxy = w.asDiagonal() * x.dy;
    const MatrixXd wyx = w.asDiagonal() * y.dx, wyy = w.asDiagonal() * y.dy;
    const MatrixXd kxx = d.d11 * (x.dx.transpose() * wxx) + d.d33 * (x.dy.transpose() * wxy);
    const MatrixXd kxy = d.d12 * (x.dx.transpose() * wyy) + d.d33 * (x.dy.transpose() * wyx);
    const MatrixXd kyy = d.d11 * (y.dy.transpose() * wyy) + d.d33 * (y.dx.transpose() * wyx);
    const Index n = kxx.rows();
    blocks.resize(static_cast<std::size_t>(n * n));
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) blocks[static_cast<std::size_t>(j * n + i)] << kxx(i, j), kxy(i, j), kxy(j, i), kyy(i, j);
}

/// Adds the work of stresses (points x (xx, yy, xy), times the points' weights) on the strains of functions.
void add_work(VectorXd& to, const std::vector<int>& functions, const Sampled& x, const Sampled& y,
              const Eigen::MatrixX3d& stress) {
    const VectorXd fx = x.dx.transpose() * stress.col(0) + x.dy.transpose() * stress.col(2);
    const VectorXd fy = y.dy.transpose() * stress.col(1) + y.dx.transpose() * stress.col(2);
    for (std::size_t i = 0; i < functions.size(); ++i)
        to.segment<2>(2 * functions[i]) += Vec2(fx[static_cast<Index>(i)], fy[static_cast<Index>(i)]);
}

/// The displacement at every point of an element.
std::vector<DisplacementAt> displacements(const PartInput& input, const CellRule& rule, const ElementBasis& b,
                                          const VectorXd& u) {
    const auto n = static_cast<Index>(b.functions.size());
    Eigen::MatrixX2d c(n, 2);
    for (Index i = 0; i < n; ++i) c.row(i) = u.segment<2>(2 * b.functions[static_cast<std::size_t>(i)]);
    std::vector<DisplacementAt> d;
    for (const Vec2& p : rule.points) {
        const auto k = static_cast<Index>(d.size());
        d.push_back(data_at(*input.structure, p));
        for (int a = 0; a < 2; ++a) {
            const Sampled& s = b.of[static_cast<std::size_t>(a)];
            d.back().value[a] += s.value.row(k).dot(c.col(a));
            d.back().gradient(a, 0) += s.dx.row(k).dot(c.col(a));
            d.back().gradient(a, 1) += s.dy.row(k).dot(c.col(a));
        }
    }
    return d;
}

/// Stresses of gradients, times the points' weights.
Eigen::MatrixX3d weighted_stress(const PartInput& input, const CellRule& rule, const std::vector<DisplacementAt>& d) {
    Eigen::MatrixX3d s(static_cast<Index>(d.size()), 3);
    for (std::size_t k = 0; k < d.size(); ++k)
        s.row(static_cast<Index>(k)) =
            input.thickness * rule.weights[k] * stress_of(input.elasticity, d[k].gradient).transpose();
    return s;
}

bool has_data(const SolutionStructure& s) {
    return s.data[0] || s.data[1];
}

/// Adds minus the work of the stresses of phi.
void add_data_load(const PartInput& input, const CellRule& rule, const ElementBasis& b, VectorXd& load) {
    std::vector<DisplacementAt> phi;
    for (const Vec2& p : rule.points) phi.push_back(data_at(*input.structure, p));
    add_work(load, b.functions, b.of[0], b.of[1], -weighted_stress(input, rule, phi));
}

}  // namespace

DisplacementBasis displacement_basis(const PartInput& input, int element, const Vec2& p) {
    DisplacementBasis b;
    b.x = evaluate(input.space, element, p);
    if (!input.structure) return b;
    b.y = weighted(b.x, *input.structure, 1, p);
    b.x = weighted(b.x, *input.structure, 0, p);
    b.data = data_at(*input.structure, p);
    return b;
}

DisplacementAt displacement_at(const PartInput& input, const VectorXd& displacement, int element, const Vec2& x) {
    if (!input.structure) return displacement_at(input.space, displacement, element, x);
    const DisplacementBasis basis = displacement_basis(input, element, x);
    DisplacementAt d = basis.data;
    for (int c = 0; c < 2; ++c) {
        const PointBasis& b = basis.of(c);
        for (std::size_t i = 0; i < b.functions.size(); ++i) {
            const double u = displacement[2 * b.functions[i] + c];
            const auto k = static_cast<Index>(i);
            d.value[c] += b.value[k] * u;
            d.gradient(c, 0) += b.dx[k] * u;
            d.gradient(c, 1) += b.dy[k] * u;
        }
    }
    return d;
}

WeightedStiffness assemble_weighted(const PartInput& input) {
    FunctionSets sets;
    for (const CellRule& rule : input.structure->rules) sets.add(extraction(input.space, rule.element).functions);
    const int n = input.space.n_functions;
    WeightedStiffness result{make_block_matrix(n, sets), VectorXd::Zero(2 * n)};
    BlockScatter scatter(result.stiffness);
    std::vector<Eigen::Matrix2d> blocks;
    for (const CellRule& rule : input.structure->rules) {
        const ElementBasis b = element_basis(input, rule);
        const Eigen::Map<const VectorXd> w(rule.weights.data(), static_cast<Index>(rule.weights.size()));
        stiffness_of(b, input.thickness * w, input.elasticity, blocks);
        scatter.add(b.functions, blocks);
        if (has_data(*input.structure)) add_data_load(input, rule, b, result.load);
    }
    return result;
}

VectorXd weighted_body_load(const PartInput& input, const std::function<Vec2(const Vec2&)>& force) {
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    for (const CellRule& rule : input.structure->rules) {
        const ElementBasis b = element_basis(input, rule);
        Eigen::MatrixX2d f(static_cast<Index>(rule.points.size()), 2);
        for (std::size_t k = 0; k < rule.points.size(); ++k)
            f.row(static_cast<Index>(k)) = input.thickness * rule.weights[k] * force(rule.points[k]).transpose();
        const VectorXd x = b.of[0].value.transpose() * f.col(0), y = b.of[1].value.transpose() * f.col(1);
        for (std::size_t i = 0; i < b.functions.size(); ++i)
            load.segment<2>(2 * b.functions[i]) += Vec2(x[static_cast<Index>(i)], y[static_cast<Index>(i)]);
    }
    return load;
}

VectorXd weighted_boundary_load(const PartInput& input, const std::vector<TractionPoint>& points) {
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    for (const TractionPoint& p : points) {
        const DisplacementBasis basis = displacement_basis(input, p.element, p.x);
        for (int c = 0; c < 2; ++c) {
            const PointBasis& b = basis.of(c);
            for (std::size_t i = 0; i < b.functions.size(); ++i)
                load[2 * b.functions[i] + c] += input.thickness * p.weight * p.traction[c] * b.value[static_cast<Index>(i)];
        }
    }
    return load;
}

VectorXd internal_forces(const PartInput& input, const VectorXd& displacement) {
    VectorXd force = VectorXd::Zero(2 * input.space.n_functions);
    for (const CellRule& rule : input.structure->rules) {
        const ElementBasis b = element_basis(input, rule);
        const Eigen::MatrixX3d stress = weighted_stress(input, rule, displacements(input, rule, b, displacement));
        add_work(force, b.functions, b.plain, b.plain, stress);
    }
    return force;
}

double weighted_strain_energy(const PartInput& input, const VectorXd& displacement) {
    double twice = 0;
    for (const CellRule& rule : input.structure->rules) {
        const std::vector<DisplacementAt> d = displacements(input, rule, element_basis(input, rule), displacement);
        const Eigen::MatrixX3d stress = weighted_stress(input, rule, d);
        for (std::size_t k = 0; k < d.size(); ++k) {
            const Eigen::Matrix2d& g = d[k].gradient;
            twice += stress.row(static_cast<Index>(k)).dot(Eigen::RowVector3d(g(0, 0), g(1, 1), g(0, 1) + g(1, 0)));
        }
    }
    return 0.5 * twice;
}

double largest_weighted_displacement(const PartInput& input, const VectorXd& displacement) {
    double largest = 0;
    for (const CellRule& rule : input.structure->rules)
        for (const DisplacementAt& d : displacements(input, rule, element_basis(input, rule), displacement))
            largest = std::max(largest, d.value.norm());
    return largest;
}

}  // namespace abut::solver
