// SPDX-License-Identifier: GPL-3.0-or-later
// Areas that are one part: the lines between them are drawn on it and bound nothing.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_material.hpp"

namespace abut::geometry {

/// A closed boundary, with the entity of each edge.
struct JoinedLoop {
    std::vector<Edge> edges;
    std::vector<int> entity;
};

/// A part as areas that are one.
struct JoinedPart {
    std::vector<int> regions;       ///< ascending
    std::vector<JoinedLoop> loops;  ///< the outer one first; the part is on their left
};

/// Joins filled regions that share lines:
///   1. Those that the user calls by one name, or of which one is said to be the other ("r3").
///   2. Of those about which the user says nothing, those that are hatched alike on both sides of lines that are drawn once:
///   drawn twice (unless all is), they are the outlines of two parts.
/// What is joined for its hatches is told and doubtful; told, too, is one hatch over areas that lie apart, which are not
/// joined. `holes`: what lies inside regions, run clockwise about itself, each with the region `around` it. `named`: by region.
/// The parts are in the order of their first regions.
std::vector<JoinedPart> join_regions(const std::vector<Region>& regions, const std::vector<Region>& holes,
                                     const std::vector<SketchPiece>& entities, const std::vector<Hatch>& hatches,
                                     std::vector<SketchRegion>& named, std::vector<SketchProblem>& warnings);

}  // namespace abut::geometry
