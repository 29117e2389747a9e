// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace abut {

namespace {

using solver::Resultant;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// A resultant about a part's local origin, as one about a point of the assembly.
Resultant to_assembly(const Resultant& local, const Frame& frame, const Vec2& about) {
    Resultant r;
    r.force = frame.vector_to_global(local.force);
    r.moment = local.moment + geometry::cross(frame.to_global({0, 0}) - about, r.force);
    return r;
}

Vec2 middle(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    return box.center();
}

double size(const Scene& scene) {
    geometry::Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    return box.diagonal();
}

/// Resultant on its part of the constraint rows' force.
Resultant constraint_reaction(const SolvedAssembly& solved, std::size_t k, const Vec2& about) {
    const solver::MeanConstraint& c = solved.problem.constraints[k];
    const PartOnGrid& grid = solved.grids[at(c.part)];
    // row' times multiplier, as a load vector
    const double mean = solved.solution.constraint_force[k] / c.area, turn = 0.5 * c.size * mean;
    Eigen::VectorXd load(2 * c.integrals.value.size());
    for (Eigen::Index f = 0; f < c.integrals.value.size(); ++f) {
        load[2 * f] = c.coefficient[0] * mean * c.integrals.value[f] - c.coefficient[2] * turn * c.integrals.dy[f];
        load[2 * f + 1] = c.coefficient[1] * mean * c.integrals.value[f] + c.coefficient[2] * turn * c.integrals.dx[f];
    }
    return to_assembly(solver::resultant_of(grid.input.space, load), grid.frame, about);
}

/// Integral of a contact's pressure: a press fit presses all round without a resultant.
double pressing_force(const SolvedAssembly& solved, std::size_t contact) {
    double sum = 0;
    if (solved.interface_of[contact] < 0) return sum;
    const solver::Interface& face = solved.contacts[contact].face;
    for (const solver::InterfacePoint& p : face.points)
        sum += p.weight * face.thickness * solver::pressure_at(face.pressure, pressure_of(solved, contact), p.s);
    return sum;
}

struct Totals {
    Resultant applied;
    std::map<int, Resultant> reactions;  // by support
    std::map<int, std::string> method;
    double largest = 0;  // largest single resultant
};

void add(Resultant& to, const Resultant& r) {
    to.force += r.force;
    to.moment += r.moment;
}

Totals totals(const SolvedAssembly& solved, const Vec2& about) {
    Totals t;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const solver::PartSystem& system = solved.problem.parts[i];
        const Frame& frame = solved.grids[i].frame;
        const Resultant applied = to_assembly(solver::resultant_of(system.input.space, system.applied), frame, about);
        add(t.applied, applied);
        t.largest = std::max(t.largest, applied.force.norm());
        const auto reactions = solver::support_reactions(system, solved.solution.displacement[i], solved.solution.load[i]);
        for (std::size_t k = 0; k < reactions.size(); ++k) {
            const int tag = system.supports[k].set.tag;
            add(t.reactions[tag], to_assembly(reactions[k], frame, about));
            std::string& method = t.method[tag];
            const std::string used = system.supports[k].method == solver::SupportMethod::aligned ? "aligned" : "nitsche";
            if (method.find(used) == std::string::npos) method += (method.empty() ? "" : ", ") + used;
        }
    }
    for (std::size_t k = 0; k < solved.problem.constraints.size(); ++k) {
        const int tag = solved.problem.constraints[k].tag;
        add(t.reactions[tag], constraint_reaction(solved, k, about));
        t.method[tag] = "rigid";
    }
    return t;
}

}  // namespace

void fill_equilibrium(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    const Vec2 about = middle(scene);
    const double arm = size(scene);
    Totals t = totals(solved, about);
    Resultant reaction;
    double largest = std::max(t.largest, solved.problem.load_scale);
    for (const auto& [tag, r] : t.reactions) {
        add(reaction, r);
        largest = std::max(largest, r.force.norm());
        Reaction out;
        out.support = tag;
        out.label = support_label(scene, tag);
        out.method = t.method[tag];
        out.force = r.force;
        out.moment = r.moment + geometry::cross(about, r.force);
        result.reactions.push_back(out);
    }
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) largest = std::max(largest, pressing_force(solved, k));
    result.equilibrium.applied = t.applied.force;
    result.equilibrium.reaction = reaction.force;
    // below what rounding of the displacements amounts to in force there is nothing to balance
    double rounding = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i)
        rounding = std::max(rounding, 1e-12 * solved.grids[i].input.elasticity.d11 * solved.grids[i].input.thickness *
                                          solved.solution.displacement[i].cwiseAbs().maxCoeff());
    if (largest > rounding) {
        result.equilibrium.relative_residual = (t.applied.force + reaction.force).norm() / largest;
        result.equilibrium.relative_moment_residual = std::abs(t.applied.moment + reaction.moment) / (largest * arm);
    }
}

}  // namespace abut
