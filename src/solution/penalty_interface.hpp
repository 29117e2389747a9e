// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's contact elements [Grishin10, section 4.5.2]: points along the first body's own edge, those of Gauss' rule
// in each of its cells, that press with beta times their penetration.
#pragma once
#include "src/solution/interface_points.hpp"

namespace abut {

/// Makes the penalty interface of a zone, the first part as the master. Points a piece of a cell: its grid's degree + 1. beta
/// by the scene's PenaltyOptions, which must be set.
ContactInterface make_penalty_interface(const Scene& scene, const geometry::FacingZone& zone, const PartOnGrid& first,
                                        const PartOnGrid& second, std::array<int, 2> solver_part, const GapRule& rule);

}  // namespace abut
