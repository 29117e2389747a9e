// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_shared.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/brep/oriented_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "geometry/sketch/sketch_crossings.hpp"

namespace abut::geometry {

namespace {

/// An entity of a chain, run so that the chain's inside is on its left.
struct Side {
    int entity, chain;
    Curve curve;
};

std::vector<Side> sides_of(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains) {
    std::vector<Side> sides;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        Part outline;
        for (const ChainLink& link : chains[c]) {
            const Curve& curve = entities[static_cast<std::size_t>(link.entity)].curve;
            outline.edges.push_back({link.along ? curve : reversed(curve), {}, {}, true, 0.0});
        }
        const bool is_clockwise = area(outline) < 0;
        for (std::size_t k = 0; k < chains[c].size(); ++k) {
            const Curve& curve = outline.edges[k].curve;
            sides.push_back({chains[c][k].entity, static_cast<int>(c), is_clockwise ? reversed(curve) : curve});
        }
    }
    return sides;
}

/// Circles that only come close would seem to share what lies within the tolerance about the place where they touch.
bool may_be_one(const Curve& a, const Curve& b, double tolerance) {
    const auto *arc = std::get_if<Arc>(&a), *other = std::get_if<Arc>(&b);
    const auto *ellipse = std::get_if<EllipticArc>(&a), *other_ellipse = std::get_if<EllipticArc>(&b);
    if (ellipse && other_ellipse && (ellipse->center - other_ellipse->center).norm() > tolerance) return false;
    if ((ellipse && (other || b.index() == 0)) || (other_ellipse && (arc || a.index() == 0))) return false;
    if (!arc || !other) return a.index() == b.index() || a.index() > 1 || b.index() > 1;  // a line and a circle are never one
    return (arc->center - other->center).norm() + std::abs(arc->radius - other->radius) <= tolerance;
}

/// Parameter of `a` in the middle of what it shares with `b`.
std::optional<double> middle_of_shared(const Curve& a, const Curve& b, double tolerance) {
    if (!may_be_one(a, b, tolerance)) return std::nullopt;
    double first = 1, last = 0;
    for (const Vec2& p : meeting_points(a, b, tolerance)) {
        const double t = closest_parameter(a, p);
        first = std::min(first, t);
        last = std::max(last, t);
    }
    if (first >= last || length(a, first, last) <= 4 * tolerance) return std::nullopt;
    const double middle = 0.5 * (first + last);
    const Vec2 p = point(a, middle);
    if ((point(b, closest_parameter(b, p)) - p).norm() > tolerance) return std::nullopt;
    return middle;
}

bool share_from_inside(const Curve& a, const Curve& b, double tolerance) {
    const std::optional<double> t = middle_of_shared(a, b, tolerance);
    return t && unit_tangent(a, *t).dot(unit_tangent(b, closest_parameter(b, point(a, *t)))) > 0;
}

}  // namespace

std::vector<bool> shared_from_inside(const std::vector<SketchPiece>& entities, const std::vector<EntityChain>& chains,
                                     double tolerance) {
    std::vector<bool> found(entities.size(), false);
    if (chains.size() < 2) return found;
    const std::vector<Side> sides = sides_of(entities, chains);
    std::vector<OrientedTree::Item> items;
    for (const Side& side : sides) items.push_back({bounding_box(side.curve), oriented_box(side.curve)});
    const OrientedTree tree(items);
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (const int near : tree.near_after(i, tolerance)) {
            const auto k = static_cast<std::size_t>(near);
            if (sides[k].chain == sides[i].chain || !may_meet(sides[i].curve, sides[k].curve, tolerance)) continue;
            if (!share_from_inside(sides[i].curve, sides[k].curve, tolerance)) continue;
            found[static_cast<std::size_t>(sides[i].entity)] = found[static_cast<std::size_t>(sides[k].entity)] = true;
        }
    return found;
}

}  // namespace abut::geometry
