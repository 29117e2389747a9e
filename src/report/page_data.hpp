// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/results/model_facts.hpp"
#include "src/results/result.hpp"

namespace abut::report {

/// What the page's script shows, as JSON that may stand in a script element: parts with their fields (packed_field.hpp),
/// contacts with their profiles, supports, loads and reactions. Numbers of tables are those of result.json to the last bit;
/// those of curves have seven digits.
std::string page_data(const Result& result, const ModelFacts& model);

}  // namespace abut::report
