// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/part_results.hpp"

#include <cmath>

#include "src/base/index.hpp"
#include "src/discretization/cut_quality.hpp"

namespace abut {

namespace {

void count_cells(const PartOnGrid& g, PartResult& part) {
    for (geometry::CellClass c : g.cells.cell_class)
        ++(c == geometry::CellClass::inner      ? part.cells_inner
           : c == geometry::CellClass::boundary ? part.cells_boundary
                                                : part.cells_outer);
}

/// Cells that were halved, and none of whose quarters was; their neighbours and all above them follow.
std::vector<PartResult::Halved> halved_cells(const PartOnGrid& g) {
    std::vector<PartResult::Halved> boxes;
    const geometry::Grid& grid = g.cells.grid;
    for (int node = 0; grid.tree && node < grid.tree->n_nodes(); ++node) {
        if (grid.tree->is_leaf(node)) continue;
        const int first = grid.tree->first_child(node);
        bool is_last = true;
        for (int k = 0; k < 4; ++k) is_last = is_last && grid.tree->is_leaf(first + k);
        if (!is_last) continue;
        const int low = grid.tree->leaf_of(first), high = grid.tree->leaf_of(first + 3);
        boxes.push_back(
            {grid.box(low).min + g.frame.shift, grid.box(high).max + g.frame.shift, grid.tree->cell(node).level + 1});
    }
    return boxes;
}

void fill_grid(const PartOnGrid& g, PartResult& part) {
    part.unknowns = 2 * g.input.space.n_functions;
    part.grid_angle = std::atan2(g.frame.s, g.frame.c);
    for (double v : g.cells.grid.x) part.grid_x.push_back(v + g.frame.shift.x());
    for (double v : g.cells.grid.y) part.grid_y.push_back(v + g.frame.shift.y());
    part.halved = halved_cells(g);
    count_cells(g, part);
    part.quality = cut_quality(g);
}

}  // namespace

void fill_parts(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        PartResult part;
        part.name = scene.parts[i].name;
        part.material = scene.materials[at(scene.parts[i].material)].name;
        part.level = scene.parts[i].level;
        part.area = area(scene.parts[i].part);
        part.solved = !solved.solver_part.empty() && solved.solver_part[i] >= 0;
        part.rigid = part.solved && solved.grids[at(solved.solver_part[i])].is_rigid;
        if (part.solved && !part.rigid) fill_grid(solved.grids[at(solved.solver_part[i])], part);
        result.unknowns += part.unknowns;
        result.cells[0] += part.cells_inner;
        result.cells[1] += part.cells_boundary;
        result.cells[2] += part.cells_outer;
        result.parts.push_back(std::move(part));
        result.geometry.push_back(scene.parts[i].part);
        result.fields.emplace_back();
    }
}

}  // namespace abut
