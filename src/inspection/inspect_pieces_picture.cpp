// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of the boundary as the grid clips it: pieces in two colours by turns, a tick at every end.
#include <array>
#include <filesystem>

#include "src/inspection/inspect_stages.hpp"
#include "src/io/number_text.hpp"

namespace abut::inspect {

namespace {

constexpr std::array<const char*, 2> piece_colors{"#0b5cad", "#d1495b"};
constexpr double tick_half = 3.5;  ///< pixels to either side of the boundary

/// Across the curve at parameter t; longer at the ends of edges.
std::string tick_data(const geometry::Curve& curve, double t, const View& view) {
    const Vec2 normal = outward_normal(curve, t), p = view(point(curve, t));
    const Vec2 half = (t == 0 || t == 1 ? 2 : 1) * tick_half * Vec2(normal.x(), -normal.y());
    return "M" + coordinate_text(p.x() - half.x()) + " " + coordinate_text(p.y() - half.y()) + "L" +
           coordinate_text(p.x() + half.x()) + " " + coordinate_text(p.y() + half.y());
}

std::string piece_elements(const geometry::Part& part, const PartCells& cells, const View& view) {
    std::array<std::string, 2> data;
    std::string ticks;
    for (std::size_t k = 0; k < cells.cells.pieces.size(); ++k) {
        const geometry::BoundaryPiece& piece = cells.cells.pieces[k];
        const geometry::Curve& curve = part.edges[static_cast<std::size_t>(piece.edge)].curve;
        data[k % 2] += path_data(curve, piece.t0, piece.t1, view);
        ticks += tick_data(curve, piece.t0, view) + tick_data(curve, piece.t1, view);
    }
    return path_element(data[0], "even") + path_element(data[1], "odd") + path_element(ticks, "tick_mark");
}

}  // namespace

std::string pieces_svg(const Inspection& inspection, const Stages& stages) {
    const View view = page_view(box_of_stages(inspection.scene, stages, false));
    const std::string css =
        ".part{stroke:none;fill-rule:evenodd}.line{fill:none;stroke:#999;stroke-width:.3}.even{fill:none;stroke:" +
        std::string(piece_colors[0]) + ";stroke-width:2.2}.odd{fill:none;stroke:" + piece_colors[1] +
        ";stroke-width:2.2}.tick_mark{fill:none;stroke:#000;stroke-width:.6}";
    std::vector<LegendEntry> legend{{piece_colors[0], "first, third, fifth, ... piece of a part"},
                                    {piece_colors[1], "second, fourth, sixth, ... piece"},
                                    {"", "short ticks: ends of pieces; long ticks: ends of edges"}};
    std::string svg = page_axes(view, inspection.unit) + pale_parts(inspection.scene, view);
    for (std::size_t i = 0; i < stages.parts.size(); ++i) {
        const ScenePart& part = inspection.scene.parts[i];
        svg += path_element(grid_line_data(stages.parts[i], true, view), "line") +
               piece_elements(part.part, stages.parts[i], view);
        legend.push_back({"", part.name + ": " + std::to_string(stages.parts[i].cells.pieces.size()) + " pieces of " +
                                  std::to_string(part.part.edges.size()) + " edges"});
    }
    const std::string file = std::filesystem::path(inspection.file).filename().string();
    return page_with_legend(view, file + ": boundary pieces in the cells of the first grids", css, svg, legend);
}

}  // namespace abut::inspect
