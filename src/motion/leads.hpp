// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed motions that take parts along as a whole, and do not deform them.
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// Does it displace anything: by edges, or a part as a whole?
bool prescribes_motion(const Support& support);

/// What supports prescribe of a part's motion: of the translation of its middle along an axis and to the left of that, and of
/// the turn, from where it is drawn.
struct Lead {
    std::array<bool, 3> is_given{false, false, false};
    Eigen::Vector3d to{0, 0, 0};  ///< radians for the turn
    Vec2 axis{1, 0};              ///< the way, where it is given as a whole: what stops a part leaves it on its line
    /// The component of the translation that is not zero; the turn, where there is no translation; -1: none.
    int way = -1;

    bool goes_anywhere() const { return to.norm() > 0; }
    /// A translation, and a turn, by these coordinates.
    Eigen::Vector3d of(const Vec2& translation, double turn) const {
        return {axis.dot(translation), geometry::left_of(axis).dot(translation), turn};
    }
    /// The translation of some coordinates.
    Vec2 translation(const Vec2& along) const { return along.x() * axis + along.y() * geometry::left_of(axis); }
};

/// The leads of a scene's parts.
struct Leads {
    std::vector<Lead> of;          ///< by part
    std::vector<char> is_leading;  ///< by support: does it prescribe a motion other than none?
    /// Not empty: a prescribed motion that is none of a part as a whole, in words.
    std::string why_not{};
};

/// Finds them. A part is led by edges where these are all displaced by the same constants, where nothing else holds it against
/// that, springs among it, and where it cannot turn. What deforms a part that supports hold by less than placed_fraction of its
/// size leads nothing.
Leads leads_of(const Scene& scene, const ResolvedConditions& conditions);

/// Takes out what leads: the scene as it would be with these supports gone.
Scene without_leads(const Scene& scene, const Leads& leads);

}  // namespace abut
