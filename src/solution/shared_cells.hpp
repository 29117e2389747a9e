// SPDX-License-Identifier: GPL-3.0-or-later
// Walls thinner than their cells, with contact on both sides: there two pressures act on the same splines, which follow half as
// many coefficients of each.
#pragma once
#include <map>
#include <vector>

#include "geometry/proximity/facing.hpp"
#include "src/discretization/discretize.hpp"

namespace abut {

/// The faces of contact in a part's cells: by cell the outward normals of the boundary's pieces there, local.
using FacesByCell = std::map<int, std::vector<Vec2>>;

/// Notes the cells that a stretch of a chain passes; it may run past a turn.
void note_faces(const PartOnGrid& g, const geometry::Chain& chain, double low, double high, FacesByCell& faces);

/// The number of faces, one or two, that press on the splines around a boundary point.
int faces_sharing(const PartOnGrid& g, const geometry::ChainPoint& p, const FacesByCell& faces);

}  // namespace abut
