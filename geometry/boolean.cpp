// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/boolean.hpp"

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_2.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_traits_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

namespace abut::geometry {

namespace {

/// Where two primitives' edges coincide, the one that comes first in reading order owns the boundary.
struct KeepFirst {
    int operator()(int a, int b) const { return std::min(a, b); }
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using PlaneTraits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using EdgeTraits = CGAL::Arr_curve_data_traits_2<PlaneTraits, int, KeepFirst>;
using Traits = CGAL::Gps_traits_2<EdgeTraits>;
using Region = CGAL::General_polygon_set_2<Traits>;
using Polygon2 = Traits::Polygon_2;
using PolygonWithHoles = Traits::Polygon_with_holes_2;
using MonotoneCurve = EdgeTraits::X_monotone_curve_2;
using Rational = Kernel::Point_2;      ///< a point with rational coordinates
using OneRoot = PlaneTraits::Point_2;  ///< a point whose coordinates are a + b sqrt(c)
using Coordinate = OneRoot::CoordNT;

// ---- numbers -------------------------------------------------------------------------------------------------------

/// Rounded to within a few units in the last place: a + b sqrt(c) is rewritten where it cancels.
double rounded(const Coordinate& v) {
    const auto a = CGAL::exact(v.a0());
    if (!v.is_extended()) return CGAL::to_double(a);
    const auto b = CGAL::exact(v.a1()), c = CGAL::exact(v.root());
    const double da = CGAL::to_double(a), db = CGAL::to_double(b) * std::sqrt(CGAL::to_double(c));
    if (da * db >= 0) return da + db;
    return CGAL::to_double(decltype(a)(a * a - b * b * c)) / (da - db);
}

Vec2 rounded(const OneRoot& p) {
    return {rounded(p.x()), rounded(p.y())};
}

struct Rotation {
    Number c, s;
};

/// Exactly on the unit circle: t is the tangent of half the angle beyond the quarter turns.
Rotation rotation(int quarter_turns, double half_tangent) {
    const Number t(half_tangent);
    const Number denominator = 1 + t * t;
    const Number c = (1 - t * t) / denominator, s = 2 * t / denominator;
    switch (((quarter_turns % 4) + 4) % 4) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

/// The rational point of the unit circle within rounding of the angle.
Rotation rotation(double angle) {
    const double quarters = std::nearbyint(angle / (std::numbers::pi / 2));
    return rotation(static_cast<int>(quarters), std::tan((angle - quarters * (std::numbers::pi / 2)) / 2));
}

Rational exact_point(const Vec2& p) {
    return {Number(p.x()), Number(p.y())};
}

Rational placed_exactly(const Vec2& p, const std::vector<Move>& moves) {
    Number x(p.x()), y(p.y());
    for (const Move& move : moves) {
        const Rotation r = rotation(move.quarter_turns, move.half_tangent);
        const Number dx = x - move.about.x(), dy = y - move.about.y();
        x = r.c * dx - r.s * dy + move.about.x() + move.translate.x();
        y = r.s * dx + r.c * dy + move.about.y() + move.translate.y();
    }
    return {x, y};
}

/// Directions are rotated only.
Kernel::Vector_2 turned_exactly(const Vec2& v, const std::vector<Move>& moves) {
    Number x(v.x()), y(v.y());
    for (const Move& move : moves) {
        const Rotation r = rotation(move.quarter_turns, move.half_tangent);
        const Number turned_x = r.c * x - r.s * y;
        y = r.s * x + r.c * y;
        x = turned_x;
    }
    return {x, y};
}

OneRoot one_root(const Rational& p) {
    return {Coordinate(p.x()), Coordinate(p.y())};
}

// ---- primitives' boundaries ----------------------------------------------------------------------------------------

/// A primitive's edge as its boundary runs through it, with its exact line or circle.
struct ExactEdge {
    int source = -1;
    Curve curve;        ///< rounded, placed, along the boundary
    int turn = 0;       ///< 0 line, +1 or -1 arc
    Rational from, to;  ///< lines: their ends
    Rational center;    ///< arcs
    Number radius;
};

ExactEdge exact_edge(const Primitive& primitive, const OrientedEdge& oriented, int first_source) {
    const Curve& own = primitive.edges[static_cast<std::size_t>(oriented.edge)].curve;
    const Curve run = oriented.along ? own : reversed(own);
    ExactEdge edge;
    edge.source = first_source + oriented.edge;
    edge.curve = placed(run, primitive.moves);
    if (const auto* line = std::get_if<Segment>(&run)) {
        edge.from = placed_exactly(line->from, primitive.moves);
        edge.to = placed_exactly(line->to, primitive.moves);
    } else {
        const Arc& arc = std::get<Arc>(run);
        edge.turn = arc.sweep > 0 ? 1 : -1;
        edge.center = placed_exactly(arc.center, primitive.moves);
        edge.radius = Number(arc.radius);
    }
    return edge;
}

using Candidates = std::vector<OneRoot>;

/// Where the line through q along d meets the circle.
Candidates line_circle(const Rational& q, const Kernel::Vector_2& d, const Rational& center, const Number& radius) {
    const Kernel::Vector_2 f = q - center;
    const Number a = d * d, b = d * f, c = f * f - radius * radius;
    const Number discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    Candidates found;
    for (int sign : {1, -1}) {
        const auto coordinate = [&](const Number& start, const Number& slope) {
            const Number middle = start - slope * b / a, half = sign * slope / a;
            return half == 0 || discriminant == 0 ? Coordinate(middle) : Coordinate(middle, half, discriminant);
        };
        found.emplace_back(coordinate(q.x(), d.x()), coordinate(q.y(), d.y()));
    }
    return found;
}

/// Exact crossings of two edges' lines or circles, where at least one is a circle.
Candidates crossings(const ExactEdge& a, const ExactEdge& b) {
    if (a.turn == 0) return line_circle(a.from, a.to - a.from, b.center, b.radius);
    if (b.turn == 0) return line_circle(b.from, b.to - b.from, a.center, a.radius);
    const Kernel::Vector_2 between = b.center - a.center;
    const Number squared = between * between;
    if (squared == 0) return {};
    const Number share = (a.radius * a.radius - b.radius * b.radius + squared) / (2 * squared);
    return line_circle(a.center + share * between, between.perpendicular(CGAL::COUNTERCLOCKWISE), a.center, a.radius);
}

bool same_circle(const ExactEdge& a, const ExactEdge& b) {
    return a.turn != 0 && a.turn == b.turn && a.center == b.center && a.radius == b.radius;
}

/// A rational point exactly on the edge's line or circle, `distance` inwards from its begin or its end.
Rational point_near(const ExactEdge& edge, bool at_end, double distance) {
    if (edge.turn == 0) {
        const Number share(distance / length(edge.curve));
        return at_end ? edge.to + share * (edge.from - edge.to) : edge.from + share * (edge.to - edge.from);
    }
    const Arc& arc = std::get<Arc>(edge.curve);
    const double inwards = edge.turn * distance / arc.radius;
    const Rotation r = rotation(at_end ? arc.start + arc.sweep - inwards : arc.start + inwards);
    return {edge.center.x() + edge.radius * r.c, edge.center.y() + edge.radius * r.s};
}

/// Where one edge ends and the next begins: one point, or two with a bridge between them.
struct Joint {
    OneRoot end, begin;
    std::optional<std::pair<Rational, Rational>> bridge;
};

Joint joint(const ExactEdge& a, const ExactEdge& b, double size) {
    if (a.turn == 0 && b.turn == 0) return {one_root(a.to), one_root(b.from), {}};  // made equal by close_line_gaps
    if (same_circle(a, b)) {
        const OneRoot p = one_root(point_near(a, true, 0));
        return {p, p, {}};
    }
    const Vec2 p = point(a.curve, 1), q = point(b.curve, 0);
    const double sine = cross(unit_tangent(a.curve, 1), unit_tangent(b.curve, 0));
    if (std::abs(sine) > tangent_sine) {
        const double far = 4 * ((p - q).norm() + bridge_fraction * size) / tangent_sine;
        for (const OneRoot& crossing : crossings(a, b))
            if ((rounded(crossing) - p).norm() <= far) return {crossing, crossing, {}};
    }
    const double inwards = 4 * (p - q).norm() + bridge_fraction / 2 * size;
    const Rational end = point_near(a, true, inwards), begin = point_near(b, false, inwards);
    return {one_root(end), one_root(begin), std::pair(end, begin)};
}

/// Neighbouring lines get the same end point: the gap that the loop was allowed goes to the second of them.
void close_line_gaps(std::vector<ExactEdge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
        ExactEdge& next = edges[(i + 1) % edges.size()];
        if (edges[i].turn == 0 && next.turn == 0) next.from = edges[i].to;
    }
}

CGAL::Orientation orientation(int turn) {
    return turn > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE;
}

void add_monotone_pieces(const PlaneTraits::Curve_2& curve, int source, std::vector<MonotoneCurve>& pieces) {
    std::vector<boost::variant<OneRoot, MonotoneCurve>> made;
    const EdgeTraits traits;
    traits.make_x_monotone_2_object()(EdgeTraits::Curve_2(curve, source), std::back_inserter(made));
    for (const auto& object : made)
        if (const auto* piece = boost::get<MonotoneCurve>(&object)) pieces.push_back(*piece);
}

void add_edge(const ExactEdge& edge, const OneRoot& from, const OneRoot& to, std::vector<MonotoneCurve>& pieces) {
    if (edge.turn == 0) {
        const PlaneTraits::X_monotone_curve_2 line(Kernel::Line_2(edge.from, edge.to), from, to);
        pieces.emplace_back(line, edge.source);
    } else {
        add_monotone_pieces({edge.center, edge.radius, orientation(edge.turn), from, to}, edge.source, pieces);
    }
}

Polygon2 polygon_of(std::vector<ExactEdge> edges, double size) {
    std::vector<MonotoneCurve> pieces;
    if (edges.size() == 1) {
        add_monotone_pieces({edges[0].center, edges[0].radius, orientation(edges[0].turn)}, edges[0].source, pieces);
        return {pieces.begin(), pieces.end()};
    }
    close_line_gaps(edges);
    std::vector<Joint> joints;  // after each edge
    for (std::size_t i = 0; i < edges.size(); ++i) joints.push_back(joint(edges[i], edges[(i + 1) % edges.size()], size));
    for (std::size_t i = 0; i < edges.size(); ++i) {
        add_edge(edges[i], joints[(i + edges.size() - 1) % edges.size()].begin, joints[i].end, pieces);
        if (const auto& bridge = joints[i].bridge)
            pieces.emplace_back(PlaneTraits::X_monotone_curve_2(bridge->first, bridge->second), bridge_source);
    }
    return {pieces.begin(), pieces.end()};
}

/// Extent and distance from the origin: what rounding is relative to.
double size_of(const Primitive& primitive) {
    Box2 box;
    for (const SourceEdge& edge : primitive.edges) box.extend(bounding_box(placed(edge.curve, primitive.moves)));
    return box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
}

/// Only arcs that meet other edges are moved by rounding; everything else is valid as it was checked.
bool has_joined_arcs(const Primitive& primitive, const BoundaryLoop& loop) {
    return loop.edges.size() > 1 && std::any_of(loop.edges.begin(), loop.edges.end(), [&](const OrientedEdge& e) {
               return std::holds_alternative<Arc>(primitive.edges[static_cast<std::size_t>(e.edge)].curve);
           });
}

/// A polygon that holds the half plane's share of the disc: its line, and three far edges.
Polygon2 half_plane_polygon(const HalfPlane& half, const std::vector<Move>& moves, int source, const Reach& reach) {
    const Rational p = placed_exactly(half.point, moves), c = exact_point(reach.center);
    const Kernel::Vector_2 n = turned_exactly(half.normal, moves), d(-n.y(), n.x());
    const Number unit = 1 / Number(half.normal.norm());  // rounded: how far the polygon reaches need not be exact
    const Rational foot = p + ((c - p) * d) / (d * d) * d;
    const Number depth =
        3 * reach.radius + std::abs((reach.center - Vec2(CGAL::to_double(foot.x()), CGAL::to_double(foot.y()))).norm());
    const Kernel::Vector_2 side = (2 * reach.radius * unit) * d, down = (-depth * unit) * n;
    const Rational corners[] = {foot - side, foot + side, foot + side + down, foot - side + down};
    std::vector<MonotoneCurve> pieces;
    for (int i = 0; i < 4; ++i)
        pieces.emplace_back(PlaneTraits::X_monotone_curve_2(corners[i], corners[(i + 1) % 4]), i == 0 ? source : far_source);
    return {pieces.begin(), pieces.end()};
}

// ---- the tree --------------------------------------------------------------------------------------------------------

/// Walks the tree in reading order, so that the next leaf is always the next primitive.
class Evaluator {
public:
    Evaluator(const std::vector<Primitive>& primitives, const Reach& reach) : primitives_(primitives), reach_(reach) {}

    Region evaluate(const CsgNode& node) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return evaluate(place->of.front());
        if (const auto* common = std::get_if<Intersection>(&node.shape)) return intersection(*common);
        if (std::holds_alternative<Difference>(node.shape)) return difference(node);
        std::vector<PolygonWithHoles> polygons;
        gather(node, polygons);
        return joined(polygons);
    }

    std::vector<GeometryProblem> problems;

private:
    static Region joined(const std::vector<PolygonWithHoles>& polygons) {
        Region region;
        region.join(polygons.begin(), polygons.end());
        return region;
    }

    /// Polygons whose union is the node: nested unions are opened, so that everything is joined in one go.
    void gather(const CsgNode& node, std::vector<PolygonWithHoles>& polygons) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return gather(place->of.front(), polygons);
        if (const auto* all = std::get_if<Union>(&node.shape)) {
            for (const CsgNode& child : all->of) gather(child, polygons);
        } else if (std::holds_alternative<Intersection>(node.shape) || std::holds_alternative<Difference>(node.shape)) {
            evaluate(node).polygons_with_holes(std::back_inserter(polygons));
        } else {
            add_primitive(node, polygons);
        }
    }

    Region intersection(const Intersection& node) {
        Region region = evaluate(node.of.front());
        for (std::size_t i = 1; i < node.of.size(); ++i) region.intersection(evaluate(node.of[i]));
        return region;
    }

    /// (a less b) less c is a less (b and c): one difference whatever the number of tools.
    Region difference(const CsgNode& node) {
        std::vector<PolygonWithHoles> tools;
        Region region = minuend(node, tools);
        region.difference(joined(tools));
        return region;
    }

    Region minuend(const CsgNode& node, std::vector<PolygonWithHoles>& tools) {
        if (const auto* place = std::get_if<Placed>(&node.shape)) return minuend(place->of.front(), tools);
        const auto* difference = std::get_if<Difference>(&node.shape);
        if (!difference) return evaluate(node);
        Region region = minuend(difference->of.front(), tools);
        for (std::size_t i = 1; i < difference->of.size(); ++i) gather(difference->of[i], tools);
        return region;
    }

    void add_primitive(const CsgNode& node, std::vector<PolygonWithHoles>& polygons) {
        const Primitive& primitive = primitives_[next_primitive_++];
        const int source = next_source_;
        next_source_ += static_cast<int>(primitive.edges.size());
        if (const auto* half = std::get_if<HalfPlane>(&node.shape))
            polygons.emplace_back(half_plane_polygon(*half, primitive.moves, source, reach_));
        else
            add_bounded(primitive, source, polygons);
    }

    void add_bounded(const Primitive& primitive, int source, std::vector<PolygonWithHoles>& polygons) {
        const double size = size_of(primitive);
        std::vector<Polygon2> loops;
        for (const BoundaryLoop& loop : primitive.loops) {
            std::vector<ExactEdge> edges;
            for (const OrientedEdge& edge : loop.edges) edges.push_back(exact_edge(primitive, edge, source));
            loops.push_back(polygon_of(std::move(edges), size));
            if (has_joined_arcs(primitive, loop) && !CGAL::is_simple_polygon(loops.back(), Traits()))
                report_invalid(primitive, loop);
        }
        for (std::size_t outer = 0; outer < loops.size(); ++outer) {
            if (primitive.loops[outer].hole_of >= 0) continue;
            PolygonWithHoles polygon(loops[outer]);
            for (std::size_t hole = 0; hole < loops.size(); ++hole)
                if (primitive.loops[hole].hole_of == static_cast<int>(outer)) polygon.add_hole(loops[hole]);
            polygons.push_back(std::move(polygon));
        }
    }

    void report_invalid(const Primitive& primitive, const BoundaryLoop& loop) {
        const SourceEdge& edge = primitive.edges[static_cast<std::size_t>(loop.edges.front().edge)];
        problems.push_back({primitive.where, "the loop of edge '" + edge.name + "' crosses or touches itself within rounding",
                            "look for very sharp corners between arcs, or move nearly touching edges apart",
                            point(placed(edge.curve, primitive.moves), 0)});
    }

    const std::vector<Primitive>& primitives_;
    Reach reach_;
    std::size_t next_primitive_ = 0;
    int next_source_ = 0;
};

// ---- the result ----------------------------------------------------------------------------------------------------

struct BeforeXy {
    bool operator()(const OneRoot& a, const OneRoot& b) const {
        return PlaneTraits().compare_xy_2_object()(a, b) == CGAL::SMALLER;
    }
};
using VertexNumbers = std::map<OneRoot, int, BeforeXy>;

int turn_of(const MonotoneCurve& curve) {
    if (curve.is_linear()) return 0;
    return curve.orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1;
}

std::vector<RawPiece> raw_loop(const Polygon2& polygon, VertexNumbers& vertices) {
    std::vector<RawPiece> loop;
    for (auto curve = polygon.curves_begin(); curve != polygon.curves_end(); ++curve) {
        const auto vertex = vertices.emplace(curve->source(), static_cast<int>(vertices.size())).first;
        loop.push_back({curve->data(), rounded(curve->source()), rounded(curve->target()), vertex->second, turn_of(*curve)});
    }
    return loop;
}

}  // namespace

BooleanBoundary boolean_boundary(const CsgNode& tree, const std::vector<Primitive>& primitives, const Reach& reach) {
    Evaluator evaluator(primitives, reach);
    const Region region = evaluator.evaluate(tree);
    BooleanBoundary boundary;
    boundary.problems = std::move(evaluator.problems);
    if (!boundary.problems.empty()) return boundary;

    std::vector<PolygonWithHoles> polygons;
    region.polygons_with_holes(std::back_inserter(polygons));
    VertexNumbers vertices;
    for (const PolygonWithHoles& polygon : polygons) {
        boundary.loops.push_back(raw_loop(polygon.outer_boundary(), vertices));
        for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
            boundary.loops.push_back(raw_loop(*hole, vertices));
    }
    return boundary;
}

}  // namespace abut::geometry
