// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/exact_regions.hpp"

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_2.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_traits_2.h>

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/variant.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "geometry/csg/exact_count.hpp"
#include "geometry/csg/loop_rounding.hpp"
#include "geometry/csg/primitives.hpp"
#include "geometry/csg/source_portions.hpp"

namespace abut::geometry {

namespace {

// ---- exact numbers, and how doubles become them and come back ----------------------------------------------------------

/// Every monotone curve carries the number of its SourcePortion. Where two primitives' edges coincide, the one that comes first
/// in reading order owns the boundary.
struct KeepFirst {
    int operator()(int a, int b) const { return std::min(a, b); }
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using PlaneTraits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using EdgeTraits = CGAL::Arr_curve_data_traits_2<PlaneTraits, int, KeepFirst>;
using MonotoneCurve = EdgeTraits::X_monotone_curve_2;
using Rational = Kernel::Point_2;      ///< a point with rational coordinates
using OneRoot = PlaneTraits::Point_2;  ///< a point whose coordinates are a + b sqrt(c)
using Coordinate = OneRoot::CoordNT;

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

/// x -> [xx xy; yx yy] x + (dx, dy): all moves of a primitive in one.
struct ExactMap {
    Number xx = 1, xy = 0, yx = 0, yy = 1, dx = 0, dy = 0;
    double scale = 1;
    bool identity = true;
};

ExactMap exact_map(const std::vector<Move>& moves) {
    ExactMap m;
    for (const Move& move : moves) {
        const Rotation r = rotation(move.quarter_turns, move.half_tangent);
        const Number sx = move.mirror == Mirror::x ? -Number(move.scale) : Number(move.scale);
        const Number sy = move.mirror == Mirror::y ? -Number(move.scale) : Number(move.scale);
        const Number px = m.dx - move.about.x(), py = m.dy - move.about.y();
        const auto turned_x = [&](const Number& x, const Number& y) { return r.c * sx * x - r.s * sy * y; };
        const auto turned_y = [&](const Number& x, const Number& y) { return r.s * sx * x + r.c * sy * y; };
        m = {turned_x(m.xx, m.yx),
             turned_x(m.xy, m.yy),
             turned_y(m.xx, m.yx),
             turned_y(m.xy, m.yy),
             turned_x(px, py) + move.about.x() + move.translate.x(),
             turned_y(px, py) + move.about.y() + move.translate.y(),
             m.scale * move.scale,
             false};
        for (const Number* n : {&m.xx, &m.xy, &m.yx, &m.yy, &m.dx, &m.dy}) CGAL::exact(*n);  // keeps lazy numbers flat
    }
    return m;
}

Rational placed_exactly(const Vec2& p, const ExactMap& m) {
    if (m.identity) return exact_point(p);
    const Number x(p.x()), y(p.y());
    return {m.xx * x + m.xy * y + m.dx, m.yx * x + m.yy * y + m.dy};
}

/// A normal: rotated, mirrored and scaled only.
Kernel::Vector_2 turned_exactly(const Vec2& v, const ExactMap& m) {
    const Number x(v.x()), y(v.y());
    return {m.xx * x + m.xy * y, m.yx * x + m.yy * y};
}

OneRoot one_root(const Rational& p) {
    return {Coordinate(p.x()), Coordinate(p.y())};
}

// ---- exact edges -----------------------------------------------------------------------------------------------------

/// A primitive's edge as its boundary runs through it, with its exact line or circle, or its run of a carrier's arcs.
struct ExactEdge {
    int portion = -1;   ///< its number; for a run of arcs that of the source's first arc
    Curve curve;        ///< rounded, placed, along the boundary
    int turn = 0;       ///< 0 line, +1 or -1 arc
    Rational from, to;  ///< lines: their ends
    Rational center;    ///< arcs
    Number radius;
    const CarrierRun* run = nullptr;  ///< ellipses and splines
    bool along = true;                ///< of their source
};

/// A carrier's arcs between rational points. An end that meets a line or circle is that one's exact end.
struct ExactCarrier {
    std::vector<Rational> points, middles;
    std::vector<bool> is_joined;  ///< by point
};

/// Where one edge ends and the next begins: one point, or two with a bridge between them.
struct ExactJoint {
    OneRoot end, begin;
    std::optional<std::pair<Rational, Rational>> bridge;
};

bool is_line(const ExactEdge& edge) {
    return !edge.run && edge.turn == 0;
}

bool is_circle(const ExactEdge& edge) {
    return edge.turn != 0;
}

ExactEdge exact_edge(const Primitive& primitive, const ExactMap& map, const OrientedEdge& oriented) {
    const Curve& own = primitive.edges[static_cast<std::size_t>(oriented.edge)].curve;
    const Curve run = oriented.along ? own : reversed(own);
    ExactEdge edge;
    edge.curve = placed(run, primitive.moves);
    edge.along = oriented.along;
    if (const auto* line = std::get_if<Segment>(&run)) {
        edge.from = placed_exactly(line->from, map);
        edge.to = placed_exactly(line->to, map);
    } else if (const auto* arc = std::get_if<Arc>(&run)) {
        edge.turn = std::get<Arc>(edge.curve).sweep > 0 ? 1 : -1;
        edge.center = placed_exactly(arc->center, map);
        edge.radius = Number(arc->radius) * map.scale;
    }
    return edge;
}

ExactCarrier exact_carrier(const Carrier& carrier) {
    ExactCarrier exact;
    for (const Vec2& p : carrier.points) exact.points.push_back(exact_point(p));
    for (const CarrierArc& arc : carrier.arcs) exact.middles.push_back(exact_point(arc.middle));
    exact.is_joined.resize(exact.points.size());
    return exact;
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
    if (is_line(a)) return line_circle(a.from, a.to - a.from, b.center, b.radius);
    if (is_line(b)) return line_circle(b.from, b.to - b.from, a.center, a.radius);
    const Kernel::Vector_2 between = b.center - a.center;
    const Number squared = between * between;
    if (squared == 0) return {};
    const Number share = (a.radius * a.radius - b.radius * b.radius + squared) / (2 * squared);
    return line_circle(a.center + share * between, between.perpendicular(CGAL::COUNTERCLOCKWISE), a.center, a.radius);
}

bool same_circle(const ExactEdge& a, const ExactEdge& b) {
    return is_circle(a) && a.turn == b.turn && a.center == b.center && a.radius == b.radius;
}

/// A rational point exactly on the edge's line or circle, `distance` inwards from its begin or its end.
Rational point_near(const ExactEdge& edge, bool at_end, double distance) {
    if (is_line(edge)) {
        const Number share(distance / length(edge.curve));
        return at_end ? edge.to + share * (edge.from - edge.to) : edge.from + share * (edge.to - edge.from);
    }
    const Arc& arc = std::get<Arc>(edge.curve);
    const double inwards = edge.turn * distance / arc.radius;
    const Rotation r = rotation(at_end ? arc.start + arc.sweep - inwards : arc.start + inwards);
    return {edge.center.x() + edge.radius * r.c, edge.center.y() + edge.radius * r.s};
}

ExactJoint joint(const ExactEdge& a, const ExactEdge& b, double size) {
    if (is_line(a) && is_line(b)) return {one_root(a.to), one_root(b.from), {}};  // made equal by close_line_gaps
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
        if (is_line(edges[i]) && is_line(next)) next.from = edges[i].to;
    }
}

CGAL::Orientation orientation(int turn) {
    return turn > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE;
}

/// The curve in what CGAL hands over, a point or a curve: CGAL 5 in boost's variant, CGAL 6 in the standard's.
template <class Made>
const MonotoneCurve* curve_in(const Made& made) {
    if constexpr (std::is_same_v<Made, std::variant<EdgeTraits::Point_2, MonotoneCurve>>)
        return std::get_if<MonotoneCurve>(&made);
    else
        return boost::get<MonotoneCurve>(&made);
}

void add_monotone_pieces(const PlaneTraits::Curve_2& curve, int source, std::vector<MonotoneCurve>& pieces) {
    const auto take = [&](const auto& made) {
        if (const MonotoneCurve* piece = curve_in(made)) pieces.push_back(*piece);
    };
    EdgeTraits().make_x_monotone_2_object()(EdgeTraits::Curve_2(curve, source), boost::make_function_output_iterator(take));
}

void add_edge(const ExactEdge& edge, const OneRoot& from, const OneRoot& to, std::vector<MonotoneCurve>& pieces) {
    if (is_line(edge)) {
        const PlaneTraits::X_monotone_curve_2 line(Kernel::Line_2(edge.from, edge.to), from, to);
        pieces.emplace_back(line, edge.portion);
    } else {
        add_monotone_pieces({edge.center, edge.radius, orientation(edge.turn), from, to}, edge.portion, pieces);
    }
}

using Traits = CGAL::Gps_traits_2<EdgeTraits>;
using Region = CGAL::General_polygon_set_2<Traits>;
using Polygon2 = Traits::Polygon_2;
using PolygonWithHoles = Traits::Polygon_with_holes_2;

}  // namespace

// ---- the boundaries of primitives ------------------------------------------------------------------------------------

struct ExactPrimitives::Model {
    Model(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources, const Carriers& carriers);

    /// By the number that a monotone curve carries, unless that is bridge_source or far_source. The turns of a carrier's arcs
    /// are known once `boundary` has been asked for a loop that runs along them.
    std::vector<SourcePortion> portions;

    /// The loop in its own direction, head to tail.
    std::vector<MonotoneCurve> boundary(std::size_t primitive, std::size_t loop);

    /// A polygon that holds the half plane's share of the disc: its line, and three far edges.
    std::vector<MonotoneCurve> half_plane(std::size_t primitive, const HalfPlane& half, const BoundingDisc& disc) const;

    void add_primitive(const Primitive& primitive, int first_source);
    /// The i-th point of a run, in the boundary's direction, as an index into its carrier's points.
    std::size_t point_index(const ExactEdge& edge, int i) const;
    ExactCarrier& carrier_of(const ExactEdge& edge);
    /// The exact end or begin of any edge that meets a run of arcs.
    Rational exact_end(const ExactEdge& edge, bool at_end);
    /// Moves a run's end to p, unless it has been joined to something else.
    void move_end(const ExactEdge& edge, bool at_end, const Rational& p);
    /// Gives neighbours the same exact end where one of them is a run of arcs. A line whose neighbour was joined to another
    /// primitive's edge (equal but for rounding) gives way; a circle cannot, and gets a bridge.
    void join_carriers(std::vector<ExactEdge>& edges);
    ExactJoint joint_of(const ExactEdge& a, const ExactEdge& b, double size);
    void add_closed(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces);
    void add_arcs(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces);

    const std::vector<Primitive>& primitives_;
    const Carriers& carriers_;
    std::vector<ExactCarrier> exact_carriers_;
    std::vector<ExactMap> maps_;
    std::vector<int> first_portion_;               ///< by source
    std::vector<int> first_portion_of_primitive_;  ///< by primitive
    std::vector<std::vector<std::vector<ExactEdge>>> loops_;
};

ExactPrimitives::Model::Model(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources,
                              const Carriers& carriers)
    : primitives_(primitives), carriers_(carriers) {
    SourcePortions numbered = number_portions(sources, carriers);
    portions = std::move(numbered.portions);
    first_portion_ = std::move(numbered.first);
    for (const Carrier& carrier : carriers.carriers) exact_carriers_.push_back(exact_carrier(carrier));
    int first_source = 0;
    for (const Primitive& primitive : primitives) {
        add_primitive(primitive, first_source);
        first_source += static_cast<int>(primitive.edges.size());
    }
    for (auto& loops : loops_)
        for (auto& loop : loops) join_carriers(loop);
}

void ExactPrimitives::Model::add_primitive(const Primitive& primitive, int first_source) {
    maps_.push_back(exact_map(primitive.moves));
    first_portion_of_primitive_.push_back(primitive.edges.empty() ? 0 : first_portion_[static_cast<std::size_t>(first_source)]);
    std::vector<std::vector<ExactEdge>> loops;
    for (const BoundaryLoop& loop : primitive.loops) {
        std::vector<ExactEdge> edges;
        for (const OrientedEdge& oriented : loop.edges) {
            const auto source = static_cast<std::size_t>(first_source + oriented.edge);
            edges.push_back(exact_edge(primitive, maps_.back(), oriented));
            edges.back().portion = first_portion_[source];
            if (carriers_.of_source[source].carrier >= 0) edges.back().run = &carriers_.of_source[source];
        }
        close_line_gaps(edges);
        loops.push_back(std::move(edges));
    }
    loops_.push_back(std::move(loops));
}

std::size_t ExactPrimitives::Model::point_index(const ExactEdge& edge, int i) const {
    const Carrier& carrier = carriers_.carriers[static_cast<std::size_t>(edge.run->carrier)];
    const int k = edge.run->first + (edge.run->along == edge.along ? i : edge.run->n_arcs - i);
    return static_cast<std::size_t>(carrier.closed ? k % static_cast<int>(carrier.arcs.size()) : k);
}

ExactCarrier& ExactPrimitives::Model::carrier_of(const ExactEdge& edge) {
    return exact_carriers_[static_cast<std::size_t>(edge.run->carrier)];
}

Rational ExactPrimitives::Model::exact_end(const ExactEdge& edge, bool at_end) {
    if (edge.run) return carrier_of(edge).points[point_index(edge, at_end ? edge.run->n_arcs : 0)];
    return is_line(edge) ? (at_end ? edge.to : edge.from) : point_near(edge, at_end, 0);
}

void ExactPrimitives::Model::move_end(const ExactEdge& edge, bool at_end, const Rational& p) {
    const std::size_t k = point_index(edge, at_end ? edge.run->n_arcs : 0);
    ExactCarrier& carrier = carrier_of(edge);
    if (carrier.is_joined[k]) return;
    carrier.is_joined[k] = true;
    carrier.points[k] = p;
}

void ExactPrimitives::Model::join_carriers(std::vector<ExactEdge>& edges) {
    if (edges.size() < 2) return;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        ExactEdge &a = edges[i], &b = edges[(i + 1) % edges.size()];
        if (!a.run && !b.run) continue;
        if (b.run) move_end(b, false, exact_end(a, true));
        if (a.run) move_end(a, true, exact_end(b, false));
        if (is_line(a)) a.to = exact_end(b, false);
        if (is_line(b)) b.from = exact_end(a, true);
    }
}

ExactJoint ExactPrimitives::Model::joint_of(const ExactEdge& a, const ExactEdge& b, double size) {
    if (!a.run && !b.run) return joint(a, b, size);
    const Rational end = exact_end(a, true), begin = exact_end(b, false);
    if (end == begin) return {one_root(end), one_root(begin), {}};
    return {one_root(end), one_root(begin), std::pair(end, begin)};
}

void ExactPrimitives::Model::add_closed(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces) {
    if (edge.run)
        add_arcs(edge, pieces);
    else
        add_monotone_pieces({edge.center, edge.radius, orientation(edge.turn)}, edge.portion, pieces);
}

void ExactPrimitives::Model::add_arcs(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces) {
    const Carrier& carrier = carriers_.carriers[static_cast<std::size_t>(edge.run->carrier)];
    const ExactCarrier& exact = carrier_of(edge);
    const int n = edge.run->n_arcs;
    const bool forward = edge.run->along == edge.along;
    for (int i = 0; i < n; ++i) {
        const Rational &from = exact.points[point_index(edge, i)], &to = exact.points[point_index(edge, i + 1)];
        const int k = (edge.run->first + (forward ? i : n - 1 - i)) % static_cast<int>(carrier.arcs.size());
        const Rational& middle = exact.middles[static_cast<std::size_t>(k)];
        const int portion = edge.portion + (edge.along ? i : n - 1 - i);
        const bool straight = carrier.arcs[static_cast<std::size_t>(k)].straight || CGAL::collinear(from, middle, to);
        const PlaneTraits::Curve_2 curve = straight ? PlaneTraits::Curve_2(from, to) : PlaneTraits::Curve_2(from, middle, to);
        const int turn = straight ? 0 : curve.orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1;
        portions[static_cast<std::size_t>(portion)].turn = edge.along ? turn : -turn;
        add_monotone_pieces(curve, portion, pieces);
    }
}

std::vector<MonotoneCurve> ExactPrimitives::Model::boundary(std::size_t primitive, std::size_t loop) {
    const std::vector<ExactEdge>& edges = loops_[primitive][loop];
    std::vector<MonotoneCurve> pieces;
    if (edges.size() == 1) {
        add_closed(edges.front(), pieces);
        return pieces;
    }
    const double size = size_of(primitives_[primitive]);
    const std::size_t n = edges.size();
    std::vector<ExactJoint> joints;  // after each edge
    for (std::size_t i = 0; i < n; ++i) joints.push_back(joint_of(edges[i], edges[(i + 1) % n], size));
    for (std::size_t i = 0; i < n; ++i) {
        if (edges[i].run)
            add_arcs(edges[i], pieces);
        else
            add_edge(edges[i], joints[(i + n - 1) % n].begin, joints[i].end, pieces);
        if (const auto& bridge = joints[i].bridge)
            pieces.emplace_back(PlaneTraits::X_monotone_curve_2(bridge->first, bridge->second), bridge_source);
    }
    return pieces;
}

std::vector<MonotoneCurve> ExactPrimitives::Model::half_plane(std::size_t primitive, const HalfPlane& half,
                                                              const BoundingDisc& disc) const {
    const ExactMap& map = maps_[primitive];
    const int portion = first_portion_of_primitive_[primitive];
    const Rational p = placed_exactly(half.point, map), c = exact_point(disc.center);
    const Kernel::Vector_2 n = turned_exactly(half.normal, map), d(-n.y(), n.x());
    const Number unit = 1 / Number(half.normal.norm() * map.scale);  // rounded: how far the polygon reaches need not be exact
    const Rational foot = p + ((c - p) * d) / (d * d) * d;
    const Number depth =
        3 * disc.radius + std::abs((disc.center - Vec2(CGAL::to_double(foot.x()), CGAL::to_double(foot.y()))).norm());
    const Kernel::Vector_2 side = (2 * disc.radius * unit) * d, down = (-depth * unit) * n;
    const Rational corners[] = {foot - side, foot + side, foot + side + down, foot - side + down};
    std::vector<MonotoneCurve> pieces;
    for (int i = 0; i < 4; ++i)
        pieces.emplace_back(PlaneTraits::X_monotone_curve_2(corners[i], corners[(i + 1) % 4]), i == 0 ? portion : far_source);
    return pieces;
}

// ---- regions ---------------------------------------------------------------------------------------------------------

struct ExactPolygons::Data {
    std::vector<PolygonWithHoles> polygons;
};

struct ExactRegion::Data {
    Region region;
};

namespace {

Polygon2 polygon_of(const std::vector<MonotoneCurve>& boundary) {
    return {boundary.begin(), boundary.end()};
}

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

std::vector<RawPiece> raw_loop(const Polygon2& polygon, const std::vector<SourcePortion>& portions, VertexNumbers& vertices) {
    std::vector<RawPiece> loop;
    for (auto curve = polygon.curves_begin(); curve != polygon.curves_end(); ++curve) {
        loop.push_back(raw_piece(portions, curve->data(), rounded(curve->source()), rounded(curve->target()), turn_of(*curve)));
        loop.back().from_vertex = vertices.emplace(curve->source(), static_cast<int>(vertices.size())).first->second;
    }
    return loop;
}

}  // namespace

ExactPolygons::ExactPolygons() : data(std::make_shared<Data>()) {}

ExactRegion joined(const ExactPolygons& polygons) {
    ExactRegion result{std::make_shared<ExactRegion::Data>()};
    result.data->region.join(polygons.data->polygons.begin(), polygons.data->polygons.end());
    return result;
}

void intersect(ExactRegion& region, const ExactRegion& with) {
    region.data->region.intersection(with.data->region);
}

void subtract(ExactRegion& region, const ExactRegion& what) {
    region.data->region.difference(what.data->region);
}

void append(const ExactRegion& region, ExactPolygons& polygons) {
    region.data->region.polygons_with_holes(std::back_inserter(polygons.data->polygons));
}

ExactPrimitives::ExactPrimitives(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources,
                                 const Carriers& carriers)
    : model_(std::make_unique<Model>(primitives, sources, carriers)) {}

ExactPrimitives::~ExactPrimitives() = default;

void ExactPrimitives::append(std::size_t k, ExactPolygons& polygons, std::vector<GeometryProblem>& problems) {
    const Primitive& primitive = model_->primitives_[k];
    std::vector<Polygon2> loops;
    for (std::size_t l = 0; l < primitive.loops.size(); ++l) {
        const BoundaryLoop& loop = primitive.loops[l];
        loops.push_back(polygon_of(model_->boundary(k, l)));
        if (may_be_invalid(primitive, loop) && !CGAL::is_simple_polygon(loops.back(), Traits()))
            problems.push_back(self_crossing(primitive, loop));
    }
    for (std::size_t outer = 0; outer < loops.size(); ++outer) {
        if (primitive.loops[outer].hole_of >= 0) continue;
        PolygonWithHoles polygon(loops[outer]);
        for (std::size_t hole = 0; hole < loops.size(); ++hole)
            if (primitive.loops[hole].hole_of == static_cast<int>(outer)) polygon.add_hole(loops[hole]);
        polygons.data->polygons.push_back(std::move(polygon));
    }
}

void ExactPrimitives::append_half_plane(std::size_t k, const HalfPlane& half, const BoundingDisc& disc,
                                        ExactPolygons& polygons) const {
    polygons.data->polygons.emplace_back(polygon_of(model_->half_plane(k, half, disc)));
}

std::vector<std::vector<RawPiece>> ExactPrimitives::loops(const ExactRegion& region) const {
    std::vector<PolygonWithHoles> polygons;
    region.data->region.polygons_with_holes(std::back_inserter(polygons));
    std::vector<std::vector<RawPiece>> loops;
    VertexNumbers vertices;
    for (const PolygonWithHoles& polygon : polygons) {
        loops.push_back(raw_loop(polygon.outer_boundary(), model_->portions, vertices));
        for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
            loops.push_back(raw_loop(*hole, model_->portions, vertices));
    }
    n_exact_loops() += static_cast<long>(loops.size());
    return loops;
}

}  // namespace abut::geometry
