// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "apps/arguments.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// --accuracy, where it is given, stands for the scene's level or target. Throws InputError if it is neither.
void override_accuracy(Accuracy& accuracy, const Arguments& arguments);

}  // namespace abut
