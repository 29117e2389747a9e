// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/accuracy_option.hpp"

#include <algorithm>

#include "geometry/input_error.hpp"
#include "src/accuracy_goal.hpp"
#include "src/nearest_name.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

const std::vector<std::string> accuracy_levels{"draft", "standard", "fine"};

}  // namespace

void override_accuracy(Accuracy& accuracy, const Arguments& arguments) {
    if (!has(arguments, "--accuracy")) return;
    const std::string text = arguments.options.at("--accuracy");
    accuracy.target.reset();
    if (std::find(accuracy_levels.begin(), accuracy_levels.end(), text) != accuracy_levels.end()) {
        accuracy.level = text;
        return;
    }
    accuracy.target = to_number(text);
    if (accuracy.target && is_target(*accuracy.target)) return;
    const std::string numbers =
        " or a relative error from " + number_text(least_target, 1) + " to " + number_text(most_target, 1);
    throw InputError("--accuracy", "'" + shortened(text) + "' is no level and no error to aim at",
                     "use " + listed(accuracy_levels) + "," + numbers);
}

}  // namespace abut
