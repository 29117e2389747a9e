// SPDX-License-Identifier: GPL-3.0-or-later
// Verification as text: the table, the JSON, the list of problems.
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/verification/verify.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);  // JSON has no other word for it
}

Json row_json(const VerifyRow& row) {
    return {{"name", row.name},
            {"quantity", row.quantity},
            {"value", number(row.value)},
            {"reference", number(row.reference)},
            {"relative_error", number(row.relative_error)},
            {"tolerance", row.tolerance ? number(*row.tolerance) : Json(nullptr)},
            {"pass", row.pass},
            {"unknowns", row.unknowns},
            {"seconds", row.seconds}};
}

std::string verdict(const VerifyRow& row) {
    if (!row.pass) return "MISSED";
    return row.tolerance ? "pass" : "recorded";
}

TextRow table_row(const VerifyRow& row) {
    const std::string value = row.failure.empty() ? number_text(row.value, 7) : "none";
    const std::string error = row.failure.empty() ? number_text(row.relative_error, 2) : "";
    return {row.name,
            row.quantity,
            value,
            number_text(row.reference, 7),
            error,
            row.tolerance ? number_text(*row.tolerance, 2) : "",
            verdict(row),
            std::to_string(row.unknowns),
            number_text(row.seconds, 2)};
}

}  // namespace

std::string verify_table(const std::vector<VerifyRow>& rows) {
    std::vector<TextRow> table{
        {"problem", "quantity", "value", "reference", "rel. error", "tolerance", "", "unknowns", "seconds"}};
    std::size_t missed = 0, judged = 0;
    for (const VerifyRow& row : rows) {
        table.push_back(table_row(row));
        missed += row.pass ? 0 : 1;
        judged += row.tolerance || !row.pass ? 1 : 0;
    }
    return aligned(table) + "\n" + std::to_string(judged - missed) + " of " + std::to_string(judged) +
           " quantities are within their tolerance\n";
}

std::string verify_json(const std::vector<VerifyRow>& rows) {
    std::string text = "[", between = "\n  ";
    for (const VerifyRow& row : rows) {
        text += between + row_json(row).dump();
        between = ",\n  ";
    }
    return text + "\n]\n";
}

std::string verify_list(const std::vector<VerifyProblem>& problems) {
    std::vector<TextRow> table;
    for (const VerifyProblem& problem : problems) table.push_back({problem.name, problem.about});
    return aligned(table);
}

}  // namespace abut
