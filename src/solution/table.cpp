// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/table.hpp"

#include <algorithm>

namespace abut {

double interpolate(const std::vector<double>& from, const std::vector<double>& to, double v) {
    const auto after = std::upper_bound(from.begin() + 1, from.end() - 1, v) - from.begin();
    const auto k = static_cast<std::size_t>(after) - 1;
    return to[k] + (v - from[k]) / (from[k + 1] - from[k]) * (to[k + 1] - to[k]);
}

}  // namespace abut
