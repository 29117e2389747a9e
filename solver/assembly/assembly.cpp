// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/assembly/assembly.hpp"

#include <algorithm>
#include <utility>

#include "solver/assembly/ring.hpp"
#include "solver/assembly/ring_stiffness.hpp"
#include "solver/linear_algebra/parallel_for.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

Eigen::Map<const VectorXd> as_vector(const std::vector<double>& v) {
    return {v.data(), static_cast<Index>(v.size())};
}

/// Calls f(cell) for every cell that is wholly inside.
template <class F>
void for_full_cells(const SplineSpace& s, F f) {
    for (int cell = 0; cell < s.n_cells(); ++cell)
        if (is_full(s, cell)) f(cell);
}

CellRule tensor_rule(const SplineSpace& s, int cell, const LineRule& rule) {
    const IntervalKnots x = s.along_x(cell), y = s.along_y(cell);
    const double x0 = x.low(), hx = x.high() - x0, y0 = y.low(), hy = y.high() - y0;
    CellRule result{cell, {}, {}};
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            result.points.emplace_back(x0 + rule.points[i] * hx, y0 + rule.points[j] * hy);
            result.weights.push_back(rule.weights[i] * rule.weights[j] * hx * hy);
        }
    return result;
}

/// Around an axis weights carry the radius.
CellRule ring_rule(const PartInput& input, int cell) {
    CellRule rule = tensor_rule(input.space, cell, input.line_rule);
    for (std::size_t k = 0; k < rule.points.size(); ++k) rule.weights[k] *= radius(input, rule.points[k]);
    return rule;
}

/// The elements of a part that hold material: full cells first, then those of the cut rules.
struct Elements {
    std::vector<int> element;
    std::vector<char> own;  ///< whose functions are the B-splines themselves
    FunctionSets functions;
};

Elements elements_of(const PartInput& input) {
    Elements e;
    const auto add = [&](int element) {
        const Extraction x = extraction(input.space, element);
        e.element.push_back(element);
        e.own.push_back(x.identity);
        e.functions.add(x.functions);
    };
    for_full_cells(input.space, add);
    for (const CellRule& rule : input.cut_rules) add(rule.element);
    return e;
}

/// The assembly under way, with room for one element.
struct Stiffness {
    const PartInput& input;
    Elasticity elasticity;
    const Elements& elements;
    BlockScatter scatter;
    CellIntegrals integrals;
    std::vector<Eigen::Matrix2d> blocks;

    /// The blocks of element k from its integrals over the B-splines, which are used up.
    void make_blocks(std::size_t k) {
        if (!elements.own[k]) extract(extraction(input.space, elements.element[k]), integrals);
        stiffness_blocks(integrals, elasticity, input.thickness, blocks);
    }
    void add_blocks(std::size_t k) { scatter.add(elements.functions[k], blocks); }
    bool needs(std::size_t k) const { return scatter.reaches(elements.functions[k]); }
};

void add_full_cells(Stiffness& s) {
    const SplineSpace& space = s.input.space;
    const IntervalIntegrals x = interval_integrals(space, 0, s.input.line_rule);
    const IntervalIntegrals y = interval_integrals(space, 1, s.input.line_rule);
    std::pair<int, int> last(-1, -1);  // the intervals whose blocks are at hand
    for (std::size_t k = 0; k + s.input.cut_rules.size() < s.elements.element.size(); ++k) {
        if (!s.needs(k)) continue;
        const int cell = s.elements.element[k];
        const std::pair sides(x.of_interval[static_cast<std::size_t>(space.column_of(cell))],
                              y.of_interval[static_cast<std::size_t>(space.row_of(cell))]);
        if (!s.elements.own[k] || sides != last) {
            integrate_full_cell(x.integrals[static_cast<std::size_t>(sides.first)],
                                y.integrals[static_cast<std::size_t>(sides.second)], s.integrals);
            s.make_blocks(k);
            last = s.elements.own[k] ? sides : std::pair(-1, -1);
        }
        s.add_blocks(k);
    }
}

void add_cut_cells(Stiffness& s) {
    std::size_t k = s.elements.element.size() - s.input.cut_rules.size();
    for (const CellRule& rule : s.input.cut_rules) {
        if (s.needs(k)) {
            integrate_cut_cell(s.input.space, rule.element, rule.points, rule.weights, s.integrals);
            s.make_blocks(k);
            s.add_blocks(k);
        }
        ++k;
    }
}

/// Functions that are worth a thread.
constexpr int least_functions = 1000;

/// Ranges of functions with about as many blocks each: shares + 1 offsets.
std::vector<int> shared_rows(const BlockMatrix& k, int threads) {
    const int shares = std::max(1, std::min(threads, k.n / least_functions));
    std::vector<int> first;
    for (int i = 0; i < shares; ++i) {
        const int blocks = static_cast<int>(static_cast<double>(k.first.back()) * i / shares);
        first.push_back(static_cast<int>(std::lower_bound(k.first.begin(), k.first.end(), blocks) - k.first.begin()));
    }
    first.push_back(k.n);
    return first;
}

void add_at(VectorXd& to, const Extraction& e, const VectorXd& local) {
    const VectorXd v = e.identity ? local : VectorXd(e.matrix.transpose() * local);
    for (std::size_t i = 0; i < e.functions.size(); ++i) to[e.functions[i]] += v[static_cast<Index>(i)];
}

}  // namespace

void for_all_cells(const PartInput& input, const std::function<void(const CellRule&)>& f) {
    for_full_cells(input.space,
                   [&](int cell) { f(input.axis ? ring_rule(input, cell) : tensor_rule(input.space, cell, input.line_rule)); });
    for (const CellRule& rule : input.cut_rules) f(rule);
}

BlockMatrix assemble_stiffness(const PartInput& input) {
    if (input.axis) return assemble_ring_stiffness(input);
    const Elements elements = elements_of(input);
    BlockMatrix k = make_block_matrix(input.space.n_functions, elements.functions);
    // every row takes in its elements in their order, whoever adds them
    const std::vector<int> first = shared_rows(k, input.threads);
    parallel_for(static_cast<int>(first.size()) - 1, input.threads, [&](int share) {
        const auto i = static_cast<std::size_t>(share);
        Stiffness stiffness{input, local_elasticity(input), elements, BlockScatter(k, first[i], first[i + 1]), {}, {}};
        add_full_cells(stiffness);
        add_cut_cells(stiffness);
    });
    return k;
}

void add_to_component(VectorXd& load, int component, const Extraction& e, const VectorXd& local) {
    const VectorXd v = e.identity ? local : VectorXd(e.matrix.transpose() * local);
    for (std::size_t i = 0; i < e.functions.size(); ++i) load[2 * e.functions[i] + component] += v[static_cast<Index>(i)];
}

FunctionIntegrals integrate_functions(const PartInput& input) {
    const SplineSpace& s = input.space;
    FunctionIntegrals f{VectorXd::Zero(s.n_functions), VectorXd::Zero(s.n_functions), VectorXd::Zero(s.n_functions)};
    Sampled at;
    for_all_cells(input, [&](const CellRule& rule) {
        sample(s, rule.element, rule.points, at);
        const Extraction e = extraction(s, rule.element);
        const auto w = as_vector(rule.weights);
        add_at(f.value, e, at.value.transpose() * w);
        add_at(f.dx, e, at.dx.transpose() * w);
        add_at(f.dy, e, at.dy.transpose() * w);
    });
    return f;
}

VectorXd body_load(const PartInput& input, const std::function<Vec2(const Vec2&)>& force) {
    const SplineSpace& s = input.space;
    VectorXd fx = VectorXd::Zero(s.n_functions), fy = fx;
    Sampled at;
    for_all_cells(input, [&](const CellRule& rule) {
        sample(s, rule.element, rule.points, at);
        const Extraction e = extraction(s, rule.element);
        VectorXd wx(static_cast<Index>(rule.points.size())), wy = wx;
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Vec2 b = input.thickness * rule.weights[k] * force(rule.points[k]);
            wx[static_cast<Index>(k)] = b.x();
            wy[static_cast<Index>(k)] = b.y();
        }
        add_at(fx, e, at.value.transpose() * wx);
        add_at(fy, e, at.value.transpose() * wy);
    });
    VectorXd load(2 * s.n_functions);
    for (Index i = 0; i < s.n_functions; ++i) load.segment<2>(2 * i) = Vec2(fx[i], fy[i]);
    return load;
}

VectorXd boundary_load(const PartInput& input, const std::vector<TractionPoint>& points) {
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    for (const TractionPoint& p : points) {
        const PointBasis b = evaluate(input.space, p.element, p.x);
        for (std::size_t i = 0; i < b.functions.size(); ++i)
            load.segment<2>(2 * b.functions[i]) += input.thickness * p.weight * b.value[static_cast<Index>(i)] * p.traction;
    }
    return load;
}

}  // namespace abut::solver
