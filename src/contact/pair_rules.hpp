// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's rules for pairs of edges: which stretches of a zone fall under which.
#pragma once
#include <array>
#include <vector>

#include "geometry/proximity/facing.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// A place on a part's boundary: indices into Scene::parts and Part::edges, and the parameter of the edge's curve.
struct BoundaryPlace {
    int part, edge;
    double t;
};

/// The portions of edges that the rules are for.
class PairRules {
public:
    explicit PairRules(const Scene& scene);
    bool none() const { return on_.empty(); }
    /// The index into ContactOptions::pairs of the last rule that speaks of a pair of places, or -1: later rules are for
    /// exceptions.
    int of(const BoundaryPlace& a, const BoundaryPlace& b) const;
    /// The last later rule that speaks of pairs of places which rule r speaks of, or -1.
    int later_than(int r) const;
    /// Parameters inside an edge where a portion begins or ends.
    std::vector<double> ends_on(int part, int edge) const;

private:
    std::vector<std::array<std::vector<EdgePortion>, 2>> on_;
};

/// A zone, or a stretch of one, with the rule that it falls under (-1: none).
struct RuledZone {
    geometry::FacingZone zone;
    int rule;
};

/// Cuts a zone where the rules change along it.
std::vector<RuledZone> split_by_rules(const Scene& scene, const PairRules& rules, int first, int second,
                                      const geometry::FacingZone& zone);

}  // namespace abut
