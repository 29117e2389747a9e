// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/inspect_stages.hpp"

#include <utility>

#include "src/analysis/grading.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/accuracy_goal.hpp"

namespace abut::inspect {

namespace {

using geometry::CellClass;

/// Does one of two cells hold material? Columns and rows count from -1 (outside the grid) to their number.
bool holds_material(const PartCells& part, int column, int row) {
    const geometry::Grid& grid = part.cells.grid;
    return column >= 0 && row >= 0 && column < grid.columns() && row < grid.rows() &&
           part.cells.cell_class[at(grid.cell(column, row))] != CellClass::outer;
}

std::string move_and_line(const Vec2& a, const Vec2& b) {
    return "M" + coordinate_text(a.x()) + " " + coordinate_text(a.y()) + "L" + coordinate_text(b.x()) + " " +
           coordinate_text(b.y());
}

/// Sides on grid line `line` across the axis; runs of sides of one kind are one stroke.
void append_line(std::string& data, const PartCells& part, int axis, int line, bool with_material, const View& view) {
    const geometry::Grid& grid = part.cells.grid;
    const int n = axis == 0 ? grid.rows() : grid.columns();
    const auto is_wanted = [&](int k) {
        const bool holds = axis == 0 ? holds_material(part, line - 1, k) || holds_material(part, line, k)
                                     : holds_material(part, k, line - 1) || holds_material(part, k, line);
        return holds == with_material;
    };
    const auto corner = [&](int k) {
        return axis == 0 ? grid_point(part, at(line), at(k), view) : grid_point(part, at(k), at(line), view);
    };
    for (int k = 0; k < n;) {
        const int begin = k;
        while (k < n && is_wanted(k)) ++k;
        if (k > begin) data += move_and_line(corner(begin), corner(k));
        if (k == begin) ++k;
    }
}

}  // namespace

Stages first_stages(const Scene& scene) {
    Stages stages;
    stages.candidates = find_candidates_anyway(scene, 1);
    const double coarseness = coarseness_of(scene.accuracy, !stages.candidates.empty());
    const WantedSizes wanted = first_sizes(scene, stages.candidates, coarseness);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        PartGrid chosen = grid_of_part(scene, static_cast<int>(i), wanted[i], coarseness, 1);
        stages.parts.push_back({chosen.frame, cut_cells(chosen.local, chosen.grid), chosen.limited});
    }
    return stages;
}

std::string pale_parts(const Scene& scene, const View& view) {
    std::string svg;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        svg += path_element(path_data(scene.parts[i].part, view), "part",
                            " fill=\"" + part_color(static_cast<int>(i)) + "\" fill-opacity=\".3\"");
    return svg;
}

Vec2 grid_point(const PartCells& part, std::size_t column, std::size_t row, const View& view) {
    return view(part.frame.to_global({part.cells.grid.x[column], part.cells.grid.y[row]}));
}

std::string cell_outline(const PartCells& part, int cell, const View& view) {
    const Box2 box = part.cells.grid.box(cell);
    std::string data;
    for (const Vec2& corner : {box.min, Vec2(box.max.x(), box.min.y()), box.max, Vec2(box.min.x(), box.max.y())}) {
        const Vec2 at = view(part.frame.to_global(corner));
        data += (data.empty() ? "M" : "L") + coordinate_text(at.x()) + " " + coordinate_text(at.y());
    }
    return data + "Z";
}

std::string grid_line_data(const PartCells& part, bool with_material, const View& view) {
    std::string data;
    if (part.cells.grid.tree) {
        for (int cell = 0; cell < part.cells.grid.n_cells(); ++cell)
            if ((part.cells.cell_class[at(cell)] != CellClass::outer) == with_material) data += cell_outline(part, cell, view);
        return data;
    }
    for (int i = 0; i <= part.cells.grid.columns(); ++i) append_line(data, part, 0, i, with_material, view);
    for (int j = 0; j <= part.cells.grid.rows(); ++j) append_line(data, part, 1, j, with_material, view);
    return data;
}

Box2 box_of_stages(const Scene& scene, const Stages& stages, bool grids) {
    Box2 box = box_of_parts(scene);
    if (!grids) return box;
    for (const PartCells& part : stages.parts)
        for (const double x : {part.cells.grid.x.front(), part.cells.grid.x.back()})
            for (const double y : {part.cells.grid.y.front(), part.cells.grid.y.back()})
                box.extend(part.frame.to_global({x, y}));
    return box;
}

}  // namespace abut::inspect

namespace abut {

std::vector<InspectionPicture> stage_pictures(const Inspection& inspection) {
    std::vector<InspectionPicture> pictures;
    if (inspection.scene.parts.empty()) return pictures;
    const inspect::Stages stages = inspect::first_stages(inspection.scene);
    pictures.push_back({"inspect_cells.svg", inspect::cells_svg(inspection, stages)});
    pictures.push_back({"inspect_pieces.svg", inspect::pieces_svg(inspection, stages)});
    if (inspection.scene.parts.size() > 1)
        pictures.push_back({"inspect_candidates.svg", inspect::candidates_svg(inspection, stages)});
    return pictures;
}

}  // namespace abut
