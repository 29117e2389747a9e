// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of the first grids: cells by class.
#include <algorithm>
#include <array>
#include <filesystem>

#include "src/inspection/inspect_stages.hpp"
#include "src/io/number_text.hpp"

namespace abut::inspect {

namespace {

using geometry::CellClass;

/// Colours that stay apart for the colour-blind and in grey print.
struct ClassColor {
    CellClass cell_class;
    const char* color;
    const char* name;
};
constexpr std::array<ClassColor, 3> class_colors{{{CellClass::outer, "#f0f0f0", "outer"},
                                                  {CellClass::inner, "#9ecae1", "inner"},
                                                  {CellClass::boundary, "#e6a23c", "boundary"}}};

/// Cells of one class; those beside each other in a row are one rectangle.
std::string cell_data(const PartCells& part, CellClass wanted, const View& view) {
    const geometry::Grid& grid = part.cells.grid;
    std::string data;
    if (grid.tree) {
        for (int cell = 0; cell < grid.n_cells(); ++cell)
            if (part.cells.cell_class[static_cast<std::size_t>(cell)] == wanted) data += cell_outline(part, cell, view);
        return data;
    }
    const auto columns = static_cast<std::size_t>(grid.columns()), rows = static_cast<std::size_t>(grid.rows());
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns;) {
            const std::size_t begin = i;
            while (i < columns && part.cells.cell_class[j * columns + i] == wanted) ++i;
            if (i == begin) {
                ++i;
                continue;
            }
            std::vector<Vec2> corners{grid_point(part, begin, j, view), grid_point(part, i, j, view),
                                      grid_point(part, i, j + 1, view), grid_point(part, begin, j + 1, view)};
            for (std::size_t k = 0; k < corners.size(); ++k)
                data += (k == 0 ? "M" : "L") + coordinate_text(corners[k].x()) + " " + coordinate_text(corners[k].y());
            data += "Z";
        }
    return data;
}

std::string counts_text(const ScenePart& part, const PartCells& cells) {
    const geometry::Grid& grid = cells.cells.grid;
    std::string text = part.name + ": " + std::to_string(grid.columns()) + " x " + std::to_string(grid.rows()) + " cells";
    if (grid.tree) text += ", halved up to " + std::to_string(grid.tree->levels()) + " times";
    for (const CellClass c : {CellClass::inner, CellClass::boundary, CellClass::outer})
        for (const ClassColor& named : class_colors)
            if (named.cell_class == c)
                text += ", " + std::to_string(std::count(cells.cells.cell_class.begin(), cells.cells.cell_class.end(), c)) +
                        " " + named.name;
    return text + (cells.is_limited ? "; coarser than wanted, to bound their number" : "");
}

/// Grids overlap where parts are close: what holds material is drawn over the empty cells of all.
std::string cell_elements(const Stages& stages, const View& view) {
    std::string svg;
    for (const bool with_material : {false, true})
        for (const PartCells& part : stages.parts) {
            for (const ClassColor& c : class_colors)
                if ((c.cell_class != CellClass::outer) == with_material)
                    svg += path_element(cell_data(part, c.cell_class, view), c.name);
            svg += path_element(grid_line_data(part, with_material, view), with_material ? "line" : "empty");
        }
    return svg;
}

}  // namespace

std::string cells_svg(const Inspection& inspection, const Stages& stages) {
    const View view = page_view(box_of_stages(inspection.scene, stages, true));
    std::string css =
        ".line{fill:none;stroke:#345;stroke-width:.35}.empty{fill:none;stroke:#bbb;stroke-width:.3}"
        ".outline{fill:none;stroke:#000;stroke-width:1.1}";
    std::vector<LegendEntry> legend;
    for (const ClassColor& c : class_colors) {
        css += "." + std::string(c.name) + "{fill:" + c.color + "}";
        legend.push_back({c.color, std::string(c.name) + " cells"});
    }
    std::string svg = page_axes(view, inspection.unit) + cell_elements(stages, view);
    for (std::size_t i = 0; i < stages.parts.size(); ++i) {
        const ScenePart& part = inspection.scene.parts[i];
        svg += path_element(path_data(part.part, view), "outline");
        legend.push_back({"", counts_text(part, stages.parts[i])});
    }
    const std::string file = std::filesystem::path(inspection.file).filename().string();
    return page_with_legend(view, file + ": cells of the first grids", css, svg, legend);
}

}  // namespace abut::inspect
