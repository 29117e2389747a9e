// SPDX-License-Identifier: GPL-3.0-or-later
// Tables with a header: CSV as spreadsheets write it, and JSON lines.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// One row of a table.
struct TableRow {
    std::map<std::string, std::string> cells;  ///< by column; without those that are empty
    int line = 0;                              ///< where the row begins, from 1
};

struct Table {
    std::string file;
    std::vector<std::string> columns;  ///< in the order of their first appearance
    std::vector<TableRow> rows;
};

/// Reads a comma-separated table (RFC 4180): the first line names the columns, fields may be quoted; blanks around fields,
/// blank lines, lines that begin with # and a byte order mark are left out. Throws InputError with every fault: a row with more
/// fields than columns, quotes that do not close, columns without a name or with the same one.
Table parse_csv(const std::string& text, const std::string& file);

/// Reads a table of JSON lines: one object with texts and numbers a line; blank lines are left out. Throws InputError with
/// every fault.
Table parse_json_lines(const std::string& text, const std::string& file);

/// Reads a table by its ending, .csv or .jsonl (.ndjson). Throws InputError with every fault, and where the file cannot be
/// read.
Table read_table(const std::string& path);
/// Is the file a table by its ending?
bool is_table(const std::string& path);

/// The place of a row for messages: "file:12".
std::string place_of(const Table& table, const TableRow& row);
/// The cell's text, nothing where it is empty.
std::optional<std::string> cell(const TableRow& row, const std::string& column);

}  // namespace abut
