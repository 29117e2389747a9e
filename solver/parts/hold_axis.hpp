// SPDX-License-Identifier: GPL-3.0-or-later
// u_x = 0 on the axis that a part touches: without it the hoop strain u_x / r has no finite energy.
#pragma once
#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// Drops the functions of the first grid line, in x: exact and free. Where the basis continues functions from there to cells
/// farther on, so that dropping would hold more: a penalty of gamma = nitsche_factor degree^2 d11 per length of the axis, along
/// the first column's cells. It needs no traction to be consistent, since that of a ring of radius 0 does no work. What was
/// done is in axis_hold; a support that moves the axis is a failure.
void hold_axis(PartSystem& system);

}  // namespace abut::solver
