// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a grid as they are drawn in cells.svg, by class and contact.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/interfaces/common_grid.hpp"
#include "src/report/svg.hpp"

namespace abut {

/// What a cell is drawn as; where parts share a cell, the last one of these.
enum class Shade : std::uint8_t { outer, inner, boundary, contact };

/// The look of a shade; light, middle and dark are apart in grey print too. The name is the element's class in the picture.
struct ShadeStyle {
    Shade shade;
    const char *name, *color;
};
inline constexpr std::array<ShadeStyle, 4> shade_styles{{{Shade::outer, "outer", "#ffffff"},
                                                         {Shade::inner, "inner", "#8dbbe8"},
                                                         {Shade::boundary, "boundary", "#ffe27a"},
                                                         {Shade::contact, "contact", "#2f9e4f"}}};

/// A box of cells and what each is drawn as, row by row.
struct Sheet {
    geometry::CellRange box;
    std::vector<Shade> shade;
};

/// The sheet of steps 1 to 3: the cells of all parts on the one grid.
Sheet common_sheet(const geometry::CommonGrid& common);
/// The sheet of step 4: the cells of one part on its own grid.
Sheet split_sheet(const geometry::CommonGrid& common, std::size_t part);

/// The cells as SVG: one path for every class that occurs, those beside each other in a row as one rectangle; then the grid's
/// lines.
std::string sheet_svg(const Sheet& sheet, const geometry::UniformGrid& grid, const View& view);

}  // namespace abut
