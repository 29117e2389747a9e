// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/part_errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/curves/gauss.hpp"
#include "geometry/quadrature/transformed_gauss.hpp"
#include "solver/assembly/cell_integrals.hpp"
#include "solver/terms/solution_structure.hpp"
#include "solver/terms/stress.hpp"
#include "src/answers/field_results.hpp"

namespace abut::test {

namespace {

using Eigen::Index;
using solver::CellRule;

constexpr int extra_points = 2;             // of the rules in each direction: the fields are no polynomials
constexpr int boundary_points_a_piece = 2;  // with weight 0: looked at, not integrated

CellRule full_cell(const geometry::Grid& grid, int cell, int n) {
    const geometry::GaussRule& line = geometry::gauss_rule(n);
    const Vec2 a = grid.box(cell).min, h = grid.box(cell).size();
    CellRule rule{cell, {}, {}};
    for (std::size_t v = 0; v < line.points.size(); ++v)
        for (std::size_t u = 0; u < line.points.size(); ++u) {
            rule.points.push_back(a + h.cwiseProduct(Vec2(line.points[u], line.points[v])));
            rule.weights.push_back(line.weights[u] * line.weights[v] * h.prod());
        }
    return rule;
}

/// Points and weights of all elements; along the boundary, too.
std::vector<CellRule> rules_of(const PartOnGrid& g, int order) {
    std::vector<CellRule> rules;
    for (int cell = 0; cell < g.input.space.n_cells(); ++cell)
        if (g.elements.fraction[static_cast<std::size_t>(cell)] == 1)
            rules.push_back(full_cell(g.cells.grid, cell, order + 1 + extra_points));
    for (geometry::CellRule& rule : transformed_rules(g.local, g.cells, g.elements, order, extra_points))
        rules.push_back({rule.element, std::move(rule.points), std::move(rule.weights)});
    for (int e = 0; e < static_cast<int>(g.local.edges.size()); ++e)
        for (const geometry::BoundaryPoint& p : boundary_rule(g.local, g.cells, g.elements, e, 0, 1, boundary_points_a_piece)) {
            if (rules.back().element != p.element) rules.push_back({p.element, {}, {}});
            rules.back().points.push_back(p.x);
            rules.back().weights.push_back(0);
        }
    return rules;
}

/// What is known at one point, all in the grid's frame.
struct At {
    Vec2 x;
    double weight;
    Vec2 u, exact_u;
    Eigen::Vector3d raw, smooth, exact;
};

Eigen::Vector3d local_stress(const Frame& f, const Eigen::Vector3d& s) {
    Eigen::Matrix2d turn, t;
    turn << f.c, f.s, -f.s, f.c;
    t << s[0], s[2], s[2], s[1];
    t = (turn * t * turn.transpose()).eval();
    return {t(0, 0), t(1, 1), t(0, 1)};
}

/// Combinations of an element's functions at points of it.
struct Fields {
    Eigen::MatrixX2d value, dx, dy;
};
Fields fields_at(const solver::SplineSpace& space, const Eigen::MatrixX2d& c, const CellRule& rule) {
    solver::Sampled at;
    sample(space, rule.element, rule.points, at);
    const solver::Extraction e = extraction(space, rule.element);
    Eigen::MatrixX2d own(static_cast<Index>(e.functions.size()), 2);
    for (std::size_t k = 0; k < e.functions.size(); ++k) own.row(static_cast<Index>(k)) = c.row(e.functions[k]);
    const Eigen::MatrixX2d local = e.identity ? own : Eigen::MatrixX2d(e.matrix * own);
    return {at.value * local, at.dx * local, at.dy * local};
}

std::vector<At> look(const PartProblem& problem, const PartOnGrid& g, const Eigen::VectorXd& u) {
    const solver::StressField stress = stress_field(g, u);
    if (!stress.failure.empty())
        throw std::runtime_error(stress.failure + " (" + std::to_string(g.input.space.n_functions) + " functions)");
    const solver::StressOf raw(g.input, u);
    const Eigen::MatrixX2d c =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>>(u.data(), u.size() / 2, 2);
    std::vector<At> all;
    for (const CellRule& rule : rules_of(g, problem.degree)) {
        if (rule.points.empty()) continue;
        const bool weighted = g.input.structure != nullptr;
        const Fields f = weighted ? Fields{} : fields_at(g.input.space, c, rule);
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const Vec2 p = rule.points[k], global = g.frame.to_global(p);
            solver::DisplacementAt d;
            if (weighted) {
                d = displacement_at(g.input, u, rule.element, p);
            } else {
                const auto row = static_cast<Index>(k);
                d.value = f.value.row(row).transpose();
                d.gradient << f.dx.row(row).transpose(), f.dy.row(row).transpose();
            }
            all.push_back({p, rule.weights[k], d.value, g.frame.vector_to_local(problem.exact.displacement(global)),
                           raw(rule.element, p, d), solver::stress_at(stress, rule.element, p).head<3>(),
                           local_stress(g.frame, problem.exact.stress(global))});
        }
    }
    return all;
}

/// Takes the rigid motion off that fits the displacements' error best.
void take_off_motion(std::vector<At>& all, const Vec2& center, double size) {
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    Eigen::Vector3d work = Eigen::Vector3d::Zero();
    const auto motion = [&](const Vec2& x) {
        const Vec2 r = (x - center) / size;
        Eigen::Matrix<double, 2, 3> m;
        m << 1, 0, -r.y(), 0, 1, r.x();
        return m;
    };
    for (const At& a : all) {
        gram += a.weight * motion(a.x).transpose() * motion(a.x);
        work += a.weight * motion(a.x).transpose() * (a.u - a.exact_u);
    }
    const Eigen::Vector3d best = gram.ldlt().solve(work);
    for (At& a : all) a.u -= motion(a.x) * best;
}

/// Twice the strain energy density of a stress.
double density(const Elasticity& d, const Eigen::Vector3d& s) {
    const double determinant = d.d11 * d.d11 - d.d12 * d.d12;
    return (d.d11 * (s[0] * s[0] + s[1] * s[1]) - 2 * d.d12 * s[0] * s[1]) / determinant + s[2] * s[2] / d.d33;
}

}  // namespace

void add_errors(const PartProblem& problem, const PreparedPart& prepared, PartAnswer& answer) {
    const PartOnGrid& g = prepared.on_grid;
    const Eigen::VectorXd u = solve(prepared.system, prepared.system.load);
    std::vector<At> all = look(problem, g, u);
    if (problem.hold == Hold::rigid) take_off_motion(all, g.center, g.size);
    double u2 = 0, e2 = 0, energy = 0, wrong = 0, largest_u = 0, largest_s = 0;
    for (const At& a : all) {
        u2 += a.weight * a.exact_u.squaredNorm();
        e2 += a.weight * (a.u - a.exact_u).squaredNorm();
        energy += a.weight * density(g.input.elasticity, a.exact);
        wrong += a.weight * density(g.input.elasticity, a.raw - a.exact);
        largest_u = std::max(largest_u, a.exact_u.norm());
        largest_s = std::max(largest_s, a.exact.norm());
        answer.largest_displacement = std::max(answer.largest_displacement, (a.u - a.exact_u).norm());
        answer.largest_stress = std::max(answer.largest_stress, (a.smooth - a.exact).norm());
        answer.largest_raw_stress = std::max(answer.largest_raw_stress, (a.raw - a.exact).norm());
    }
    answer.displacement = std::sqrt(e2 / u2);
    answer.energy = std::sqrt(wrong / energy);
    answer.largest_displacement /= largest_u;
    answer.largest_stress /= largest_s;
    answer.largest_raw_stress /= largest_s;
    answer.exact_energy = 0.5 * energy;
    answer.strain_energy = strain_energy(prepared.system, u);
}

}  // namespace abut::test
