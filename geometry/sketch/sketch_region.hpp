// SPDX-License-Identifier: GPL-3.0-or-later
// The area inside a closed chain, while it is decided whether it is material.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/sketch/sketch_faces.hpp"

namespace abut::geometry {

/// What answers fast where a point lies, of regions that are asked.
struct RegionFinder {
    EdgeTree tree;
    SlabbedPieces pieces;
};

/// A closed chain as a part without holes, run counter-clockwise.
struct Region {
    Part outline;
    std::vector<int> entity;  ///< by edge
    Box2 box;
    double area = 0;
    int first_entity = 0;
    int divided = -1;  ///< the divided outline that it is an area of; -1: none
    bool is_face_filled = true;
    bool is_overlaid = false;  ///< drawn over other outlines, whose hole it is not
    int around = -1;           ///< the region directly around it
    bool is_filled = false;
    bool is_doubtful = false;
    bool is_chosen = false;                          ///< does the user say what it is?
    std::string joins{};                             ///< the region that it is one part with, where the user says so: "r3"
    std::string name{};                              ///< of the part, where the user gave one
    std::vector<int> hatches{};                      ///< that it lies in, by their place among the drawing's
    mutable std::unique_ptr<RegionFinder> finder{};  ///< made when first asked
};

/// The region inside a chain.
Region region_of(const std::vector<SketchPiece>& entities, const EntityChain& chain);
/// Runs the same boundary the other way; the first edge stays first.
void turn(Region& region);
/// What answers for the region, made when first asked.
const RegionFinder& finder_of(const Region& region);
/// Is the point within the tolerance of the region's boundary?
bool is_on_boundary(const Region& region, const Vec2& p, double tolerance);

/// A point of the region outside of those that it is directly around, clear of the boundaries as far as a few trials find.
/// Where none is found: the middle of its first edge.
std::vector<Vec2> inner_points(const std::vector<Region>& regions);

}  // namespace abut::geometry
