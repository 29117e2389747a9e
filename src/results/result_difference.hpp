// SPDX-License-Identifier: GPL-3.0-or-later
// Two results beside each other, from their result.json.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace abut {

/// A number of both results.
struct ComparedNumber {
    std::string of, quantity;    ///< "pin/hA16 - bracket/h9C", "max pressure"
    std::optional<double> a, b;  ///< unset: that result has no such contact or part, or no such number
    double known = 0;            ///< how well both are known together, absolute: the sum of their stated errors; 0: not told
};
/// The difference relative to the larger of both; nothing where one is missing, 0 where both are 0.
std::optional<double> relative_difference(const ComparedNumber& number);
/// Do they differ by more than both are known to? False where that is not told.
bool exceeds_errors(const ComparedNumber& number);

/// Numbers of parts, contacts, probes and supports of two results, in the order of the first, then what only the second has.
struct ResultDifference {
    std::string verdict_a, verdict_b;  ///< as result.json has them
    std::vector<ComparedNumber> numbers;
};
/// Compares two texts of result.json; names: of the files, for messages. Contacts are the same where their edges are (of
/// several on the same edges the first is the first), parts where their names are. Throws InputError where a text is none.
ResultDifference compare_results(const std::string& a, const std::string& name_a, const std::string& b,
                                 const std::string& name_b);

/// The differences as plain text: a line for each number.
std::string difference_table(const ResultDifference& difference);
/// The cells of that table, the heading first: of, quantity, A, B, change, remark.
std::vector<std::vector<std::string>> difference_rows(const ResultDifference& difference);

}  // namespace abut
