// SPDX-License-Identifier: GPL-3.0-or-later
// Where the stress of a part has no limit: re-entrant corners, ends of supports and of bonds, held points, ends of contact at
// corners, places where friction that slips turns round.
#pragma once
#include <array>
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut {

/// A place without a limit of the stress.
struct SingularPlace {
    Vec2 at;              ///< assembly coordinates
    double missed_share;  ///< what splines miss of the strain energy in the cells within a cell's size; 0 where not known
    bool is_of_contact = false;
    double growth = 0;     ///< stress grows like distance^-growth towards a re-entrant corner, or a support's end; 0: not known
    bool is_held = false;  ///< a support ends there
};

/// An end of a bond at which tractions have no limit. A bond makes one body of two: their boundaries meet there in a corner,
/// which is re-entrant where both together fill more than half a turn; where no other bond of theirs goes on. Where they fill
/// half a turn it goes by their materials, unless a plane of symmetry or the axis cuts it off.
struct BondEnd {
    std::size_t contact;
    std::array<int, 2> parts;  ///< of the scene
    std::array<Vec2, 2> at;    ///< on each, assembly coordinates
    double excess;             ///< what they fill more than half a turn, radians
};
std::vector<BondEnd> singular_bond_ends(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved);

/// Does the largest pressure of a contact (peaks: by contact, where) stand at such an end?
std::vector<char> peaks_at_bond_ends(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                                     const std::vector<Vec2>& peaks);

/// The places of one part of the scene.
std::vector<SingularPlace> singular_places(const Scene& scene, const ResolvedConditions& conditions,
                                           const SolvedAssembly& solved, int part);

/// A boundary that turns by more, in radians, has a corner: as for the cells at re-entrant corners (grid_design).
constexpr double sharp_turn = 0.1;

/// Stress grows like distance^-growth towards a corner with one face free and one clamped, where the boundary turns to the left
/// by so much: 1 - lambda, k sin(lambda w)^2 = (k + 1)^2 / 4 - (lambda sin(w))^2, of material through w = pi - turn, with
/// Kolosov's constant k, or what comes nearest where lambda is complex [Williams 1952].
double growth_at_clamp(double turn, double kolosov);

/// How the boundary of a part turns to the left at one of its points; 0 within an edge.
double turn_at(const geometry::Part& part, const Vec2& place);

}  // namespace abut
