// SPDX-License-Identifier: GPL-3.0-or-later
// Linear interpolation in tables of two columns.
#pragma once
#include <vector>

namespace abut {

/// The value of `to` at v in `from`, which ascends; beyond its ends the first and the last piece are continued. At least two
/// entries.
double interpolate(const std::vector<double>& from, const std::vector<double>& to, double v);

}  // namespace abut
