// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/common_grid.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Cells between two coordinates counted in cells: [first, end) within 0 to n.
struct Span {
    int first, n;
};
Span span_of(double low, double high, int n) {
    const int first = static_cast<int>(std::clamp(std::floor(low), 0.0, n - 1.0));
    const int end = static_cast<int>(std::clamp(std::ceil(high), first + 1.0, n + 0.0));
    return {first, end - first};
}

CellRange range_of(const Box2& box, const UniformGrid& grid) {
    const Vec2 low = grid.in_cells(box.min), high = grid.in_cells(box.max);
    const Span columns = span_of(low.x(), high.x(), grid.columns), rows = span_of(low.y(), high.y(), grid.rows);
    return {columns.first, rows.first, columns.n, rows.n};
}

/// The smallest box of all cells that are not outer ones.
CellRange filled_range(const CellClasses& cells) {
    const CellRange& box = cells.box;
    int left = box.column + box.columns, right = -1, bottom = box.row + box.rows, top = -1;
    for (int row = box.row; row < box.row + box.rows; ++row)
        for (int column = box.column; column < box.column + box.columns; ++column) {
            if (cells.at(column, row) == CellClass::outer) continue;
            left = std::min(left, column);
            right = std::max(right, column);
            bottom = std::min(bottom, row);
            top = std::max(top, row);
        }
    return right < left ? CellRange{} : CellRange{left, bottom, right - left + 1, top - bottom + 1};
}

bool lie_together(const CellRange& a, const CellRange& b) {
    return a.column <= b.column + b.columns && b.column <= a.column + a.columns && a.row <= b.row + b.rows &&
           b.row <= a.row + a.rows;
}

std::vector<ContactCells> contacts_of(const CommonGrid& common) {
    std::vector<ContactCells> contacts;
    const auto n = common.parts.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k) {
            if (!lie_together(common.parts[i].box, common.parts[k].box)) continue;
            CaseCells its_case = case_cells(common.parts[i], common.parts[k], common.grid.columns);
            if (its_case.letter == 'e') continue;
            contacts.push_back({{static_cast<int>(i), static_cast<int>(k)}, std::move(its_case)});
        }
    return contacts;
}

CommonGrid refused(const std::string& reason) {
    CommonGrid none;
    none.refusal = reason;
    return none;
}

std::vector<double> lines_of(double origin, double cell, int first, int n) {
    std::vector<double> lines;
    for (int i = first; i <= first + n; ++i) lines.push_back(origin + cell * i);
    return lines;
}

}  // namespace

UniformGrid uniform_grid(const Box2& box, double cell_size) {
    if (box.empty() || !(cell_size > 0)) return {};
    const Vec2 size = box.size() / cell_size;
    const auto count = [](double v) { return std::max(1.0, std::ceil(v - along_line_fraction)); };
    if (!(count(size.x()) * count(size.y()) <= most_common_cells)) return {};
    return {box.min, cell_size, static_cast<int>(count(size.x())), static_cast<int>(count(size.y()))};
}

CommonGrid common_grid(const std::vector<const Part*>& parts, double cell_size) {
    const std::string too_many = "the grid would have more than " + std::to_string(most_common_cells) + " cells";
    if (!(cell_size > 0)) return refused("the size of the cells is not positive");
    Box2 all;
    for (const Part* part : parts) all.extend(bounding_box(*part));
    if (all.empty()) return refused("there is no part");

    CommonGrid common;
    common.grid = uniform_grid(all, cell_size);
    if (common.grid.columns == 0) return refused(too_many);
    std::vector<CellRange> ranges;
    std::size_t n_cells = 0;
    for (const Part* part : parts) {
        ranges.push_back(range_of(bounding_box(*part), common.grid));
        n_cells += ranges.back().n_cells();
    }
    if (n_cells > most_common_cells) return refused(too_many + " in the boxes around the parts");
    for (std::size_t i = 0; i < parts.size(); ++i) common.parts.push_back(classify_cells(*parts[i], common.grid, ranges[i]));
    common.contacts = contacts_of(common);
    for (const CellClasses& cells : common.parts) common.split.push_back(filled_range(cells));
    return common;
}

char case_of_parts(const CommonGrid& common, int part1, int part2) {
    ENSURE(part1 >= 0 && static_cast<std::size_t>(part1) < common.parts.size() && part2 >= 0 &&
               static_cast<std::size_t>(part2) < common.parts.size(),
           "the parts are on the grid");
    const std::array<int, 2> wanted{std::min(part1, part2), std::max(part1, part2)};
    const auto found = std::lower_bound(common.contacts.begin(), common.contacts.end(), wanted,
                                        [](const ContactCells& c, const std::array<int, 2>& part) { return c.part < part; });
    return found != common.contacts.end() && found->part == wanted ? found->its_case.letter : 'e';
}

Grid split_grid(const CommonGrid& common, int part) {
    ENSURE(part >= 0 && static_cast<std::size_t>(part) < common.split.size(), "the part is on the grid");
    const CellRange& range = common.split[static_cast<std::size_t>(part)];
    if (range.columns == 0) return {};
    const UniformGrid& grid = common.grid;
    return {lines_of(grid.corner.x(), grid.cell, range.column, range.columns),
            lines_of(grid.corner.y(), grid.cell, range.row, range.rows)};
}

}  // namespace abut::geometry
