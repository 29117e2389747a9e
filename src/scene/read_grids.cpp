// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "src/scene/read_accuracy.hpp"

namespace abut {

namespace {

/// More cells in one direction are taken for a slip of the pen.
constexpr int most_cells = 100000;
/// A thousandth of a cell of a thousandth of a part: deeper ones are taken for a slip of the pen, too.
constexpr int most_levels = 20;

std::vector<double> read_knots(SceneReading& reading, const JsonValue& value) {
    std::vector<double> knots;
    if (!check_list(reading, value, 2, "knots")) return knots;
    for (const JsonValue& item : value.items) {
        const std::optional<double> knot = read_number(reading, item, dimension::length);
        if (!knot) continue;
        if (!knots.empty() && *knot <= knots.back()) {
            report_problem(reading, item, "the knots are not in ascending order", "each must be greater than the one before");
            return knots;
        }
        knots.push_back(*knot);
    }
    return knots;
}

/// [p, q] within the limits.
std::optional<std::array<int, 2>> read_integers(SceneReading& reading, const JsonValue& value, int least, int most) {
    if (value.kind != JsonValue::Kind::array || value.items.size() != 2) {
        report_problem(reading, value, "expected two whole numbers, one for each direction, found " + described(value));
        return std::nullopt;
    }
    const auto first = read_integer(reading, value.items[0], least, most),
               second = read_integer(reading, value.items[1], least, most);
    if (!first || !second) return std::nullopt;
    return std::array<int, 2>{*first, *second};
}

/// Knots in both directions, or a number of cells: not a mixture.
void check_combination(SceneReading& reading, const JsonValue& value) {
    const JsonValue* x = find_member(value, "x");
    const JsonValue* y = find_member(value, "y");
    const JsonValue* cells = find_member(value, "cells");
    const JsonValue* offset = find_member(value, "offset");
    if (cells && (x || y))
        report_problem(reading, *cells, "'cells' cannot be combined with knots", "give 'x' and 'y', or 'cells'");
    else if (!cells && !(x && y))
        report_problem(reading, value, "the grid is incomplete", "give the knots 'x' and 'y', or 'cells'");
    if (offset && !cells) report_problem(reading, *offset, "'offset' belongs to 'cells'", "move the knots instead");
}

std::optional<GridOptions::Halved> read_halved(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"from", "to", "levels"})) return std::nullopt;
    const auto a = required_member(reading, value, "from", read_vector, dimension::length),
               b = required_member(reading, value, "to", read_vector, dimension::length);
    const JsonValue* levels = find_member(value, "levels");
    const auto n = levels ? read_integer(reading, *levels, 1, most_levels) : 1;
    if (!a || !b || !n) return std::nullopt;
    return GridOptions::Halved{a->cwiseMin(*b), a->cwiseMax(*b), *n};
}

GridOptions read_grid(SceneReading& reading, const JsonValue& value) {
    GridOptions grid;
    grid.where = value.pointer;
    if (!check_object(reading, value, {"x", "y", "cells", "offset", "angle", "degree", "refine"})) return grid;
    check_combination(reading, value);
    if (const JsonValue* x = find_member(value, "x")) grid.x = read_knots(reading, *x);
    if (const JsonValue* y = find_member(value, "y")) grid.y = read_knots(reading, *y);
    if (const JsonValue* cells = find_member(value, "cells"))
        grid.cells = read_integers(reading, *cells, 1, most_cells).value_or(grid.cells);
    grid.offset = member_or(reading, value, "offset", grid.offset, read_vector, dimension::length);
    grid.angle = member_or(reading, value, "angle", 0.0, read_number, dimension::angle) * std::numbers::pi / 180;
    if (const JsonValue* degree = find_member(value, "degree"))
        grid.degree = read_integers(reading, *degree, least_degree, most_degree);
    if (const JsonValue* refine = find_member(value, "refine"); refine && check_list(reading, *refine, 0, "boxes"))
        for (const JsonValue& item : refine->items)
            if (const auto halved = read_halved(reading, item)) grid.refine.push_back(*halved);
    return grid;
}

}  // namespace

std::map<std::string, GridOptions> read_grids(SceneReading& reading, const JsonValue& grids) {
    std::map<std::string, GridOptions> result;
    if (grids.kind != JsonValue::Kind::object) {
        report_problem(reading, grids, "expected an object with a key for each part, found " + described(grids));
        return result;
    }
    for (const JsonValue& item : grids.items) {
        check_part_name(reading, item, item.key);
        result.emplace(item.key, read_grid(reading, item));
    }
    return result;
}

}  // namespace abut
