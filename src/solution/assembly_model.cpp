// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/assembly_model.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <optional>

#include "geometry/curves/bezier_span.hpp"
#include "solver/contact/independent_groups.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/recovery/recovery.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/discretization/part_grid.hpp"
#include "src/discretization/rigid_part.hpp"
#include "src/discretization/shared_grids.hpp"
#include "src/plan/rigid_parts.hpp"
#include "src/plan/support_components.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/part_systems.hpp"
#include "src/solution/preload.hpp"

namespace abut {

namespace {

using Eigen::VectorXd;

constexpr int max_wall_refinements = 5;

class Timed {
public:
    Timed(Stopwatches& seconds, std::string stage) : seconds_(seconds), stage_(std::move(stage)) {}
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;
    ~Timed() { seconds_[stage_] += seconds(); }
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

private:
    Stopwatches& seconds_;
    std::string stage_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A part on a grid, and what it took.
struct PutPart {
    PartOnGrid grid;
    bool is_refined = false, is_limited = false;
};

PutPart put_on_grid(const Scene& scene, const DesignedGrid& designed, double coarseness) {
    const int part = designed.part;
    if (!why_rigid(scene, part).empty()) return {put_rigid_part(scene, part)};
    bool limited = false;
    double refinement = 1;
    PartGrid chosen = designed.grid;
    for (int attempt = 0;; ++attempt) {
        limited = limited || chosen.limited;
        PartOnGrid g = discretize(scene, part, chosen.frame, chosen.grid, chosen.degree);
        const bool is_final = chosen.given || attempt == max_wall_refinements || scene.accuracy.cell_size;
        if (!is_final && !g.input.space.failure.empty()) {
            refinement *= 0.5;
            chosen = grid_of_part(scene, part, designed.wanted, coarseness, refinement);
            continue;
        }
        g.too_fine = chosen.too_fine;
        return {std::move(g), attempt > 0, limited};
    }
}

/// Wall time of the factorisations: where parts were made side by side, their share of what all of it took.
double factorisation_seconds(const SolvedAssembly& solved, double wall) {
    double all = 0, factorisation = 0;
    for (const solver::PartSystem& system : solved.problem.parts) {
        all += system.seconds.all;
        factorisation += system.seconds.factorisation;
    }
    return all > wall ? factorisation * wall / all : factorisation;
}

void add_steps(const solver::SolveSeconds& steps, Stopwatches& seconds) {
    seconds["rows"] += steps.rows;
    seconds["condensation"] += steps.condensation;
    seconds["contact iterations"] += steps.contact;
    seconds["displacements"] += steps.displacements;
}

/// Index of the solver's new interface.
int append_interface(const ContactInterface& contact, SolvedAssembly& solved) {
    solved.problem.interfaces.push_back(contact.face);
    solved.problem.foundation.push_back(contact.foundation);
    solved.problem.own_normals.push_back(contact.own_normals);
    return static_cast<int>(solved.problem.interfaces.size()) - 1;
}

/// Held as drawn, across the interface.
void bond(ContactInterface& contact) {
    contact.face.bilateral = true;
    for (solver::InterfacePoint& p : contact.face.points) p.gap = 0;
}

/// The same points along the interface, where they are held, or by friction.
ContactInterface along(ContactInterface contact, double friction) {
    const std::vector<solver::InterfacePoint> drawn = contact.face.points;
    bond(contact);
    if (friction > 0)  // the gap as drawn, which tractions act midway of
        for (std::size_t q = 0; q < drawn.size(); ++q) contact.face.points[q].gap = drawn[q].gap + contact.drawn.closing;
    contact.face.expected.clear();
    if (friction > 0) contact.face.friction = friction;
    for (solver::InterfacePoint& p : contact.face.points)
        for (Vec2& n : p.normal) n = geometry::left_of(n);
    for (auto& pair : contact.own_normals)
        for (Vec2& n : pair) n = geometry::left_of(n);
    return contact;
}

/// Is the gap closed by an interference, or by a drawn overlap that counts as one?
bool closes(const Scene& scene, const Candidate& c) {
    return !c.bonded && (c.interference != 0 || (scene.contacts.overlap == "press_fit" && c.zone.gap_min < 0));
}

/// Rigid parts have no pressure between them, and nothing to hold them together by: the pair is looked at after the solution.
bool are_rigid(const Scene& scene, const Candidate& c, const PartOnGrid& first, const PartOnGrid& second) {
    if (!first.is_rigid || !second.is_rigid) return false;
    if (!c.bonded) return true;
    throw InputError(scene.contacts.pairs[at(c.rule)].where,
                     "parts " + scene.parts[at(c.first)].name + " and " + scene.parts[at(c.second)].name +
                         " are both rigid: they cannot be bonded",
                     "draw them as one part, or make one of them elastic");
}

/// By solver part, of all candidates.
std::vector<FacesByCell> faces_of_contact(const std::vector<Candidate>& candidates, const SolvedAssembly& solved) {
    std::vector<FacesByCell> faces(solved.grids.size());
    for (const Candidate& c : candidates) {
        const int a = solved.solver_part[at(c.first)], b = solved.solver_part[at(c.second)];
        const geometry::FacingZone& z = c.zone;
        if (a >= 0) note_faces(solved.grids[at(a)], z.chain1, z.begin1, z.end1, faces[at(a)]);
        if (b >= 0)
            note_faces(solved.grids[at(b)], z.chain2, std::min(z.begin2, z.end2), std::max(z.begin2, z.end2), faces[at(b)]);
    }
    return faces;
}

/// The interface of a candidate between grids, and the time that it took.
struct MadeInterface {
    std::optional<ContactInterface> contact{};  ///< none between parts that are not solved or both rigid
    double seconds = 0;
};

MadeInterface made_interface(const Scene& scene, const Candidate& c, const SolvedAssembly& solved,
                             const std::vector<FacesByCell>& faces) {
    const int a = solved.solver_part[at(c.first)], b = solved.solver_part[at(c.second)];
    if (a < 0 || b < 0 || are_rigid(scene, c, solved.grids[at(a)], solved.grids[at(b)])) return {};
    const auto begin = std::chrono::steady_clock::now();
    MadeInterface made{make_interface(scene, c, solved.grids[at(a)], solved.grids[at(b)], {a, b}, faces, solved.known.get())};
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return made;
}

void make_interfaces(const Scene& scene, const std::vector<Candidate>& candidates, int threads, SolvedAssembly& solved) {
    const std::vector<FacesByCell> faces = faces_of_contact(candidates, solved);
    std::vector<MadeInterface> made(candidates.size());
    solver::parallel_for(static_cast<int>(made.size()), threads,
                         [&](int k) { made[at(k)] = made_interface(scene, candidates[at(k)], solved, faces); });
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& c = candidates[k];
        const bool has_friction = c.friction > 0 && !c.bonded;
        solved.interface_of.push_back(-1);
        solved.shear_of.push_back(-1);
        solved.contacts.emplace_back();
        solved.contacts.back().part = {c.first, c.second};
        if (!made[k].contact) continue;
        solved.contacts.back() = std::move(*made[k].contact);
        ContactInterface& contact = solved.contacts.back();
        EffectUse& use = solved.uses[c.bonded ? "bonding" : "contact"];
        use.seconds += made[k].seconds;
        if (contact.face.points.empty()) continue;
        use.items += static_cast<long>(contact.face.points.size());
        if (closes(scene, c)) solved.uses["interference"].items += static_cast<long>(contact.face.points.size());
        if (c.bonded) bond(contact);
        solved.interface_of.back() = append_interface(contact, solved);
        if (c.bonded || has_friction) solved.shear_of.back() = append_interface(along(contact, c.friction), solved);
        if (has_friction) solved.uses["friction"].items += static_cast<long>(contact.face.points.size());
    }
}

/// Tells the parts where their interfaces are, and models where those of their copies.
void note_contact_elements(SolvedAssembly& solved) {
    for (const solver::Interface& face : solved.problem.interfaces)
        for (std::size_t side = 0; side < 2; ++side) {
            const PartOnGrid& own = solved.grids[at(face.part[side])];
            const int part = own.model < 0 ? face.part[side] : solved.solver_part[at(own.model)];
            std::vector<int>& elements = solved.grids[at(part)].input.contact_elements;
            for (const solver::InterfacePoint& p : face.points)
                if (elements.empty() || elements.back() != p.element[side]) elements.push_back(p.element[side]);
        }
}

/// Of the error aimed at: what the increments may change, beside what the grids leave.
constexpr double path_share = 0.5;

/// How well places of a part's outline are known.
double rounding_of_outline(const PartOnGrid& g) {
    return geometry::coordinate_roundings * std::numeric_limits<double>::epsilon() * (g.frame.shift.norm() + g.size);
}

/// Is a pressure no more than what loads are rounded by, or where there are none, than what places of outlines are that are
/// drawn against each other?
bool is_rounding(const SolvedAssembly& solved, std::size_t contact, const Eigen::VectorXd& pressure, double load_scale) {
    const solver::Interface& face = solved.contacts[contact].face;
    const double length = face.pressure.breakpoints.back() - face.pressure.breakpoints.front(),
                 largest = pressure.cwiseAbs().maxCoeff();
    if (largest * length * face.thickness <= solver::open_force_fraction * load_scale) return true;
    return load_scale == 0 &&
           largest * length * compliance_of(solved, contact) <=
               rounding_of_outline(solved.grids[at(face.part[0])]) + rounding_of_outline(solved.grids[at(face.part[1])]);
}

/// A stiff penalty asks more of its points than the cells have to give: single ones open within the contact. Stretches that lie
/// fewer points apart than two cells have are one.
std::vector<PressedStretch> without_flicker(const std::vector<PressedStretch>& stretches, const solver::KnotVector& points,
                                            int points_per_cell) {
    std::vector<PressedStretch> joined;
    for (const PressedStretch& stretch : stretches) {
        const auto between = [&](double s) { return !joined.empty() && s > joined.back().end && s < stretch.begin; };
        const auto n = std::count_if(points.breakpoints.begin(), points.breakpoints.end(), between);
        if (joined.empty() || n >= 2 * points_per_cell) {
            joined.push_back(stretch);
        } else {
            joined.back().end = stretch.end;
            joined.back().to_end = stretch.to_end;
            joined.back().at_end = stretch.at_end;
        }
    }
    return joined;
}

/// The solution's steps by effect: those on multipliers in proportion to the rows of each, the rest is elasticity's.
void add_solution_uses(const Scene& scene, const solver::SolveSeconds& s, SolvedAssembly& solved) {
    long contact = 0, bonding = 0, friction = 0;
    for (const solver::Interface& face : solved.problem.interfaces)
        (face.friction ? friction : face.bilateral ? bonding : contact) += solver::n_rows(face);
    std::map<std::string, long> held;
    for (const solver::MeanConstraint& c : solved.problem.constraints) ++held[effect_of(scene.supports[at(c.tag)])];
    const long rows = contact + bonding + friction + static_cast<long>(solved.problem.constraints.size());
    const double on_rows = s.rows + s.condensation + s.contact;
    const auto add = [&](const std::string& effect, long n) {
        if (n == 0) return;
        EffectUse& use = solved.uses[effect];
        use.items += n;
        use.seconds += on_rows * static_cast<double>(n) / static_cast<double>(rows);
    };
    add("contact", contact);
    add("bonding", bonding);
    add("friction", friction);
    for (const auto& [effect, n] : held) add(effect, n);
    solved.uses["elasticity"].seconds += s.displacements + (rows == 0 ? on_rows : 0);
}

/// Does a part go farther than it is large, or where nothing holds it?
bool goes_astray(const SolvedAssembly& solved) {
    if (!solved.solution.mechanism.empty()) return true;
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const PartOnGrid& g = solved.grids[k];
        if (!solved.problem.parts[k].free_motions.empty() && !g.is_rigid &&
            solver::largest_displacement(g.input, solved.solution.displacement[k]) > g.size)
            return true;
    }
    return false;
}

/// Displacements, pressures and stretches of contact, on systems that are factorised.
void solve_contacts(const Scene& scene, SolvedAssembly& solved, Stopwatches& seconds, int threads) {
    {
        const Timed timed(seconds, "solve");
        tighten(scene, solved, threads);
        if (!solved.failure.empty()) return;
        solved.problem.begins_touching = !grids_are_fixed(scene);
        solved.solution = solve_groups(solved.problem, threads);
        const auto has_friction = [](const solver::Interface& face) { return face.friction.has_value(); };
        if (std::none_of(solved.problem.interfaces.begin(), solved.problem.interfaces.end(), has_friction) &&
            goes_astray(solved)) {
            solved.problem.drops_imbalance = true;
            solver::AssemblySolution again = solve_groups(solved.problem, threads);
            std::swap(again, solved.solution);
            if (goes_astray(solved)) std::swap(again, solved.solution);
        }
    }
    add_steps(solved.solution.seconds, seconds);
    add_solution_uses(scene, solved.solution.seconds, solved);
    solved.stretches.assign(solved.contacts.size(), {});
    solved.part_energy.clear();
    if (!solved.solution.mechanism.empty()) return;
    fill_preload_forces(solved);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (solved.interface_of[k] >= 0)
            solved.stretches[k] = stretches_of(solved, k, pressure_of(solved, k), solved.problem.load_scale);
}

/// Slips count from there, and loads grow from those there.
void begin_from(const SolvedAssembly& before, SolvedAssembly& solved) {
    for (const PartOnGrid& g : solved.grids) {
        const int there = before.solver_part[at(g.part)];
        const VectorXd none = VectorXd::Zero(2 * solved.problem.parts[solved.problem.before.size()].n());
        solver::StateBefore state{none, none, none};
        if (there >= 0 && at(there) < before.solution.displacement.size()) {
            const solver::PartSystem& system = before.problem.parts[at(there)];
            state = {before.solution.displacement[at(there)], system.load, solve(system, system.load)};
        }
        ENSURE(state.displacement.size() == none.size(), "a state before is of the same grids");
        solved.problem.before.push_back(std::move(state));
    }
    solved.problem.is_way_before_broken = before.solution.is_way_broken;
}

/// What cannot be put on a grid is told in `failure`.
SolvedAssembly put_on_grids(const Scene& scene, const ResolvedConditions& conditions, const std::vector<bool>& solve_part,
                            const WantedSizes& wanted, double coarseness, Stopwatches& seconds, int threads) {
    ENSURE(solve_part.size() == scene.parts.size() && wanted.size() == scene.parts.size(),
           "every part has a wanted size, and is solved or not");
    SolvedAssembly solved;
    solved.solver_part.assign(scene.parts.size(), -1);
    const Timed timed(seconds, "geometry");
    const std::vector<DesignedGrid> designed = design_grids(scene, conditions, solve_part, wanted, coarseness, threads);
    std::vector<std::optional<PutPart>> put(designed.size());
    solver::parallel_for(static_cast<int>(put.size()), threads, [&](int k) {
        if (designed[at(k)].model < 0) put[at(k)] = put_on_grid(scene, designed[at(k)], coarseness);
    });
    for (std::size_t k = 0; k < put.size(); ++k) solved.solver_part[at(designed[k].part)] = static_cast<int>(k);
    for (std::size_t k = 0; k < put.size(); ++k) {
        const DesignedGrid& d = designed[k];
        if (d.model >= 0) {  // models come before their copies
            PartOnGrid& model = solved.grids[at(solved.solver_part[at(d.model)])];
            if (!model.fit) model.fit = std::make_shared<Once<solver::StressFitFactor>>();
            solved.grids.push_back(copied(scene, d.part, d.frame, model));
            continue;
        }
        solved.refined_for_walls += put[k]->is_refined ? 1 : 0;
        solved.limited_grids += put[k]->is_limited ? 1 : 0;
        solved.grids.push_back(std::move(put[k]->grid));
        if (!solved.grids.back().input.space.failure.empty())
            solved.failure = "part " + scene.parts[at(d.part)].name + ": " + solved.grids.back().input.space.failure;
    }
    return solved;
}

/// Interfaces, systems and factors of parts on their grids.
void make_assembly(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                   Stopwatches& seconds, int threads, SolvedAssembly& solved) {
    const Timed timed(seconds, "assembly");
    make_interfaces(scene, candidates, threads, solved);
    note_contact_elements(solved);
    const double before = timed.seconds();
    make_systems(scene, conditions, threads, solved);
    seconds["factorisation"] += factorisation_seconds(solved, timed.seconds() - before);
}

}  // namespace

SolvedAssembly prepare_parts(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                             const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                             Stopwatches& seconds, int threads) {
    SolvedAssembly solved = put_on_grids(scene, conditions, solve_part, wanted, coarseness, seconds, threads);
    if (!solved.failure.empty()) return solved;
    make_assembly(scene, conditions, candidates, seconds, threads, solved);
    solved.failure.clear();
    for (PartOnGrid& g : solved.grids)
        if (!g.fit) g.fit = std::make_shared<Once<solver::StressFitFactor>>();
    for (solver::PartSystem& system : solved.problem.parts) system.factor.keep_forms();
    solved.known = std::make_shared<KnownInterfaces>(faces_of_contact(candidates, solved));
    return solved;
}

SolvedAssembly solve_case(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const SolvedAssembly& prepared, const SolvedAssembly* before,
                          Stopwatches& seconds, int threads) {
    SolvedAssembly solved;
    solved.failure = prepared.failure;
    solved.refined_for_walls = prepared.refined_for_walls;
    solved.limited_grids = prepared.limited_grids;
    // Steps without friction do not know in which order they are.
    if (!scene.in_steps || has_friction(candidates)) solved.known = prepared.known;
    solved.solver_part.assign(scene.parts.size(), -1);
    solved.grids.reserve(prepared.grids.size());
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        if (!solve_part[i]) continue;
        solved.solver_part[i] = static_cast<int>(solved.grids.size());
        solved.grids.push_back(prepared.grids[at(prepared.solver_part[i])]);
    }
    if (!solved.failure.empty()) return solved;
    try {
        const Timed timed(seconds, "assembly");
        make_interfaces(scene, candidates, threads, solved);
        load_systems(scene, conditions, prepared, threads, solved);
    } catch (const InputError& error) { solved.failure = one_line(error.problems().front()); }
    if (solved.failure.empty() && before) begin_from(*before, solved);
    if (solved.failure.empty()) solve_contacts(scene, solved, seconds, threads);
    return solved;
}

SolvedAssembly solve_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                          Stopwatches& seconds, int threads) {
    SolvedAssembly solved = put_on_grids(scene, conditions, solve_part, wanted, coarseness, seconds, threads);
    if (!solved.failure.empty()) return solved;
    make_assembly(scene, conditions, candidates, seconds, threads, solved);
    if (solved.failure.empty()) solve_contacts(scene, solved, seconds, threads);
    return solved;
}

void solve_contacts_again(const Scene& scene, const std::vector<Candidate>& candidates, SolvedAssembly& solved,
                          Stopwatches& seconds, int threads) {
    {
        const Timed timed(seconds, "assembly");
        solved.contacts.clear();
        solved.interface_of.clear();
        solved.shear_of.clear();
        solved.problem.interfaces.clear();
        solved.problem.foundation.clear();
        solved.problem.own_normals.clear();
        solved.problem.near = std::move(solved.solution.amplitudes);
        solved.problem.path_tolerance.reset();
        make_interfaces(scene, candidates, threads, solved);
    }
    solve_contacts(scene, solved, seconds, threads);
}

bool follow_loads(const Scene& scene, SolvedAssembly& solved, Stopwatches& seconds, int threads) {
    std::vector<solver::Interface>& faces = solved.problem.interfaces;
    if (std::none_of(faces.begin(), faces.end(), [](const solver::Interface& f) { return f.friction.has_value(); }))
        return false;
    expect_pressures_of(solved.solution, faces);
    solved.problem.path_tolerance = path_share * target_of(scene.accuracy);
    solve_contacts(scene, solved, seconds, threads);
    return true;
}

double largest_condition(const SolvedAssembly& solved, int threads) {
    const std::vector<solver::PartSystem>& parts = solved.problem.parts;
    std::vector<double> condition(parts.size(), 0);
    solver::parallel_for(static_cast<int>(parts.size()), threads, [&](int i) {
        const solver::PartSystem& system = parts[at(i)];
        if (system.body || !system.failure.empty() || has_factor_of_model(solved, at(i))) return;
        condition[at(i)] = condition_estimate(system);
    });
    return parts.empty() ? 0 : *std::max_element(condition.begin(), condition.end());
}

std::vector<PressedStretch> stretches_of(const SolvedAssembly& solved, std::size_t contact, const Eigen::VectorXd& pressure,
                                         double load_scale) {
    const solver::Interface& face = solved.contacts[contact].face;
    if (face.bilateral) return {{face.pressure.breakpoints.front(), face.pressure.breakpoints.back(), true, true}};
    if (is_rounding(solved, contact, pressure, load_scale)) return {};
    const std::vector<PressedStretch> stretches = pressed_stretches(solved.contacts[contact].face.pressure, pressure);
    if (face.penalty.empty()) return stretches;
    const solver::SplineSpace& space = solved.grids[at(face.part[0])].input.space;
    return without_flicker(stretches, face.pressure, std::max(space.x.degree, space.y.degree) + 1);
}

bool carries_nothing(const SolvedAssembly& solved, std::size_t contact) {
    const auto is_nothing = [&](const Eigen::VectorXd& traction) {
        return is_rounding(solved, contact, traction, solved.problem.load_scale);
    };
    const int shear = solved.shear_of[contact];
    return is_nothing(pressure_of(solved, contact)) && (shear < 0 || is_nothing(solved.solution.pressure[at(shear)]));
}

const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact) {
    ENSURE(contact < solved.interface_of.size() && at(solved.interface_of[contact]) < solved.solution.pressure.size(),
           "pressures are asked for of contacts that were solved");
    return solved.solution.pressure[at(solved.interface_of[contact])];
}

}  // namespace abut
