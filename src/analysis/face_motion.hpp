// SPDX-License-Identifier: GPL-3.0-or-later
// How a part moves where a contact is: an arm that bends takes its end along, however its other parts move.
#pragma once
#include "solver/parts/part_system.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The rigid motion in a solution that comes nearest to the displacements of one of a contact's two faces, in assembly
/// coordinates about the face's middle. Along itself a face goes, and it turns, as its part does in the mean (not at all where
/// edges of that are held), unless it does otherwise by more than what it is pressed in by, and is no half of a symmetric
/// contact. Around an axis the part's motion, which is along it. The contact is coupled.
solver::RigidMotion face_motion(const SolvedAssembly& solved, std::size_t contact, std::size_t side);

/// Is the contact half of one that goes on beyond a line of symmetry? Supports hold one of its parts along the face at its end.
bool ends_at_mirror(const SolvedAssembly& solved, std::size_t contact);

/// The load (2n) of a force and a moment about a point on a part, both in assembly coordinates, which one of a contact's faces
/// takes like a rigid plate on an even bed of springs.
Eigen::VectorXd load_on_face(const SolvedAssembly& solved, std::size_t contact, std::size_t side, const Vec2& force,
                             double moment, const Vec2& about);

}  // namespace abut
