// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/boolean_model.hpp"

#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

namespace abut::geometry::exact {

namespace {

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

Joint joint(const ExactEdge& a, const ExactEdge& b, double size) {
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

void add_monotone_pieces(const PlaneTraits::Curve_2& curve, int source, std::vector<MonotoneCurve>& pieces) {
    std::vector<boost::variant<OneRoot, MonotoneCurve>> made;
    const EdgeTraits traits;
    traits.make_x_monotone_2_object()(EdgeTraits::Curve_2(curve, source), std::back_inserter(made));
    for (const auto& object : made)
        if (const auto* piece = boost::get<MonotoneCurve>(&object)) pieces.push_back(*piece);
}

void add_edge(const ExactEdge& edge, const OneRoot& from, const OneRoot& to, std::vector<MonotoneCurve>& pieces) {
    if (is_line(edge)) {
        const PlaneTraits::X_monotone_curve_2 line(Kernel::Line_2(edge.from, edge.to), from, to);
        pieces.emplace_back(line, edge.portion);
    } else {
        add_monotone_pieces({edge.center, edge.radius, orientation(edge.turn), from, to}, edge.portion, pieces);
    }
}

/// Extent and distance from the origin: what rounding is relative to.
double size_of(const Primitive& primitive) {
    Box2 box;
    for (const SourceEdge& edge : primitive.edges) box.extend(bounding_box(placed(edge.curve, primitive.moves)));
    return box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
}

}  // namespace

ExactModel::ExactModel(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources,
                       const Carriers& carriers)
    : primitives_(primitives), carriers_(carriers) {
    for (std::size_t s = 0; s < sources.size(); ++s) number_portions(sources[s].curve, static_cast<int>(s));
    for (const Carrier& carrier : carriers.carriers) exact_carriers_.push_back(exact_carrier(carrier));
    int first_source = 0;
    for (const Primitive& primitive : primitives) {
        add_primitive(primitive, first_source);
        first_source += static_cast<int>(primitive.edges.size());
    }
    for (auto& loops : loops_)
        for (auto& loop : loops) join_carriers(loop);
}

void ExactModel::number_portions(const Curve& curve, int source) {
    first_portion_.push_back(static_cast<int>(portions.size()));
    SourcePortion portion;
    portion.source = source;
    const CarrierRun& run = carriers_.of_source[static_cast<std::size_t>(source)];
    if (const auto* arc = std::get_if<Arc>(&curve)) portion.turn = arc->sweep > 0 ? 1 : -1;
    if (const auto* line = std::get_if<Segment>(&curve)) portion.way = line->to - line->from;
    if (run.carrier < 0) portions.push_back(portion);
    for (std::size_t i = 0; run.carrier >= 0 && i + 1 < run.t.size(); ++i) {
        portion.t0 = run.t[i];
        portion.t1 = run.t[i + 1];
        portion.way = point(curve, portion.t1) - point(curve, portion.t0);
        portions.push_back(portion);
    }
}

void ExactModel::add_primitive(const Primitive& primitive, int first_source) {
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

std::size_t ExactModel::point_index(const ExactEdge& edge, int i) const {
    const Carrier& carrier = carriers_.carriers[static_cast<std::size_t>(edge.run->carrier)];
    const int k = edge.run->first + (edge.run->along == edge.along ? i : edge.run->n_arcs - i);
    return static_cast<std::size_t>(carrier.closed ? k % static_cast<int>(carrier.arcs.size()) : k);
}

ExactCarrier& ExactModel::carrier_of(const ExactEdge& edge) {
    return exact_carriers_[static_cast<std::size_t>(edge.run->carrier)];
}

Rational ExactModel::exact_end(const ExactEdge& edge, bool at_end) {
    if (edge.run) return carrier_of(edge).points[point_index(edge, at_end ? edge.run->n_arcs : 0)];
    return is_line(edge) ? (at_end ? edge.to : edge.from) : point_near(edge, at_end, 0);
}

void ExactModel::move_end(const ExactEdge& edge, bool at_end, const Rational& p) {
    const std::size_t k = point_index(edge, at_end ? edge.run->n_arcs : 0);
    ExactCarrier& carrier = carrier_of(edge);
    if (carrier.is_joined[k]) return;
    carrier.is_joined[k] = true;
    carrier.points[k] = p;
}

void ExactModel::join_carriers(std::vector<ExactEdge>& edges) {
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

Joint ExactModel::joint_of(const ExactEdge& a, const ExactEdge& b, double size) {
    if (!a.run && !b.run) return joint(a, b, size);
    const Rational end = exact_end(a, true), begin = exact_end(b, false);
    if (end == begin) return {one_root(end), one_root(begin), {}};
    return {one_root(end), one_root(begin), std::pair(end, begin)};
}

void ExactModel::add_closed(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces) {
    if (edge.run)
        add_arcs(edge, pieces);
    else
        add_monotone_pieces({edge.center, edge.radius, orientation(edge.turn)}, edge.portion, pieces);
}

void ExactModel::add_arcs(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces) {
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

std::vector<MonotoneCurve> ExactModel::boundary(std::size_t primitive, std::size_t loop) {
    const std::vector<ExactEdge>& edges = loops_[primitive][loop];
    std::vector<MonotoneCurve> pieces;
    if (edges.size() == 1) {
        add_closed(edges.front(), pieces);
        return pieces;
    }
    const double size = size_of(primitives_[primitive]);
    const std::size_t n = edges.size();
    std::vector<Joint> joints;  // after each edge
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

std::vector<MonotoneCurve> ExactModel::half_plane(std::size_t primitive, const HalfPlane& half, const Reach& reach) const {
    const ExactMap& map = maps_[primitive];
    const int portion = first_portion_of_primitive_[primitive];
    const Rational p = placed_exactly(half.point, map), c = exact_point(reach.center);
    const Kernel::Vector_2 n = turned_exactly(half.normal, map), d(-n.y(), n.x());
    const Number unit = 1 / Number(half.normal.norm() * map.scale);  // rounded: how far the polygon reaches need not be exact
    const Rational foot = p + ((c - p) * d) / (d * d) * d;
    const Number depth =
        3 * reach.radius + std::abs((reach.center - Vec2(CGAL::to_double(foot.x()), CGAL::to_double(foot.y()))).norm());
    const Kernel::Vector_2 side = (2 * reach.radius * unit) * d, down = (-depth * unit) * n;
    const Rational corners[] = {foot - side, foot + side, foot + side + down, foot - side + down};
    std::vector<MonotoneCurve> pieces;
    for (int i = 0; i < 4; ++i)
        pieces.emplace_back(PlaneTraits::X_monotone_curve_2(corners[i], corners[(i + 1) % 4]), i == 0 ? portion : far_source);
    return pieces;
}

}  // namespace abut::geometry::exact
