// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/selection.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Part;

/// Portions of one curve, as pairs t0 < t1.
using Intervals = std::vector<std::pair<double, double>>;

/// A normal at exactly the limit of `within` counts as inside; this much rounding (radians) is forgiven.
constexpr double angle_rounding = 1e-9;
constexpr double all_round = 2 * std::numbers::pi;

/// Glob match with `*` for any run of characters. Greedy with one point of return: linear for one `*`, quadratic at worst.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p, ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

/// "left#12" -> "left"; other names as they are.
std::string_view without_piece_number(std::string_view name) {
    const std::size_t hash = name.rfind('#');
    if (hash == std::string_view::npos || hash + 1 == name.size()) return name;
    const bool digits = std::all_of(name.begin() + static_cast<std::ptrdiff_t>(hash) + 1, name.end(),
                                    [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
    return digits ? name.substr(0, hash) : name;
}

bool names_edge(const std::string& pattern, const ScenePart& part, const geometry::Edge& edge) {
    if (matches(pattern, part.name + "/" + edge.name)) return true;
    // A spline's piece that a Boolean cut again has two numbers: "cam#1#0" is of "cam#1" and of "cam".
    for (std::string_view name = edge.name, whole = without_piece_number(name); whole != name;
         name = whole, whole = without_piece_number(name))
        if (matches(pattern, part.name + "/" + std::string(whole))) return true;
    return false;
}

// --- box

bool inside(const Vec2& p, const std::array<Vec2, 2>& box, double margin) {
    return p.x() >= box[0].x() - margin && p.x() <= box[1].x() + margin && p.y() >= box[0].y() - margin &&
           p.y() <= box[1].y() + margin;
}

/// 0, the parameters that lie farther than margin (arc length) from the one before and from both ends, and 1; ascending.
std::vector<double> well_apart(const Curve& curve, std::vector<double> parameters, double margin) {
    std::sort(parameters.begin(), parameters.end());
    std::vector<double> result{0};
    for (const double t : parameters) {
        const bool apart = geometry::length(curve, result.back(), t) > margin && geometry::length(curve, t, 1) > margin;
        if (apart) result.push_back(t);
    }
    result.push_back(1);
    return result;
}

/// Between two neighbouring crossings a curve is either inside or outside: its middle decides. The margin takes edges that lie
/// on a side of the box, and keeps mere touches from cutting an edge.
Intervals inside_box(const Curve& curve, const std::array<Vec2, 2>& box, double margin) {
    std::vector<double> cuts;
    for (const Vec2& corner : box)
        for (const int axis : {0, 1})
            for (const double t : geometry::crossings(curve, axis, corner[axis])) cuts.push_back(t);
    const std::vector<double> parameters = well_apart(curve, std::move(cuts), margin);
    Intervals result;
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
        const double t0 = parameters[i], t1 = parameters[i + 1];
        if (inside(geometry::point(curve, 0.5 * (t0 + t1)), box, margin)) result.emplace_back(t0, t1);
    }
    return result;
}

// --- facing

double direction_angle(const Vec2& v) {
    return std::atan2(v.y(), v.x());
}

/// The outward normal of an arc turns evenly with t: from `first` by the sweep; radially outward on arcs that turn left.
Intervals arc_facing(const Arc& arc, double middle, double within) {
    const double first = arc.start + (arc.sweep > 0 ? 0 : std::numbers::pi);
    const double low = std::min(first, first + arc.sweep), high = std::max(first, first + arc.sweep);
    Intervals result;
    for (double turn = std::floor((low - middle - within) / all_round); middle - within + turn * all_round < high; ++turn) {
        const double a = std::max(low, middle - within + turn * all_round),
                     b = std::min(high, middle + within + turn * all_round);
        if (a >= b) continue;
        const double t0 = std::clamp((a - first) / arc.sweep, 0.0, 1.0), t1 = std::clamp((b - first) / arc.sweep, 0.0, 1.0);
        result.emplace_back(std::min(t0, t1), std::max(t0, t1));
    }
    return result;
}

/// 0, every parameter where the normal is at a limit of the angle, and 1. With the limit turned into an axis, those are among
/// the places where the tangent is parallel to an axis.
std::vector<double> limit_parameters(const Curve& curve, double middle, double within) {
    std::vector<double> parameters{0, 1};
    for (const double limit : {middle - within, middle + within})
        for (const double t : axis_extrema(transformed(curve, std::cos(limit), -std::sin(limit), Vec2(0, 0))))
            parameters.push_back(t);
    std::sort(parameters.begin(), parameters.end());
    return parameters;
}

Intervals facing(const Curve& curve, const Vec2& direction, double within) {
    if (within >= std::numbers::pi) return {{0, 1}};
    const double middle = direction_angle(direction);
    if (const auto* arc = std::get_if<Arc>(&curve)) return arc_facing(*arc, middle, within);
    const std::vector<double> parameters = limit_parameters(curve, middle, within);
    Intervals result;
    for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
        const double t0 = parameters[i], t1 = parameters[i + 1];
        if (t0 == t1) continue;
        const double off =
            std::remainder(direction_angle(geometry::outward_normal(curve, 0.5 * (t0 + t1))) - middle, all_round);
        if (std::abs(off) <= within + angle_rounding) result.emplace_back(t0, t1);
    }
    return result;
}

// --- one selector

/// A place that is farther from a part than this part is large is none of it: in another unit, or with another sign.
int closest_edge(const Part& part, const Vec2& p) {
    const NearestEdges nearest = nearest_edges(part, p);
    return nearest.distance <= geometry::bounding_box(part).diagonal() ? nearest.edges.front() : -1;
}

/// What a selector takes of one edge of a part that it names.
Intervals selected_of_edge(const Selector& selector, const ScenePart& part, int edge) {
    const geometry::Edge& e = part.part.edges[static_cast<std::size_t>(edge)];
    if (selector.box) return inside_box(e.curve, *selector.box, geometry::merge_length(part.part));
    if (selector.facing) return facing(e.curve, *selector.facing, selector.within * std::numbers::pi / 180);
    return names_edge(selector.pattern, part, e) ? Intervals{{0, 1}} : Intervals{};
}

void select_one(const Scene& scene, const Selector& selector, std::vector<EdgePortion>& portions) {
    for (std::size_t p = 0; p < scene.parts.size(); ++p) {
        const ScenePart& part = scene.parts[p];
        if (selector.pattern.empty() && part.name != selector.part) continue;
        const int closest = selector.near ? closest_edge(part.part, *selector.near) : -1;
        for (int e = 0; e < static_cast<int>(part.part.edges.size()); ++e) {
            const Intervals intervals = !selector.near ? selected_of_edge(selector, part, e)
                                        : e == closest ? Intervals{{0, 1}}
                                                       : Intervals{};
            for (const auto& [t0, t1] : intervals) portions.push_back({static_cast<int>(p), e, t0, t1});
        }
    }
}

// --- what to say where nothing matches

std::vector<std::string> part_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const ScenePart& part : scene.parts) names.push_back(part.name);
    return names;
}

/// Names of all edges of the parts whose name matches the pattern.
std::vector<std::string> edge_names(const Scene& scene, const std::string& part_pattern) {
    std::vector<std::string> names;
    for (const ScenePart& part : scene.parts) {
        if (!matches(part_pattern, part.name)) continue;
        for (const geometry::Edge& edge : part.part.edges) names.push_back(part.name + "/" + edge.name);
    }
    return names;
}

/// The name that was meant, perhaps: of a piece, or of all pieces of an edge.
std::string nearest_edge_name(const std::string& pattern, const std::vector<std::string>& edges) {
    std::vector<std::string> candidates = edges;
    for (const std::string& edge : edges) candidates.emplace_back(without_piece_number(edge));
    return nearest_name(pattern, candidates);
}

Problem nothing_matches(const Scene& scene, const Selector& selector) {
    const bool by_name = !selector.pattern.empty();
    const std::string part = by_name ? selector.pattern.substr(0, selector.pattern.find('/')) : selector.part;
    // A star may stand for a '/' as well: "*left" speaks of all parts.
    const std::vector<std::string> edges = edge_names(scene, by_name && part.find('*') != std::string::npos ? "*" : part);
    if (edges.empty())
        return {selector.where, "there is no part '" + shortened(part) + "'", nearest_name_hint(part, part_names(scene))};
    if (by_name && selector.pattern == part && part.find('*') == std::string::npos) {
        return {selector.where, "'" + shortened(part) + "' names a part, not an edge",
                "write \"" + part + "/*\" for all its edges: " + listed(edges)};
    }
    if (by_name) {
        return {selector.where, "no edge matches '" + shortened(selector.pattern) + "'",
                "did you mean '" + nearest_edge_name(selector.pattern, edges) + "'? the edges are " + listed(edges)};
    }
    if (selector.near) {
        const auto named =
            std::find_if(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& p) { return p.name == part; });
        const geometry::Box2 box = geometry::bounding_box(named->part);
        return {selector.where,
                "the place is " + number_text(nearest_edges(named->part, *selector.near).distance, 4) + " away from '" +
                    shortened(part) + "', which is " + number_text(box.diagonal(), 4) + " across",
                "give a place beside one of its edges: it goes from (" + number_text(box.min.x(), 4) + ", " +
                    number_text(box.min.y(), 4) + ") to (" + number_text(box.max.x(), 4) + ", " + number_text(box.max.y(), 4) +
                    ")"};
    }
    const std::string what = selector.box ? "inside the box" : "facing this way";
    return {selector.where, "no edge of '" + shortened(part) + "' lies " + what, "its edges are " + listed(edges)};
}

/// Overlapping and adjoining portions of one edge become one.
std::vector<EdgePortion> merged(std::vector<EdgePortion> portions) {
    std::sort(portions.begin(), portions.end(), [](const EdgePortion& a, const EdgePortion& b) {
        return std::tie(a.part, a.edge, a.t0, a.t1) < std::tie(b.part, b.edge, b.t0, b.t1);
    });
    std::vector<EdgePortion> result;
    for (const EdgePortion& portion : portions) {
        const bool same_edge = !result.empty() && result.back().part == portion.part && result.back().edge == portion.edge;
        if (same_edge && portion.t0 <= result.back().t1) {
            result.back().t1 = std::max(result.back().t1, portion.t1);
        } else {
            result.push_back(portion);
        }
    }
    return result;
}

}  // namespace

NearestEdges nearest_edges(const Part& part, const Vec2& p) {
    std::vector<double> distances;
    for (const geometry::Edge& edge : part.edges)
        distances.push_back((geometry::point(edge.curve, geometry::closest_parameter(edge.curve, p)) - p).norm());
    NearestEdges nearest;
    if (distances.empty()) return nearest;
    nearest.distance = *std::min_element(distances.begin(), distances.end());
    const double as_near = nearest.distance + geometry::merge_length(part);
    for (std::size_t e = 0; e < distances.size(); ++e)
        if (distances[e] <= as_near) nearest.edges.push_back(static_cast<int>(e));
    return nearest;
}

std::vector<EdgePortion> select(const Scene& scene, const Selection& selection) {
    std::vector<EdgePortion> portions;
    std::vector<Problem> problems;
    for (const Selector& selector : selection) {
        const std::size_t before = portions.size();
        select_one(scene, selector, portions);
        if (portions.size() == before) problems.push_back(nothing_matches(scene, selector));
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    return merged(std::move(portions));
}

int own_part(const PairRule& rule) {
    const int part = rule.on[0].empty() ? -1 : rule.on[0].front().part;
    const auto is_its = [&](const EdgePortion& p) { return p.part == part; };
    const auto is_on_it = [&](const std::vector<EdgePortion>& side) { return std::all_of(side.begin(), side.end(), is_its); };
    return std::all_of(rule.on.begin(), rule.on.end(), is_on_it) ? part : -1;
}

std::set<int> parts_with_themselves(const ContactOptions& contacts) {
    std::set<int> parts = contacts.of_one_part;
    for (const PairRule& rule : contacts.pairs)
        if (const int part = own_part(rule); part >= 0 && (rule.kind == PairRule::Kind::bonded || rule.interference != 0))
            parts.insert(part);
    return parts;
}

void resolve(const Scene& scene, PairRule& rule) {
    for (std::size_t side : {0U, 1U}) rule.on[side] = select(scene, rule.between[side]);
}

}  // namespace abut
