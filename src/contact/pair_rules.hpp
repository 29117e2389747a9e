// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's rules for pairs of edges: which stretches of a zone fall under which.
#pragma once
#include <array>
#include <set>
#include <vector>

#include "geometry/proximity/facing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// The edges that the rules name, looked up once for all zones. Throws InputError where a rule names none.
class PairRules {
public:
    explicit PairRules(const Scene& scene);
    bool none() const { return edges_.empty(); }
    /// The index into ContactOptions::pairs of the last rule that speaks of a pair of edges, or -1: later rules are for
    /// exceptions.
    int of(int part1, int edge1, int part2, int edge2) const;
    /// The last later rule that speaks of pairs of edges which rule r speaks of, or -1.
    int later_than(int r) const;

private:
    using Edges = std::set<std::array<int, 2>>;  // part, edge
    std::vector<std::array<Edges, 2>> edges_;
};

/// A zone, or a stretch of one, with the rule that it falls under (-1: none).
struct RuledZone {
    geometry::FacingZone zone;
    int rule;
};

/// Cuts a zone where the rules change for the edges that it runs over.
std::vector<RuledZone> split_by_rules(const Scene& scene, const PairRules& rules, int first, int second,
                                      const geometry::FacingZone& zone);

}  // namespace abut
