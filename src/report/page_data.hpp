// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut::report {

/// What the page's script shows, as JSON that may stand in a script element: parts with their fields (packed_field.hpp),
/// contacts with their profiles, supports, loads and reactions. Numbers of tables are those of result.json to the last bit;
/// those of curves have seven digits.
std::string page_data(const Result& result, const ModelFacts& model);

/// One load case or step of a page over several.
struct CaseTab {
    std::string name, loads, verdict, sentence;  ///< verdict: its word
    std::string data;                            ///< page_data of its result
};
/// What the script shows of several cases, or of steps.
std::string tabs_data(const std::vector<CaseTab>& cases, bool in_steps);

/// The fields of the parts alone, by part, as page_data has them.
std::string fields_data(const std::vector<geometry::Part>& parts, const std::vector<PartField>& fields);

}  // namespace abut::report
