// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/csv_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/brep/input_error.hpp"

namespace abut::csv_table_test {
namespace {

std::vector<Problem> faults_of(const std::string& text, Table (*parse)(const std::string&, const std::string&) = parse_csv) {
    try {
        parse(text, "t.csv");
    } catch (const InputError& error) { return error.problems(); }
    return {};
}

TEST(CsvTable, ReadsWhatSpreadsheetsWrite) {
    const Table table = parse_csv(
        "\xEF\xBB\xBF"
        "file, name ,P\r\n\"a,b.dxf\",\"say \"\"x\"\"\",1.5\r\n\r\n# a remark\nc.dxf,,\n\"two\nlines\",d",
        "t.csv");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"file", "name", "P"}));
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(cell(table.rows[0], "file"), "a,b.dxf");
    EXPECT_EQ(cell(table.rows[0], "name"), "say \"x\"");
    EXPECT_EQ(cell(table.rows[0], "P"), "1.5");
    EXPECT_EQ(cell(table.rows[1], "name"), std::nullopt);
    EXPECT_EQ(cell(table.rows[2], "file"), "two\nlines");
    EXPECT_EQ(table.rows[0].line, 2);
    EXPECT_EQ(table.rows[1].line, 5);
    EXPECT_EQ(place_of(table, table.rows[2]), "t.csv:6");
}

TEST(CsvTable, NamesEveryFaultWithItsLine) {
    const auto faults = faults_of("a,b,a,\n1,2,3,4,5\n\"open");
    ASSERT_EQ(faults.size(), 4U);
    EXPECT_NE(faults[0].what.find("two columns 'a'"), std::string::npos);
    EXPECT_NE(faults[1].what.find("column 4 has no name"), std::string::npos);
    EXPECT_EQ(faults[2].where, "t.csv:2");
    EXPECT_EQ(faults[3].where, "t.csv:3");
    EXPECT_EQ(faults_of("").size(), 1U);
    EXPECT_NE(faults_of("a;b\n1;2\n").at(0).what.find("semicolons"), std::string::npos);
    EXPECT_NE(faults_of("a\n\"x\"y\n").at(0).what.find("after the quotes"), std::string::npos);
    EXPECT_TRUE(faults_of("a,b\n1\n").empty());  // fields that are missing at the end are empty
}

TEST(CsvTable, ReadsJsonLines) {
    const Table table = parse_json_lines("{\"file\": \"a.dxf\", \"P\": 0.1}\n\n{\"Q\": 1e3, \"name\": null}\n", "t.jsonl");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"file", "P", "Q", "name"}));
    EXPECT_EQ(cell(table.rows[0], "P"), "0.1");
    EXPECT_EQ(cell(table.rows[1], "Q"), "1000");
    EXPECT_EQ(cell(table.rows[1], "name"), std::nullopt);
    EXPECT_EQ(table.rows[1].line, 3);
}

TEST(CsvTable, NamesFaultsOfJsonLines) {
    const auto faults = faults_of("{\"a\": [1]}\n5\n{\"a\": \n", parse_json_lines);
    ASSERT_EQ(faults.size(), 3U);
    EXPECT_EQ(faults[0].where, "t.csv:1 /a");
    EXPECT_EQ(faults[1].where, "t.csv:2");
    EXPECT_EQ(faults[2].where, "t.csv:3");
}

/// Texts of the characters that mean something, 10 000 of them: refused in words, or rows whose cells have a column.
TEST(CsvTable, AnyTextIsATableOrRefused) {
    std::mt19937 random(7);
    const std::string letters = "a1,\"\"\n\r# \t{}:[]";
    int tables = 0, refused = 0;
    for (int k = 0; k < 10000; ++k) {
        std::string text;
        for (auto n = random() % 40; n > 0; --n) text += letters[random() % letters.size()];
        try {
            const Table table = k % 2 == 0 ? parse_csv(text, "t") : parse_json_lines(text, "t");
            ++tables;
            for (const TableRow& row : table.rows)
                for (const auto& [column, value] : row.cells)
                    ASSERT_TRUE(std::count(table.columns.begin(), table.columns.end(), column) == 1 && !value.empty()) << text;
        } catch (const InputError& error) {
            ++refused;
            for (const Problem& problem : error.problems()) ASSERT_FALSE(problem.where.empty() || problem.what.empty()) << text;
        }
    }
    EXPECT_GT(tables, 300);
    EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace abut::csv_table_test
