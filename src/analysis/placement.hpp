// SPDX-License-Identifier: GPL-3.0-or-later
// Parts where the loads take them. Contact is paired where parts are drawn; a part that is free to move and goes far before it
// rests is paired anew where it has gone.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A part's rigid motion in a solution: what its free motions make up of its displacement, in assembly coordinates.
solver::RigidMotion rigid_motion_of(const SolvedAssembly& solved, std::size_t grid);

/// A scene whose parts stand where they came to rest.
struct PlacedScene {
    Scene scene;
    std::vector<std::string> moved;  ///< "pin by (0, -4)", "lever by (0.1, -2) and 3.5 degrees"
};

/// The scene with its parts where they came to rest. Nothing where no part moves by more than `placed_fraction` of its own
/// size, or a load is given by expressions of the place or a support prescribes a motion. Edges keep their numbers and
/// parameters, so that conditions resolved before hold. Parts may overlap a little: contact presses them apart.
std::optional<PlacedScene> placed_at_rest(const Scene& scene, const SolvedAssembly& solved);

/// The motion of a part, over its size, from which on it is placed: pairs of curved faces that were found where a part was
/// drawn err by about the square of that.
inline constexpr double placed_fraction = 0.05;

}  // namespace abut
