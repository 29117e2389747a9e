// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/part_groups.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "solver/contact/independent_groups.hpp"
#include "src/base/index.hpp"
#include "src/plan/plan.hpp"

namespace abut {

namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// By part: the smallest part that it hangs together with.
std::vector<int> first_of_group(const Scene& scene, const std::vector<Candidate>& candidates) {
    std::vector<int> first(scene.parts.size());
    std::iota(first.begin(), first.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        const auto join = [&](int one, int other) {
            int &a = first[at(one)], &b = first[at(other)];
            changed = changed || a != b;
            a = b = std::min(a, b);
        };
        for (const Candidate& c : candidates) join(c.first, c.second);
    }
    return first;
}

void append_motions(std::vector<solver::PartMotion>& to, std::vector<solver::PartMotion>& from, int parts_before) {
    for (solver::PartMotion& motion : from) motion.part += parts_before;
    append(to, from);
}

void append_solution(solver::AssemblySolution& to, solver::AssemblySolution& from, int parts_before) {
    append(to.displacement, from.displacement);
    append(to.load, from.load);
    append(to.contact_load, from.contact_load);
    if (!from.friction.empty()) to.friction.resize(to.pressure.size());
    append(to.friction, from.friction);
    to.increments = std::max(to.increments, from.increments);
    append(to.pressure, from.pressure);
    append(to.constraint_force, from.constraint_force);
    to.holding_factor = std::max(to.holding_factor, from.holding_factor);
    to.is_way_broken = to.is_way_broken || from.is_way_broken;
    to.is_one_of_several = to.is_one_of_several || from.is_one_of_several;
    append_motions(to.neutral, from.neutral, parts_before);
    append_motions(to.mechanism, from.mechanism, parts_before);
    append_motions(to.sliding, from.sliding, parts_before);
    to.groups += from.groups;
    add_outcome(from, to);
}

void append_problem(solver::AssemblyProblem& to, solver::AssemblyProblem& from, int parts_before) {
    for (solver::Interface& face : from.interfaces)
        for (int& part : face.part) part += parts_before;
    for (solver::MeanConstraint& c : from.constraints) c.part += parts_before;
    append(to.parts, from.parts);
    append(to.interfaces, from.interfaces);
    append(to.constraints, from.constraints);
    append(to.foundation, from.foundation);
    append(to.own_normals, from.own_normals);
    append(to.part_load, from.part_load);
    to.load_scale = std::max(to.load_scale, from.load_scale);
}

/// Contacts keep the order in which they are appended.
void append_solved(SolvedAssembly& to, SolvedAssembly& from) {
    const int parts_before = static_cast<int>(to.grids.size());
    const int interfaces_before = static_cast<int>(to.problem.interfaces.size());
    for (ContactInterface& c : from.contacts)
        for (int& part : c.face.part) part += parts_before;
    for (std::vector<int>* index : {&from.interface_of, &from.shear_of})
        for (int& i : *index) i += i < 0 ? 0 : interfaces_before;
    for (std::size_t i = 0; i < to.solver_part.size(); ++i)
        if (from.solver_part[i] >= 0) to.solver_part[i] = from.solver_part[i] + parts_before;
    append(to.grids, from.grids);
    append(to.contacts, from.contacts);
    append(to.interface_of, from.interface_of);
    append(to.shear_of, from.shear_of);
    append(to.stretches, from.stretches);
    for (PreloadState& cut : from.preloads) cut.grid += parts_before;
    append(to.preloads, from.preloads);
    append_problem(to.problem, from.problem, parts_before);
    append_solution(to.solution, from.solution, parts_before);
    if (to.failure.empty()) {
        to.failure = from.failure;
        to.is_lost = from.is_lost;
    }
    to.refined_for_walls += from.refined_for_walls;
    to.limited_grids += from.limited_grids;
}

template <class T>
void take_larger(std::optional<T>& to, const std::optional<T>& from) {
    if (from && (!to || *from > *to)) to = from;
}

/// Contacts are appended.
void append_error(ErrorEstimate& to, const ErrorEstimate& from) {
    to.contacts.insert(to.contacts.end(), from.contacts.begin(), from.contacts.end());
    take_larger(to.contact_pressure, from.contact_pressure);
    take_larger(to.peak, from.peak);
    take_larger(to.energy, from.energy);
    take_larger(to.stress, from.stress);
    take_larger(to.largest_stress, from.largest_stress);
    to.own_energy.insert(to.own_energy.end(), from.own_energy.begin(), from.own_energy.end());
    to.moved.insert(to.moved.end(), from.moved.begin(), from.moved.end());
}

void append_pass(PassRecord& to, const PassRecord& from) {
    to.contacts.insert(to.contacts.end(), from.contacts.begin(), from.contacts.end());
    to.energy += from.energy;
    to.unknowns += from.unknowns;
    to.multipliers += from.multipliers;
    to.seconds = std::max(to.seconds, from.seconds);
}

/// Passes of several groups, the k-th with the k-th.
void merge_passes(const std::vector<Outcome>& groups, Outcome& whole) {
    std::size_t longest = 0;
    for (const Outcome& g : groups) longest = std::max(longest, g.passes.size());
    whole.passes.assign(longest, {});
    whole.errors.assign(longest, {});
    for (std::size_t k = 0; k < longest; ++k)
        for (const Outcome& g : groups) {
            const std::size_t own = std::min(k, g.passes.size() - 1);
            append_pass(whole.passes[k], g.passes[own]);
            append_error(whole.errors[k], g.errors[own]);
        }
}

template <class T>
void reorder(std::vector<T>& items, const std::vector<std::size_t>& order) {
    if (items.size() != order.size()) return;  // not solved: none are there
    std::vector<T> sorted;
    for (std::size_t k : order) sorted.push_back(std::move(items[k]));
    items = std::move(sorted);
}

/// Contacts in the order in which a search of the whole scene gives them.
void sort_contacts(Outcome& whole) {
    std::vector<std::size_t> order(whole.candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return comes_before(whole.candidates[a], whole.candidates[b]); });
    reorder(whole.candidates, order);
    reorder(whole.solved.contacts, order);
    reorder(whole.solved.interface_of, order);
    reorder(whole.solved.shear_of, order);
    reorder(whole.solved.stretches, order);
    reorder(whole.seen, order);
    for (ErrorEstimate& e : whole.errors) reorder(e.contacts, order);
}

/// The reason that asks most of a reader.
PathEnd worse(PathEnd a, PathEnd b) {
    return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

}  // namespace

std::vector<PartGroup> part_groups(const Scene& scene, const ResolvedConditions& conditions,
                                   const std::vector<Candidate>& candidates) {
    const std::vector<bool> solved =
        parts_to_solve(scene, conditions, touching_pairs(candidates), closing_pairs(scene, candidates));
    const std::vector<int> first = first_of_group(scene, candidates);
    std::vector<PartGroup> groups;
    std::vector<int> group_of(scene.parts.size(), -1);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        if (!solved[i]) continue;
        int& group = group_of[at(first[i])];
        if (group < 0) {
            group = static_cast<int>(groups.size());
            groups.emplace_back(scene.parts.size(), false);
        }
        groups[at(group)][i] = true;
    }
    if (groups.empty()) groups.emplace_back(scene.parts.size(), true);
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (!solved[i]) groups[0][i] = true;
    return groups;
}

Outcome merged(std::vector<Outcome> groups) {
    if (groups.size() == 1) return std::move(groups[0]);
    Outcome whole;
    merge_passes(groups, whole);
    whole.target = groups[0].target;
    whole.solved.solver_part.assign(groups[0].solved.solver_part.size(), -1);
    whole.solved.solution.converged = true;
    whole.solved.solution.groups = 0;
    for (Outcome& g : groups) {
        append_solved(whole.solved, g.solved);
        append(whole.candidates, g.candidates);
        append(whole.stress, g.stress);
        append(whole.largest, g.largest);
        append(whole.seen, g.seen);
        whole.factorizations += g.factorizations;
        whole.iterations += g.iterations;
        whole.end = worse(whole.end, g.end);
        if (g.end == PathEnd::out_of_budget) whole.next = g.next;
        if (whole.why.empty()) whole.why = g.why;
        whole.search_too_short = whole.search_too_short || g.search_too_short;
    }
    sort_contacts(whole);
    return whole;
}

}  // namespace abut
