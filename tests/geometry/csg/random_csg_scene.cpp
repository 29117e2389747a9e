// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/csg/random_csg_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry {

namespace {

constexpr double pi = std::numbers::pi;

double degrees(double angle) {
    return angle * pi / 180;
}

class Dice {
public:
    explicit Dice(std::mt19937& random) : random_(random) {}
    int upto(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n + 1)); }
    template <class T>
    T of(std::initializer_list<T> values) {
        return *(values.begin() + upto(static_cast<int>(values.size()) - 1));
    }
    Vec2 lattice_point() {
        const int x = upto(lattice_size);  // one after the other: the order of evaluation must not matter
        return {static_cast<double>(x), static_cast<double>(upto(lattice_size))};
    }

private:
    std::mt19937& random_;
};

Rectangle random_rectangle(Dice& dice) {
    const Vec2 min = dice.lattice_point();
    const double w = 1 + dice.upto(4);
    return {min, min + Vec2(w, 1 + dice.upto(4))};
}

Circle random_circle(Dice& dice) {
    const Vec2 center = dice.lattice_point();
    return {center, dice.of({1.0, 1.0, 1.5, 2.0, 3.0})};
}

Slot random_slot(Dice& dice) {
    const Vec2 from = dice.lattice_point();
    const Vec2 way = dice.of<Vec2>({{2, 0}, {0, 3}, {-4, 0}, {3, 4}, {1, 1}});
    return {from, from + way, dice.of({1.0, 0.5, 2.0})};
}

Polygon random_polygon(Dice& dice) {
    const Vec2 o = dice.lattice_point();
    const double a = 1 + dice.upto(2), b = 1 + dice.upto(3);
    switch (dice.upto(3)) {
        case 0:
            return {{o, o + Vec2(a + b, 0), o + Vec2(a, b)}};
        case 1:  // an L
            return {{o, o + Vec2(a + b, 0), o + Vec2(a + b, 1), o + Vec2(1, 1), o + Vec2(1, a + 1), o + Vec2(0, a + 1)}};
        case 2:  // clockwise
            return {{o, o + Vec2(0, b), o + Vec2(a, b + 1), o + Vec2(a, 0)}};
        default:  // a hexagon whose slanted sides run along lattice diagonals
            return {
                {o + Vec2(1, 0), o + Vec2(1 + a, 0), o + Vec2(2 + a, 1), o + Vec2(1 + a, 2), o + Vec2(1, 2), o + Vec2(0, 1)}};
    }
}

Ellipse random_ellipse(Dice& dice) {
    const Vec2 center = dice.lattice_point();
    const Vec2 radii = dice.of<Vec2>({{2, 1}, {1, 2}, {3, 1.5}, {1.5, 1}});
    return {center, radii, dice.of({0.0, 0.0, 30.0, 90.0})};
}

Loops loops_of(const std::vector<Curve>& curves) {
    Loops loops;
    loops.loops.emplace_back();
    for (std::size_t k = 0; k < curves.size(); ++k)
        loops.loops[0].push_back({curves[k], "e" + std::to_string(k), "/loops/0/" + std::to_string(k)});
    return loops;
}

Loops random_spline_loop(Dice& dice) {
    const Vec2 o = dice.lattice_point();
    const double w = 2 + dice.upto(2), h = 1 + dice.upto(2);
    const auto p = [&](double x, double y) { return Vec2(o + Vec2(x, y)); };
    switch (dice.upto(2)) {
        case 0:  // a box with one wavy side
            return loops_of({Segment{p(0, 0), p(w, 0)}, Segment{p(w, 0), p(w, h)},
                             bezier_curve({p(w, h), p(0.7 * w, h + 2), p(0.3 * w, h - 0.9), p(0, h)}, {}),
                             Segment{p(0, h), p(0, 0)}});
        case 1: {  // a circle as NURBS, of nine points
            const double s = std::sqrt(0.5);
            Nurbs circle{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {}, {1, s, 1, s, 1, s, 1, s, 1}};
            for (const auto& [x, y] :
                 std::vector<std::pair<int, int>>{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}})
                circle.points.push_back(p(h * x, h * y));
            return loops_of(nurbs_curves(circle));
        }
        default: {  // a closed periodic cubic through no lattice point but around one
            Nurbs ring{3, {}, {}, {}};
            const std::vector<Vec2> corners{p(1.3, 0), p(1, 1.1), p(-0.2, 1.6), p(-1.4, 0.7), p(-1, -1), p(0.4, -1.2)};
            for (std::size_t k = 0; k < corners.size() + 3; ++k) ring.points.push_back(corners[k % corners.size()]);
            for (std::size_t k = 0; k < ring.points.size() + 4; ++k) ring.knots.push_back(static_cast<double>(k));
            return loops_of(nurbs_curves(ring));
        }
    }
}

CsgNode random_leaf(Dice& dice, Leaves leaves, int& first_name) {
    const std::string name = "p" + std::to_string(first_name++);
    const auto leaf = [&](auto shape) { return CsgNode{std::move(shape), name, "/" + name}; };
    switch (dice.upto(leaves == Leaves::all ? 7 : 5)) {
        case 0:
        case 1:
            return leaf(random_rectangle(dice));
        case 2:
        case 3:
            return leaf(random_circle(dice));
        case 4:
            return leaf(random_slot(dice));
        case 5:
            return leaf(random_polygon(dice));
        case 6:
            return leaf(random_ellipse(dice));
        default:
            return leaf(random_spline_loop(dice));
    }
}

CsgNode maybe_placed(Dice& dice, CsgNode node) {
    if (dice.upto(3) > 0) return node;
    Placed placed;
    placed.of.push_back(std::move(node));
    placed.rotate = dice.of({0.0, 90.0, 180.0, 30.0, 45.0, -37.0});
    placed.about = dice.of<Vec2>({{0, 0}, {4, 4}, {1, 3}});
    placed.translate = dice.of<Vec2>({{0, 0}, {1, 0}, {-2, 3}, {0.5, 0.5}});
    placed.scale = dice.of({1.0, 1.0, 0.5, 2.0});
    placed.mirror = dice.of({Mirror::none, Mirror::x, Mirror::y});
    return {std::move(placed), "", "/place"};
}

/// Loops of one list, whose edges follow each other head to tail.
Polygon as_polygon(const Loops& loops) {
    Polygon polygon;
    for (const LoopEdge& edge : loops.loops.front()) {
        const int n = std::holds_alternative<Segment>(edge.curve) ? 1 : n_chords;
        for (int k = 0; k < n; ++k) polygon.points.push_back(point(edge.curve, k / static_cast<double>(n)));
    }
    return polygon;
}

bool is_member(const Loops& loops, const Vec2& p) {
    return geometry::is_member(with_polygons({loops, "", ""}), p);
}

bool is_member(const Polygon& polygon, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        const Vec2 &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
        const bool crosses = (a.y() < p.y()) != (b.y() < p.y());
        if (crosses && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

bool is_member(const Rectangle& r, const Vec2& p) {
    return p.x() > r.min.x() && p.x() < r.max.x() && p.y() > r.min.y() && p.y() < r.max.y();
}
bool is_member(const Circle& c, const Vec2& p) {
    return (p - c.center).norm() < c.radius;
}
bool is_member(const Ellipse& e, const Vec2& p) {
    const double c = std::cos(degrees(e.angle)), s = std::sin(degrees(e.angle));
    const Vec2 d = p - e.center;
    return Vec2((c * d.x() + s * d.y()) / e.radii.x(), (-s * d.x() + c * d.y()) / e.radii.y()).norm() < 1;
}
bool is_member(const Slot& slot, const Vec2& p) {
    const Vec2 u = slot.to - slot.from;
    const double t = std::clamp((p - slot.from).dot(u) / u.squaredNorm(), 0.0, 1.0);
    return (slot.from + t * u - p).norm() < slot.radius;
}
bool is_member(const HalfPlane& h, const Vec2& p) {
    return (p - h.point).dot(h.normal) < 0;
}
bool is_member(const Imported& imported, const Vec2& p) {
    return contains(imported.part, p);
}
bool is_member(const Union& node, const Vec2& p) {
    return std::ranges::any_of(node.of, [&](const CsgNode& child) { return geometry::is_member(child, p); });
}
bool is_member(const Intersection& node, const Vec2& p) {
    return std::ranges::all_of(node.of, [&](const CsgNode& child) { return geometry::is_member(child, p); });
}
bool is_member(const Difference& node, const Vec2& p) {
    return geometry::is_member(node.of.front(), p) &&
           std::none_of(node.of.begin() + 1, node.of.end(),
                        [&](const CsgNode& child) { return geometry::is_member(child, p); });
}
/// Of the point moved back: translate, rotate, mirror, scale undone in this order.
bool is_member(const Placed& place, const Vec2& p) {
    const double c = std::cos(degrees(place.rotate)), s = std::sin(degrees(place.rotate));
    const Vec2 d = p - place.translate - place.about;
    Vec2 back(c * d.x() + s * d.y(), -s * d.x() + c * d.y());
    if (place.mirror == Mirror::x) back.x() = -back.x();
    if (place.mirror == Mirror::y) back.y() = -back.y();
    return geometry::is_member(place.of.front(), place.about + back / place.scale);
}

std::string vec_text(const Vec2& p) {
    std::ostringstream out;
    out << "[" << p.x() << ", " << p.y() << "]";
    return out.str();
}
std::string list_text(const std::vector<CsgNode>& of) {
    std::string text;
    for (const CsgNode& child : of) text += (text.empty() ? "" : ", ") + tree_text(child);
    return text;
}

}  // namespace

CsgNode random_tree(std::mt19937& random, Leaves leaves, int& first_name) {
    Dice dice(random);
    const auto leaf = [&] { return maybe_placed(dice, random_leaf(dice, leaves, first_name)); };
    const int n = dice.upto(2);
    CsgNode tree = leaf();
    for (int k = 0; k < n; ++k) {
        std::vector<CsgNode> of;
        of.push_back(std::move(tree));
        of.push_back(leaf());
        switch (dice.upto(2)) {
            case 0:
                tree = {Union{std::move(of)}, "", "/union"};
                break;
            case 1:
                tree = {Intersection{std::move(of)}, "", "/intersection"};
                break;
            default:
                tree = {Difference{std::move(of)}, "", "/difference"};
        }
        tree = maybe_placed(dice, std::move(tree));
    }
    return tree;
}

CsgNode turned(CsgNode node, double rotate, const Vec2& translate) {
    Placed placed;
    placed.of.push_back(std::move(node));
    placed.rotate = rotate;
    placed.translate = translate;
    return {std::move(placed), "", "/turned"};
}

CsgNode with_polygons(const CsgNode& node) {
    CsgNode same = node;
    if (const auto* loops = std::get_if<Loops>(&node.shape)) same.shape = as_polygon(*loops);
    std::visit(
        [](auto& shape) {
            if constexpr (requires { shape.of; })
                for (CsgNode& child : shape.of) child = with_polygons(child);
        },
        same.shape);
    return same;
}

bool is_member(const CsgNode& node, const Vec2& p) {
    return std::visit([&](const auto& shape) { return is_member(shape, p); }, node.shape);
}

std::string tree_text(const CsgNode& node) {
    std::ostringstream out;
    if (!node.name.empty()) out << node.name << "=";
    if (const auto* r = std::get_if<Rectangle>(&node.shape)) out << "rectangle(" << vec_text(r->min) << vec_text(r->max) << ")";
    if (const auto* c = std::get_if<Circle>(&node.shape)) out << "circle(" << vec_text(c->center) << " r " << c->radius << ")";
    if (const auto* e = std::get_if<Ellipse>(&node.shape))
        out << "ellipse(" << vec_text(e->center) << vec_text(e->radii) << " at " << e->angle << ")";
    if (const auto* s = std::get_if<Slot>(&node.shape))
        out << "slot(" << vec_text(s->from) << vec_text(s->to) << " r " << s->radius << ")";
    if (const auto* polygon = std::get_if<Polygon>(&node.shape)) {
        out << "polygon(";
        for (const Vec2& p : polygon->points) out << vec_text(p);
        out << ")";
    }
    if (const auto* loops = std::get_if<Loops>(&node.shape)) {
        out << "loops(";
        for (const auto& loop : loops->loops)
            for (const LoopEdge& edge : loop) out << kind_name(edge.curve) << vec_text(point(edge.curve, 0)) << " ";
        out << ")";
    }
    if (const auto* u = std::get_if<Union>(&node.shape)) out << "union(" << list_text(u->of) << ")";
    if (const auto* i = std::get_if<Intersection>(&node.shape)) out << "intersection(" << list_text(i->of) << ")";
    if (const auto* d = std::get_if<Difference>(&node.shape)) out << "difference(" << list_text(d->of) << ")";
    if (const auto* p = std::get_if<Placed>(&node.shape))
        out << "place(" << list_text(p->of) << ", scale " << p->scale << ", mirror " << static_cast<int>(p->mirror)
            << ", rotate " << p->rotate << ", translate " << vec_text(p->translate) << ", about " << vec_text(p->about) << ")";
    return out.str();
}

}  // namespace abut::geometry
