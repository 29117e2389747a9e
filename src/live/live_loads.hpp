// SPDX-License-Identifier: GPL-3.0-or-later
// A scene whose loads somebody moves: forces by their two components, all other loads by a factor.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/live/live_settings.hpp"
#include "src/scene/scene.hpp"
#include "src/session/prepared_scene.hpp"

namespace abut {

/// The numbers that are moved.
struct LiveInputs {
    std::map<std::string, double> parameters;  ///< those with a range, by name
    /// How each load of the scene was moved: its factor, or the two components of a force. A force that was not turned goes
    /// with the parameters that it is made of.
    std::vector<std::vector<double>> loads;
    LiveSettings settings{};  ///< those that were moved
    bool operator==(const LiveInputs&) const = default;
};

/// Is the load a force, which has a direction that can be turned?
bool is_live_force(const Load& load);
/// Such a force under what was moved.
Vec2 live_force(const Load& load, const std::vector<double>& moved);
/// Must the load's factor not be negative: a spin, which grows with the square of the speed, a preload?
bool keeps_its_sign(const Load& load);

/// The loads as the scene gives them, or as one of its cases has them.
std::vector<std::vector<double>> live_loads(const Scene& scene);
std::vector<std::vector<double>> live_loads(const Scene& scene, const LoadCase& load_case);

/// The scene with its loads as they were moved, under their own names, without cases: what is shown, saved and reported.
Scene scene_under(const Scene& scene, const LiveInputs& inputs);

/// The scene with every number that moves as a load of its own with a name of its own: what is prepared.
Scene with_unit_loads(const Scene& scene);
/// The factors of these loads.
LoadFactors unit_factors(const Scene& scene, const LiveInputs& inputs);

}  // namespace abut
