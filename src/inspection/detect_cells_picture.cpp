// SPDX-License-Identifier: GPL-3.0-or-later
// cells.svg: the dissertation's four steps from parts to grids and contact cells [Grishin10, section 4.5.1], in the colours of
// its Figures 4.7 to 4.9.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/brep/extent.hpp"
#include "src/contact/cell_search.hpp"
#include "src/inspection/cell_sheet.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/inspection/inspect_page.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/boxes_apart.hpp"
#include "src/report/label_placement.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

using geometry::CellRange;
using geometry::CommonGrid;
using geometry::ContactCells;
using geometry::UniformGrid;
using inspect::text_element;

constexpr double panel_width = 700, max_panel_height = 720, margin = 46, row_height = 18, font_size = 12;
/// Between split grids, as a fraction of the common grid's diagonal: room for a name.
constexpr double gap_fraction = 0.06;

struct CellsPicture {
    const Scene& scene;
    const Detection& detection;
    CommonGrid common;
    double wanted_cell;  ///< before their number was bounded
};

// ---- the grid ----

/// Cells of the grid, or of the boxes of all parts, whichever are more; counted in doubles, for there may be very many.
double cells_wanted(const std::vector<Box2>& parts, const Box2& all, double cell) {
    const auto n = [&](double length) { return std::max(1.0, std::ceil(length / cell)); };
    double boxes = 0;
    for (const Box2& b : parts) boxes += n(b.size().x()) * n(b.size().y());
    return std::max(boxes, n(all.size().x()) * n(all.size().y()));
}

/// The wanted size, or a larger one with which the cells are no more than `most`; with one cell for all it ends in any case.
double bounded_cell(const Scene& scene, double wanted, int most) {
    std::vector<Box2> boxes;
    Box2 all;
    for (const ScenePart& p : scene.parts) {
        boxes.push_back(bounding_box(p.part));
        all.extend(boxes.back());
    }
    constexpr double least_step = 1.01;
    double cell = wanted;
    for (double n = cells_wanted(boxes, all, cell); n > most && cell < all.diagonal(); n = cells_wanted(boxes, all, cell))
        cell *= std::max(least_step, std::sqrt(n / most));
    return cell;
}

/// The smallest of the sizes that the detected pairs have in the table; where the search itself decides, its own.
double wanted_cell(const Scene& scene, const Detection& detection) {
    if (is_by_dissertation(scene)) return search_cell(scene);
    double smallest = std::numeric_limits<double>::infinity();
    for (const DetectedPair& pair : detection.pairs)
        for (const int p : pair.part) smallest = std::min(smallest, extent(scene.parts[static_cast<std::size_t>(p)].part));
    return geometry::case_cell_fraction * smallest;
}

CellsPicture gridded(const Scene& scene, const Detection& detection, int most_cells) {
    std::vector<const geometry::Part*> parts;
    for (const ScenePart& p : scene.parts) parts.push_back(&p.part);
    const double wanted = wanted_cell(scene, detection);
    return {scene, detection, common_grid(parts, bounded_cell(scene, wanted, most_cells)), wanted};
}

// ---- elements ----

std::string outline_svg(const ScenePart& part, const View& view) {
    return "<path class=\"outline\" d=\"" + path_data(part.part, view) + "\"><title>" + escape_xml(part.name) +
           "</title></path>\n";
}

// ---- names and numbers ----

/// The first place where the text hides no other one; none: it is left out.
std::string placed_text(const std::vector<Vec2>& places, const std::string& text, const char* css, LabelPlacement& labels) {
    for (const Vec2& place : places) {
        const Box2 box = text_box(text, font_size, place);
        if (!labels.is_free(box, false)) continue;
        labels.take(box);
        return text_element(place + Vec2(0, 0.35 * font_size), css, "middle", text);
    }
    return {};
}

/// Middles of the contact cells, the nearest to their mean first.
std::vector<Vec2> number_places(const geometry::CaseCells& its_case, const UniformGrid& grid, const View& view) {
    std::vector<Vec2> places;
    Vec2 mean(0, 0);
    for (const std::vector<int>& cells : its_case.cells)
        for (const int cell : cells) {
            const int column = cell % grid.columns, row = cell / grid.columns;
            places.push_back(view(grid.point(column + 0.5, row + 0.5)));
            mean += places.back();
        }
    mean /= std::max(1.0, static_cast<double>(places.size()));
    std::stable_sort(places.begin(), places.end(),
                     [&](const Vec2& a, const Vec2& b) { return (a - mean).norm() < (b - mean).norm(); });
    return places;
}

const ContactCells* contact_of(const CommonGrid& common, const std::array<int, 2>& part) {
    for (const ContactCells& contact : common.contacts)
        if (contact.part == part) return &contact;
    return nullptr;
}

const DetectedPair* pair_of(const std::vector<DetectedPair>& pairs, const std::array<int, 2>& part) {
    for (const DetectedPair& pair : pairs)
        if (pair.part == part) return &pair;
    return nullptr;
}

/// Cells are those of two parts, whatever their zones: the parts' first row, with the numbers of all, "2, 3".
struct Numbered {
    const DetectedPair* pair;
    std::string numbers;
};
std::vector<Numbered> numbered(const std::vector<DetectedPair>& pairs) {
    std::vector<Numbered> list;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto own =
            std::find_if(list.begin(), list.end(), [&](const Numbered& n) { return n.pair->part == pairs[k].part; });
        if (own == list.end())
            list.push_back({&pairs[k], contact_number(k)});
        else
            own->numbers += ", " + contact_number(k);
    }
    return list;
}

std::string numbers_svg(const CellsPicture& picture, const View& view, LabelPlacement& labels) {
    std::string svg;
    for (const auto& [pair, numbers] : numbered(picture.detection.pairs))
        if (const ContactCells* contact = contact_of(picture.common, pair->part))
            svg += placed_text(number_places(contact->its_case, picture.common.grid, view), numbers, "number", labels);
    return svg;
}

// ---- both halves ----

Box2 box_of(const CellRange& range, const UniformGrid& grid) {
    if (range.columns == 0) return {};
    return {grid.point(range.column, range.row), grid.point(range.column + range.columns, range.row + range.rows)};
}

Box2 panel_area(double left, const View& view) {
    return {Vec2(left, 0), Vec2(left + panel_width, view.height)};
}

std::string common_svg(const CellsPicture& picture, const View& view) {
    std::string svg = "<g class=\"common\">\n" + sheet_svg(common_sheet(picture.common), picture.common.grid, view);
    for (const ScenePart& part : picture.scene.parts) svg += outline_svg(part, view);
    LabelPlacement labels(panel_area(0, view));
    return svg + numbers_svg(picture, view, labels) + "</g>\n";
}

View moved(View view, const Vec2& shift) {
    view.offset += view.scale * Vec2(shift.x(), -shift.y());
    return view;
}

/// Above the grid, below it, beside it.
std::vector<Vec2> name_places(const Box2& box, const View& view, const std::string& name) {
    const Vec2 middle = view(box.center()), text = text_box(name, font_size, {0, 0}).size();
    const Vec2 reach = 0.5 * (view.scale * box.size() + text) + Vec2(4, 4);
    return {middle - Vec2(0, reach.y()), middle + Vec2(0, reach.y()), middle + Vec2(reach.x(), 0), middle - Vec2(reach.x(), 0)};
}

std::string split_svg(const CellsPicture& picture, const std::vector<Vec2>& shifts, const View& view) {
    const CommonGrid& common = picture.common;
    LabelPlacement labels(panel_area(panel_width, view));
    std::vector<Box2> boxes;
    for (std::size_t p = 0; p < shifts.size(); ++p) {
        boxes.push_back(box_of(common.split[p], common.grid));
        if (boxes[p].empty()) continue;
        const View own = moved(view, shifts[p]);
        Box2 drawn;
        drawn.extend(own(boxes[p].min));
        drawn.extend(own(boxes[p].max));
        labels.take(drawn);
    }
    std::string svg = "<g class=\"split\">\n";
    for (std::size_t p = 0; p < shifts.size(); ++p) {
        if (boxes[p].empty()) continue;
        const ScenePart& part = picture.scene.parts[p];
        const View own = moved(view, shifts[p]);
        svg += sheet_svg(split_sheet(common, p), common.grid, own) + outline_svg(part, own) +
               placed_text(name_places(boxes[p], own, part.name), part.name, "name", labels);
    }
    return svg + "</g>\n";
}

// ---- legend ----

const char* words_for(char letter) {
    if (letter == 'a') return "boundary cells in common";
    if (letter == 'b') return "boundary cells side by side";
    if (letter == 'c') return "boundary cells of one beside or among inner cells of the other";
    return letter == 'd' ? "inner cells side by side or in common" : "no cells come together";
}

std::string cells_text(const geometry::CaseCells& its_case) {
    if (its_case.letter == 'a') return counted(its_case.cells[0].size(), "contact cell");
    return std::to_string(its_case.cells[0].size()) + " and " + counted(its_case.cells[1].size(), "contact cell");
}

std::string case_text(const CellsPicture& picture, const std::array<int, 2>& part) {
    const auto name = [&](int p) { return picture.scene.parts[static_cast<std::size_t>(p)].name; };
    const ContactCells* contact = contact_of(picture.common, part);
    const char letter = contact ? contact->its_case.letter : 'e';
    return name(part[0]) + " - " + name(part[1]) + ": case " + letter + ", " + words_for(letter) +
           (contact ? "; " + cells_text(contact->its_case) : "");
}

/// The table's letter is found on a grid of the pair alone, with cells of its own size.
std::string found_text(const CellsPicture& picture, const DetectedPair& pair) {
    const ContactCells* contact = contact_of(picture.common, pair.part);
    const std::string letter(1, contact ? contact->its_case.letter : 'e');
    return case_text(picture, pair.part) +
           (letter == pair.cells_case ? "" : " (case " + pair.cells_case + " on the grid of this pair alone, as in the table)");
}

std::string grid_text(const CellsPicture& picture) {
    const UniformGrid& grid = picture.common.grid;
    const std::string unit = picture.scene.length_unit;
    std::string text = "one grid of " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " cells of " +
                       with_unit(grid.cell, 4, unit);
    if (grid.cell > picture.wanted_cell)
        text += ", larger than the " + with_unit(picture.wanted_cell, 4, unit) +
                " of the detection, to bound their number: the cases are those on the cells drawn";
    return text;
}

std::vector<std::string> legend_lines(const CellsPicture& picture) {
    std::vector<std::string> lines{grid_text(picture)};
    const std::vector<DetectedPair>& pairs = picture.detection.pairs;
    for (const auto& [pair, numbers] : numbered(pairs)) lines.push_back(numbers + "  " + found_text(picture, *pair));
    for (const ContactCells& contact : picture.common.contacts) {
        if (pair_of(pairs, contact.part)) continue;
        const bool is_near = pair_of(picture.detection.near_misses, contact.part) != nullptr;
        lines.push_back(case_text(picture, contact.part) + (is_near ? " (a near miss)" : " (not among the pairs found)"));
    }
    return lines;
}

std::string swatches_svg(const CellsPicture& picture, double y) {
    constexpr double step = 170;
    const Sheet sheet = common_sheet(picture.common);
    std::string svg;
    double x = margin;
    for (const ShadeStyle& style : shade_styles) {
        const auto n = static_cast<std::size_t>(std::count(sheet.shade.begin(), sheet.shade.end(), style.shade));
        svg += report::rectangle({x, y - 10}, {16, 11}, "class=\"swatch " + std::string(style.name) + "\"") +
               text_element({x + 24, y}, "legend", "start", counted(n, std::string(style.name) + " cell"));
        x += step;
    }
    return svg;
}

std::string legend_svg(const CellsPicture& picture, double top) {
    double y = top;
    std::string svg = swatches_svg(picture, y);
    for (const std::string& line : legend_lines(picture)) {
        y += row_height;
        svg += text_element({margin, y}, "legend", "start", line);
    }
    return svg;
}

// ---- the page ----

/// Lines are thin where cells have few pixels, lest they hide the colours.
std::string style(double cell_pixels) {
    const std::string line = coordinate_text(std::clamp(0.04 * cell_pixels, 0.1, 0.5));
    const std::string outline = coordinate_text(std::clamp(0.15 * cell_pixels, 0.6, 1.3));
    std::string css = "text{font:12px sans-serif;fill:#222}.outline{fill:none;stroke:#000;stroke-width:" + outline +
                      "}.line{fill:none;stroke:#555;stroke-width:" + line +
                      "}.swatch{stroke:#666;stroke-width:.5}.number{font-weight:bold;stroke:#fff;stroke-width:3;"
                      "stroke-linejoin:round;paint-order:stroke}.head{font-size:14px}";
    for (const ShadeStyle& s : shade_styles) css += "." + std::string(s.name) + "{fill:" + s.color + "}";
    return css;
}

std::string page(const CellsPicture& picture) {
    const CommonGrid& common = picture.common;
    const Box2 whole{common.grid.corner, common.grid.point(common.grid.columns, common.grid.rows)};
    std::vector<Box2> boxes;
    for (const CellRange& range : common.split) boxes.push_back(box_of(range, common.grid));
    const std::vector<Vec2> shifts = shifts_apart(boxes, gap_fraction * whole.diagonal());
    Box2 spread;
    for (std::size_t p = 0; p < boxes.size(); ++p)
        if (!boxes[p].empty()) spread.extend(Box2{boxes[p].min + shifts[p], boxes[p].max + shifts[p]});

    const View left = fit_view(whole, panel_width, max_panel_height, margin);
    View right = fit_view(spread, panel_width, max_panel_height, margin);
    right.offset.x() += panel_width;
    const double panels = std::max(left.height, right.height);
    const double height = panels + row_height * (static_cast<double>(legend_lines(picture).size()) + 2);
    const std::string title = picture.scene.title.empty() ? picture.scene.file : picture.scene.title;
    return report::open_picture(2 * panel_width, height, "Cells of " + title, style(left.scale * common.grid.cell)) +
           common_svg(picture, left) + split_svg(picture, shifts, right) +
           text_element({margin, 18}, "head", "start", "Steps 1 to 3: one grid, its cells by class, contact cells") +
           text_element({panel_width + margin, 18}, "head", "start", "Step 4: the grid split, one grid for each part") +
           legend_svg(picture, panels + row_height) + "</svg>\n";
}

}  // namespace

std::string detection_cells_svg(const Scene& scene, const Detection& detection, int most_cells) {
    if (scene.parts.size() < 2 || detection.pairs.empty()) return {};
    const CellsPicture picture = gridded(scene, detection, most_cells);
    return picture.common.refusal.empty() ? page(picture) : std::string();
}

}  // namespace abut
