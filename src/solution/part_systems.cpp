// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/part_systems.hpp"

#include <algorithm>

#include "geometry/brep/outline.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/dilatation.hpp"
#include "src/base/index.hpp"
#include "src/discretization/load_vector.hpp"
#include "src/discretization/preload_cut.hpp"
#include "src/discretization/rigid_part.hpp"
#include "src/discretization/solution_structure.hpp"
#include "src/discretization/support_sets.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/support_components.hpp"
#include "src/plan/support_wrenches.hpp"

namespace abut {

namespace {

struct LoadedSystem {
    solver::PartSystem system;
    double load_scale = 0;
    EffectUses uses{};
};
LoadedSystem make_rigid(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g) {
    pull_displacements(scene, g);  // which a rigid part has none of
    PartLoad load = load_vector(scene, conditions, g);
    LoadedSystem made{{}, load.scale, std::move(load.uses)};
    MeteredCall call(made.uses, "rigid parts");
    made.system = rigid_system(scene, conditions, g, load);
    call.count(1);
    return made;
}

LoadedSystem make_system(const Scene& scene, const ResolvedConditions& conditions, PartOnGrid& g) {
    if (g.is_rigid) return make_rigid(scene, conditions, g);
    g.input.structure = make_structure(scene, conditions, g);
    if (g.input.structure) g.input.is_projected = false;  // they do not go together: a warning says so
    g.input.free_strain = free_strain(scene, g);
    g.input.pulls = pull_displacements(scene, g);
    for (const Load* load : preloads_on(scene, g.part))
        g.cuts.push_back({g.frame.to_local(load->across[0]), g.frame.to_local(load->across[1])});
    PartLoad load = load_vector(scene, conditions, g);
    return {solver::make_part_system(g.input, support_sets(scene, conditions, g), std::move(load.vector), g.center, g.size,
                                     spring_sets(scene, conditions, g), load.weighted),
            load.scale, std::move(load.uses)};
}

/// A system that is there already, under other loads.
LoadedSystem loaded(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g,
                    const solver::PartSystem& system) {
    PartLoad load = load_vector(scene, conditions, g);
    LoadedSystem made{solver::with_loads(system, std::move(load.vector), load.weighted), load.scale, std::move(load.uses)};
    made.system.seconds = {};
    return made;
}

/// With dirichlet "aligned" every support of edges has to be imposed that way.
void require_aligned(const Scene& scene, const PartOnGrid& g, const solver::PartSystem& system) {
    for (const solver::SupportRecord& record : system.supports)
        if (scene.accuracy.dirichlet == "aligned" && record.method == solver::SupportMethod::nitsche)
            throw InputError(scene.supports[at(record.set.tag)].where,
                             "this support cannot be imposed by dropping functions: on part " + scene.parts[at(g.part)].name +
                                 " it " + record.why,
                             "set accuracy.dirichlet to \"auto\" or \"nitsche\"");
}

std::string at_place(const Vec2& x) {
    return "(" + number_text(x.x(), 6) + ", " + number_text(x.y(), 6) + ")";
}

/// Part, place and meaning of a system that cannot be solved.
std::string failure_of(const Scene& scene, const PartOnGrid& g, const solver::PartSystem& system) {
    const std::string where = system.failed_at ? ", near " + at_place(g.frame.to_global(system.failed_at->at)) : "";
    return "part " + scene.parts[at(g.part)].name + where + ": " + system.failure;
}

/// Pieces that are less than a cell apart would hold each other in the splines. Empty: the part is one body, or rigid, or each
/// piece is held.
std::string loose_piece(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& g) {
    // a structure of the solution holds points, too
    const std::optional<Vec2> loose =
        g.is_rigid || g.input.structure ? std::nullopt : piece_not_held(scene, conditions, g.part);
    if (!loose) return "";
    const ScenePart& part = scene.parts[at(g.part)];
    return "part " + part.name + " consists of " + std::to_string(count_pieces(part.part)) +
           " separate pieces, and supports of its own edges do not hold each of them (points, bonds and contacts do not "
           "count); that at " +
           at_place(*loose) + " is free: make every piece a part, or support it";
}

/// What the system's own code spent on its effects.
EffectUses uses_of(const solver::PartSystem& system) {
    EffectUses uses;
    const auto& s = system.seconds;
    long points = 0;
    for (const solver::SpringSet& set : system.springs) points += static_cast<long>(set.points.size());
    if (points > 0) uses["springs"] = {s.springs, points};
    if (system.body) return uses;
    uses["elasticity"] = {s.all - s.springs - s.dilatation, 2L * system.n()};
    if (system.input.dilatation) uses["incompressibility"] = {s.dilatation, system.input.dilatation->space.n_functions};
    return uses;
}

/// Does a support of this kind hold the part?
bool is_held_by(const Scene& scene, Support::Kind kind, const PartOnGrid& g) {
    return std::any_of(scene.supports.begin(), scene.supports.end(),
                       [&](const Support& s) { return s.kind == kind && s.part == scene.parts[at(g.part)].name; });
}

/// Rigid supports and held points of one part.
void append_constraints(const Scene& scene, const ResolvedConditions& conditions, std::size_t part, SolvedAssembly& solved) {
    const PartOnGrid& g = solved.grids[part];
    if (g.is_rigid) return;
    const int index = static_cast<int>(part);
    const auto append = [&](Support::Kind kind, const char* effect, const auto& made) {
        if (!is_held_by(scene, kind, g)) return;
        MeteredCall call(solved.uses, effect);
        for (solver::MeanConstraint& c : made()) {
            solved.problem.constraints.push_back(std::move(c));
            call.count(1);
        }
    };
    append(Support::Kind::rigid, "rigid supports", [&] { return mean_constraints(scene, g, index); });
    append(Support::Kind::points, "held points", [&] { return point_constraints(scene, conditions, g, index); });
}

/// Parts are made side by side, each on its share of the threads; in turn, on all threads each, where the largest part would
/// keep the others waiting.
struct SharedThreads {
    int side_by_side, each;
};

SharedThreads shared_threads(const std::vector<PartOnGrid>& grids, int threads) {
    constexpr double much_more = 1.25;  // than a thread's share: what threads within a part lose
    double largest = 0, all = 0;
    for (const PartOnGrid& g : grids) {
        const double size = g.is_rigid || g.model >= 0 ? 0 : g.input.space.n_functions;
        largest = std::max(largest, size);
        all += size;
    }
    if (largest * threads > much_more * all) return {1, threads};
    return {threads, std::max(1, threads / std::max(1, static_cast<int>(grids.size())))};
}

/// Those of one part, which no load changes, from an assembly that has them.
void append_known_constraints(const Scene& scene, const SolvedAssembly& known, std::size_t part, SolvedAssembly& solved) {
    const int there = known.solver_part[at(solved.grids[part].part)];
    for (const solver::MeanConstraint& c : known.problem.constraints) {
        if (c.part != there) continue;
        solved.problem.constraints.push_back(c);
        solved.problem.constraints.back().part = static_cast<int>(part);
        ++solved.uses[effect_of(scene.supports[at(c.tag)])].items;
    }
}

/// Takes them in, with what they say of themselves. known: of the same supports, or null.
void take_systems(const Scene& scene, const ResolvedConditions& conditions, std::vector<LoadedSystem> made,
                  const SolvedAssembly* known, SolvedAssembly& solved) {
    for (std::size_t i = 0; i < made.size(); ++i) {
        PartOnGrid& g = solved.grids[i];
        solved.problem.load_scale = std::max(solved.problem.load_scale, made[i].load_scale);
        solved.problem.part_load.push_back(made[i].load_scale);
        solved.problem.parts.push_back(std::move(made[i].system));
        const solver::PartSystem& system = solved.problem.parts.back();
        add_uses(solved.uses, made[i].uses);
        add_uses(solved.uses, uses_of(system));
        g.input.dilatation = system.input.dilatation;
        require_aligned(scene, g, system);
        if (!system.failure.empty()) solved.failure = failure_of(scene, g, system);
        if (std::string loose = loose_piece(scene, conditions, g); !loose.empty()) solved.failure = std::move(loose);
        if (known)
            append_known_constraints(scene, *known, i, solved);
        else
            append_constraints(scene, conditions, i, solved);
    }
}

}  // namespace

void make_systems(const Scene& scene, const ResolvedConditions& conditions, int threads, SolvedAssembly& solved) {
    std::vector<LoadedSystem> made(solved.grids.size());
    const SharedThreads shared = shared_threads(solved.grids, threads);
    for (PartOnGrid& g : solved.grids) g.input.threads = shared.each;
    solver::parallel_for(static_cast<int>(made.size()), shared.side_by_side, [&](int i) {
        if (!has_factor_of_model(solved, at(i))) made[at(i)] = make_system(scene, conditions, solved.grids[at(i)]);
    });
    solver::parallel_for(static_cast<int>(made.size()), threads, [&](int i) {
        if (!has_factor_of_model(solved, at(i))) return;
        const PartOnGrid& g = solved.grids[at(i)];
        const solver::PartSystem& system = made[at(solved.solver_part[at(g.model)])].system;
        made[at(i)] = system.failure.empty() ? loaded(scene, conditions, g, system) : LoadedSystem{system};
    });
    take_systems(scene, conditions, std::move(made), nullptr, solved);
}

void load_systems(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& prepared, int threads,
                  SolvedAssembly& solved) {
    std::vector<LoadedSystem> made(solved.grids.size());
    solver::parallel_for(static_cast<int>(made.size()), threads, [&](int i) {
        PartOnGrid& g = solved.grids[at(i)];
        const solver::PartSystem& system = prepared.problem.parts[at(prepared.solver_part[at(g.part)])];
        if (g.is_rigid || g.input.free_strain || free_strain(scene, g) || !system.failure.empty()) {
            made[at(i)] = make_system(scene, conditions, g);
            return;
        }
        made[at(i)] = loaded(scene, conditions, g, system);
    });
    take_systems(scene, conditions, std::move(made), &prepared, solved);
}

}  // namespace abut
