// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of a contact's faces where these have moved to.
#pragma once
#include <array>

#include "solver/parts/part_system.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// One of a contact's parts, gone with its face in a solution (face_motion.hpp).
struct PlacedFace {
    solver::RigidMotion motion;
    geometry::Part there;
};
using PlacedFaces = std::array<PlacedFace, 2>;
PlacedFaces placed_faces(const Scene& scene, const SolvedAssembly& solved, std::size_t contact);

/// What the motions open a pair as drawn by, along its normal.
double opening(const PlacedFaces& faces, const geometry::FacingPair& drawn);

/// The pair there of the same place on the rounder face as in a pair as drawn; `found` tells whether there is one.
geometry::FacingPair placed_pair(const ContactInterface& contact, const PlacedFaces& faces, const geometry::FacingPair& drawn);

/// How much farther apart the faces of pressed contacts are where they have moved to than by their drawn gap and motions along
/// its normals, by contact: round faces that slide along each other open by s^2 / 2 (R1 + R2). 0 of others, and of flat faces.
/// Elastic parts are taken as strained by that motion, whose stretching of what turns is no part of it.
std::vector<double> gaps_left_out(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
