// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/accuracy_goal.hpp"

#include <cmath>

namespace abut {

namespace {

/// Away from the ends of contact errors fall faster than with the cell size: quadratic splines' pressures and stresses.
constexpr double coarseness_exponent = 0.15;

}  // namespace

double target_of(const Accuracy& accuracy) {
    if (accuracy.target) return *accuracy.target;
    if (accuracy.level == "draft") return draft_target;
    return accuracy.level == "fine" ? fine_target : standard_target;
}

double coarseness_of(const Accuracy& accuracy) {
    return std::pow(target_of(accuracy) / standard_target, coarseness_exponent);
}

}  // namespace abut
