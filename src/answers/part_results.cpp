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

void fill_grid(const PartOnGrid& g, PartResult& part) {
    part.unknowns = 2 * g.input.space.n_functions;
    part.grid_angle = std::atan2(g.frame.s, g.frame.c);
    for (double v : g.cells.grid.x) part.grid_x.push_back(v + g.frame.shift.x());
    for (double v : g.cells.grid.y) part.grid_y.push_back(v + g.frame.shift.y());
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
