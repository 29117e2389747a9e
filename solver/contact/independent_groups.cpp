// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/independent_groups.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// Union-find by the smallest member.
int root_of(std::vector<int>& parent, int i) {
    while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
    return i;
}

/// Indices into the whole problem of what a group has.
struct Members {
    std::vector<int> parts, interfaces, constraints;
};

std::vector<Members> members_of(const AssemblyProblem& problem) {
    std::vector<Members> groups;
    std::vector<int> group_of(problem.parts.size());
    for (const std::vector<int>& parts : independent_groups(problem)) {
        for (int part : parts) group_of[at(part)] = static_cast<int>(groups.size());
        groups.push_back({parts, {}, {}});
    }
    for (std::size_t k = 0; k < problem.interfaces.size(); ++k)
        groups[at(group_of[at(problem.interfaces[k].part[0])])].interfaces.push_back(static_cast<int>(k));
    for (std::size_t k = 0; k < problem.constraints.size(); ++k)
        groups[at(group_of[at(problem.constraints[k].part)])].constraints.push_back(static_cast<int>(k));
    return groups;
}

/// Moves between the whole problem and a group's own, and back.
struct Mover {
    AssemblyProblem& whole;
    const Members& members;
    AssemblyProblem own{};

    void take() {
        std::vector<int> number(whole.parts.size(), -1);
        for (int part : members.parts) {
            number[at(part)] = static_cast<int>(own.parts.size());
            own.parts.push_back(std::move(whole.parts[at(part)]));
            own.load_scale = std::max(own.load_scale, whole.part_load[at(part)]);
            own.path_tolerance = whole.path_tolerance;
            own.is_way_before_broken = whole.is_way_before_broken;
            own.drops_imbalance = whole.drops_imbalance;
            own.begins_touching = whole.begins_touching;
            if (!whole.before.empty()) own.before.push_back(whole.before[at(part)]);
            if (!whole.near.empty()) own.near.push_back(whole.near[at(part)]);
        }
        for (int k : members.interfaces) {
            own.interfaces.push_back(std::move(whole.interfaces[at(k)]));
            for (int& part : own.interfaces.back().part) part = number[at(part)];
            own.foundation.push_back(whole.foundation[at(k)]);
            own.own_normals.push_back(std::move(whole.own_normals[at(k)]));
        }
        for (int k : members.constraints) {
            own.constraints.push_back(std::move(whole.constraints[at(k)]));
            own.constraints.back().part = number[at(own.constraints.back().part)];
        }
    }

    void give_back() {
        for (std::size_t i = 0; i < own.parts.size(); ++i) whole.parts[at(members.parts[i])] = std::move(own.parts[i]);
        for (std::size_t i = 0; i < own.interfaces.size(); ++i) {
            for (int& part : own.interfaces[i].part) part = members.parts[at(part)];
            whole.interfaces[at(members.interfaces[i])] = std::move(own.interfaces[i]);
            whole.own_normals[at(members.interfaces[i])] = std::move(own.own_normals[i]);
        }
        for (std::size_t i = 0; i < own.constraints.size(); ++i) {
            own.constraints[i].part = members.parts[at(own.constraints[i].part)];
            whole.constraints[at(members.constraints[i])] = std::move(own.constraints[i]);
        }
    }
};

template <class T>
void scatter(std::vector<T>&& from, const std::vector<int>& to_index, std::vector<T>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[at(to_index[i])] = std::move(from[i]);
}

void append_motions(const std::vector<PartMotion>& from, const Members& members, std::vector<PartMotion>& to) {
    for (PartMotion motion : from) {
        motion.part = members.parts[at(motion.part)];
        to.push_back(motion);
    }
}

void add_seconds(const SolveSeconds& from, SolveSeconds& to) {
    to.rows += from.rows;
    to.condensation += from.condensation;
    to.contact += from.contact;
    to.displacements += from.displacements;
}

/// Steps of groups that were solved side by side: their shares of the wall time.
void scale_to_wall(double wall, SolveSeconds& s) {
    const double sum = s.rows + s.condensation + s.contact + s.displacements;
    if (!(sum > wall)) return;
    for (double* step : {&s.rows, &s.condensation, &s.contact, &s.displacements}) *step *= wall / sum;
}

void merge(AssemblySolution&& from, const Members& members, AssemblySolution& to) {
    scatter(std::move(from.displacement), members.parts, to.displacement);
    scatter(std::move(from.load), members.parts, to.load);
    scatter(std::move(from.contact_load), members.parts, to.contact_load);
    scatter(std::move(from.pressure), members.interfaces, to.pressure);
    scatter(std::move(from.constraint_force), members.constraints, to.constraint_force);
    if (!from.friction.empty()) {
        to.friction.resize(to.pressure.size());
        scatter(std::move(from.friction), members.interfaces, to.friction);
    }
    to.increments = std::max(to.increments, from.increments);
    if (!from.amplitudes.empty()) {
        to.amplitudes.resize(to.displacement.size());
        scatter(std::move(from.amplitudes), members.parts, to.amplitudes);
    }
    append_motions(from.neutral, members, to.neutral);
    append_motions(from.mechanism, members, to.mechanism);
    append_motions(from.sliding, members, to.sliding);
    to.holding_factor = std::max(to.holding_factor, from.holding_factor);
    to.is_way_broken = to.is_way_broken || from.is_way_broken;
    to.is_one_of_several = to.is_one_of_several || from.is_one_of_several;
    add_outcome(from, to);
    add_seconds(from.seconds, to.seconds);
}

}  // namespace

std::vector<std::vector<int>> independent_groups(const AssemblyProblem& problem) {
    const auto n = static_cast<int>(problem.parts.size());
    std::vector<int> parent(problem.parts.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const Interface& face : problem.interfaces) {
        const int a = root_of(parent, face.part[0]), b = root_of(parent, face.part[1]);
        parent[at(std::max(a, b))] = std::min(a, b);
    }
    std::vector<std::vector<int>> groups;
    std::vector<int> group_of(parent.size(), -1);
    for (int i = 0; i < n; ++i) {
        int& group = group_of[at(root_of(parent, i))];
        if (group < 0) {
            group = static_cast<int>(groups.size());
            groups.emplace_back();
        }
        groups[at(group)].push_back(i);
    }
    return groups;
}

void add_outcome(const AssemblySolution& from, AssemblySolution& to) {
    to.n_multipliers += from.n_multipliers;
    to.iterations += from.iterations;
    to.contact_problems += from.contact_problems;
    to.converged = to.converged && from.converged;
    to.used_fallback = to.used_fallback || from.used_fallback;
    to.residual = std::max(to.residual, from.residual);
}

AssemblySolution solve_groups(AssemblyProblem& problem, int threads) {
    const std::vector<Members> groups = members_of(problem);
    if (groups.size() < 2 || problem.part_load.empty()) return solve_assembly(problem, threads);
    AssemblySolution whole;
    whole.groups = static_cast<int>(groups.size());
    whole.displacement.resize(problem.parts.size());
    whole.load.resize(problem.parts.size());
    whole.contact_load.resize(problem.parts.size());
    whole.pressure.resize(problem.interfaces.size());
    whole.constraint_force.resize(problem.constraints.size());
    whole.converged = true;
    const auto begin = std::chrono::steady_clock::now();
    std::vector<AssemblySolution> own(groups.size());
    // groups are disjoint: side by side they touch nothing in common
    const bool side_by_side = static_cast<int>(groups.size()) >= threads;
    parallel_for(static_cast<int>(groups.size()), side_by_side ? threads : 1, [&](int i) {
        Mover mover{problem, groups[at(i)]};
        mover.take();
        own[at(i)] = solve_assembly(mover.own, side_by_side ? 1 : threads);
        mover.give_back();
    });
    for (std::size_t i = 0; i < groups.size(); ++i) merge(std::move(own[i]), groups[i], whole);
    scale_to_wall(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), whole.seconds);
    return whole;
}

}  // namespace abut::solver
