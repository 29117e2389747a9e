// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/inspection/cell_sheet.hpp"

#include <algorithm>

#include "src/inspection/inspect_page.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

using geometry::CellClass;
using geometry::CellRange;
using geometry::CommonGrid;
using geometry::ContactCells;
using geometry::UniformGrid;
using inspect::path_element;

Sheet empty_sheet(const CellRange& box) {
    return {box, std::vector<Shade>(box.n_cells(), Shade::outer)};
}

void shade_classes(const geometry::CellClasses& cells, Sheet& sheet) {
    const CellRange& box = cells.box;
    for (int row = box.row; row < box.row + box.rows; ++row)
        for (int column = box.column; column < box.column + box.columns; ++column) {
            const CellClass c = cells.at(column, row);
            if (c == CellClass::outer) continue;
            Shade& shade = sheet.shade[sheet.box.index(column, row)];
            shade = std::max(shade, c == CellClass::inner ? Shade::inner : Shade::boundary);
        }
}

void shade_contacts(const std::vector<int>& cells, const UniformGrid& grid, Sheet& sheet) {
    for (const int cell : cells) sheet.shade[sheet.box.index(cell % grid.columns, cell / grid.columns)] = Shade::contact;
}

/// Cells of one shade; those beside each other in a row are one rectangle.
std::string shade_data(const Sheet& sheet, Shade wanted, const UniformGrid& grid, const View& view) {
    std::string data;
    const CellRange& box = sheet.box;
    const auto is_wanted = [&](int column, int row) {
        return column < box.column + box.columns && sheet.shade[box.index(column, row)] == wanted;
    };
    for (int row = box.row; row < box.row + box.rows; ++row)
        for (int column = box.column; column < box.column + box.columns; ++column) {
            const int begin = column;
            while (is_wanted(column, row)) ++column;
            if (column == begin) continue;
            const Vec2 low = view(grid.point(begin, row)), high = view(grid.point(column, row + 1));
            data += "M" + coordinate_text(low.x()) + " " + coordinate_text(low.y()) + "H" + coordinate_text(high.x()) + "V" +
                    coordinate_text(high.y()) + "H" + coordinate_text(low.x()) + "Z";
        }
    return data;
}

std::string line_data(const CellRange& box, const UniformGrid& grid, const View& view) {
    const Vec2 low = view(grid.point(box.column, box.row));
    const Vec2 high = view(grid.point(box.column + box.columns, box.row + box.rows));
    std::string data;
    for (int i = box.column; i <= box.column + box.columns; ++i)
        data += "M" + coordinate_text(view(grid.point(i, 0)).x()) + " " + coordinate_text(low.y()) + "V" +
                coordinate_text(high.y());
    for (int k = box.row; k <= box.row + box.rows; ++k)
        data += "M" + coordinate_text(low.x()) + " " + coordinate_text(view(grid.point(0, k)).y()) + "H" +
                coordinate_text(high.x());
    return data;
}

}  // namespace

Sheet common_sheet(const CommonGrid& common) {
    Sheet sheet = empty_sheet({0, 0, common.grid.columns, common.grid.rows});
    for (const geometry::CellClasses& cells : common.parts) shade_classes(cells, sheet);
    for (const ContactCells& contact : common.contacts)
        for (const std::vector<int>& cells : contact.its_case.cells) shade_contacts(cells, common.grid, sheet);
    return sheet;
}

Sheet split_sheet(const CommonGrid& common, std::size_t part) {
    Sheet sheet = empty_sheet(common.split[part]);
    shade_classes(common.parts[part], sheet);
    for (const ContactCells& contact : common.contacts)
        for (const std::size_t side : {0, 1})
            if (contact.part[side] == static_cast<int>(part)) shade_contacts(contact.its_case.cells[side], common.grid, sheet);
    return sheet;
}

std::string sheet_svg(const Sheet& sheet, const UniformGrid& grid, const View& view) {
    std::string svg;
    for (const ShadeStyle& style : shade_styles) {
        const std::string data = shade_data(sheet, style.shade, grid, view);
        if (!data.empty()) svg += path_element(data, style.name);
    }
    return svg + path_element(line_data(sheet.box, grid, view), "line");
}

}  // namespace abut
