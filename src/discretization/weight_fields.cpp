// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/weight_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/implicit/blended_distance.hpp"
#include "geometry/implicit/r_functions.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using geometry::CsgNode;
using geometry::Curve;
using geometry::Jet;
using geometry::Part;
using geometry::Segment;
using geometry::Vec2;

/// The line of a straight edge: n.(p - a), n outward.
struct Line {
    Vec2 a, n;
    double operator()(const Vec2& p) const { return n.dot(p - a); }
};

Line line_of(const Curve& segment) {
    return {point(segment, 0), outward_normal(segment, 0.5)};
}

/// Largest value of a line's function on a curve.
double farthest(const Line& line, const Curve& curve) {
    // turned so that the first coordinate is n.p
    return bounding_box(transformed(curve, line.n.x(), -line.n.y(), {0, 0})).max.x() - line.n.dot(line.a);
}

bool lies_on(const Line& line, const Curve& curve, double merge) {
    return std::holds_alternative<Segment>(curve) && std::abs(line(point(curve, 0))) < merge &&
           std::abs(line(point(curve, 1))) < merge;
}

/// The held edges on a line that bounds the part's hull and that nothing else reaches but at their ends; empty if it is no such
/// line.
std::vector<int> edges_on_hull_line(const Part& part, const std::vector<int>& held, const Line& line, double merge) {
    std::vector<int> on_line;
    std::vector<Vec2> ends;
    for (int e : held) {
        const Curve& curve = part.edges[at(e)].curve;
        if (!lies_on(line, curve, merge)) continue;
        on_line.push_back(e);
        ends.push_back(point(curve, 0));
        ends.push_back(point(curve, 1));
    }
    const auto is_held_end = [&](const Vec2& p) {
        return std::any_of(ends.begin(), ends.end(), [&](const Vec2& q) { return (p - q).norm() < merge; });
    };
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        if (std::find(on_line.begin(), on_line.end(), static_cast<int>(e)) != on_line.end()) continue;
        const Curve& curve = part.edges[e].curve;
        const double reach = farthest(line, curve);
        const bool touches_at_end = is_held_end(point(curve, 0)) || is_held_end(point(curve, 1));
        if (reach > merge || (reach > -merge && !touches_at_end) || lies_on(line, curve, merge)) return {};
    }
    return on_line;
}

Jet linear(const Line& line, double size, const Vec2& p) {
    return {-line(p) / size, -line.n.x() / size, -line.n.y() / size, 0, 0, 0};
}

Jet jet_of(const geometry::FieldValue& f, double unit) {
    return {f.value / unit, f.gradient.x() / unit, f.gradient.y() / unit, 0, 0, 0};
}

WeightField weight(const geometry::ImplicitField& field, double size, bool is_linear = false) {
    return {[field, size](const Vec2& p) { return jet_of(geometry::evaluate(field, p), size); }, is_linear};
}

/// Least and largest value of a curve's whole field along another curve.
struct FieldRange {
    double least, largest;
};
FieldRange range_along(const geometry::ImplicitField& field, const Curve& curve) {
    FieldRange range{geometry::value(field, point(curve, 0)), 0};
    range.largest = range.least;
    for (int k = 1; k <= geometry::held_samples; ++k) {
        const double v = geometry::value(field, point(curve, static_cast<double>(k) / geometry::held_samples));
        range = {std::min(range.least, v), std::max(range.largest, v)};
    }
    return range;
}

bool lies_along(const geometry::ImplicitField& field, const Curve& curve, double merge) {
    const FieldRange range = range_along(field, curve);
    return std::max(-range.least, range.largest) < merge;
}

/// Nodes first, then each line, circle or ellipse once.
std::vector<WeightField> r_functions(const Part& part, const std::vector<int>& held, double size, const CsgNode& tree) {
    const double merge = geometry::merge_fraction * size;
    const geometry::HeldNodes nodes = geometry::held_nodes(tree, part, held);
    std::vector<WeightField> fields;
    for (const geometry::ImplicitField& node : nodes.fields) fields.push_back(weight(node, size));
    std::vector<int> edges = nodes.rest;
    while (!edges.empty()) {
        const Curve& curve = part.edges[at(edges.front())].curve;
        fields.push_back(weight(geometry::whole_field(curve), size, std::holds_alternative<Segment>(curve)));
        const geometry::ImplicitField field = geometry::whole_field(curve);
        edges.erase(edges.begin());
        std::erase_if(edges, [&](int e) { return lies_along(field, part.edges[at(e)].curve, merge); });
    }
    return fields;
}

bool is_finite(const Jet& j) {
    return std::isfinite(j.v) && std::isfinite(j.x) && std::isfinite(j.y);
}

}  // namespace

EdgeWeights edge_weights(const std::string& word) {
    if (word == "r_function") return EdgeWeights::r_function;
    return word == "blended" ? EdgeWeights::blended : EdgeWeights::joined;
}

std::optional<int> edge_that_holds_more(const Part& part, const std::vector<int>& edges, double size, const CsgNode& tree) {
    const double merge = geometry::merge_fraction * size;
    for (const int e : geometry::held_nodes(tree, part, edges).rest) {
        const geometry::ImplicitField field = geometry::whole_field(part.edges[at(e)].curve);
        for (std::size_t k = 0; k < part.edges.size(); ++k) {
            const FieldRange range = range_along(field, part.edges[k].curve);
            const bool is_held = std::find(edges.begin(), edges.end(), static_cast<int>(k)) != edges.end();
            if (range.least < -merge || (range.largest < merge && !is_held)) return e;
        }
    }
    return std::nullopt;
}

std::vector<WeightField> edge_fields(const Part& part, const std::vector<int>& edges, double size, EdgeWeights how,
                                     const CsgNode& tree) {
    if (edges.empty()) return {};
    if (how == EdgeWeights::r_function) return r_functions(part, edges, size, tree);
    if (how == EdgeWeights::blended) return {weight(geometry::blended_edge_distance(part, edges), size)};
    const double merge = geometry::merge_fraction * size;
    std::vector<WeightField> fields;
    std::vector<int> rest = edges;
    while (!rest.empty()) {
        const int edge = rest.front();
        const Curve& curve = part.edges[at(edge)].curve;
        std::vector<int> on_line;
        if (std::holds_alternative<Segment>(curve)) on_line = edges_on_hull_line(part, edges, line_of(curve), merge);
        if (on_line.empty()) {
            on_line = {edge};
            fields.push_back(weight(geometry::edge_field(part, {edge}, geometry::leaf_join_order), size));
        } else {
            const Line line = line_of(curve);
            fields.push_back({[line, size](const Vec2& p) { return linear(line, size, p); }, true});
        }
        std::erase_if(rest, [&](int e) { return std::find(on_line.begin(), on_line.end(), e) != on_line.end(); });
    }
    return fields;
}

WeightField point_weight(const std::vector<Vec2>& points, double size) {
    const geometry::ImplicitField field = geometry::point_field(points);
    return weight(field, size * size);
}

WeightField conjoined(const std::vector<WeightField>& fields) {
    if (fields.size() == 1) return fields.front();
    const auto middle = fields.begin() + static_cast<std::ptrdiff_t>(fields.size() / 2);
    const JetField a = conjoined({fields.begin(), middle}).field, b = conjoined({middle, fields.end()}).field;
    return {[a, b](const Vec2& p) { return geometry::conjunction(a(p), b(p), 0.0); }, false};
}

JetField blended(const std::vector<PrescribedField>& fields) {
    if (fields.size() == 1) return fields.front().value;
    return [fields](const Vec2& p) {
        std::vector<Jet> square;
        for (const PrescribedField& f : fields) {
            const Jet d = f.distance.field(p);
            square.push_back(d * d);
        }
        Jet above, below;
        for (std::size_t k = 0; k < fields.size(); ++k) {
            Jet share(1);  // product of the others' squares: sum of g / d^2 without its poles
            for (std::size_t j = 0; j < fields.size(); ++j)
                if (j != k) share = share * square[j];
            above += fields[k].value(p) * share;
            below += share;
        }
        return above / below;
    };
}

solver::ScalarField scalar_field(const JetField& field, const Vec2& inside) {
    return [field, inside](const Vec2& p) -> solver::ScalarAt {
        Jet j = field(p);
        if (!is_finite(j)) j = field(p + inward_step * (inside - p));
        return {j.v, {j.x, j.y}};
    };
}

}  // namespace abut
