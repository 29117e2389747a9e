// SPDX-License-Identifier: GPL-3.0-or-later
// Where the traction that loads put on a smooth edge jumps: where a pressure on part of a face ends. The stress beside such a
// place depends on the direction from it, however near, and no spline follows that.
#pragma once
#include <vector>

#include "src/plan/boundary_conditions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A place where the traction jumps.
struct LoadEnd {
    Vec2 at;    ///< assembly coordinates
    Vec2 jump;  ///< force per area
};

/// The places of one part of the scene, by the loads that its edges carry together, and the pressures of contacts that begin
/// where a load ends. At corners, between whose sides the traction may differ without a jump of the stress, there is none.
std::vector<LoadEnd> load_ends(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                               int part);

}  // namespace abut
