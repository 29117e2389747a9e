// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "geometry/sketch.hpp"

namespace abut {

/// Throws them as an InputError, each with file, line, entity and place; returns where there are none.
void throw_if_any(const std::string& file, const std::vector<geometry::SketchProblem>& problems);

}  // namespace abut
