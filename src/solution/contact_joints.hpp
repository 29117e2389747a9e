// SPDX-License-Identifier: GPL-3.0-or-later
// Where edges meet within a contact without a corner, but with another curvature: a flat and its fillet, for instance. The
// pressure has a steep peak there.
#pragma once
#include <array>
#include <vector>

#include "src/solution/contact_interface.hpp"

namespace abut {

/// A place within a contact where the gap's curvature jumps.
struct ContactJoint {
    double s;               ///< on the middle curve
    std::array<Vec2, 2> x;  ///< of both bodies, in the assembly's frame
    double opening;         ///< by how much the gap's second derivative grows there, along the middle curve (1/length)
};

/// The joints of both chains, over the whole interface, that change the gap's curvature by half of it or more; ascending.
std::vector<ContactJoint> contact_joints(const Scene& scene, const ContactInterface& contact);

}  // namespace abut
