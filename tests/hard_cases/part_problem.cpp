// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/part_problem.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/linear_algebra/condition.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/discretization/solution_structure.hpp"
#include "src/discretization/support_sets.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/scene/dissertation_method.hpp"
#include "tests/hard_cases/part_errors.hpp"

namespace abut::test {

namespace {

constexpr int extra_boundary_points = 3;  // the fields are no polynomials

std::string dirichlet_of(Hold hold) {
    if (hold == Hold::aligned) return "aligned";
    return hold == Hold::structure ? "solution_structure" : "nitsche";
}

Scene scene_of(const PartProblem& problem) {
    Scene scene;
    scene.analysis = problem.analysis;
    scene.materials = {problem.material};
    scene.parts = {{"part", problem.part, 0, 1, "/parts/0"}};
    scene.accuracy.degree = problem.degree;
    scene.accuracy.basis = name_of(problem.basis);
    scene.accuracy.dirichlet = dirichlet_of(problem.hold);
    if (problem.hold == Hold::dissertation) {
        scene.accuracy.weights = "joined";  // of the whole line where an edge bounds the hull, else nothing that goes on inside
        take_dissertation_method(scene);
    }
    for (const HeldEdge& held : problem.held) {
        if (problem.hold == Hold::rigid) break;
        Support support;
        support.x = held.component == 0;
        support.y = held.component == 1;
        scene.supports.push_back(support);
    }
    return scene;
}

ResolvedConditions conditions_of(const PartProblem& problem) {
    ResolvedConditions conditions;
    for (const HeldEdge& held : problem.held)
        if (problem.hold != Hold::rigid) conditions.supports.push_back({{0, held.edge, 0, 1}});
    return conditions;
}

bool is_held(const PartProblem& problem, int edge, int component) {
    return problem.hold != Hold::rigid && std::any_of(problem.held.begin(), problem.held.end(), [&](const HeldEdge& h) {
               return h.edge == edge && h.component == component;
           });
}

/// Exact tractions of the components that are not held, in the grid's frame.
std::vector<solver::TractionPoint> tractions(const PartProblem& problem, const PartOnGrid& g) {
    std::vector<solver::TractionPoint> points;
    for (int e = 0; e < static_cast<int>(g.local.edges.size()); ++e)
        for (const geometry::BoundaryPoint& p :
             boundary_rule(g.local, g.cells, g.elements, e, 0, 1, problem.degree + extra_boundary_points)) {
            const Eigen::Vector3d s = problem.exact.stress(g.frame.to_global(p.x));
            const Vec2 n = g.frame.vector_to_global(p.normal);
            Vec2 t(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y());
            for (int c : {0, 1})
                if (is_held(problem, e, c)) t[c] = 0;
            points.push_back({p.element, p.x, p.weight, g.frame.vector_to_local(t)});
        }
    return points;
}

std::vector<solver::SupportSet> supports(const PartProblem& problem, const Scene& scene, const PartOnGrid& g) {
    std::vector<solver::SupportSet> sets = support_sets(scene, conditions_of(problem), g);
    for (solver::SupportSet& set : sets)
        for (solver::SupportPoint& p : set.points)
            if (!set.by_structure && !set.side)
                p.value = g.frame.vector_to_global(p.direction).dot(problem.exact.displacement(g.frame.to_global(p.x)));
    return sets;
}

double smallest_fraction(const PartOnGrid& g) {
    double smallest = 1;
    for (double f : g.elements.fraction)
        if (f > 0) smallest = std::min(smallest, f);
    return smallest;
}

}  // namespace

std::string name_of(solver::Basis basis) {
    if (basis == solver::Basis::plain) return "plain";
    return basis == solver::Basis::normalized ? "normalized" : "web";
}

std::string name_of(Hold hold) {
    switch (hold) {
        case Hold::rigid:
            return "rigid";
        case Hold::nitsche:
            return "nitsche";
        case Hold::aligned:
            return "aligned";
        case Hold::structure:
            return "structure";
        default:
            return "dissertation";
    }
}

Elasticity elasticity_of(const PartProblem& problem) {
    const Material& m = problem.material;
    return problem.analysis == Analysis::plane_strain ? solver::plane_strain(m.E, m.nu) : solver::plane_stress(m.E, m.nu);
}

geometry::Grid even_grid(const PartProblem& problem, double h, const Vec2& offset) {
    const Frame& f = problem.frame;
    const geometry::Box2 box = bounding_box(transformed(problem.part, f.c, -f.s, -f.shift));
    geometry::Grid grid;
    for (int axis : {0, 1}) {
        std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        auto k = static_cast<long>(std::floor((box.min[axis] - offset[axis]) / h));
        while (offset[axis] + static_cast<double>(k) * h > box.min[axis]) --k;
        do lines.push_back(offset[axis] + static_cast<double>(k++) * h);
        while (lines.back() < box.max[axis]);
    }
    return grid;
}

PreparedPart prepare_part(const PartProblem& problem, const geometry::Grid& grid) {
    const Scene scene = scene_of(problem);
    PreparedPart p{discretize(scene, 0, problem.frame, grid, {problem.degree, problem.degree}), {}};
    PartOnGrid& g = p.on_grid;
    if (!g.input.space.failure.empty()) {
        p.system.failure = g.input.space.failure;
        return p;
    }
    g.input.structure = make_structure(scene, conditions_of(problem), g);
    if (problem.standard_form || g.input.structure) g.input.is_projected = false;
    const auto force = [&](const Vec2& local) -> Vec2 {
        return g.frame.vector_to_local(problem.exact.body_force(g.frame.to_global(local)));
    };
    const std::vector<solver::TractionPoint> t = tractions(problem, g);
    Eigen::VectorXd load = boundary_load(g.input, t), weighted;
    if (problem.exact.body_force) load += body_load(g.input, force);
    if (g.input.structure) {
        weighted = weighted_boundary_load(g.input, t);
        if (problem.exact.body_force) weighted += weighted_body_load(g.input, force);
    }
    p.system = make_part_system(g.input, supports(problem, scene, g), std::move(load), g.center, g.size, {}, weighted);
    g.input.dilatation = p.system.input.dilatation;
    return p;
}

namespace {

/// The 2-norm condition number of the stiffness as it is assembled, from below; without pressures beside the displacement.
double unscaled_condition(const solver::PartSystem& system) {
    const solver::SparseSymmetric a = restricted(system.stiffness, system.number, system.n_kept);
    const Eigen::Map<const Eigen::SparseMatrix<double>> lower(a.n, a.n, static_cast<Eigen::Index>(a.value.size()),
                                                              a.first.data(), a.row.data(), a.value.data());
    return solver::condition_by_lanczos(
        a.n, [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return lower.selfadjointView<Eigen::Lower>() * x; },
        [&](const Eigen::VectorXd& b) { return system.factor.solve(b); });
}

}  // namespace

PartAnswer solve_part(const PartProblem& problem, const geometry::Grid& grid) {
    const PreparedPart p = prepare_part(problem, grid);
    PartAnswer answer;
    answer.smallest_fraction = smallest_fraction(p.on_grid);
    answer.failure = p.system.failure;
    if (!answer.failure.empty()) return answer;
    answer.unknowns = 2 * p.on_grid.input.space.n_functions;
    answer.condition = p.system.factor.condition_estimate();
    if (problem.basis != solver::Basis::web) answer.unscaled_condition = unscaled_condition(p.system);
    for (const solver::SupportRecord& record : p.system.supports) answer.methods.push_back(record.method);
    if (problem.hold != Hold::dissertation) add_errors(problem, p, answer);
    return answer;
}

double dense_condition(const solver::PartSystem& system) {
    const solver::SparseSymmetric a = restricted(system.stiffness, system.number, system.n_kept);
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(a.n, a.n);
    for (int c = 0; c < a.n; ++c)
        for (int k = a.first[static_cast<std::size_t>(c)]; k < a.first[static_cast<std::size_t>(c) + 1]; ++k)
            m(a.row[static_cast<std::size_t>(k)], c) = a.value[static_cast<std::size_t>(k)];
    const Eigen::VectorXd scale = m.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * m * scale.asDiagonal(), Eigen::EigenvaluesOnly)
            .eigenvalues();
    return values[values.size() - 1] / values[0];
}

}  // namespace abut::test
