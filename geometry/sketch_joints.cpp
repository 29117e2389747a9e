// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch_joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace abut::geometry {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
/// A sweep that misses the full turn by less is one: the gap is a rounding error of the circumference.
constexpr double full_turn_angle = 1e-12;

/// Disjoint sets of ends; the smallest index of a set is its root, which keeps the result independent of the merging order.
class Sets {
public:
    explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void merge(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

std::vector<EntityEnd> all_ends(const std::vector<SketchEntity>& entities) {
    std::vector<EntityEnd> ends;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (is_full_circle(entities[i].curve)) continue;
        ends.push_back({static_cast<int>(i), true});
        ends.push_back({static_cast<int>(i), false});
    }
    return ends;
}

/// Merges the sets of all pairs of points within the tolerance: a sweep along x.
Sets group_points(const std::vector<Vec2>& points, double tolerance) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : points[a].y() < points[b].y();
    });
    Sets sets(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = i + 1; k < order.size() && points[order[k]].x() - points[order[i]].x() <= tolerance; ++k)
            if ((points[order[k]] - points[order[i]]).norm() <= tolerance) sets.merge(order[i], order[k]);
    }
    return sets;
}

double largest_distance(const std::vector<Vec2>& points) {
    double largest = 0;
    for (const Vec2& a : points)
        for (const Vec2& b : points) largest = std::max(largest, (a - b).norm());
    return largest;
}

/// Where the lines of two segments cross, if that is as near as the gap is wide: there both keep their direction.
std::optional<Vec2> corner(const Curve& a, const Curve& b, const Vec2& middle, double gap) {
    constexpr double smallest_sine = 0.1;  // of the angle between them; flatter corners move along the lines more than the gap
    const auto *s = std::get_if<Segment>(&a), *r = std::get_if<Segment>(&b);
    if (!s || !r) return std::nullopt;
    const Vec2 u = (s->to - s->from).normalized(), v = (r->to - r->from).normalized();
    if (std::abs(cross(u, v)) < smallest_sine) return std::nullopt;
    const Vec2 crossing = s->from + cross(r->from - s->from, v) / cross(u, v) * u;
    return (crossing - middle).norm() <= gap ? std::optional(crossing) : std::nullopt;
}

/// Segments can be moved without loss, arcs cannot: where an arc and a segment meet, the arc's end stays; two segments meet in
/// their corner. Ends that differ by rounding errors meet at the segment's, which is the file's own number.
Vec2 meeting_point(const std::vector<SketchEntity>& entities, const std::vector<EntityEnd>& ends, double gap, double rounding) {
    const auto is_arc = [&](const EntityEnd& e) {
        return std::holds_alternative<Arc>(entities[static_cast<std::size_t>(e.entity)].curve);
    };
    const auto n_arcs = std::count_if(ends.begin(), ends.end(), is_arc);
    if (gap <= rounding) {
        const auto segment = std::find_if_not(ends.begin(), ends.end(), is_arc);
        return position(entities, segment == ends.end() ? ends.front() : *segment);
    }
    if (n_arcs == 1) return position(entities, *std::find_if(ends.begin(), ends.end(), is_arc));
    Vec2 sum(0, 0);
    for (const EntityEnd& end : ends) sum += position(entities, end);
    const Vec2 middle = sum / static_cast<double>(ends.size());
    if (ends.size() != 2) return middle;
    const auto curve = [&](std::size_t i) -> const Curve& { return entities[static_cast<std::size_t>(ends[i].entity)].curve; };
    return corner(curve(0), curve(1), middle, gap).value_or(middle);
}

/// Keeping the radius turns a change dc of the chord into one of dc / (2 r cos(half)) of the half angle: below this cosine the
/// bulge is kept instead, which near a half turn hardly moves the centre.
constexpr double well_conditioned_cosine = 0.5;

Arc arc_with_bulge(const Vec2& from, const Vec2& to, double sweep) {
    const double bulge = std::tan(sweep / 4);
    const Vec2 center = 0.5 * (from + to) + (1 - bulge * bulge) / (4 * bulge) * left_of(to - from);
    const Vec2 d = from - center;
    return {center, d.norm(), std::atan2(d.y(), d.x()), sweep};
}

Arc rebuilt(const Arc& arc, const Vec2& from, const Vec2& to) {
    if (from == to) return {arc.center, arc.radius, arc.start, std::copysign(two_pi, arc.sweep)};
    const double half = std::abs(arc.sweep) / 2;
    const double sine = (to - from).norm() / (2 * arc.radius);
    if (std::abs(std::cos(half)) < well_conditioned_cosine || sine > 1) return arc_with_bulge(from, to, arc.sweep);
    const double new_half = half < std::numbers::pi / 2 ? std::asin(sine) : std::numbers::pi - std::asin(sine);
    Arc kept_radius = arc_with_bulge(from, to, std::copysign(2 * new_half, arc.sweep));
    kept_radius.radius = arc.radius;
    return kept_radius;
}

Curve with_ends(const Curve& curve, const Vec2& from, const Vec2& to, double rounding) {
    const auto* arc = std::get_if<Arc>(&curve);
    if (!arc) return Segment{from, to};
    const double move = std::max((point(curve, 0) - from).norm(), (point(curve, 1) - to).norm());
    return move <= rounding ? curve : Curve(rebuilt(*arc, from, to));
}

}  // namespace

bool is_full_circle(const Curve& curve) {
    const auto* arc = std::get_if<Arc>(&curve);
    return arc && std::abs(arc->sweep) >= two_pi - full_turn_angle;
}

Vec2 position(const std::vector<SketchEntity>& entities, const EntityEnd& end) {
    return point(entities[static_cast<std::size_t>(end.entity)].curve, end.is_begin ? 0 : 1);
}

Joints join_ends(const std::vector<SketchEntity>& entities, double tolerance, double rounding) {
    const std::vector<EntityEnd> ends = all_ends(entities);
    std::vector<Vec2> points;
    for (const EntityEnd& end : ends) points.push_back(position(entities, end));
    Sets sets = group_points(points, tolerance);

    Joints joints;
    joints.at_begin.assign(entities.size(), -1);
    joints.at_end.assign(entities.size(), -1);
    std::vector<int> joint_of_root(ends.size(), -1);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        int& joint = joint_of_root[sets.root(i)];
        if (joint < 0) {
            joint = static_cast<int>(joints.joints.size());
            joints.joints.emplace_back();
        }
        joints.joints[static_cast<std::size_t>(joint)].ends.push_back(ends[i]);
        (ends[i].is_begin ? joints.at_begin : joints.at_end)[static_cast<std::size_t>(ends[i].entity)] = joint;
    }
    for (Joint& joint : joints.joints) {
        std::vector<Vec2> of_joint;
        for (const EntityEnd& end : joint.ends) of_joint.push_back(position(entities, end));
        joint.gap = largest_distance(of_joint);
        joint.at = meeting_point(entities, joint.ends, joint.gap, rounding);
    }
    return joints;
}

void close_joints(std::vector<SketchEntity>& entities, const Joints& joints, double rounding) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (joints.at_begin[i] < 0) continue;
        const Vec2& from = joints.joints[static_cast<std::size_t>(joints.at_begin[i])].at;
        const Vec2& to = joints.joints[static_cast<std::size_t>(joints.at_end[i])].at;
        entities[i].curve = with_ends(entities[i].curve, from, to, rounding);
    }
}

}  // namespace abut::geometry
