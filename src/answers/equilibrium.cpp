// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/parts/rigid_body.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

namespace {

using solver::Resultant;

/// Rounding times how much stiffer Nitsche's supports are than their part, in a hundred cells: of a displacement, of a part led
/// without any load 2e-13 to 2e-12.
constexpr double rounding_of_displacement = 1e-11, rounding_of_force = 1e-9;

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

struct Totals {
    Resultant applied;
    std::map<int, Reaction> reactions;  // by support; the moment about `about`
    double largest = 0;                 // largest single resultant
};

/// To a resultant or a reaction.
template <class To>
void add(To& to, const Resultant& r) {
    to.force += r.force;
    to.moment += r.moment;
}

/// Adds words that are not there yet.
void add_words(std::string& to, const std::string& words, const std::string& separator) {
    if (to.find(words) == std::string::npos) to += (to.empty() ? "" : separator) + words;
}

std::string name_of(solver::SupportMethod method) {
    if (method == solver::SupportMethod::aligned) return "aligned";
    return method == solver::SupportMethod::nitsche ? "nitsche" : "structure";
}

/// The tractions of one of the solver's interfaces on a part.
void append_tractions(const SolvedAssembly& solved, std::size_t f, std::size_t part, std::vector<solver::TractionPoint>& to) {
    const solver::Interface& face = solved.problem.interfaces[f];
    for (std::size_t side = 0; side < 2; ++side) {
        if (at(face.part[side]) != part) continue;
        const double share = (side == 0 ? -1 : 1) * face.thickness / solved.grids[part].input.thickness;
        for (const solver::InterfacePoint& p : face.points) {
            const double traction = solver::pressure_at(face.pressure, solved.solution.pressure[f], p.s);
            to.push_back({p.element[side], p.x[side], p.weight, share * traction * p.normal[side]});
        }
    }
}

/// Contact pressures and constraints as a load on a part's plain functions.
Eigen::VectorXd plain_load(const SolvedAssembly& solved, std::size_t part) {
    const PartOnGrid& grid = solved.grids[part];
    std::vector<solver::TractionPoint> points;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        if (solved.interface_of[k] < 0) continue;
        for (const int f : {solved.interface_of[k], solved.shear_of[k]})
            if (f >= 0) append_tractions(solved, at(f), part, points);
    }
    return solver::boundary_load(grid.input, points);
}

void add_springs(const SolvedAssembly& solved, std::size_t part, const Vec2& about, Totals& t) {
    const solver::PartSystem& system = solved.problem.parts[part];
    for (const solver::SpringSet& set : system.springs) {
        const solver::SpringAnswer answer = solver::spring_answer(system.input, set, solved.solution.displacement[part]);
        Reaction& r = t.reactions[set.tag];
        add(r, to_assembly(answer.force, solved.grids[part].frame, about));
        r.method = "spring";
        r.why = "a spring is no constraint: its stiffness is part of the system";
        r.energy = r.energy.value_or(0) + answer.energy;
    }
}

void add_part_reactions(const SolvedAssembly& solved, std::size_t part, const Vec2& about, Totals& t) {
    const solver::PartSystem& system = solved.problem.parts[part];
    const Frame& frame = solved.grids[part].frame;
    const Eigen::VectorXd& u = solved.solution.displacement[part];
    if (system.body) {
        const Eigen::VectorXd forces = solver::forces_on(system, u, solved.solution.load[part]);
        for (const auto& [tag, force] : solver::rigid_reactions(system, forces)) {
            Reaction& r = t.reactions[tag];
            add(r, to_assembly(force, frame, about));
            add_words(r.method, "rigid", ", ");
            add_words(r.why, "the part is rigid: its supports balance its loads, shared as equally stiff points would", "; ");
        }
        add_springs(solved, part, about, t);
        return;
    }
    const Eigen::VectorXd plain = system.input.structure ? plain_load(solved, part) : Eigen::VectorXd();
    const auto reactions = solver::support_reactions(system, u, solved.solution.load[part], plain);
    for (std::size_t k = 0; k < reactions.size(); ++k) {
        const solver::SupportRecord& record = system.supports[k];
        Reaction& r = t.reactions[record.set.tag];
        add(r, to_assembly(reactions[k], frame, about));
        add_words(r.method, name_of(record.method), ", ");
        add_words(r.why, record.why, "; ");
        const bool is_along_edges = !record.set.points.front().normal.isZero(0);
        if (record.method != solver::SupportMethod::structure || !is_along_edges) continue;
        const Resultant stress = to_assembly(solver::traction_resultant(system.input, record.set, u), frame, about);
        r.force_from_stress = r.force_from_stress.value_or(Vec2(0, 0)) + stress.force;
    }
    add_springs(solved, part, about, t);
}

Totals totals(const Scene& scene, const SolvedAssembly& solved, const Vec2& about) {
    Totals t;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const solver::PartSystem& system = solved.problem.parts[i];
        const Frame& frame = solved.grids[i].frame;
        const Resultant applied = to_assembly(solver::resultant_of(system.input.space, system.applied), frame, about);
        add(t.applied, applied);
        t.largest = std::max(t.largest, applied.force.norm());
        add_part_reactions(solved, i, about, t);
    }
    for (std::size_t k = 0; k < solved.problem.constraints.size(); ++k) {
        const int tag = solved.problem.constraints[k].tag;
        add(t.reactions[tag], constraint_reaction(solved, k, about));
        const bool is_point = scene.supports[at(tag)].kind == Support::Kind::points;
        t.reactions[tag].method = is_point ? "point" : "rigid";
        t.reactions[tag].why =
            is_point ? "the displacement of the points themselves" : "the part's mean motion, whatever its grid";
    }
    return t;
}

/// Forces of a part below this are rounding: of its displacements, as stiff as it is; or of the forces within it, by its strain
/// energy, where those balance by themselves (edges held all round).
double force_rounding(const SolvedAssembly& solved, std::size_t part) {
    const solver::PartInput& input = solved.grids[part].input;
    const double stiffness = input.elasticity.d11 * input.thickness;
    const Eigen::VectorXd& u = solved.solution.displacement[part];
    const double energy = std::max(0.0, energy_of_part(solved, part));
    return std::max(rounding_of_displacement * stiffness * u.cwiseAbs().maxCoeff(),
                    rounding_of_force * std::sqrt(2 * energy * stiffness));
}

/// A force at a point goes with a displacement without limit: one warning for all points that are held, unless they only keep
/// parts in place that balance by themselves.
void warn_of_points(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    for (std::size_t part = 0; part < solved.grids.size(); ++part) {
        if (points_that_carry(scene, solved, part).empty()) continue;
        result.warnings.push_back("part " + scene.parts[at(solved.grids[part].part)].name +
                                  " is held at points: stresses have no limit there, and displacements depend on "
                                  "the size of the cells");
        return;
    }
}

/// How u_x is held on the axis, part by part, beside the plan's word that it is.
void note_axis(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    for (Effect& effect : result.effects)
        for (std::size_t k = 0; effect.name == "axisymmetry" && k < solved.grids.size(); ++k)
            if (const std::string& hold = solved.problem.parts[k].axis_hold; !hold.empty())
                effect.why += "; " + scene.parts[at(solved.grids[k].part)].name + ": " + hold;
}

}  // namespace

void fill_equilibrium(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    const Vec2 about = middle(scene);
    const double arm = size(scene);
    Totals t = totals(scene, solved, about);
    Resultant reaction;
    double largest = std::max(t.largest, solved.problem.load_scale);
    for (auto& [tag, r] : t.reactions) {
        ENSURE(tag >= 0 && at(tag) < scene.supports.size(), "a reaction is that of a support of the scene");
        reaction.force += r.force;
        reaction.moment += r.moment;
        largest = std::max(largest, r.force.norm());
        r.support = tag;
        r.label = support_label(scene, tag);
        r.moment += geometry::cross(about, r.force);
        result.reactions.push_back(r);
    }
    note_axis(scene, solved, result);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) largest = std::max(largest, pressing_force(solved, k));
    if (scene.analysis == Analysis::axisymmetric) {
        // around the axis only forces along it have a resultant: radial ones, and moments, balance by themselves
        for (Resultant* r : {&t.applied, &reaction}) *r = {{0, r->force.y()}, 0};
        for (Reaction& r : result.reactions) r.moment = 0;
    }
    result.equilibrium.applied = t.applied.force;
    result.equilibrium.reaction = reaction.force;
    double rounding = 0;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) rounding = std::max(rounding, force_rounding(solved, i));
    warn_of_points(scene, solved, result);
    if (largest > rounding) {
        result.equilibrium.relative_residual = (t.applied.force + reaction.force).norm() / largest;
        result.equilibrium.relative_moment_residual = std::abs(t.applied.moment + reaction.moment) / (largest * arm);
    }
}

}  // namespace abut
