// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

namespace abut::geometry {

namespace {

/// Reads the tree from the root to the leaves.
class Reader {
public:
    Reader(std::vector<Primitive>& primitives, std::vector<GeometryProblem>& problems)
        : primitives_(primitives), problems_(problems) {}

    void read(const CsgNode& node, const std::string& name, std::vector<Move> moves) {
        const std::string own = name.empty() || node.name.empty() ? name + node.name : name + "/" + node.name;
        std::visit([&](const auto& shape) { read_shape(shape, node, own, std::move(moves)); }, node.shape);
    }

private:
    void read_children(const std::vector<CsgNode>& of, const CsgNode& node, const std::string& name,
                       const std::vector<Move>& moves) {
        if (of.empty()) report(node, "the node has no geometry to work on", "list at least one node");
        for (const CsgNode& child : of) read(child, name, moves);
    }

    template <class Shape>
    void read_shape(const Shape& shape, const CsgNode& node, const std::string& name, std::vector<Move> moves) {
        if constexpr (std::is_same_v<Shape, Union> || std::is_same_v<Shape, Intersection> ||
                      std::is_same_v<Shape, Difference>) {
            read_children(shape.of, node, name, moves);
        } else if constexpr (std::is_same_v<Shape, Placed>) {
            if (shape.of.size() > 1) report(node, "place has more than one geometry", "join them by a union");
            if (!std::isfinite(shape.rotate) || !shape.translate.allFinite() || !shape.about.allFinite() ||
                !std::isfinite(shape.scale))
                return report(node, "the placement is not finite", "check the numbers");
            if (!(shape.scale > 0))
                return report(node, "the placement's scale is not positive", "give a scale above 0; mirror by \"mirror\"");
            moves.insert(moves.begin(), move_of(shape));
            read_children(shape.of, node, name, moves);
        } else {
            Primitive primitive;
            primitive.name = name;
            primitive.where = node.where;
            primitive.moves = std::move(moves);
            fill(primitive, shape, node);
            if (is_mirrored(primitive.moves)) run_backwards(primitive.loops);
            primitives_.push_back(std::move(primitive));
        }
    }

    static Move move_of(const Placed& place) {
        const double degrees = std::remainder(place.rotate, 360.0);
        const double quarters = std::nearbyint(degrees / 90);
        const double rest = (degrees - 90 * quarters) * (std::numbers::pi / 180);
        return {
            (static_cast<int>(quarters) + 4) % 4, std::tan(rest / 2), place.about, place.translate, place.scale, place.mirror};
    }

    /// A mirror exchanges left and right: the loops must run the other way to keep the material on their left.
    static void run_backwards(std::vector<BoundaryLoop>& loops) {
        for (BoundaryLoop& loop : loops) {
            std::reverse(loop.edges.begin(), loop.edges.end());
            for (OrientedEdge& edge : loop.edges) edge.along = !edge.along;
        }
    }

    void fill(Primitive& primitive, const Rectangle& r, const CsgNode& node) {
        if (!r.min.allFinite() || !r.max.allFinite()) return report(node, "the rectangle is not finite", "check the numbers");
        if (!(r.min.x() < r.max.x() && r.min.y() < r.max.y()))
            return report(node, "the rectangle has no area", "each coordinate of max must exceed that of min", r.min);
        const Vec2 se(r.max.x(), r.min.y()), nw(r.min.x(), r.max.y());
        primitive.edges = {{Segment{nw, r.min}, "left"},
                           {Segment{se, r.max}, "right"},
                           {Segment{r.min, se}, "bottom"},
                           {Segment{r.max, nw}, "top"}};
        primitive.loops = {{{{0, true}, {2, true}, {1, true}, {3, true}}, -1}};
    }

    void fill(Primitive& primitive, const Circle& c, const CsgNode& node) {
        if (!c.center.allFinite() || !std::isfinite(c.radius))
            return report(node, "the circle is not finite", "check the numbers");
        if (!(c.radius > 0)) return report(node, "the circle's radius is not positive", "give a radius above 0", c.center);
        primitive.edges = {{Arc{c.center, c.radius, 0, 2 * std::numbers::pi}, "circle"}};
        primitive.loops = {{{{0, true}}, -1}};
    }

    /// Equal radii make it a circle, which Booleans then know as one.
    void fill(Primitive& primitive, const Ellipse& e, const CsgNode& node) {
        if (!e.center.allFinite() || !e.radii.allFinite() || !std::isfinite(e.angle))
            return report(node, "the ellipse is not finite", "check the numbers");
        if (!(e.radii.x() > 0 && e.radii.y() > 0))
            return report(node, "the ellipse's radii are not positive", "give two radii above 0", e.center);
        if (e.radii.x() == e.radii.y()) {
            const double start = std::remainder(e.angle, 360.0) * (std::numbers::pi / 180);
            primitive.edges = {{Arc{e.center, e.radii.x(), start, 2 * std::numbers::pi}, "ellipse"}};
        } else {
            const Vec2 axis = direction(e.angle);
            const EllipticArc arc{e.center, e.radii.x() * axis, e.radii.y() * left_of(axis), 0, 2 * std::numbers::pi};
            primitive.edges = {{arc, "ellipse"}};
        }
        primitive.loops = {{{{0, true}}, -1}};
    }

    void fill(Primitive& primitive, const Slot& s, const CsgNode& node) {
        if (!s.from.allFinite() || !s.to.allFinite() || !std::isfinite(s.radius))
            return report(node, "the slot is not finite", "check the numbers");
        if (!(s.radius > 0)) return report(node, "the slot's radius is not positive", "give a radius above 0", s.from);
        const Vec2 along = s.to - s.from;
        const double size = std::max(s.radius, s.from.cwiseAbs().cwiseMax(s.to.cwiseAbs()).maxCoeff());
        if (!(along.norm() > merge_fraction * size))
            return report(node, "the slot has no length", "move its ends apart, or draw a circle", s.from);
        const double pi = std::numbers::pi, angle = std::atan2(along.y(), along.x());
        const Vec2 side = s.radius * right_of(along.normalized());
        primitive.edges = {{Segment{s.from + side, s.to + side}, "side0"},
                           {Arc{s.to, s.radius, angle - pi / 2, pi}, "end1"},
                           {Segment{s.to - side, s.from - side}, "side1"},
                           {Arc{s.from, s.radius, angle + pi / 2, pi}, "end0"}};
        primitive.loops = {{{{0, true}, {1, true}, {2, true}, {3, true}}, -1}};
    }

    /// Exact at quarter turns.
    static Vec2 direction(double angle) {
        const double degrees = std::remainder(angle, 360.0), quarters = std::nearbyint(degrees / 90);
        const double rest = (degrees - 90 * quarters) * (std::numbers::pi / 180);
        Vec2 v(std::cos(rest), std::sin(rest));
        for (int k = (static_cast<int>(quarters) + 4) % 4; k > 0; --k) v = left_of(v);
        return v;
    }

    void fill(Primitive& primitive, const Polygon& polygon, const CsgNode& node) {
        const std::size_t n = polygon.points.size();
        if (n < 3) return report(node, "the polygon has fewer than three points", "give at least three points");
        std::vector<LoopEdge> edges;
        for (std::size_t i = 0; i < n; ++i)
            edges.push_back({Segment{polygon.points[i], polygon.points[(i + 1) % n]},
                             std::string("e").append(std::to_string(i)), node.where});
        fill(primitive, Loops{{std::move(edges)}}, node);
    }

    void fill(Primitive& primitive, const HalfPlane& h, const CsgNode& node) {
        if (!h.point.allFinite() || !h.normal.allFinite())
            return report(node, "the half plane is not finite", "check the numbers");
        if (h.normal.norm() == 0) return report(node, "the half plane's normal is zero", "give a direction", h.point);
        // For names and arc lengths; exact_regions.cpp takes the exact line from the node itself.
        primitive.half_plane = true;
        primitive.edges = {{Segment{h.point, h.point + left_of(h.normal).normalized()}, "line"}};
    }

    void fill(Primitive& primitive, const Loops& loops, const CsgNode& node) {
        Boundary boundary = boundary_of(loops, node.where);
        problems_.insert(problems_.end(), boundary.problems.begin(), boundary.problems.end());
        for (const Repair& repair : boundary.repairs)
            primitive.repairs.push_back(
                {repair.what, placed(repair.at, primitive.moves), repair.size * scale_of(primitive.moves)});
        for (const auto& loop : loops.loops)
            for (const LoopEdge& edge : loop) primitive.edges.push_back({edge.curve, edge.name});
        primitive.loops = std::move(boundary.loops);
    }

    void fill(Primitive& primitive, const Imported& imported, const CsgNode& node) {
        if (imported.part.loops.empty()) report(node, "the import is empty", "check the file and the layer");
        primitive.imported = true;
        for (const Edge& edge : imported.part.edges)
            primitive.edges.push_back({edge.along_source ? edge.curve : reversed(edge.curve), edge.name, edge.source_begin});
        for (const Loop& loop : imported.part.loops) {
            BoundaryLoop same;
            for (int e : loop.edges) same.edges.push_back({e, imported.part.edges[static_cast<std::size_t>(e)].along_source});
            primitive.loops.push_back(std::move(same));
        }
        assign_holes(primitive, imported.part);
    }

    /// Loops of a part know by their orientation only that they are holes; of which loop is found here.
    static void assign_holes(Primitive& primitive, const Part& part) {
        const auto alone = [&](std::size_t l, bool backwards) {
            Part loop;
            for (int e : part.loops[l].edges) {
                const Curve& curve = part.edges[static_cast<std::size_t>(e)].curve;
                loop.edges.push_back({backwards ? reversed(curve) : curve, "", ""});
            }
            return loop;
        };
        std::vector<Part> outer(part.loops.size());
        for (std::size_t l = 0; l < part.loops.size(); ++l)
            if (Part loop = alone(l, false); area(loop) > 0) outer[l] = std::move(loop);
        for (std::size_t h = 0; h < part.loops.size(); ++h) {
            if (!outer[h].edges.empty()) continue;
            const Vec2 p = point(part.edges[static_cast<std::size_t>(part.loops[h].edges.front())].curve, 0.5);
            double smallest = std::numeric_limits<double>::infinity();
            for (std::size_t o = 0; o < outer.size(); ++o) {
                if (outer[o].edges.empty() || !contains(outer[o], p) || area(outer[o]) >= smallest) continue;
                smallest = area(outer[o]);
                primitive.loops[h].hole_of = static_cast<int>(o);
            }
        }
    }

    void report(const CsgNode& node, std::string what, std::string hint, const Vec2& at = {0, 0}) {
        problems_.push_back({node.where, std::move(what), std::move(hint), at});
    }

    std::vector<Primitive>& primitives_;
    std::vector<GeometryProblem>& problems_;
};

}  // namespace

std::vector<Primitive> primitives_of(const CsgNode& tree, std::vector<GeometryProblem>& problems) {
    std::vector<Primitive> primitives;
    Reader(primitives, problems).read(tree, "", {});
    return primitives;
}

namespace {

/// The map of one place but for the shift by -about that comes first. Negating y is negating x and half a turn.
Similarity similarity(const Move& move) {
    static constexpr double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
    const double t = move.half_tangent, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    const int quarters = (move.quarter_turns + (move.mirror == Mirror::y ? 2 : 0)) % 4;
    const double qc = cosine[quarters], qs = sine[quarters];
    return {qc * c - qs * s, qs * c + qc * s, move.about + move.translate, move.scale, move.mirror != Mirror::none};
}

}  // namespace

Curve placed(Curve curve, const std::vector<Move>& moves) {
    for (const Move& move : moves)
        curve = transformed(transformed(curve, Similarity{1, 0, -move.about, 1, false}), similarity(move));
    return curve;
}

Vec2 placed(Vec2 p, const std::vector<Move>& moves) {
    for (const Move& move : moves) p = similarity(move)(p - move.about);
    return p;
}

bool is_mirrored(const std::vector<Move>& moves) {
    return std::count_if(moves.begin(), moves.end(), [](const Move& m) { return m.mirror != Mirror::none; }) % 2 != 0;
}

double scale_of(const std::vector<Move>& moves) {
    double scale = 1;
    for (const Move& move : moves) scale *= move.scale;
    return scale;
}

}  // namespace abut::geometry
