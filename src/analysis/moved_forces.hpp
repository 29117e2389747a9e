// SPDX-License-Identifier: GPL-3.0-or-later
// Where contacts' forces act, and along which lines, once parts have moved.
#pragma once
#include <cstddef>
#include <vector>

#include "solver/parts/free_motions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// How well it is known where a contact's force acts, of a part's size; what works less in a motion works nothing.
inline constexpr double known_places = 1e-3;
/// How well the place of a contact's force within it is known, of half the contact's length.
inline constexpr double known_within_contact = 0.05;

/// A contact's force on its first part: where and what it is in the solution, and as parts have moved if it keeps its size;
/// what else it can be there.
struct MovedForce {
    std::size_t contact;
    Vec2 drawn, moved;  ///< places
    Vec2 force{0, 0}, turned{0, 0};
    bool any_direction = false;  ///< a joint, or friction; what this bears then is looked at (beyond_friction)
    bool any_place = false;      ///< flat faces, bonds
    double virial = 0;           ///< the sum of place about `drawn` times force: round about a joint there is one
    Vec2 along{0, 0};            ///< from `drawn` to where the parts as drawn are closest
    Vec2 normal{0, 0};           ///< where the parts have moved; none in hollow faces, along which it differs
};

/// One for every stretch under pressure, and for those together that meet in a corner; contacts without pressure have none.
/// motions: of all parts that are solved, in their order (SolvedAssembly::grids), in assembly coordinates.
std::vector<MovedForce> moved_forces(const Scene& scene, const SolvedAssembly& solved,
                                     const std::vector<solver::RigidMotion>& motions);
/// Finds them where each face moves as it does in the solution (face_motion.hpp).
std::vector<MovedForce> moved_forces(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
