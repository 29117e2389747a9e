// SPDX-License-Identifier: GPL-3.0-or-later
// INSERT records: which block, where, and how often.
#pragma once
#include <string>

#include "geometry/dxf/dxf_placement.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// Rows and columns of one block.
struct Insert {
    std::string block;  ///< its name as the record writes it
    Placement first;    ///< of the instance in row 0, column 0
    Vec2 column{0, 0}, row{0, 0};
    int n_columns = 1, n_rows = 1;
    std::string wrong;  ///< as one line for the user; empty if nothing is
};

/// Reads an INSERT record. `base`: the block's base point. Steps between rows and columns turn with the insert and are not
/// scaled.
Insert read_insert(const Record& record, const Vec2& base);
Placement placement_of(const Insert& insert, int row, int column);

}  // namespace abut::geometry::dxf
