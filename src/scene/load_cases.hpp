// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

/// The scene under the loads of one of its cases: loads times their factors, those that do not act left out; what is expected
/// of this case alone. It has no cases.
Scene scene_of_case(const Scene& scene, const LoadCase& load_case);

/// The loads that act in any of the scene's cases, as they are given.
std::vector<Load> acting_loads(const Scene& scene);

/// The case of this name. Throws InputError where the scene has none.
const LoadCase& case_named(const Scene& scene, const std::string& name);

/// Throws InputError where the scene has cases: for commands that answer one set of loads.
void refuse_cases(const Scene& scene);

}  // namespace abut
