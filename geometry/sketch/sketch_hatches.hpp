// SPDX-License-Identifier: GPL-3.0-or-later
// Where a drawing is hatched, and which hatches look alike.
#pragma once
#include <string>
#include <vector>

#include "geometry/brep/monotone.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Hatches that can be asked where they are.
class HatchedAreas {
public:
    explicit HatchedAreas(const std::vector<Hatch>& hatches);
    /// The hatches that the point lies in, by their place among those given, ascending.
    std::vector<int> at_point(const Vec2& p) const;

private:
    struct Area {
        Box2 box;
        std::vector<std::vector<MonotonePiece>> loops;
    };
    std::vector<Area> areas_;
};

/// Do two hatches look the same: pattern, angle, scale, layer and colour?
bool look_alike(const HatchLook& a, const HatchLook& b);
/// Do two areas look the same that these hatches cover, one over the other perhaps? Not where one of them has none.
bool look_alike(const std::vector<Hatch>& hatches, const std::vector<int>& a, const std::vector<int>& b);
/// "ANSI31, 45 degrees, scale 2", for messages.
std::string look_text(const HatchLook& look);

}  // namespace abut::geometry
