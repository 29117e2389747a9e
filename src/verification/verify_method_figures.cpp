// SPDX-License-Identifier: GPL-3.0-or-later
// What the dissertation's method works on, as pictures: cells and Gauss points, the search for contact, weights.
#include <algorithm>
#include <array>
#include <cmath>

#include "src/base/index.hpp"
#include "src/discretization/part_grid.hpp"
#include "src/discretization/solution_structure.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_contours.hpp"
#include "src/report/report_svg.hpp"
#include "src/verification/verify_figures.hpp"

namespace abut {

namespace {

constexpr double grid_width = 1000, grid_height = 1000, grid_margin = 24, heading_height = 56;
constexpr double weight_width = 520;
constexpr int weight_patches = 120;  // along the longer side of the picture
constexpr const char* method_style = "text{font:12px sans-serif;fill:#222}.title{font-weight:bold}.note{fill:#555}";

/// Every part of a scene on its grid, with its weights.
std::vector<PartOnGrid> parts_on_grids(const Scene& scene) {
    const ResolvedConditions conditions = resolve_conditions(scene);
    std::vector<PartOnGrid> parts;
    for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i) {
        const PartGrid grid = grid_of_part(scene, i, {}, 1, 1);
        parts.push_back(discretize(scene, i, grid.frame, grid.grid, grid.degree));
        parts.back().input.structure = make_structure(scene, conditions, parts.back());
    }
    return parts;
}

View view_of(const Scene& scene, double width, double height) {
    Box2 box;
    for (const ScenePart& part : scene.parts) box.extend(bounding_box(part.part));
    View view = fit_view(box, width, height, grid_margin);
    view.offset.y() += heading_height;
    view.height += heading_height;
    return view;
}

std::string heading_of(const std::string& title, const std::string& note) {
    return report::text({grid_margin, 22}, "start", title, "class=\"title\"") +
           report::text({grid_margin, 42}, "start", note, "class=\"note\"");
}

std::string cells_of(const PartOnGrid& g, const View& view) {
    const geometry::Grid& grid = g.cells.grid;
    std::string svg;
    for (int cell = 0; cell < static_cast<int>(g.cells.cell_class.size()); ++cell) {
        const geometry::CellClass its = g.cells.cell_class[at(cell)];
        if (its == geometry::CellClass::outer) continue;
        const auto i = at(grid.column_of(cell)), j = at(grid.row_of(cell));
        const auto corner = [&](std::size_t a, std::size_t b) {
            return view(g.frame.to_global({grid.x[i + a], grid.y[j + b]}));
        };
        const bool is_inner = its == geometry::CellClass::inner;
        svg += report::polygon({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)},
                               std::string("stroke=\"#8a8a8a\" stroke-width=\"0.4\" fill=\"") +
                                   (is_inner ? "#9ecae1" : "#f4d35e") + "\" fill-opacity=\"0.7\"");
    }
    return svg;
}

void append_point(std::string& data, const Vec2& p) {
    constexpr double side = 1.3;
    data += "M" + coordinate_text(p.x() - 0.5 * side) + " " + coordinate_text(p.y() - 0.5 * side) + "h1.3v1.3h-1.3z";
}

/// Of the weighted functions where the part has weights, else of the cut cells.
std::string gauss_points_of(const PartOnGrid& g, const View& view, std::size_t& n) {
    const std::vector<solver::CellRule>& rules = g.input.structure ? g.input.structure->rules : g.input.cut_rules;
    std::string data;
    for (const solver::CellRule& rule : rules)
        for (const Vec2& p : rule.points) append_point(data, view(g.frame.to_global(p)));
    for (const solver::CellRule& rule : rules) n += rule.points.size();
    return report::path(data, "fill=\"#000\"");
}

std::string grid_svg(const Scene& scene, const std::vector<PartOnGrid>& parts, const std::string& title) {
    const View view = view_of(scene, grid_width, grid_height);
    std::string inner;
    std::size_t n = 0;
    for (const PartOnGrid& g : parts) inner += cells_of(g, view);
    for (const PartOnGrid& g : parts)
        inner += gauss_points_of(g, view, n) +
                 report::path(path_data(scene.parts[at(g.part)].part, view), "fill=\"none\" stroke=\"#222\"");
    return report::open_picture(view.width, view.height, title, method_style) +
           heading_of(title, "Blue: inner cells; yellow: boundary cells; dots: the " + std::to_string(n) +
                                 " Gauss points, transformed in boundary cells") +
           inner + "</svg>\n";
}

/// A weight over the box of its part, by patches; the part's outline clips it.
struct WeightSample {
    std::vector<report::Patch> patches;
    double largest = 0;
};
WeightSample sampled(const PartOnGrid& g, const solver::ScalarField& weight, const View& view) {
    const Box2 box = bounding_box(g.local);
    const double h = std::max(box.size().x(), box.size().y()) / weight_patches;
    const auto nx = static_cast<int>(std::ceil(box.size().x() / h)), ny = static_cast<int>(std::ceil(box.size().y() / h));
    const auto place = [&](double i, double j) { return Vec2(box.min + h * Vec2(i, j)); };
    WeightSample sample;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            report::Patch patch{};
            const std::array<Vec2, 4> corners{place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)};
            for (std::size_t k = 0; k < 4; ++k) {
                patch.at[k] = view(g.frame.to_global(corners[k]));
                patch.value[k] = weight(corners[k]).value;
            }
            patch.middle = weight(place(i + 0.5, j + 0.5)).value;
            if (contains(g.local, place(i + 0.5, j + 0.5))) sample.largest = std::max(sample.largest, patch.middle);
            sample.patches.push_back(patch);
        }
    for (report::Patch& patch : sample.patches) {
        for (double& v : patch.value) v /= sample.largest;
        patch.middle /= sample.largest;
    }
    return sample;
}

std::string weight_panel(const Scene& scene, const std::vector<PartOnGrid>& parts, const View& view, std::size_t component) {
    std::string svg;
    for (const PartOnGrid& g : parts) {
        const std::string data = path_data(scene.parts[at(g.part)].part, view);
        const bool has_weight = g.input.structure && g.input.structure->weight[component];
        if (!has_weight) {
            svg += report::path(data, "fill=\"#e4e4e4\" fill-rule=\"evenodd\" stroke=\"#777\"");
            continue;
        }
        const WeightSample sample = sampled(g, g.input.structure->weight[component], view);
        const std::string id = "w" + std::to_string(component) + "-" + std::to_string(g.part);
        svg += report::clip_path(id, data) + "<g clip-path=\"url(#" + id + ")\">\n" + report::filled_bands(sample.patches) +
               "</g>\n" + report::path(data, "fill=\"none\" stroke=\"#222\"");
    }
    return svg;
}

std::string weights_svg(const Scene& scene, const std::vector<PartOnGrid>& parts, const std::string& title) {
    const View view = view_of(scene, weight_width, weight_width);
    std::string inner;
    for (std::size_t c = 0; c < 2; ++c)
        inner += "<g transform=\"translate(" + std::to_string(static_cast<int>(weight_width) * static_cast<int>(c)) +
                 " 20)\">\n" +
                 report::text({grid_margin, 52}, "start", c == 0 ? "(a) of the x component" : "(b) of the y component") +
                 weight_panel(scene, parts, view, c) + "</g>\n";
    return report::open_picture(2 * weight_width, view.height + 20, title, method_style) +
           heading_of(title, "Weight functions, each as a share of its largest value in the part; grey: not held") + inner +
           "</svg>\n";
}

}  // namespace

std::vector<Figure> method_figures(const DissertationTable& table, const std::string& data_folder) {
    const std::optional<VerifyRun>& run = table.runs[static_cast<std::size_t>(Ours::written)];
    if (!run) return {};
    const Scene scene = scene_of_run(*run, data_folder);
    const std::vector<PartOnGrid> parts = parts_on_grids(scene);
    return {{table.name + "_grid.svg", grid_svg(scene, parts, table.title)},
            {table.name + "_weights.svg", weights_svg(scene, parts, table.title)},
            {table.name + "_search.svg", detection_cells_svg(scene, detect_contacts(scene, std::nullopt))}};
}

}  // namespace abut
