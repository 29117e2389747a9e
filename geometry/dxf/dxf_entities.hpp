// SPDX-License-Identifier: GPL-3.0-or-later
// From the records of outlines to curves.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "geometry/curves/curve.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// The curves of one entity, or why it cannot be read.
struct Outline {
    std::vector<Curve> curves;
    bool is_in_pieces = false;  ///< is each curve a piece with a number of its own (polylines, splines with corners)?
    std::string wrong;          ///< what makes the entity unreadable, as one line for the user; empty if nothing does
};

/// The curves of records[i], a LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE (its vertices follow it) or SPLINE, in the
/// coordinates that the record stands in. An entity shrunk to a point is a segment of no length. z is dropped.
Outline read_outline(std::span<const Record> records, std::size_t i);

/// The least and the largest z of what an outline is drawn through, likewise.
struct Heights {
    double least = 0, largest = 0;
};
Heights heights_of(std::span<const Record> records, std::size_t i);

/// The piece of a polyline from one vertex to the next; bulge: tan(sweep / 4), positive counter-clockwise.
Curve from_bulge(const Vec2& from, const Vec2& to, double bulge);

/// Are its coordinates those of a plane of its own, given by its normal? Lines, splines and three-dimensional polylines use the
/// drawing's, and ellipses do but for the side of their second axis.
bool has_own_plane(const Record& entity);
/// Does it have a plane of its own with a normal that points down?
bool is_seen_from_below(const Record& entity);

/// First point that the record states, for messages; what is missing is 0.
Vec2 first_point(const Record& record);

}  // namespace abut::geometry::dxf
