// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/loop_meetings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/message_text.hpp"
#include "geometry/brep/oriented_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"

namespace abut::geometry {

namespace {

/// Two ends are a tolerance apart at most, and so are the points found near each: in tolerances, what is still one place.
constexpr double same_place = 4;
/// Curves whose tangents differ by a smaller sine touch.
constexpr double crossing_sine = 1e-6;
/// Points between two meetings that tell whether the curves stay together: as fractions of the way, at odd places so that
/// symmetric curves do not agree on all of them by chance.
constexpr double between[] = {0.11, 0.31, 0.47, 0.67, 0.89};

/// One pair of edges, and what is asked about it.
class Pair {
public:
    Pair(const LoopModel& model, int a, int b)
        : model_(model), a_(a), b_(b), tolerance_(model.tolerance), tangent_reach_(std::sqrt(8 * tolerance_ * model.size)) {}

    std::optional<EdgeMeeting> meeting() const {
        const std::vector<Vec2> points = meeting_points(curve_a(), curve_b(), tolerance_);
        if (points.empty()) return std::nullopt;
        const std::vector<double> places = places_on_a(points);
        if (const auto stretch = shared_stretch(places)) return stretch;
        std::optional<EdgeMeeting> found;
        for (const double t : places) {
            const Vec2 p = point(curve_a(), t);
            if (at_shared_corner(t, p)) continue;
            if (crosses_at(p)) return EdgeMeeting{EdgeMeeting::Kind::cross, a_, b_, p, p, 0};
            if (!found) found = EdgeMeeting{EdgeMeeting::Kind::touch, a_, b_, p, p, 0};
        }
        return found;
    }

private:
    const Curve& curve_a() const { return model_.curve(a_); }
    const Curve& curve_b() const { return model_.curve(b_); }
    bool close(const Vec2& p, const Vec2& q, double tolerances = same_place) const {
        return (p - q).norm() <= tolerances * tolerance_;
    }
    bool on_b(const Vec2& p) const { return close(point(curve_b(), closest_parameter(curve_b(), p)), p, 1); }

    /// Parameters on a, ascending, of the meetings. Where a is closed, its ends are one point: both parameters count.
    std::vector<double> places_on_a(const std::vector<Vec2>& points) const {
        std::vector<double> places;
        for (const Vec2& p : points) places.push_back(closest_parameter(curve_a(), p));
        for (const double end : {0.0, 1.0})
            if (on_b(point(curve_a(), end))) places.push_back(end);
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        return places;
    }

    bool stay_together(double t0, double t1) const {
        return std::all_of(std::begin(between), std::end(between),
                           [&](double f) { return on_b(point(curve_a(), t0 + f * (t1 - t0))); });
    }

    bool at_an_end(const Vec2& p) const {
        for (const int end : {2 * a_, 2 * a_ + 1, 2 * b_, 2 * b_ + 1})
            if (close(model_.end_point(end), p)) return true;
        return false;
    }

    /// Curves that touch tangentially stay within the tolerance over a while: it takes more than tangent_reach to count as a
    /// stretch, or an end of one of the edges on either side.
    bool is_stretch(double t0, double t1) const {
        const Vec2 p0 = point(curve_a(), t0), p1 = point(curve_a(), t1);
        const double way = length(curve_a(), t0, t1);
        if (way <= same_place * tolerance_) return false;
        return (way > tangent_reach_ || (at_an_end(p0) && at_an_end(p1))) && stay_together(t0, t1);
    }

    /// From the first to the last place that they share, if the curves run along each other.
    std::optional<EdgeMeeting> shared_stretch(const std::vector<double>& places) const {
        std::optional<EdgeMeeting> stretch;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            if (!is_stretch(places[i], places[i + 1])) continue;
            if (!stretch) stretch = EdgeMeeting{EdgeMeeting::Kind::along, a_, b_, point(curve_a(), places[i]), {0, 0}, 0};
            stretch->to = point(curve_a(), places[i + 1]);
            stretch->shared += length(curve_a(), places[i], places[i + 1]);
        }
        if (!stretch) return stretch;
        const double longer = std::max(length(curve_a()), length(curve_b()));
        if (stretch->shared >= longer - 2 * same_place * tolerance_) stretch->kind = EdgeMeeting::Kind::same;
        return stretch;
    }

    /// Is the point at t of a part of the corner that the edges share, if they share one?
    bool at_shared_corner(double t, const Vec2& p) const {
        for (const int end_a : {2 * a_, 2 * a_ + 1})
            for (const int end_b : model_.joined[static_cast<std::size_t>(end_a)]) {
                if (end_b / 2 != b_) continue;
                const Vec2 corner = model_.end_point(end_a);
                if (close(corner, p)) return true;
                const bool beside = (corner - p).norm() <= tangent_reach_ && !at_an_end(p);
                if (beside && stay_together(std::min(t, end_a % 2 + 0.0), std::max(t, end_a % 2 + 0.0))) return true;
            }
        return false;
    }

    bool crosses_at(const Vec2& p) const {
        if (at_an_end(p)) return false;
        const Vec2 u = unit_tangent(curve_a(), closest_parameter(curve_a(), p));
        const Vec2 v = unit_tangent(curve_b(), closest_parameter(curve_b(), p));
        return std::abs(cross(u, v)) > crossing_sine;
    }

    const LoopModel& model_;
    int a_, b_;
    double tolerance_, tangent_reach_;
};

double perimeter_of_list(const LoopModel& model, int list) {
    double sum = 0;
    for (int e = model.first[static_cast<std::size_t>(list)]; e < model.first[static_cast<std::size_t>(list) + 1]; ++e)
        sum += length(model.curve(e));
    return sum;
}

int n_edges_of_list(const LoopModel& model, int list) {
    return model.first[static_cast<std::size_t>(list) + 1] - model.first[static_cast<std::size_t>(list)];
}

using LoopPair = std::pair<int, int>;
LoopPair loops_of(const LoopModel& model, const EdgeMeeting& m) {
    const int a = model.list_of(m.a), b = model.list_of(m.b);
    return {std::min(a, b), std::max(a, b)};
}

/// Pairs of lists that share all their length, with what they share.
std::vector<LoopPair> loops_drawn_twice(const LoopModel& model, const std::vector<EdgeMeeting>& meetings) {
    std::map<LoopPair, double> shared;
    for (const EdgeMeeting& m : meetings)
        if (m.shared > 0 && model.list_of(m.a) != model.list_of(m.b)) shared[loops_of(model, m)] += m.shared;
    std::vector<LoopPair> twice;
    for (const auto& [loops, length_shared] : shared) {
        const int n = n_edges_of_list(model, loops.first) + n_edges_of_list(model, loops.second);
        const double all = std::max(perimeter_of_list(model, loops.first), perimeter_of_list(model, loops.second));
        if (length_shared >= all - 2 * same_place * n * model.tolerance) twice.push_back(loops);
    }
    return twice;
}

GeometryProblem problem_of_loops(const LoopModel& model, const LoopPair& loops) {
    const int a = model.first[static_cast<std::size_t>(loops.first)], b = model.first[static_cast<std::size_t>(loops.second)];
    if (n_edges_of_list(model, loops.first) == 1 && n_edges_of_list(model, loops.second) == 1)
        return model.problem(b, "edges " + model.pair(a, b) + " are the same: the loop is drawn twice", "remove one of them",
                             model.end_point(2 * b));
    return model.problem(
        b, "the loops of edges " + model.pair(a, b) + " are the same: drawn twice at " + place_text(model.end_point(2 * b)),
        "remove one of the two loops", model.end_point(2 * b));
}

bool in_one_loop(const LoopModel& model, const EdgeMeeting& m) {
    return model.list_of(m.a) == model.list_of(m.b);
}

GeometryProblem problem_of_stretch(const LoopModel& model, const EdgeMeeting& m) {
    const std::string edges = "edges " + model.pair(m.a, m.b), from_to = place_text(m.at) + " to " + place_text(m.to);
    if (is_spike(model, m))
        return model.problem(m.b, "a spike: " + edges + " run back over each other from " + from_to,
                             "remove the spike, so that the outline goes on where it begins", m.at);
    if (m.kind == EdgeMeeting::Kind::same)
        return model.problem(m.b, edges + " are the same, from " + from_to, "remove one of them", m.at);
    const std::string who = in_one_loop(model, m) ? "the loop touches itself: " : "two loops touch: ";
    return model.problem(m.a, who + edges + " run along each other from " + from_to,
                         in_one_loop(model, m) ? "leave out what is drawn twice"
                                               : "leave out the edge between them, or give each loop a node of its own",
                         m.at);
}

GeometryProblem problem_of_point(const LoopModel& model, const EdgeMeeting& m) {
    const bool one = in_one_loop(model, m), crosses = m.kind == EdgeMeeting::Kind::cross;
    const std::string verb = crosses ? "cross" : "touch", edges = "edges " + model.pair(m.a, m.b);
    const std::string who = one ? "the loop " + verb + "es itself: " : "two loops " + verb + ": ";
    const std::string hint = one ? crosses ? "give the corners in the order in which the outline runs through them"
                                           : "split it into two loops, or move the edges apart"
                                 : "move them apart, or give each loop a node of its own and join or subtract them";
    return model.problem(m.a, who + edges + " " + verb + " at " + place_text(m.at), hint, m.at);
}

/// Of several meetings of two loops in one place the first is told; `order` lists the most telling ones first.
std::vector<int> told(const LoopModel& model, const std::vector<EdgeMeeting>& meetings, const std::vector<int>& order) {
    std::vector<Box2> places(2 * meetings.size());
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        places[2 * i].extend(meetings[i].at);
        places[2 * i + 1].extend(meetings[i].to);
    }
    const EdgeTree tree(places);
    std::vector<bool> is_told(meetings.size(), false);
    for (const int i : order) {
        const EdgeMeeting& m = meetings[static_cast<std::size_t>(i)];
        const auto said = [&](int place) {
            const auto other = static_cast<std::size_t>(place / 2);
            return is_told[other] && loops_of(model, meetings[other]) == loops_of(model, m);
        };
        const std::vector<int> near = tree.near(places[2 * static_cast<std::size_t>(i)], same_place * model.tolerance);
        is_told[static_cast<std::size_t>(i)] = m.shared > 0 || std::none_of(near.begin(), near.end(), said);
    }
    std::vector<int> found;
    for (std::size_t i = 0; i < meetings.size(); ++i)
        if (is_told[i]) found.push_back(static_cast<int>(i));
    return found;
}

}  // namespace

std::vector<EdgeMeeting> edge_meetings(const LoopModel& model, const std::vector<bool>& is_left_out) {
    std::vector<OrientedTree::Item> items;
    for (const LoopEdge& edge : model.edges) items.push_back({bounding_box(edge.curve), oriented_box(edge.curve)});
    const OrientedTree tree(items);
    std::vector<EdgeMeeting> found;
    for (std::size_t a = 0; a < items.size(); ++a) {
        if (is_left_out[a]) continue;
        for (const int b : tree.near_after(a, model.tolerance)) {
            if (is_left_out[static_cast<std::size_t>(b)]) continue;
            if (const auto meeting = Pair(model, static_cast<int>(a), b).meeting()) found.push_back(*meeting);
        }
    }
    return found;
}

bool is_spike(const LoopModel& model, const EdgeMeeting& meeting) {
    if (!(meeting.shared > 0)) return false;
    int shared = 0, alone = 0;
    for (const int end : {2 * meeting.a, 2 * meeting.a + 1}) {
        const std::vector<int>& joined = model.joined[static_cast<std::size_t>(end)];
        const bool with_b = std::any_of(joined.begin(), joined.end(), [&](int o) { return o / 2 == meeting.b; });
        shared += with_b;
        alone += with_b && joined.size() == 1;
    }
    return alone == 1 || (alone == 2 && shared == 2 && meeting.kind != EdgeMeeting::Kind::same);
}

std::vector<GeometryProblem> meeting_problems(const LoopModel& model, const std::vector<EdgeMeeting>& meetings) {
    std::vector<GeometryProblem> problems;
    const std::vector<LoopPair> twice = loops_drawn_twice(model, meetings);
    for (const LoopPair& loops : twice) problems.push_back(problem_of_loops(model, loops));
    std::vector<EdgeMeeting> rest;
    for (const EdgeMeeting& m : meetings)
        if (!std::binary_search(twice.begin(), twice.end(), loops_of(model, m))) rest.push_back(m);

    std::vector<int> order;
    for (const auto kind :
         {EdgeMeeting::Kind::same, EdgeMeeting::Kind::along, EdgeMeeting::Kind::cross, EdgeMeeting::Kind::touch})
        for (std::size_t i = 0; i < rest.size(); ++i)
            if (rest[i].kind == kind) order.push_back(static_cast<int>(i));
    for (const int i : told(model, rest, order)) {
        const EdgeMeeting& m = rest[static_cast<std::size_t>(i)];
        problems.push_back(m.shared > 0 ? problem_of_stretch(model, m) : problem_of_point(model, m));
    }
    return problems;
}

}  // namespace abut::geometry
