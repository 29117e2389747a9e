// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_inserts.hpp"

#include <algorithm>

#include "geometry/dxf/dxf_entities.hpp"
#include "geometry/dxf/dxf_numbers.hpp"

namespace abut::geometry::dxf {

Insert read_insert(const Record& record, const Vec2& base) {
    Numbers numbers(record);
    Insert insert;
    insert.block = record.text(2);
    const double angle = numbers(50, 0);
    const Placement mirror = is_seen_from_below(record) ? seen_from_below() : Placement{};
    const Placement turn = rotated_and_scaled(angle, 1, 1);
    Placement place = rotated_and_scaled(angle, numbers(41, 1), numbers(42, 1));
    place.base = base;
    place.shift = numbers.point(10);
    insert.first = composed(mirror, place);
    insert.column = numbers(44, 0) * mirror.turned(turn.x_axis);
    insert.row = numbers(45, 0) * mirror.turned(turn.y_axis);
    insert.n_columns = std::max(1, record.integer(70, 1));
    insert.n_rows = std::max(1, record.integer(71, 1));
    insert.wrong = numbers.wrong();
    return insert;
}

Placement placement_of(const Insert& insert, int row, int column) {
    Placement placement = insert.first;
    placement.shift += column * insert.column + row * insert.row;
    return placement;
}

}  // namespace abut::geometry::dxf
