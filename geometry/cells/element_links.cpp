// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/element_links.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace abut::geometry {

namespace {

constexpr std::array<CellSide, 4> all_sides = {CellSide::bottom, CellSide::right, CellSide::top, CellSide::left};

struct Sides {
    const CutCells& cells;
    const ElementSides& of_boundary;
    const std::vector<int>& n_elements;
    double crossing_length;
    std::vector<int> index_of_cell;  // in boundary_cells

    bool has_material(int cell) const { return cells.cell_class[static_cast<std::size_t>(cell)] != CellClass::outer; }
    bool is_boundary(int cell) const { return cells.cell_class[static_cast<std::size_t>(cell)] == CellClass::boundary; }
    std::size_t index(int cell) const { return static_cast<std::size_t>(index_of_cell[static_cast<std::size_t>(cell)]); }
    bool has_one_element(int cell) const { return !is_boundary(cell) || n_elements[index(cell)] == 1; }
};

/// Calls f(cell) for the cells with material across a side.
template <class F>
void for_cells_across(const Sides& sides, int cell, CellSide side, F f) {
    sides.cells.grid.for_cells_across(cell, (side == CellSide::right) - (side == CellSide::left),
                                      (side == CellSide::top) - (side == CellSide::bottom), [&](int other) {
                                          if (sides.has_material(other)) f(other);
                                      });
}

/// Stretches of one side. An inner cell has all of it: `whole` is then filled and returned.
std::span<const SideStretch> stretches_on(const Sides& sides, int cell, CellSide side, SideStretch& whole) {
    if (!sides.is_boundary(cell)) {
        const int along = side == CellSide::right || side == CellSide::left ? 1 : 0;
        const Box2 box = sides.cells.grid.box(cell);
        whole = {cell, side, box.min[along], box.max[along]};
        return {&whole, 1};
    }
    const std::size_t k = sides.index(cell);
    const auto begin = sides.of_boundary.stretches.begin() + sides.of_boundary.first[k];
    const auto end = sides.of_boundary.stretches.begin() + sides.of_boundary.first[k + 1];
    const auto from = std::find_if(begin, end, [&](const SideStretch& s) { return s.side == side; });
    const auto to = std::find_if(from, end, [&](const SideStretch& s) { return s.side != side; });
    return {from, to};
}

/// Calls link(element of the cell, element across) for every overlap along a side.
template <class Link>
void for_overlaps(const Sides& sides, int cell, int other, CellSide side, Link link) {
    SideStretch whole_here, whole_there;
    const auto here = stretches_on(sides, cell, side, whole_here);
    const auto there = stretches_on(sides, other, opposite(side), whole_there);
    for (std::size_t i = 0, j = 0; i < here.size() && j < there.size();) {
        const double low = std::max(here[i].from, there[j].from), high = std::min(here[i].to, there[j].to);
        if (high - low > sides.crossing_length) link(here[i].component, there[j].component);
        if (here[i].to < there[j].to)
            ++i;
        else
            ++j;
    }
}

/// Two cells of one element each, with material across their side?
bool is_plain(const Sides& sides, int cell, int other, CellSide side) {
    if (!sides.has_one_element(cell) || !sides.has_one_element(other)) return false;
    bool linked = false;
    for_overlaps(sides, cell, other, side, [&](int, int) { linked = true; });
    return linked;
}

/// Cells some side of which is not plain, ascending. Both cells of each such side are found from a boundary one.
std::vector<int> special_cells(const Sides& sides) {
    std::vector<int> special;
    for (int cell : sides.of_boundary.boundary_cells) {
        if (!sides.has_one_element(cell)) special.push_back(cell);
        for (CellSide side : all_sides)
            for_cells_across(sides, cell, side, [&](int other) {
                if (is_plain(sides, cell, other, side)) return;
                special.push_back(cell);
                special.push_back(other);
            });
    }
    std::sort(special.begin(), special.end());
    special.erase(std::unique(special.begin(), special.end()), special.end());
    return special;
}

/// The elements of a cell, each with what is across its sides; an element without neighbours is there with itself, as (e, e).
std::vector<std::pair<int, int>> links_of(const Sides& sides, int cell, std::vector<int>& around) {
    std::vector<std::pair<int, int>> links{{cell, cell}};
    around.clear();
    for (CellSide side : all_sides) {
        SideStretch whole;
        for (const SideStretch& s : stretches_on(sides, cell, side, whole)) links.emplace_back(s.component, s.component);
        for_cells_across(sides, cell, side, [&](int other) {
            around.push_back(other);
            for_overlaps(sides, cell, other, side, [&](int here, int there) { links.emplace_back(here, there); });
        });
    }
    std::sort(around.begin(), around.end());
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    return links;
}

}  // namespace

std::map<int, std::vector<int>> element_links(const CutCells& cells, const ElementSides& boundary_sides,
                                              const std::vector<int>& n_elements, double crossing_length) {
    Sides sides{cells, boundary_sides, n_elements, crossing_length, std::vector<int>(cells.cell_class.size())};
    for (std::size_t k = 0; k < boundary_sides.boundary_cells.size(); ++k)
        sides.index_of_cell[static_cast<std::size_t>(boundary_sides.boundary_cells[k])] = static_cast<int>(k);
    std::map<int, std::vector<int>> neighbours;
    std::vector<int> around;
    for (int cell : special_cells(sides)) {
        const std::vector<std::pair<int, int>> links = links_of(sides, cell, around);
        for (auto it = links.begin(); it != links.end();) {
            const int element = it->first;
            std::vector<int> across;
            for (; it != links.end() && it->first == element; ++it)
                if (it->second != element) across.push_back(it->second);
            if (across != around) neighbours[element] = std::move(across);
        }
    }
    return neighbours;
}

}  // namespace abut::geometry
