// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "apps/arguments.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// --accuracy, where it is given, stands for the scene's level or target. Throws InputError if it is neither.
void override_accuracy(Accuracy& accuracy, const Arguments& arguments);

/// --budget, where it is given, stands for the scene's. Throws InputError if it is no bound on time or memory.
void override_budget(Accuracy& accuracy, const Arguments& arguments);

}  // namespace abut
