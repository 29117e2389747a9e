// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/functional_interface.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/closest_points.hpp"
#include "geometry/interfaces/interface_kind.hpp"
#include "geometry/proximity/facing.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// A groove holds a round part across all directions where their radii differ by no more than a running fit.
constexpr double conforming_fraction = 0.01;

std::optional<double> diameter_of(const Curve& curve) {
    const auto* arc = std::get_if<Arc>(&curve);
    return arc ? std::optional<double>(2 * arc->radius) : std::nullopt;
}

struct Touch {
    Vec2 at, normal;  ///< on the first part
};

Touch touch_at(const Curve& curve, double t) {
    return {point(curve, t), outward_normal(curve, t)};
}

Touch closest_touch(const Part& first, const Part& second, const FacingEdges& s) {
    const Curve &c1 = curve_of(first, s.edge1), &c2 = curve_of(second, s.edge2);
    const ClosestPoints c = closest_points(c1, c2);
    Touch touch = touch_at(c1, c.t1);
    // at a corner of the first part the face of the second gives the direction
    if (is_convex_corner(first, s.edge1, c.t1)) touch.normal = -outward_normal(c2, c.t2);
    return touch;
}

bool is_conforming(const Part& first, const Part& second, const FacingEdges& s) {
    const auto d1 = diameter_of(curve_of(first, s.edge1)), d2 = diameter_of(curve_of(second, s.edge2));
    return d1 && d2 && std::abs(*d1 - *d2) <= conforming_fraction * std::min(*d1, *d2);
}

bool holds_centre(const std::string& kind, const Part& first, const Part& second, const FacingEdges& s) {
    return diameter_of(curve_of(first, s.edge1)) &&
           (kind == "pin-in-hole" || (kind == "round-in-groove" && is_conforming(first, second, s)));
}

Vec2 centre_of(const Part& first, const FacingEdges& s) {
    return std::get<Arc>(curve_of(first, s.edge1)).center;
}

void append_wrenches(const Part& first, const Part& second, const std::string& kind, const FacingEdges& s,
                     std::vector<Screw>& wrenches) {
    if (holds_centre(kind, first, second, s)) {
        for (const Vec2& direction : {Vec2(1, 0), Vec2(0, 1)})
            wrenches.push_back(force_through(centre_of(first, s), direction));
        return;
    }
    if (kind == "flat-on-flat") {
        const Vec2 n = outward_normal(curve_of(first, s.edge1), 0.5);
        for (const Vec2& end : s.ends) wrenches.push_back(force_through(end, -n));
        return;
    }
    const Touch touch = closest_touch(first, second, s);
    wrenches.push_back(force_through(touch.at, -touch.normal));
}

void fill_parameters(const Part& first, const Part& second, const FacingEdges& s, FunctionalInterface& result) {
    result.diameter = {diameter_of(curve_of(first, s.edge1)), diameter_of(curve_of(second, s.edge2))};
    const bool round_in = result.kind == "pin-in-hole" || result.kind == "round-in-groove";
    if (round_in && result.diameter[0] && result.diameter[1])
        result.clearance = std::abs(*result.diameter[0] - *result.diameter[1]);
    if (holds_centre(result.kind, first, second, s)) {
        result.center = centre_of(first, s);
        return;
    }
    const Touch touch = result.kind == "flat-on-flat"
                            ? Touch{0.5 * (s.ends[0] + s.ends[1]), outward_normal(curve_of(first, s.edge1), 0.5)}
                            : closest_touch(first, second, s);
    result.at = touch.at;
    result.normal = touch.normal;
}

}  // namespace

FunctionalInterface functional_interface(const Part& first, const Part& second, const std::string& kind,
                                         const std::vector<FacingEdges>& stretches, const ScrewScale& scale) {
    ENSURE(!stretches.empty() && scale.size > 0, "a contact has a stretch, and its parts have a size");
    if (kind == "tooth-on-tooth" && stretches.size() > 1) {
        const auto closest = std::min_element(stretches.begin(), stretches.end(),
                                              [](const FacingEdges& a, const FacingEdges& b) { return a.gap < b.gap; });
        return functional_interface(first, second, kind, {*closest}, scale);
    }
    FunctionalInterface result;
    result.kind = kind;
    fill_parameters(first, second, stretches.front(), result);
    std::vector<Screw> wrenches;
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        const FacingEdges& s = stretches[k];
        append_wrenches(first, second, k == 0 ? kind : interface_kind(first, s.edge1, second, s.edge2), s, wrenches);
    }
    result.wrenches = wrench_space(wrenches, scale);
    result.twists = twist_space(wrenches, scale);
    return result;
}

}  // namespace abut::geometry
