// SPDX-License-Identifier: GPL-3.0-or-later
// Runs scenes given as text or as files of data/, as a user would.
#pragma once
#include <string>
#include <vector>

#include "src/analysis/analysis.hpp"

namespace abut::test {

/// Analyses a scene given as JSON text.
Result answer(const std::string& json);
/// Analyses all cases or steps of a scene given as JSON text; one of a scene without.
std::vector<Result> answer_of_cases(const std::string& json);
/// Analyses a file below the source folder.
Result answer_file(const std::string& path);

/// Do these words stand in one of the warnings?
bool warns(const std::vector<std::string>& warnings, const std::string& words);

/// "[x, y]" with all digits.
std::string pair_text(double x, double y);
std::string number(double v);

}  // namespace abut::test
