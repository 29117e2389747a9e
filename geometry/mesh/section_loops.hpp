// SPDX-License-Identifier: GPL-3.0-or-later
// The plane section of one body as closed polylines.
#pragma once
#include "geometry/mesh/section.hpp"

namespace abut::geometry {

/// Cracks of a section narrower than this fraction of its diagonal are closed.
inline constexpr double crack_fraction = joining_fraction;
/// A turn below this angle, radians, within the rounding of single precision is no corner: the section crosses an edge between
/// two triangles of one plane face.
inline constexpr double flat_turn = 1e-3;

/// A place where a section does not close, or did not before its crack was closed.
struct SectionGap {
    Vec2 from, to;  ///< an end of the section, and the nearest beginning (or itself, if there is none)
};

/// The section of one body as polylines.
struct SectionLoops {
    std::vector<std::vector<Vec2>> loops;  ///< closed, material on the left, without points within plane faces
    std::vector<SectionGap> open;          ///< chains that do not close (left out of `loops`)
    std::vector<SectionGap> closed_cracks;
    Box2 box;  ///< of all of it
};

/// The section of one body by a plane, its points in the plane as SectionPlane says. Vertices on the plane count as above it,
/// so that every triangle crosses it in one segment or not at all. The body's indices must be valid. Loops begin at their first
/// triangle. Cost O(n log n), and O(open ends^2).
SectionLoops section_loops(const Mesh& body, const SectionPlane& plane);

}  // namespace abut::geometry
