// SPDX-License-Identifier: GPL-3.0-or-later
// An HTML table.
#pragma once
#include <string>
#include <vector>

namespace abut::report {

/// A column: its heading, and whether its entries are numbers (set to the right) or words.
struct Column {
    std::string heading;
    bool number = false;
};

/// An HTML table. Entries are plain text and escaped here; a row may be shorter than the columns.
std::string html_table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows);

}  // namespace abut::report
