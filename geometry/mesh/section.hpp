// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes cut by a plane, and the cut recovered as lines and arcs.
#pragma once
#include <optional>

#include "geometry/mesh/mesh.hpp"

namespace abut::geometry {

/// The plane coordinate `axis` (0 x, 1 y, 2 z) = at. In it z gives (x, y), x gives (y, z), y gives (x, z).
struct SectionPlane {
    int axis = 2;
    double at = 0;
};

/// Default tolerance of lines and arcs, as a fraction of the diagonal of a body's section: vertices of facets lie on the true
/// circle but for the rounding of single precision and of six digits in text. Never below least_arc_fraction.
inline constexpr double arc_fraction = 1e-5;
inline constexpr double least_arc_fraction = 1e-6;
/// A face whose vertices are all closer to the plane than this fraction of the diagonal of all bodies lies in it.
inline constexpr double face_band_fraction = 1e-6;
/// One step off such faces, as a fraction of the diagonal of all bodies; steps are tried on both sides in turn.
inline constexpr double nudge_fraction = 1e-5;
inline constexpr int most_nudges = 64;

/// The plane that is cut at where none is given: the middle of the thinnest direction of all bodies together; of directions
/// equally thin z, else y.
SectionPlane default_plane(const std::vector<Mesh>& bodies);

/// Bodies cut by a plane, as a drawing.
struct Section {
    Drawing drawing;
    SectionPlane plane;  ///< the plane that was cut at
    /// What was mended: the plane moved (size: how far), arcs recovered (size: residual), cracks closed (size: gap), what is
    /// wrong with the mesh of a body away from the plane (size 0), and the repairs of the mesh file.
    std::vector<Repair> repairs;
};

/// The choices of a cut of meshes.
struct SectionOptions {
    double tolerance = 0;        ///< of arcs; 0: arc_fraction of the body's section
    bool recognise_arcs = true;  ///< facets that are arcs within the tolerance, or stand for a curve, become arcs
};

/// Cuts all bodies into a drawing: one layer per body, named after it, with lines and arcs `e0`, `e1`, ... in order along each
/// loop. A plane that runs along faces of a body is moved off them by a fraction of the size, and a repair says so. Sections
/// that do not close (holes in the mesh) are problems with place; the problems of such a body's mesh join them. Facets of
/// circles (arc_fit.hpp) and of other curves (arc_fit_curves.hpp) become arcs, unless these would cross another boundary that
/// the facets do not (section_bulges.hpp; a repair says so); the largest distance of the section's vertices from an arc is a
/// repair's size. Bodies that the plane does not meet are counted as ignored; that it meets none is a problem. Bodies with
/// coordinates that are no numbers, or triangles of vertices that are not there, are problems. Cost O(n log n).
Section cut(const MeshFile& mesh, const SectionPlane& plane, const SectionOptions& options);
/// Cuts all bodies with arcs recognised (tolerance: SectionOptions::tolerance).
Section cut(const MeshFile& mesh, const SectionPlane& plane, double tolerance);
/// The drawing of cut() with arcs recognised.
Drawing section(const MeshFile& mesh, const SectionPlane& plane, double tolerance);

}  // namespace abut::geometry
