// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/curves/moved_ends.hpp"
#include "geometry/curves/numbers.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// A sweep that misses the full turn by less is one: the gap is a rounding error of the circumference.
constexpr double full_turn_angle = 1e-12;

/// Disjoint sets of places; the smallest index of a set is its root. Of each set, how many ends and places it has.
class Sets {
public:
    explicit Sets(std::vector<int> n_ends) : parent_(n_ends.size()), n_ends_(std::move(n_ends)), n_places_(parent_.size(), 1) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    bool is_alone(std::size_t i) { return n_ends_[root(i)] == 1; }
    /// Is it as drawn, or has every end a partner?
    bool is_even_or_exact(std::size_t i) { return n_ends_[root(i)] % 2 == 0 || n_places_[root(i)] == 1; }
    void merge(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return;
        parent_[std::max(a, b)] = std::min(a, b);
        n_ends_[std::min(a, b)] += n_ends_[std::max(a, b)];
        n_places_[std::min(a, b)] += n_places_[std::max(a, b)];
    }

private:
    std::vector<std::size_t> parent_;
    std::vector<int> n_ends_, n_places_;
};

std::vector<EntityEnd> all_ends(const std::vector<SketchPiece>& entities) {
    std::vector<EntityEnd> ends;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (is_full_turn(entities[i].curve)) continue;
        ends.push_back({static_cast<int>(i), true});
        ends.push_back({static_cast<int>(i), false});
    }
    return ends;
}

/// Different points among those of all ends: many ends in exactly one point cost no more than one.
struct Places {
    std::vector<Vec2> points;
    std::vector<int> n_ends;      ///< by place
    std::vector<Vec2> direction;  ///< in which the first end leaves, by place
    std::vector<std::size_t> of_end;
};

Places places_of(const std::vector<SketchPiece>& entities, const std::vector<EntityEnd>& ends) {
    Places places;
    std::map<std::pair<double, double>, std::size_t> known;
    for (const EntityEnd& end : ends) {
        const Vec2 p = position(entities, end);
        const auto [at, is_new] = known.emplace(std::pair(p.x(), p.y()), places.points.size());
        if (is_new) {
            places.points.push_back(p);
            places.n_ends.push_back(0);
            places.direction.push_back(leaving_direction(entities[static_cast<std::size_t>(end.entity)], end.is_begin));
        }
        ++places.n_ends[at->second];
        places.of_end.push_back(at->second);
    }
    return places;
}

struct Pair {
    double distance;
    std::size_t a, b;
};

/// All pairs within the tolerance, the nearest first.
std::vector<Pair> near_pairs(const std::vector<Vec2>& points, double tolerance) {
    std::vector<Box2> boxes(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) boxes[i].extend(points[i]);
    const EdgeTree tree(boxes);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const int near : tree.near(boxes[i], tolerance)) {
            const auto k = static_cast<std::size_t>(near);
            const double distance = (points[i] - points[k]).norm();
            if (k > i && distance <= tolerance) pairs.push_back({distance, i, k});
        }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.distance < y.distance; });
    return pairs;
}

Sets group_places(const Places& places, double tolerance, double coincidence, double rounding) {
    Sets sets(places.n_ends);
    const std::vector<Pair> pairs = near_pairs(places.points, tolerance);
    for (const Pair& pair : pairs)
        if (pair.distance <= rounding) sets.merge(pair.a, pair.b);
    for (const Pair& pair : pairs) {
        const bool is_alone = sets.is_alone(pair.a), is_other_alone = sets.is_alone(pair.b);
        const bool is_side_by_side = places.direction[pair.a].dot(places.direction[pair.b]) > side_by_side_cosine;
        if (is_alone && is_other_alone ? !is_side_by_side : pair.distance <= coincidence) sets.merge(pair.a, pair.b);
    }
    for (const Pair& pair : pairs)
        if ((sets.is_alone(pair.a) && !sets.is_alone(pair.b) && sets.is_even_or_exact(pair.b)) ||
            (sets.is_alone(pair.b) && !sets.is_alone(pair.a) && sets.is_even_or_exact(pair.a)))
            sets.merge(pair.a, pair.b);
    return sets;
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

/// The end that most others lie on already, if there are any that do.
std::optional<Vec2> crowded_place(const std::vector<SketchPiece>& entities, const std::vector<EntityEnd>& ends,
                                  double rounding) {
    std::optional<Vec2> best;
    std::ptrdiff_t most = 1;
    for (const EntityEnd& end : ends) {
        const Vec2 p = position(entities, end);
        const auto n = std::count_if(ends.begin(), ends.end(), [&](const EntityEnd& other) {
            return (position(entities, other) - p).norm() <= rounding;
        });
        if (n <= most) continue;
        most = n;
        best = p;
    }
    return best;
}

/// Ends that differ by rounding errors meet at a segment's, which is the file's own number. Otherwise where most of them lie
/// already, so that what was cut in two stays straight. Segments can be moved without loss, curves cannot: where one curve and
/// segments meet, the curve's end stays; two segments meet in their corner.
Vec2 meeting_point(const std::vector<SketchPiece>& entities, const std::vector<EntityEnd>& ends, double gap, double rounding) {
    const auto curve = [&](const EntityEnd& e) -> const Curve& { return entities[static_cast<std::size_t>(e.entity)].curve; };
    const auto is_curved = [&](const EntityEnd& e) { return !std::holds_alternative<Segment>(curve(e)); };
    if (gap <= rounding) {
        const auto segment = std::find_if_not(ends.begin(), ends.end(), is_curved);
        return position(entities, segment == ends.end() ? ends.front() : *segment);
    }
    if (const auto crowded = crowded_place(entities, ends, rounding)) return *crowded;
    if (std::count_if(ends.begin(), ends.end(), is_curved) == 1)
        return position(entities, *std::find_if(ends.begin(), ends.end(), is_curved));
    Vec2 sum(0, 0);
    for (const EntityEnd& end : ends) sum += position(entities, end);
    const Vec2 middle = sum / static_cast<double>(ends.size());
    return ends.size() == 2 ? corner(curve(ends[0]), curve(ends[1]), middle, gap).value_or(middle) : middle;
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
    if (std::holds_alternative<Segment>(curve)) return Segment{from, to};
    const double move = std::max((point(curve, 0) - from).norm(), (point(curve, 1) - to).norm());
    if (move <= rounding) return curve;
    const auto* arc = std::get_if<Arc>(&curve);
    return arc ? Curve(rebuilt(*arc, from, to)) : with_moved_ends(curve, from, to);
}

}  // namespace

bool is_full_turn(const Curve& curve) {
    const auto* arc = std::get_if<Arc>(&curve);
    const auto* ellipse = std::get_if<EllipticArc>(&curve);
    const double sweep = arc ? arc->sweep : ellipse ? ellipse->sweep : 0.0;
    return std::abs(sweep) >= two_pi - full_turn_angle;
}

Vec2 position(const std::vector<SketchPiece>& entities, const EntityEnd& end) {
    return point(entities[static_cast<std::size_t>(end.entity)].curve, end.is_begin ? 0 : 1);
}

Vec2 leaving_direction(const SketchPiece& entity, bool is_begin) {
    return is_begin ? unit_tangent(entity.curve, 0) : Vec2(-unit_tangent(entity.curve, 1));
}

Joints join_ends(const std::vector<SketchPiece>& entities, double tolerance, double coincidence, double rounding) {
    ENSURE(tolerance >= 0 && coincidence >= 0 && rounding >= 0, "ends are joined within a distance");
    const std::vector<EntityEnd> ends = all_ends(entities);
    const Places places = places_of(entities, ends);
    Sets sets = group_places(places, tolerance, coincidence, rounding);

    Joints joints;
    joints.at_begin.assign(entities.size(), -1);
    joints.at_end.assign(entities.size(), -1);
    std::vector<int> joint_of_root(places.points.size(), -1);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        int& joint = joint_of_root[sets.root(places.of_end[i])];
        if (joint < 0) {
            joint = static_cast<int>(joints.joints.size());
            joints.joints.emplace_back();
        }
        joints.joints[static_cast<std::size_t>(joint)].ends.push_back(ends[i]);
        (ends[i].is_begin ? joints.at_begin : joints.at_end)[static_cast<std::size_t>(ends[i].entity)] = joint;
    }
    for (Joint& joint : joints.joints) {
        Box2 box;
        for (const EntityEnd& end : joint.ends) box.extend(position(entities, end));
        joint.gap = box.diagonal();  // of two ends their distance, of more hardly more than the largest
        joint.at = meeting_point(entities, joint.ends, joint.gap, rounding);
    }
    return joints;
}

void close_joints(std::vector<SketchPiece>& entities, const Joints& joints, double rounding) {
    ENSURE(joints.at_begin.size() == entities.size() && joints.at_end.size() == entities.size(), "every entity has its joints");
    for (std::size_t i = 0; i < entities.size(); ++i) {
        if (joints.at_begin[i] < 0) continue;
        const Vec2& from = joints.joints[static_cast<std::size_t>(joints.at_begin[i])].at;
        const Vec2& to = joints.joints[static_cast<std::size_t>(joints.at_end[i])].at;
        entities[i].curve = with_ends(entities[i].curve, from, to, rounding);
    }
}

}  // namespace abut::geometry
