// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/verification/verify_dissertation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"

namespace abut {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The comparison of one cell: judged, or recorded beside the reference or the printed value.
Quantity quantity_of(const DissertationLine& line, std::size_t column) {
    Quantity q{line.what, {}, line.reference.value_or(line.mesh_free.value_or(unknown)), std::nullopt, 0};
    for (const Judged& judged : line.judged) {
        if (static_cast<std::size_t>(judged.column) != column) continue;
        q.tolerance = judged.tolerance;
        if (!judged.below_printed) continue;
        q.reference = 0;
        q.scale = *line.mesh_free;
    }
    return q;
}

std::optional<VerifyRow> cell_of(const DissertationTable& table, const DissertationLine& line, std::size_t column,
                                 const Result& answer, double seconds) {
    const bool failed = answer.status != "ok";
    const std::optional<double> value = failed ? unknown : line.value(answer);
    if (!value) return std::nullopt;
    VerifyRow row = compared(quantity_of(line, column), *value);
    row.name = "dissertation-" + table.name + "-" + ours_name[column];
    row.unknowns = answer.unknowns + answer.multipliers;
    row.seconds = seconds;
    if (failed) row.failure = "the analysis failed: " + answer.message;
    return row;
}

std::string printed(const std::optional<double>& value, const std::string& mark) {
    return value ? number_text(*value, 4) + mark : "-";
}

std::string ours_text(const std::optional<VerifyRow>& cell) {
    if (!cell) return "-";
    if (!std::isfinite(cell->value)) return "none";
    return number_text(cell->value, 5) + (cell->pass ? (cell->tolerance ? " *" : "") : " MISSED");
}

TextRow line_text(const DissertationLine& line, const std::array<std::optional<VerifyRow>, n_ours>& cells) {
    TextRow row{"  " + line.what, line.unit, printed(line.ansys, ""), printed(line.mesh_free, line.mark)};
    for (const auto& cell : cells) row.push_back(ours_text(cell));
    row.push_back(line.reference ? number_text(*line.reference, 5) : "-");
    return row;
}

std::string table_text(const SolvedTable& solved) {
    std::vector<TextRow> text{{"", "unit", "ANSYS", "mesh-free", "written", "penalty", "mortar", "default", "reference"}};
    for (std::size_t k = 0; k < solved.cells.size(); ++k) text.push_back(line_text(solved.table.lines[k], solved.cells[k]));
    std::string result = solved.table.title + "\n" + aligned(text);
    for (const std::string& note : solved.table.notes) result += "  " + note + "\n";
    return result;
}

/// Table 5.2: the printed condition numbers, and ours of every column.
std::string conditions_text(const std::vector<SolvedTable>& solved) {
    std::vector<TextRow> text{{"", "ANSYS", "mesh-free", "written", "written, scaled", "penalty", "mortar", "default"}};
    for (const SolvedTable& table : solved) {
        const auto line = std::find_if(table.table.lines.begin(), table.table.lines.end(),
                                       [](const DissertationLine& l) { return l.what == whole_condition; });
        if (line == table.table.lines.end()) continue;
        TextRow row{"  " + table.table.name, printed(line->ansys, ""), printed(line->mesh_free, "")};
        const auto& written = table.answers[static_cast<std::size_t>(Ours::written)];
        row.push_back(printed(written ? written->solver.assembled_condition : std::nullopt, ""));
        for (const auto& answer : table.answers)
            row.push_back(answer ? number_text(answer->solver.condition_estimate, 4) : "-");
        text.push_back(std::move(row));
    }
    return "Table 5.2: condition numbers\n" + aligned(text) +
           "  Printed, and written: of the matrix of all parts with its penalties, not scaled (1-norm). Scaled, and all that\n"
           "  follow: of the diagonally scaled matrix of the part that has the largest (2-norm).\n";
}

}  // namespace

SolvedTable solve_table(const DissertationTable& table, const std::string& data_folder) {
    SolvedTable solved{table, {}, {}};
    solved.cells.resize(table.lines.size());
    for (std::size_t column = 0; column < n_ours; ++column) {
        if (!table.runs[column]) continue;
        const auto begin = std::chrono::steady_clock::now();
        solved.answers[column] = answer_of(*table.runs[column], data_folder);
        const Result& answer = *solved.answers[column];
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        for (std::size_t k = 0; k < table.lines.size(); ++k)
            solved.cells[k][column] = cell_of(table, table.lines[k], column, answer, seconds);
    }
    return solved;
}

std::vector<VerifyRow> rows_of(const SolvedTable& solved) {
    std::vector<VerifyRow> rows;
    for (std::size_t column = 0; column < n_ours; ++column)
        for (const auto& cells : solved.cells)
            if (cells[column]) rows.push_back(*cells[column]);
    return rows;
}

std::string dissertation_text(const std::vector<SolvedTable>& solved) {
    std::string text =
        "ANSYS and mesh-free: as the dissertation prints them. On its grids: written, its method as it was written; penalty, "
        "mortar,\n"
        "ours. default: ours on the grids that abut chooses. * within its tolerance; the others are recorded. Units: F force, "
        "L "
        "length.\n\n";
    for (const SolvedTable& table : solved) text += table_text(table) + "\n";
    text += conditions_text(solved) + "\n";
    std::size_t judged = 0, missed = 0;
    for (const SolvedTable& table : solved)
        for (const VerifyRow& row : rows_of(table)) {
            judged += row.tolerance || !row.pass ? 1 : 0;
            missed += row.pass ? 0 : 1;
        }
    return text + std::to_string(judged - missed) + " of " + std::to_string(judged) + " values are within their tolerance\n";
}

std::string dissertation_list() {
    return aligned({{"dissertation", "its tables 4.1-4.5, 5.1 and 5.2, printed values beside ours"}});
}

}  // namespace abut
