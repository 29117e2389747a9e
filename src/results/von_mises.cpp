// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "src/results/result.hpp"

namespace abut {

double von_mises(const Stress& stress) {
    // By differences, not by squares and products: exactly 0 under hydrostatic stress.
    const double a = stress.xx - stress.yy, b = stress.yy - stress.zz, c = stress.zz - stress.xx;
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * stress.xy * stress.xy);
}

}  // namespace abut
