// SPDX-License-Identifier: GPL-3.0-or-later
// Random trees of primitives on a coarse lattice, so that edges, corners and tangents coincide often, and who belongs to them
// by the primitives' own definitions.
#pragma once
#include <random>
#include <string>

#include "geometry/csg/csg.hpp"

namespace abut::geometry {

/// Which kinds of leaves a scene may hold.
enum class Leaves { lines_and_circles, all };

/// Lattice points have integer coordinates from 0 to this.
inline constexpr int lattice_size = 8;

/// One to three leaves in a tree, names `p0`, `p1`, ... from `first_name` on, which is advanced.
CsgNode random_tree(std::mt19937& random, Leaves leaves, int& first_name);

/// The same node under one more placement.
CsgNode turned(CsgNode node, double rotate, const Vec2& translate);

/// Chords per curve of the polygon that stands for a loop's edge: such a polygon is off by less than 1e-4 of the curve's
/// length.
inline constexpr int n_chords = 100;
/// The same tree with fine polygons for `loops`, to ask many points of.
CsgNode with_polygons(const CsgNode& node);
/// Is p a point of the tree's set? By inequalities, polygons by counting crossings of a ray. `loops` must be polygons.
bool is_member(const CsgNode& node, const Vec2& p);

/// The tree for the user, to see what failed.
std::string tree_text(const CsgNode& node);

}  // namespace abut::geometry
