// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/expected_pairs.hpp"

#include <algorithm>
#include <iterator>

#include "src/io/csv_table.hpp"
#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

bool names_side(const std::string& name, const DetectedPair& pair, std::size_t side) {
    const auto& edges = pair.edges[side];
    return name == pair.parts[side] || std::find(edges.begin(), edges.end(), name) != edges.end();
}

bool names_pair(const ExpectedPair& e, const DetectedPair& p) {
    return (names_side(e.names[0], p, 0) && names_side(e.names[1], p, 1)) ||
           (names_side(e.names[1], p, 0) && names_side(e.names[0], p, 1));
}

std::string not_found(const ExpectedPair& e, const Detection& detection) {
    const std::string line = "expected " + e.names[0] + " - " + e.names[1] + ", not found";
    for (const DetectedPair& p : detection.near_misses)
        if (names_pair(e, p)) return line + ": " + p.why;
    return line;
}

using Rows = std::vector<const DetectedPair*>;

/// Closest first.
int closeness(const DetectedPair& p) {
    return p.status == "overlap" ? 0 : p.status == "touching" ? 1 : 2;
}

/// Have the rows that one expectation names the status, of their closest, and among these the interface that are expected?
/// Notes where not.
bool is_as_expected(const ExpectedPair& e, const Rows& rows, std::vector<std::string>& differences) {
    const DetectedPair& closest = **std::min_element(
        rows.begin(), rows.end(), [](const auto* a, const auto* b) { return closeness(*a) < closeness(*b); });
    const std::string who = closest.parts[0] + " - " + closest.parts[1] + ": ";
    const std::size_t before = differences.size();
    if (!e.status.empty() && e.status != closest.status)
        differences.push_back(who + "status " + closest.status + ", expected " + e.status + " (" + closest.why + ")");
    const auto has_interface = [&](const DetectedPair* p) {
        return p->status == closest.status && p->interface == e.interface;
    };
    if (!e.interface.empty() && std::none_of(rows.begin(), rows.end(), has_interface))
        differences.push_back(who + "interface " + closest.interface + ", expected " + e.interface);
    return differences.size() == before;
}

/// The rows of each pair of parts; expectations are of pairs, however many zones these have.
std::vector<Rows> by_parts(const Detection& detection) {
    std::vector<Rows> pairs;
    for (const DetectedPair& p : detection.pairs) {
        const auto own = std::find_if(pairs.begin(), pairs.end(), [&](const Rows& r) { return r[0]->parts == p.parts; });
        if (own == pairs.end())
            pairs.push_back({&p});
        else
            own->push_back(&p);
    }
    return pairs;
}

const std::vector<std::string> known_columns{"file", "part_1", "part_2", "status", "interface"};

void check_columns(const Table& table, std::vector<Problem>& problems) {
    for (const std::string& column : table.columns)
        if (std::find(known_columns.begin(), known_columns.end(), column) == known_columns.end())
            problems.push_back(
                {table.file, "unknown column '" + shortened(column) + "'", nearest_name_hint(column, known_columns)});
}

void read_row(const Table& table, const TableRow& row, ExpectationTable& expectations, std::vector<Problem>& problems) {
    const auto text = [&](const char* column) { return cell(row, column).value_or(""); };
    const std::string file = text("file");
    const ExpectedPair pair{{text("part_1"), text("part_2")}, text("status"), text("interface")};
    if (file.empty() || pair.names[0].empty() != pair.names[1].empty()) {
        problems.push_back({place_of(table, row),
                            file.empty() ? "this row names no file" : "this row names one part of a pair only",
                            "a row is file,part_1,part_2; both parts empty: the file has no pair"});
        return;
    }
    std::vector<ExpectedPair>& pairs = expectations[file];
    if (!pair.names[0].empty()) pairs.push_back(pair);
}

}  // namespace

int count_pairs(const Detection& detection) {
    return static_cast<int>(by_parts(detection).size());
}

ExpectationCount count_expected(const Detection& detection, const std::vector<ExpectedPair>& expected) {
    const std::vector<Rows> pairs = by_parts(detection);
    ExpectationCount count;
    count.expected = static_cast<int>(expected.size());
    count.detected = static_cast<int>(pairs.size());
    std::vector<bool> named(pairs.size(), false), right(pairs.size(), false);
    for (const ExpectedPair& e : expected) {
        bool found = false, as_expected = false;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            Rows rows;
            std::copy_if(pairs[k].begin(), pairs[k].end(), std::back_inserter(rows),
                         [&](const DetectedPair* p) { return names_pair(e, *p); });
            if (rows.empty()) continue;
            found = named[k] = true;
            if (!is_as_expected(e, rows, count.differences)) continue;
            as_expected = right[k] = true;
        }
        count.expected_found += as_expected;
        if (!found) count.differences.push_back(not_found(e, detection));
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const DetectedPair& p = *pairs[k].front();
        if (!named[k]) count.differences.push_back("found " + p.parts[0] + " - " + p.parts[1] + ", not expected: " + p.why);
        count.detected_expected += right[k];
    }
    return count;
}

ExpectationTable read_expectation_table(const std::string& path) {
    if (!is_table(path))
        throw InputError(path, "the expected pairs of many files are a table",
                         "give a .csv or .jsonl file with the columns file,part_1,part_2");
    const Table table = read_table(path);
    std::vector<Problem> problems;
    check_columns(table, problems);
    ExpectationTable expectations;
    for (const TableRow& row : table.rows) read_row(table, row, expectations, problems);
    if (!problems.empty()) throw InputError(std::move(problems));
    return expectations;
}

const std::vector<ExpectedPair>* expected_for(const ExpectationTable& table, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const auto found = table.find(name);
        if (found != table.end()) return &found->second;
    }
    return nullptr;
}

}  // namespace abut
