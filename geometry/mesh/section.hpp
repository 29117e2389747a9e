// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes cut by a plane, and the cut recovered as lines and arcs.
#pragma once
#include "geometry/mesh/mesh.hpp"
#include "geometry/mesh/section_plane.hpp"

namespace abut::geometry {

/// Default tolerance of lines and arcs, as a fraction of the diagonal of a body's section: vertices of facets lie on the true
/// circle but for the rounding of single precision and of six digits in text. Never below least_arc_fraction.
inline constexpr double arc_fraction = 1e-5;
inline constexpr double least_arc_fraction = 1e-6;

/// The plane of a choice (section_plane.hpp) for these bodies; of an empty choice the one that is cut at by default.
SectionPlane plane_of(const SectionChoice& choice, const std::vector<Mesh>& bodies);

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
