// SPDX-License-Identifier: GPL-3.0-or-later
// Functional interfaces and mobility as JSON texts, for result.json and contacts.json.
#pragma once
#include <string>

#include "src/results/result.hpp"

namespace abut {

/// A functional interface as JSON: {"kind", "diameters", "clearance", "center" or "at" and "normal", "wrenches": [[fx, fy, m]],
/// "twists": [[vx, vy, w]]}; parameters that the kind does not have are left out.
std::string functional_json(const FunctionalInterface& interface);

/// The mobility as JSON: {"degrees_of_freedom", "gruebler", "redundant", "parts": [{"part", "wrenches", "twists", "free":
/// [{"twist", "motion"}]}]}
std::string mobility_json(const MobilityResult& mobility);

}  // namespace abut
