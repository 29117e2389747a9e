// SPDX-License-Identifier: GPL-3.0-or-later
// Where the stress of a part has no limit: re-entrant corners, ends of supports and of bonds, held points, ends of contact at
// corners, places where friction that slips turns round.
#pragma once
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut {

/// A place without a limit of the stress.
struct SingularPlace {
    Vec2 at;              ///< assembly coordinates
    double missed_share;  ///< what splines miss of the strain energy in the cells within a cell's size; 0 where not known
    bool is_of_contact = false;
    double growth = 0;  ///< stress grows like distance^-growth towards a re-entrant corner of the part; 0 at other places
};

/// The places of one part of the scene.
std::vector<SingularPlace> singular_places(const Scene& scene, const ResolvedConditions& conditions,
                                           const SolvedAssembly& solved, int part);

/// A boundary that turns by more, in radians, has a corner: as for the cells at re-entrant corners (grid_design).
constexpr double sharp_turn = 0.1;

/// How the boundary of a part turns to the left at one of its points; 0 within an edge.
double turn_at(const geometry::Part& part, const Vec2& place);

}  // namespace abut
