// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of effects as `analyze --plan` prints it.
#pragma once
#include <string>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// The plan as text, one line per effect: its name, on or off, why, and the parts or pairs that it concerns.
std::string plan_table(const std::vector<Effect>& effects);
/// The plan as JSON: an array of objects with the keys of `effects` in result.json, without the seconds.
std::string plan_json(const std::vector<Effect>& effects);

}  // namespace abut
