// SPDX-License-Identifier: GPL-3.0-or-later
// Grids that are each other's mirror images, for scenes that are solved on the half (solver/parts/fold.hpp).
#pragma once
#include <string>

#include "src/discretization/part_grid.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Moves the inner lines of a part that is its own image to where their images are.
void make_symmetric(const MirrorLine& mirror, PartGrid& grid);

/// Grid of a part whose image is on a grid already.
PartGrid mirrored_grid(const Scene& scene, int part, const PartOnGrid& image, const MirrorLine& mirror);

/// Tells all parts what their images are. Empty: done; else which part has no image on its
/// grid, and why; then no part is told anything.
std::string set_mirrors(const Scene& scene, const MirrorLine& mirror, SolvedAssembly& solved);

/// Closed zones begin on the mirror line, where the gap is larger, or where their images begin: their pressures' knots are then
/// each other's images.
void put_seams_on_mirror(const Scene& scene, const MirrorLine& mirror, std::vector<Candidate>& candidates);

}  // namespace abut
