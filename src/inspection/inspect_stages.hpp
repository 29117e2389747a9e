// SPDX-License-Identifier: GPL-3.0-or-later
// What an analysis begins with, and its pictures: the first grids with their cells and clipped boundaries, and the facing
// zones.
#pragma once
#include <string>
#include <vector>

#include "src/contact/candidates.hpp"
#include "src/discretization/part_grid.hpp"
#include "src/inspection/inspect.hpp"
#include "src/inspection/inspect_page.hpp"

namespace abut::inspect {

/// A part's first grid and its cells.
struct PartCells {
    Frame frame;  ///< of the grid
    geometry::CutCells cells;
    bool is_limited = false;  ///< the grid is coarser than wanted, to bound the number of cells
};

/// The first stages of an analysis.
struct Stages {
    std::vector<Candidate> candidates;
    std::vector<PartCells> parts;  ///< by scene part
};

/// The candidates and grids of an analysis before a basis that cannot be made halves any cells. Drawn overlaps are no fault
/// here. Throws InputError where the scene asks for an impossible grid.
Stages first_stages(const Scene& scene);

/// Pictures of the cells, of the pieces of the boundary that they clip, and of the candidates for contact.
std::string cells_svg(const Inspection& inspection, const Stages& stages);
std::string pieces_svg(const Inspection& inspection, const Stages& stages);
std::string candidates_svg(const Inspection& inspection, const Stages& stages);

/// Paths of all parts, pale.
std::string pale_parts(const Scene& scene, const View& view);
/// A crossing of a part's grid lines, in picture coordinates.
Vec2 grid_point(const PartCells& part, std::size_t column, std::size_t row, const View& view);
/// Path data of one cell's outline.
std::string cell_outline(const PartCells& part, int cell, const View& view);
/// Path data of the lines of a part's grid: the sides of cells that hold material, or those of the others.
std::string grid_line_data(const PartCells& part, bool with_material, const View& view);
/// The box of all parts and, where `grids` is set, of their grids.
Box2 box_of_stages(const Scene& scene, const Stages& stages, bool grids);

}  // namespace abut::inspect
