// SPDX-License-Identifier: GPL-3.0-or-later
// Detected pairs against those that are expected.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "src/contact/detect.hpp"

namespace abut {

struct ExpectedPair {
    std::array<std::string, 2> names;  ///< parts, or edges ("part/edge"), in either order
    std::string status, interface;     ///< empty: any
};

/// The number of pairs of parts, however many zones these have.
int count_pairs(const Detection& detection);

/// How detected pairs compare with expected ones.
struct ExpectationCount {
    int expected = 0, expected_found = 0;     ///< recall is their ratio
    int detected = 0, detected_expected = 0;  ///< precision is theirs
    std::vector<std::string> differences;     ///< one line each
};

/// Counts: each expected pair is looked for, each detected one has to be expected; differences as lines, in that order. A pair
/// whose status or interface is another than the expected one counts as neither found nor expected.
ExpectationCount count_expected(const Detection& detection, const std::vector<ExpectedPair>& expected);

/// Expected pairs of many files. A file without pairs of its own may still be there: nothing is to be found in it.
using ExpectationTable = std::map<std::string, std::vector<ExpectedPair>>;

/// Reads a table (.csv, .jsonl) with a row for each pair: "file", "part_1", "part_2" (both empty: no pair at all), and, if
/// wanted, "status" and "interface". Throws InputError.
ExpectationTable read_expectation_table(const std::string& path);

/// The pairs of the first of these names that the table has; nullptr where it has none.
const std::vector<ExpectedPair>* expected_for(const ExpectationTable& table, const std::vector<std::string>& names);

}  // namespace abut
