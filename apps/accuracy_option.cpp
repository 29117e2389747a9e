// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/accuracy_option.hpp"

#include <algorithm>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/scene/accuracy_goal.hpp"
#include "src/scene/scene_words.hpp"

namespace abut {

void override_accuracy(Accuracy& accuracy, const Arguments& arguments) {
    if (!has(arguments, "--accuracy")) return;
    const std::string text = arguments.options.at("--accuracy");
    accuracy.target.reset();
    const std::vector<std::string>& levels = accuracy_levels();
    if (std::find(levels.begin(), levels.end(), text) != levels.end()) {
        accuracy.level = text;
        return;
    }
    accuracy.target = to_number(text);
    if (accuracy.target && is_target(*accuracy.target)) return;
    const std::string numbers =
        " or a relative error from " + number_text(least_target, 1) + " to " + number_text(most_target, 1);
    throw InputError("--accuracy", "'" + shortened(text) + "' is no level and no error to aim at",
                     "use " + listed(levels) + "," + numbers);
}

void override_budget(Accuracy& accuracy, const Arguments& arguments) {
    if (!has(arguments, "--budget")) return;
    try {
        accuracy.budget = parse_budget(arguments.options.at("--budget"));
    } catch (const InputError& error) {
        throw InputError("--budget", error.problems().front().what, error.problems().front().hint);
    }
}

}  // namespace abut
