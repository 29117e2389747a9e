// SPDX-License-Identifier: GPL-3.0-or-later
// Parts away from where they were drawn: finite rigid motions, and the scene with its parts there.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/plan/boundary_conditions.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// A part's finite rigid motion: x goes to x turned about the origin by the angle, and then moved by the shift.
struct Placement {
    double angle = 0;  ///< radians, counter-clockwise; whole turns count
    Vec2 shift{0, 0};

    Vec2 turned(const Vec2& v) const;
    Vec2 of(const Vec2& x) const { return turned(x) + shift; }
    bool goes_nowhere() const { return angle == 0 && shift == Vec2(0, 0); }
};

/// The motion along a screw: that of a body whose point at the centre goes along `translation` while it turns evenly. What
/// turns about a point stays on its circles.
Placement along_screw(const Vec2& center, const Vec2& translation, double rotation);
/// The motion that turns a part and moves its point at the centre by `translation` in the end.
Placement about_center(const Vec2& center, const Vec2& translation, double rotation);
/// One motion after the other.
Placement followed_by(const Placement& first, const Placement& then);
/// Without digits below a small part of the motion: these are rounding, and would turn parts out of the symmetry that they were
/// drawn with. size: of the part, center: its middle.
Placement without_rounding(const Placement& placement, const Vec2& center, double size, double digits = 1e-6);

/// From this motion on, over a part's size, the pairs that were found where it was drawn do not hold. Below, peaks of a pin
/// with some clearance err by 0.7 % at 0.008 of its size, by 1.2 % at 0.02, by up to 5 % at 0.04 (measured), which
/// analysis/moved_pairs tells. From 0.01 on they would be right, but chain.json with its many loose pins finds no answer where
/// it settles.
inline constexpr double placed_fraction = 0.05;
/// From this turn on (radians) forces have other levers: they err by it times a part's height over its width.
inline constexpr double placed_turn = 0.01;

/// Is a motion farther than the pairing of edges where a part stood before is good for? size: the diagonal of the part's box.
bool is_far(const Vec2& translation, double turn, double size);

/// Has any pair of edges friction?
bool has_friction(const ContactOptions& contacts);
/// May any pair of them be pressed apart: by an interference, or since parts are drawn over each other?
bool has_fits(const ContactOptions& contacts);

/// Why parts are taken where they are drawn, however far they go; empty: they are followed. Something is given that means
/// another thing elsewhere (a load by expressions of the place, a prescribed motion that deforms its part, a rule for edges
/// near a point), or the scene asks for it.
std::string why_not_followed(const Scene& scene, const ResolvedConditions& conditions);

/// The scene with its parts moved from where they are drawn, by part. What belongs to a part goes with it: probes, held points,
/// lines of action, cuts, grids; supports prescribe what is left of their motions. Edges keep their numbers and
/// parameters, so that conditions resolved before hold. Parts may overlap a little: contact presses them apart.
Scene placed(const Scene& drawn, const ResolvedConditions& conditions, const std::vector<Placement>& placements);

/// The middle of an assembly that is drawn farther from the origin than it is large: there its coordinates lose the digits that
/// small steps need. Else nothing.
std::optional<Vec2> far_middle(const Scene& scene);
/// The scene with its parts elsewhere, and its prescribed motions as they were.
Scene shifted(const Scene& drawn, const ResolvedConditions& conditions, const Vec2& by);

/// Where parts come to rest: the scene with its parts there, and how they go there from where they are drawn, by part.
struct Rest {
    Scene scene;
    std::vector<Placement> placements;
    bool is_held = false;  ///< by friction, which was there on the way, too
};
/// The rest with parts placed there.
Rest rest_at(const Scene& drawn, const ResolvedConditions& conditions, std::vector<Placement> placements, bool is_held = false);

/// "pin by (0, -4)", "lever by (0.1, -2) and 3.5 degrees"; center: of the part as drawn.
std::string placement_text(const std::string& part, const Placement& placement, const Vec2& center, double size);

}  // namespace abut
