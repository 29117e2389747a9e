// SPDX-License-Identifier: GPL-3.0-or-later
// In this order: each edge alone (finite, its length, does it meet itself), which ends join, where edges meet otherwise, the
// chains from joint to joint, their orientation and nesting. Orientation and nesting need loops without problems; all else is
// looked at whatever was found before, so that the user learns of everything at once.
#include "geometry/csg/loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "geometry/brep/loop_nesting.hpp"
#include "geometry/brep/message_text.hpp"
#include "geometry/brep/self_crossing.hpp"
#include "geometry/csg/loop_meetings.hpp"
#include "geometry/csg/loop_model.hpp"

namespace abut::geometry {

namespace {

/// Angles that exceed a full turn by less are a full turn, as a fraction of it.
constexpr double full_turn_slack = 1e-12;
/// Ends of open loops that are told per loop; a last problem tells how many more there are.
constexpr int max_open_ends = 20;

int n_edges(const LoopModel& model) {
    return static_cast<int>(model.edges.size());
}

bool turns_too_far(double sweep) {
    return std::abs(sweep) > 2 * std::numbers::pi * (1 + full_turn_slack);
}

/// What is wrong with the numbers of an edge; empty if nothing.
std::pair<std::string, std::string> fault_of(const Curve& curve) {
    if (!is_finite(curve)) return {"is not finite", "check its numbers"};
    if (const auto* arc = std::get_if<Arc>(&curve)) {
        if (!(arc->radius > 0)) return {"has no positive radius", "give a radius above 0"};
        if (turns_too_far(arc->sweep)) return {"runs more than once around its circle", "give at most a full turn"};
    }
    if (const auto* arc = std::get_if<EllipticArc>(&curve)) {
        if (cross(arc->a, arc->b) == 0) return {"has a half axis without length", "give radii above 0"};
        if (turns_too_far(arc->sweep)) return {"runs more than once around its ellipse", "give at most a full turn"};
    }
    return {};
}

void check_numbers(const LoopModel& model, std::vector<GeometryProblem>& problems) {
    for (int e = 0; e < n_edges(model); ++e)
        if (const auto [what, hint] = fault_of(model.curve(e)); !what.empty())
            problems.push_back(model.problem(e, "edge '" + model.name(e) + "' " + what, hint, {0, 0}));
}

void measure(LoopModel& model) {
    Box2 box;
    for (const LoopEdge& edge : model.edges) box.extend(bounding_box(edge.curve));
    model.size = box.diagonal();
    model.tolerance = merge_fraction * model.size;
}

/// Lengths that the rounding of the edge's own coordinates could make.
double rounding_of(const Curve& curve) {
    const Box2 box = bounding_box(curve);
    return 4 * std::numeric_limits<double>::epsilon() * std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
}

/// Tiny edges are left out, those without any length are the user's slip.
std::vector<bool> drop_tiny_edges(const LoopModel& model, Boundary& result) {
    std::vector<bool> is_left_out(model.edges.size(), false);
    for (int e = 0; e < n_edges(model); ++e) {
        const double s = length(model.curve(e));
        if (s > model.tolerance) continue;
        const Vec2 at = model.end_point(2 * e);
        const std::string edge = "edge '" + model.name(e) + "'";
        is_left_out[static_cast<std::size_t>(e)] = true;
        if (s <= rounding_of(model.curve(e))) {
            result.problems.push_back(model.problem(e, edge + " has no length at " + place_text(at),
                                                    "remove it, or the point that is given twice", at));
        } else {
            result.dropped.push_back(e);
            result.repairs.push_back(
                {edge + " is shorter than the merge length, " + number_text(model.tolerance) + ", and was left out", at, s});
        }
    }
    return is_left_out;
}

void check_vanished_loops(const LoopModel& model, const std::vector<bool>& is_left_out,
                          std::vector<GeometryProblem>& problems) {
    for (std::size_t l = 0; l + 1 < model.first.size(); ++l) {
        const int first = model.first[l], last = model.first[l + 1];
        if (first == last || std::count(is_left_out.begin() + first, is_left_out.begin() + last, false) > 0) continue;
        problems.push_back(model.problem(first,
                                         "the loop of edge '" + model.name(first) +
                                             "' has no edge longer than the merge length, " + number_text(model.tolerance),
                                         "remove it", model.end_point(2 * first)));
    }
}

void check_names(const LoopModel& model, std::vector<GeometryProblem>& problems) {
    std::map<std::string, int> seen;
    for (int e = 0; e < n_edges(model); ++e)
        if (!seen.emplace(model.name(e), e).second)
            problems.push_back(model.problem(e, "the edge name '" + model.name(e) + "' is given twice",
                                             "give each edge a name of its own", model.end_point(2 * e)));
}

void check_self_meetings(const LoopModel& model, std::vector<GeometryProblem>& problems) {
    for (int e = 0; e < n_edges(model); ++e)
        if (const auto m = self_meeting(model.curve(e), model.tolerance))
            problems.push_back(model.problem(e,
                                             "edge '" + model.name(e) + "' " + (m->crosses ? "crosses" : "touches") +
                                                 " itself at " + place_text(m->at) + ", where its parameter is " +
                                                 number_text(m->t0) + " and " + number_text(m->t1),
                                             "move its points so that it does not meet itself", m->at));
}

/// Every loose end once, with the nearest other loose end.
void report_gaps(const LoopModel& model, std::vector<int> loose, std::vector<GeometryProblem>& problems) {
    for (int told = 0; !loose.empty(); ++told) {
        const int a = loose.front();
        const Vec2 at = model.end_point(a);
        if (told == max_open_ends) {
            problems.push_back(model.problem(a / 2, std::to_string(loose.size()) + " more ends of the loop's edges are open",
                                             "close the loop", at));
            return;
        }
        loose.erase(loose.begin());
        const auto distance = [&](int end) { return (model.end_point(end) - at).norm(); };
        const auto nearest =
            std::min_element(loose.begin(), loose.end(), [&](int i, int j) { return distance(i) < distance(j); });
        if (nearest == loose.end()) {
            problems.push_back(model.problem(
                a / 2, "the loop is open: nothing joins the end of edge '" + model.name(a / 2) + "' at " + place_text(at),
                "close the loop", at));
            return;
        }
        const std::string apart = number_text(distance(*nearest)) + " apart at " + place_text(at);
        const std::string hint = "move the ends together (within " + number_text(model.tolerance) + ")";
        if (a / 2 == *nearest / 2)
            problems.push_back(model.problem(
                a / 2, "the loop is open: the ends of edge '" + model.name(a / 2) + "' are " + apart, "close the loop", at));
        else
            problems.push_back(
                model.problem(a / 2, "the loop is open: edges " + model.pair(a / 2, *nearest / 2) + " are " + apart, hint, at));
        loose.erase(nearest);
    }
}

/// Points where more than two ends meet, each once.
bool report_branchings(const LoopModel& model, int first, int last, std::vector<GeometryProblem>& problems) {
    bool branched = false;
    for (int end = 2 * first; end < 2 * last; ++end) {
        const std::vector<int>& others = model.joined[static_cast<std::size_t>(end)];
        if (others.size() <= 1) continue;
        branched = true;
        if (others.front() < end) continue;  // said there; `joined` is ascending
        std::string names = "'" + model.name(end / 2) + "'";
        for (const int other : others) names += ", '" + model.name(other / 2) + "'";
        const Vec2 at = model.end_point(end);
        problems.push_back(model.problem(end / 2, "the loop touches itself: edges " + names + " all end at " + place_text(at),
                                         "let two edges meet at each point, or split the loop", at));
    }
    return branched;
}

/// Follows the edges of one list from joint to joint, which is one loop (or several, if the list holds them).
void follow(const LoopModel& model, int first, int last, const std::vector<bool>& is_left_out, Boundary& result) {
    std::vector<bool> used(is_left_out.begin() + first, is_left_out.begin() + last);
    for (int start = first; start < last; ++start) {
        BoundaryLoop loop;
        for (int e = start, begin = 0; !used[static_cast<std::size_t>(e - first)];) {
            used[static_cast<std::size_t>(e - first)] = true;
            loop.edges.push_back({e, begin == 0});
            const int next = model.joined[static_cast<std::size_t>(2 * e + 1 - begin)].front();
            e = next / 2;
            begin = next % 2;
        }
        if (!loop.edges.empty()) result.loops.push_back(std::move(loop));
    }
}

void chain(const LoopModel& model, const std::vector<bool>& is_left_out, Boundary& result) {
    for (std::size_t l = 0; l + 1 < model.first.size(); ++l) {
        const int first = model.first[l], last = model.first[l + 1];
        std::vector<int> loose;
        for (int end = 2 * first; end < 2 * last; ++end)
            if (!is_left_out[static_cast<std::size_t>(end / 2)] && model.joined[static_cast<std::size_t>(end)].empty())
                loose.push_back(end);
        const bool branched = report_branchings(model, first, last, result.problems);
        report_gaps(model, loose, result.problems);
        if (!branched && loose.empty()) follow(model, first, last, is_left_out, result);
    }
}

bool only_join_each_other(const LoopModel& model, const EdgeMeeting& m) {
    return std::ranges::all_of(std::array{2 * m.a, 2 * m.a + 1}, [&](int end) {
        const std::vector<int>& joined = model.joined[static_cast<std::size_t>(end)];
        return joined.size() == 1 && joined.front() / 2 == m.b;
    });
}

/// An edge drawn twice, or there and back, has been told already: chains are looked for without it.
std::vector<bool> without_repeated(const LoopModel& model, const std::vector<EdgeMeeting>& meetings,
                                   std::vector<bool> is_left_out) {
    for (const EdgeMeeting& m : meetings) {
        if (m.kind != EdgeMeeting::Kind::same || model.list_of(m.a) != model.list_of(m.b)) continue;
        is_left_out[static_cast<std::size_t>(m.b)] = true;
        if (is_spike(model, m) || only_join_each_other(model, m)) is_left_out[static_cast<std::size_t>(m.a)] = true;
    }
    return is_left_out;
}

void reverse(BoundaryLoop& loop) {
    std::reverse(loop.edges.begin(), loop.edges.end());
    for (OrientedEdge& e : loop.edges) e.along = !e.along;
}

Part alone(const LoopModel& model, const BoundaryLoop& loop) {
    Part part;
    for (const OrientedEdge& e : loop.edges)
        part.edges.push_back({e.along ? model.curve(e.edge) : reversed(model.curve(e.edge)), "", ""});
    return part;
}

/// Turns all loops counter-clockwise; a loop whose area vanishes beside its length is a problem.
void turn_counter_clockwise(const LoopModel& model, Boundary& result) {
    for (BoundaryLoop& loop : result.loops) {
        const Part part = alone(model, loop);
        const double a = area(part);
        const int e = loop.edges.front().edge;
        if (std::abs(a) <= model.tolerance * perimeter(part))
            result.problems.push_back(
                model.problem(e, "the loop of edge '" + model.name(e) + "' has no area", "remove it", model.end_point(2 * e)));
        if (a < 0) reverse(loop);
    }
}

void nest(const LoopModel& model, Boundary& result) {
    Part part;
    for (const BoundaryLoop& loop : result.loops) {
        part.loops.emplace_back();
        for (const Edge& edge : alone(model, loop).edges) {
            part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back(edge);
        }
    }
    const std::vector<int> holes = hole_of(part);
    for (std::size_t l = 0; l < result.loops.size(); ++l) {
        result.loops[l].hole_of = holes[l];
        if (holes[l] >= 0) reverse(result.loops[l]);
    }
}

/// The loops with all checks, once every edge is known to be sound in itself.
void trace(LoopModel& model, Boundary& result) {
    const std::vector<bool> is_tiny = drop_tiny_edges(model, result);
    check_vanished_loops(model, is_tiny, result.problems);
    check_names(model, result.problems);
    check_self_meetings(model, result.problems);
    join_close_ends(model, is_tiny);
    const std::vector<EdgeMeeting> meetings = edge_meetings(model, is_tiny);
    for (GeometryProblem& problem : meeting_problems(model, meetings)) result.problems.push_back(std::move(problem));
    const std::vector<bool> is_left_out = without_repeated(model, meetings, is_tiny);
    if (is_left_out != is_tiny) join_close_ends(model, is_left_out);
    chain(model, is_left_out, result);
    if (result.problems.empty()) turn_counter_clockwise(model, result);
    if (result.problems.empty()) nest(model, result);
}

}  // namespace

Boundary boundary_of(const Loops& loops, const std::string& where) {
    Boundary result;
    LoopModel model = loop_model(loops);
    if (model.edges.empty()) {
        result.problems.push_back({where, "there are no edges", "list at least one loop", {0, 0}});
        return result;
    }
    check_numbers(model, result.problems);
    if (!result.problems.empty()) return result;
    measure(model);
    trace(model, result);
    if (!result.problems.empty()) result.loops.clear();
    return result;
}

}  // namespace abut::geometry
