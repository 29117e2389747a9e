// SPDX-License-Identifier: GPL-3.0-or-later
// Pages made anew from reports that were written before.
#pragma once
#include <optional>
#include <string>

#include "src/results/result_difference.hpp"

namespace abut {

/// The report with the style and the script of this program, its words and pictures as they were. Throws InputError where the
/// text is no report of abut; name: of the file.
std::string remade_report(const std::string& html, const std::string& name);

/// A page of two reports: the table of their differences, and both in one instrument, by tabs. Throws as above.
std::string compare_html(const ResultDifference& difference, const std::string& html_a, const std::string& name_a,
                         const std::string& html_b, const std::string& name_b);

}  // namespace abut
