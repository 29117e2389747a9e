// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_hatches.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/message_text.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

std::vector<MonotonePiece> inside_of(const std::vector<Curve>& loop) {
    Part part;
    for (const Curve& curve : loop) part.edges.push_back({curve, {}, {}, true, 0.0});
    if (area(part) < 0) {
        std::reverse(part.edges.begin(), part.edges.end());
        for (Edge& edge : part.edges) edge.curve = reversed(edge.curve);
    }
    return monotone_pieces(part);
}

/// Lines are the same turned by half a turn.
double angle_between(double a, double b) {
    constexpr double half_turn = 180;
    return std::abs(std::remainder(a - b, half_turn));
}

}  // namespace

HatchedAreas::HatchedAreas(const std::vector<Hatch>& hatches) {
    for (const Hatch& hatch : hatches) {
        areas_.emplace_back();
        for (const std::vector<Curve>& loop : hatch.loops) {
            for (const Curve& curve : loop) areas_.back().box.extend(bounding_box(curve));
            areas_.back().loops.push_back(inside_of(loop));
        }
    }
}

std::vector<int> HatchedAreas::at_point(const Vec2& p) const {
    Box2 here;
    here.extend(p);
    std::vector<int> found;
    for (std::size_t h = 0; h < areas_.size(); ++h) {
        if (!here.is_within(areas_[h].box, 0)) continue;
        const auto n = std::count_if(areas_[h].loops.begin(), areas_[h].loops.end(),
                                     [&](const std::vector<MonotonePiece>& loop) { return contains(loop, p); });
        if (n % 2 != 0) found.push_back(static_cast<int>(h));
    }
    return found;
}

bool look_alike(const HatchLook& a, const HatchLook& b) {
    constexpr double seen_degrees = 0.1, seen_ratio = 1e-3;  // nobody draws, or sees, a smaller difference
    return a.pattern == b.pattern && a.layer == b.layer && a.color == b.color &&
           angle_between(a.angle, b.angle) <= seen_degrees &&
           std::abs(a.scale - b.scale) <= seen_ratio * std::max(std::abs(a.scale), std::abs(b.scale));
}

bool look_alike(const std::vector<Hatch>& hatches, const std::vector<int>& a, const std::vector<int>& b) {
    const auto has_each_of = [&](const std::vector<int>& these, const std::vector<int>& those) {
        return std::all_of(those.begin(), those.end(), [&](int other) {
            return std::any_of(these.begin(), these.end(),
                               [&](int own) { return look_alike(hatches[at(own)].look, hatches[at(other)].look); });
        });
    };
    return !a.empty() && !b.empty() && has_each_of(a, b) && has_each_of(b, a);
}

std::string look_text(const HatchLook& look) {
    return look.pattern + (look.angle != 0 ? ", " + number_text(look.angle) + " degrees" : "") +
           (look.scale != 1 ? ", scale " + number_text(look.scale) : "");
}

}  // namespace abut::geometry
