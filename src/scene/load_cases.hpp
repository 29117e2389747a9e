// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

/// What one of the scene's cases is called: "load case", or "step".
std::string case_word(const Scene& scene);

/// The case on the way from one to another: factors of named loads in between.
LoadCase between(const LoadCase& from, const LoadCase& to, double fraction);

/// The scene under the loads of one of its cases: loads times their factors, those that do not act left out, but for
/// steps' that act in another one; what is expected of this case alone. It has no cases.
Scene scene_of_case(const Scene& scene, const LoadCase& load_case);

/// The loads that act in any of the scene's cases, as they are given.
std::vector<Load> acting_loads(const Scene& scene);

/// The case of this name. Throws InputError where the scene has none, and where it is a step, which needs those before it.
const LoadCase& case_named(const Scene& scene, const std::string& name);

/// Throws InputError where the scene has cases: for commands that answer one set of loads.
void refuse_cases(const Scene& scene);

}  // namespace abut
