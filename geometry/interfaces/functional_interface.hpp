// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts as generic functional interfaces [Grishin10, section 2.2.1]: which kind, its parameters, the loads it transmits and
// the motions it leaves. As in the dissertation, a clearance makes no difference to the screws.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/interfaces/screw.hpp"

namespace abut::geometry {

/// A stretch along which one edge of the first part faces one of the second.
struct FacingEdges {
    int edge1, edge2;
    std::array<Vec2, 2> ends;  ///< on the first part
    double length;
    double gap;  ///< the smallest
};

/// What a contact is to an engineer: its kind, its measures, what it transmits and what it leaves free.
struct FunctionalInterface {
    std::string kind;                               ///< of the stretch that carries most: "pin-in-hole", "flat-on-flat", ...
    std::array<std::optional<double>, 2> diameter;  ///< of its edges, where they are circles
    std::optional<double> clearance;                ///< hole less pin, of diameters
    std::optional<Vec2> center;                     ///< of pins and of what turns in a groove: the first part's circle
    std::optional<Vec2> at, normal;                 ///< the others: middle of the stretch or point of contact, and the first
                                                    ///< part's outward normal there
    std::vector<Screw> wrenches;                    ///< (fx, fy, m about the origin) that the second part can exert
    std::vector<Screw> twists;                      ///< (vx, vy of the point at the origin, w) that the first keeps
};

/// The functional interface that all stretches of a contact make together (their wrenches add up, eq 2.7), the carrying one
/// first; at least one. `scale`: of the two parts. A pin, and a round part in a groove of its own radius, is held across all
/// directions at its centre, a face on a face at both ends of the stretch, everything else in one point. Of teeth, only those
/// that come closest.
FunctionalInterface functional_interface(const Part& first, const Part& second, const std::string& kind,
                                         const std::vector<FacingEdges>& stretches, const ScrewScale& scale);

}  // namespace abut::geometry
