// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/rigid_pairs.hpp"

#include <algorithm>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

constexpr int sampled_pairs = 200;  // along a candidate between rigid parts
/// Rigid faces that overlap by more than this fraction of the smaller diagonal press on each other.
constexpr double pressed_fraction = 1e-6;

/// How deep two rigid parts overlap along a candidate after the solution.
double depth_of(const Scene& scene, const SolvedAssembly& solved, const Candidate& c) {
    const std::array<int, 2> parts{c.first, c.second};
    double deepest = 0, guess = c.zone.begin2;
    for (int k = 0; k <= sampled_pairs; ++k) {
        const double t = static_cast<double>(k) / sampled_pairs;
        const auto pair = pair_from_first(scene.parts[at(c.first)].part, scene.parts[at(c.second)].part, c.zone,
                                          (1 - t) * c.zone.begin1 + t * c.zone.end1, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        double gap = pair.gap - c.closing();
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t i = at(solved.solver_part[at(parts[side])]);
            const PartOnGrid& g = solved.grids[i];
            const Vec2 x = g.frame.to_local(side == 0 ? pair.on1.x : pair.on2.x);
            const auto u = solver::displacement_at(g.input, solved.solution.displacement[i],
                                                   element_at(g.local, g.cells, g.elements, x), x);
            gap += (side == 0 ? -1 : 1) * pair.normal.dot(g.frame.vector_to_global(u.value));
        }
        deepest = std::max(deepest, -gap);
    }
    return deepest;
}

bool are_rigid(const SolvedAssembly& solved, const Candidate& c) {
    const auto is_rigid = [&](int part) {
        const int i = solved.solver_part[at(part)];
        return i >= 0 && solved.grids[at(i)].is_rigid;
    };
    return is_rigid(c.first) && is_rigid(c.second);
}

}  // namespace

std::string rigid_stops(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& solved) {
    const auto moves = [&](int part) {
        return std::any_of(solved.solution.mechanism.begin(), solved.solution.mechanism.end(),
                           [&](const solver::PartMotion& m) { return m.part == solved.solver_part[at(part)]; });
    };
    for (const Candidate& c : candidates)
        if (are_rigid(solved, c) && (moves(c.first) || moves(c.second)))
            return scene.parts[at(c.first)].name + " and " + scene.parts[at(c.second)].name +
                   " face each other, but both are rigid, and no pressure follows between rigid parts: make one of them "
                   "elastic";
    return "";
}

std::string rigid_pair_failure(const Scene& scene, const std::vector<Candidate>& candidates, const SolvedAssembly& solved) {
    for (const Candidate& c : candidates) {
        if (!are_rigid(solved, c)) continue;
        const int a = solved.solver_part[at(c.first)], b = solved.solver_part[at(c.second)];
        const double size = std::min(solved.grids[at(a)].size, solved.grids[at(b)].size);
        const double depth = depth_of(scene, solved, c);
        if (depth > pressed_fraction * size)
            return "the rigid parts " + scene.parts[at(c.first)].name + " and " + scene.parts[at(c.second)].name +
                   " are pushed into each other by " + number_text(depth, 3) +
                   ": no pressure follows between rigid parts. Make one of them elastic";
    }
    return "";
}

}  // namespace abut
