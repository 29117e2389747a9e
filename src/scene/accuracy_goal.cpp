// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/accuracy_goal.hpp"

#include <cmath>

namespace abut {

namespace {

/// Of the target. Away from the ends of contact errors fall faster than with the cell size.
constexpr double exponent_with_contact = 0.15, exponent_without = 0.37;

}  // namespace

double target_of(const Accuracy& accuracy) {
    if (accuracy.target) return *accuracy.target;
    if (accuracy.level == "draft") return draft_target;
    return accuracy.level == "fine" ? fine_target : standard_target;
}

double coarseness_of(const Accuracy& accuracy, bool has_contact) {
    return std::pow(target_of(accuracy) / standard_target, has_contact ? exponent_with_contact : exponent_without);
}

bool grids_are_fixed(const Scene& scene) {
    if (scene.accuracy.grids.size() >= scene.parts.size()) return true;
    if (scene.accuracy.adapt) return !*scene.accuracy.adapt;
    return scene.accuracy.cell_size || !scene.accuracy.grids.empty();
}

}  // namespace abut
