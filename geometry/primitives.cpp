// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/primitives.hpp"

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
            if (!std::isfinite(shape.rotate) || !shape.translate.allFinite() || !shape.about.allFinite())
                return report(node, "the placement is not finite", "check the numbers");
            moves.insert(moves.begin(), move_of(shape));
            read_children(shape.of, node, name, moves);
        } else {
            Primitive primitive{name, node.where, std::move(moves), {}, {}, false, false};
            fill(primitive, shape, node);
            primitives_.push_back(std::move(primitive));
        }
    }

    static Move move_of(const Placed& place) {
        const double degrees = std::remainder(place.rotate, 360.0);
        const double quarters = std::nearbyint(degrees / 90);
        const double rest = (degrees - 90 * quarters) * (std::numbers::pi / 180);
        return {(static_cast<int>(quarters) + 4) % 4, std::tan(rest / 2), place.about, place.translate};
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

    void fill(Primitive& primitive, const Polygon& polygon, const CsgNode& node) {
        const std::size_t n = polygon.points.size();
        if (n < 3) return report(node, "the polygon has fewer than three points", "give at least three points");
        std::vector<LoopEdge> edges;
        for (std::size_t i = 0; i < n; ++i)
            edges.push_back({Segment{polygon.points[i], polygon.points[(i + 1) % n]}, "e" + std::to_string(i), node.where});
        fill(primitive, Loops{{std::move(edges)}}, node);
    }

    void fill(Primitive& primitive, const HalfPlane& h, const CsgNode& node) {
        if (!h.point.allFinite() || !h.normal.allFinite())
            return report(node, "the half plane is not finite", "check the numbers");
        if (h.normal.norm() == 0) return report(node, "the half plane's normal is zero", "give a direction", h.point);
        // For names and arc lengths; boolean.cpp takes the exact line from the node itself.
        primitive.half_plane = true;
        primitive.edges = {{Segment{h.point, h.point + left_of(h.normal).normalized()}, "line"}};
    }

    void fill(Primitive& primitive, const Loops& loops, const CsgNode& node) {
        Boundary boundary = boundary_of(loops, node.where);
        problems_.insert(problems_.end(), boundary.problems.begin(), boundary.problems.end());
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

Curve placed(Curve curve, const std::vector<Move>& moves) {
    for (const Move& move : moves) {
        static constexpr double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
        const double t = move.half_tangent, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
        const double qc = cosine[move.quarter_turns], qs = sine[move.quarter_turns];
        const double tc = qc * c - qs * s, ts = qs * c + qc * s;
        curve = transformed(transformed(curve, 1, 0, -move.about), tc, ts, move.about + move.translate);
    }
    return curve;
}

}  // namespace abut::geometry
