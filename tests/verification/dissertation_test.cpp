// SPDX-License-Identifier: GPL-3.0-or-later
// `abut verify dissertation`: its tables, their judgement, their text.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "src/verification/verify_dissertation.hpp"

namespace abut::dissertation_test {
namespace {

const std::string data = ABUT_SOURCE_DIR "/data";

DissertationTable table_named(const std::string& name) {
    for (const DissertationTable& table : dissertation_tables())
        if (table.name == name) return table;
    throw std::out_of_range(name);
}

/// The table without the default column, which takes longest.
DissertationTable on_its_grids(const std::string& name) {
    DissertationTable table = table_named(name);
    table.runs[static_cast<std::size_t>(Ours::automatic)].reset();
    return table;
}

void expect_passes(const SolvedTable& solved, std::size_t least_judged) {
    std::size_t judged = 0;
    for (const VerifyRow& row : rows_of(solved)) {
        EXPECT_TRUE(row.pass) << row.name << ": " << row.quantity << " = " << row.value << ", not " << row.reference << " "
                              << row.failure;
        judged += row.tolerance.has_value();
    }
    EXPECT_GE(judged, least_judged);
}

class DissertationTables : public ::testing::TestWithParam<std::string> {};
TEST_P(DissertationTables, AreWithinTheirTolerances) {
    expect_passes(solve_table(on_its_grids(GetParam()), data), 4);
}
std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(All, DissertationTables, ::testing::Values("A", "B", "C", "beam", "beam-points", "vise"), test_name);

class LongDissertationTables : public ::testing::TestWithParam<std::string> {};
TEST_P(LongDissertationTables, AreWithinTheirTolerancesByDefault) {
    expect_passes(solve_table(table_named(GetParam()), data), 5);
}
INSTANTIATE_TEST_SUITE_P(Long, LongDissertationTables, ::testing::Values("A", "B", "C", "beam", "vise"), test_name);

/// Printed values that our errors do not stay below, other grids, another reference: each is missed.
TEST(DissertationJudgement, CanMiss) {
    DissertationTable table = on_its_grids("B");
    for (DissertationLine& line : table.lines) {
        if (line.what == "error of the pressure at the five points") line.mesh_free = 0.01;
        if (line.what == "cells of the grids") line.mesh_free = 373;
        if (line.what == "largest pressure") line.reference = 4000;
    }
    std::set<std::string> missed;
    for (const VerifyRow& row : rows_of(solve_table(table, data)))
        if (!row.pass) missed.insert(row.quantity);
    EXPECT_EQ(missed,
              (std::set<std::string>{"error of the pressure at the five points", "cells of the grids", "largest pressure"}));
}

TEST(DissertationJudgement, AnAnalysisThatFailsIsMissed) {
    DissertationTable table = on_its_grids("vise");
    table.runs = {std::nullopt, VerifyRun{"verification/slope.json"}, std::nullopt};
    for (const VerifyRow& row : rows_of(solve_table(table, data))) {
        EXPECT_FALSE(row.pass) << row.quantity;
        EXPECT_NE(row.failure.find("failed"), std::string::npos);
    }
}

TEST(DissertationText, ShowsPrintedValuesBesideOurs) {
    const SolvedTable solved = solve_table(on_its_grids("B"), data);
    const std::string text = dissertation_text({solved});
    for (const char* words :
         {"ANSYS", "mesh-free", "written", "Table 5.2", "penalty", "mortar", "default", "reference", "Case B", "0.257", "0.123",
          "3513", "3511", "984 (1)", "768, a misprint", "F/L^2", "within their tolerance"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 132U) << line;
}

TEST(DissertationText, JsonHasARowForEveryValueOfOurs) {
    const SolvedTable solved = solve_table(on_its_grids("C"), data);
    const auto rows = nlohmann::json::parse(verify_json(rows_of(solved)));
    // the condition number of the whole matrix is the dissertation's method's alone
    EXPECT_EQ(rows.size(), 3 * solved.table.lines.size() - 2);
    std::set<std::string> names;
    for (const auto& row : rows) names.insert(row["name"]);
    EXPECT_EQ(names, (std::set<std::string>{"dissertation-C-mortar", "dissertation-C-penalty", "dissertation-C-written"}));
}

}  // namespace
}  // namespace abut::dissertation_test
