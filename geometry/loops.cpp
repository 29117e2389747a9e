// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "geometry/curve_meetings.hpp"

namespace abut::geometry {

namespace {

std::string text(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", value);
    return buffer;
}

std::string text(const Vec2& p) {
    return "(" + text(p.x()) + ", " + text(p.y()) + ")";
}

/// All edges in file order, and the findings.
struct Work {
    std::vector<const LoopEdge*> edges;
    std::vector<int> first_of_loop;  ///< and the number of edges at the end
    double tolerance = 0;
    Boundary result;

    const LoopEdge& edge(int e) const { return *edges[static_cast<std::size_t>(e)]; }
    const Curve& curve(int e) const { return edge(e).curve; }
    void report(int e, std::string what, std::string hint, const Vec2& at) {
        result.problems.push_back({edge(e).where, std::move(what), std::move(hint), at});
    }
    std::string pair(int a, int b) const { return "'" + edge(a).name + "' and '" + edge(b).name + "'"; }
    /// The edge's end: 0 where it begins, 1 where it ends.
    Vec2 end(int e, int which) const { return point(curve(e), which); }
};

Work collect(const Loops& loops) {
    Work work;
    for (const auto& loop : loops.loops) {
        work.first_of_loop.push_back(static_cast<int>(work.edges.size()));
        for (const LoopEdge& edge : loop) work.edges.push_back(&edge);
    }
    work.first_of_loop.push_back(static_cast<int>(work.edges.size()));
    return work;
}

int n_edges(const Work& work) {
    return static_cast<int>(work.edges.size());
}

bool finite(const Curve& curve) {
    if (const auto* s = std::get_if<Segment>(&curve)) return s->from.allFinite() && s->to.allFinite();
    const Arc& a = std::get<Arc>(curve);
    return a.center.allFinite() && std::isfinite(a.radius) && std::isfinite(a.start) && std::isfinite(a.sweep);
}

void check_edges(Work& work) {
    for (int e = 0; e < n_edges(work); ++e) {
        const std::string name = "edge '" + work.edge(e).name + "'";
        if (!finite(work.curve(e)))
            work.report(e, name + " is not finite", "check its numbers", {0, 0});
        else if (const auto* arc = std::get_if<Arc>(&work.curve(e)); arc && !(arc->radius > 0))
            work.report(e, name + " has no positive radius", "give a radius above 0", arc->center);
    }
    if (!work.result.problems.empty()) return;
    Box2 box;
    for (int e = 0; e < n_edges(work); ++e) box.extend(bounding_box(work.curve(e)));
    work.tolerance = merge_fraction * box.diagonal();
    for (int e = 0; e < n_edges(work); ++e)
        if (!(length(work.curve(e)) > work.tolerance))
            work.report(e, "edge '" + work.edge(e).name + "' has no length at " + text(work.end(e, 0)),
                        "remove it, or the point that is given twice", work.end(e, 0));
}

void check_names(Work& work) {
    std::map<std::string, int> seen;
    for (int e = 0; e < n_edges(work); ++e)
        if (const auto [it, is_new] = seen.emplace(work.edge(e).name, e); !is_new)
            work.report(e, "the edge name '" + it->first + "' is given twice", "give each edge a name of its own",
                        work.end(e, 0));
}

struct End {
    int edge = -1, which = 0;
    Vec2 at{0, 0};
};

/// For each end of the loop's edges the other ends that lie within the tolerance of it.
std::vector<std::vector<int>> partners(const std::vector<End>& ends, double tolerance) {
    std::vector<int> order(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    const auto x = [&](int i) { return ends[static_cast<std::size_t>(i)].at.x(); };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return x(a) < x(b); });
    std::vector<std::vector<int>> near(ends.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size() && x(order[j]) - x(order[i]) <= tolerance; ++j) {
            const auto a = static_cast<std::size_t>(order[i]), b = static_cast<std::size_t>(order[j]);
            if ((ends[a].at - ends[b].at).norm() > tolerance) continue;
            near[a].push_back(order[j]);
            near[b].push_back(order[i]);
        }
    return near;
}

/// Every loose end once, with the nearest other loose end.
void report_gaps(Work& work, const std::vector<End>& ends, std::vector<int> loose) {
    while (!loose.empty()) {
        const End& a = ends[static_cast<std::size_t>(loose.front())];
        const auto distance = [&](int i) { return (ends[static_cast<std::size_t>(i)].at - a.at).norm(); };
        loose.erase(loose.begin());
        const auto nearest =
            std::min_element(loose.begin(), loose.end(), [&](int i, int j) { return distance(i) < distance(j); });
        if (nearest == loose.end()) {
            work.report(a.edge,
                        "the loop is open: nothing joins the end of edge '" + work.edge(a.edge).name + "' at " + text(a.at),
                        "close the loop", a.at);
            return;
        }
        const End& b = ends[static_cast<std::size_t>(*nearest)];
        if (a.edge == b.edge)
            work.report(a.edge,
                        "the loop is open: the ends of edge '" + work.edge(a.edge).name + "' are " + text(distance(*nearest)) +
                            " apart at " + text(a.at),
                        "close the loop", a.at);
        else
            work.report(a.edge,
                        "the loop is open: edges " + work.pair(a.edge, b.edge) + " are " + text(distance(*nearest)) +
                            " apart at " + text(a.at),
                        "move the ends together (within " + text(work.tolerance) + ")", a.at);
        loose.erase(nearest);
    }
}

/// Follows the edges first..last-1 from end to end.
void chain(Work& work, int first, int last) {
    std::vector<End> ends;
    for (int e = first; e < last; ++e)
        for (int which : {0, 1}) ends.push_back({e, which, work.end(e, which)});
    const auto near = partners(ends, work.tolerance);

    std::vector<int> loose;
    bool branched = false;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (near[i].empty()) loose.push_back(static_cast<int>(i));
        if (near[i].size() <= 1) continue;
        branched = true;
        if (*std::min_element(near[i].begin(), near[i].end()) < static_cast<int>(i)) continue;  // said once per point
        std::string names = "'" + work.edge(ends[i].edge).name + "'";
        for (int other : near[i]) names += ", '" + work.edge(ends[static_cast<std::size_t>(other)].edge).name + "'";
        work.report(ends[i].edge, "the loop touches itself: edges " + names + " all end at " + text(ends[i].at),
                    "let two edges meet at each point, or split the loop", ends[i].at);
    }
    report_gaps(work, ends, loose);
    if (branched || !loose.empty()) return;

    std::vector<bool> used(static_cast<std::size_t>(last - first), false);
    for (int start = first; start < last; ++start) {
        BoundaryLoop loop;
        int e = start, from = 0;
        while (!used[static_cast<std::size_t>(e - first)]) {
            used[static_cast<std::size_t>(e - first)] = true;
            loop.edges.push_back({e, from == 0});
            const int next = near[static_cast<std::size_t>(2 * (e - first) + 1 - from)].front();
            e = ends[static_cast<std::size_t>(next)].edge;
            from = ends[static_cast<std::size_t>(next)].which;
        }
        if (!loop.edges.empty()) work.result.loops.push_back(std::move(loop));
    }
}

bool same_curve(const Work& work, int a, int b) {
    const auto close = [&](const Vec2& p, const Vec2& q) { return (p - q).norm() <= work.tolerance; };
    const Vec2 a0 = work.end(a, 0), a1 = work.end(a, 1), b0 = work.end(b, 0), b1 = work.end(b, 1);
    return ((close(a0, b0) && close(a1, b1)) || (close(a0, b1) && close(a1, b0))) &&
           close(point(work.curve(a), 0.5), point(work.curve(b), 0.5));
}

/// Do the curves go through each other at p, away from their ends?
bool cross_at(const Work& work, int a, int b, const Vec2& p) {
    for (int e : {a, b})
        for (int which : {0, 1})
            if ((work.end(e, which) - p).norm() <= 4 * work.tolerance) return false;
    const Vec2 ta = unit_tangent(work.curve(a), closest_parameter(work.curve(a), p));
    const Vec2 tb = unit_tangent(work.curve(b), closest_parameter(work.curve(b), p));
    return std::abs(cross(ta, tb)) > 1e-6;
}

/// Neighbours in a loop may meet at the corner that they share, nothing else may meet.
void check_pair(Work& work, int a, int b) {
    if (same_curve(work, a, b))
        return work.report(b, "edges " + work.pair(a, b) + " are the same", "remove one of them", work.end(b, 0));
    for (const Vec2& p : meeting_points(work.curve(a), work.curve(b), work.tolerance)) {
        // Within rounding of a shared corner: the two ends are a tolerance apart at most, and so are the points found.
        bool at_corner = false;
        for (int i : {0, 1})
            for (int j : {0, 1})
                at_corner |=
                    (work.end(a, i) - p).norm() <= 4 * work.tolerance && (work.end(b, j) - p).norm() <= 4 * work.tolerance;
        if (at_corner) continue;
        const char* verb = cross_at(work, a, b, p) ? " cross at " : " touch at ";
        return work.report(std::min(a, b), "edges " + work.pair(std::min(a, b), std::max(a, b)) + verb + text(p),
                           "boundaries must not cross or touch", p);
    }
}

/// All pairs of edges whose boxes overlap, by a sweep along x.
template <class Check>
void for_close_pairs(const Work& work, Check check) {
    struct Item {
        Box2 box;
        int edge;
    };
    std::vector<Item> items;
    for (int e = 0; e < n_edges(work); ++e) items.push_back({bounding_box(work.curve(e)), e});
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.box.min.x() < b.box.min.x(); });
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t j = i + 1; j < items.size() && items[j].box.min.x() <= items[i].box.max.x() + work.tolerance; ++j)
            if (items[i].box.overlaps(items[j].box, work.tolerance)) check(items[i].edge, items[j].edge);
}

void check_crossings(Work& work) {
    for_close_pairs(work, [&](int a, int b) { check_pair(work, std::min(a, b), std::max(a, b)); });
}

/// Corners that two different loops share pass the pairwise check (they look like neighbours): found here.
void check_shared_corners(Work& work) {
    std::vector<End> corners;
    for (std::size_t l = 0; l < work.result.loops.size(); ++l)
        for (const OrientedEdge& e : work.result.loops[l].edges)
            corners.push_back({e.edge, static_cast<int>(l), work.end(e.edge, e.along ? 0 : 1)});
    const auto near = partners(corners, 4 * work.tolerance);
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int other : near[i]) {
            const End& b = corners[static_cast<std::size_t>(other)];
            if (b.edge < corners[i].edge || b.which == corners[i].which) continue;
            work.report(
                corners[i].edge,
                "two loops touch: edges " + work.pair(corners[i].edge, b.edge) + " share the corner " + text(corners[i].at),
                "boundaries must not cross or touch", corners[i].at);
        }
}

Part alone(const Work& work, const BoundaryLoop& loop) {
    Part part;
    for (const OrientedEdge& e : loop.edges)
        part.edges.push_back({e.along ? work.curve(e.edge) : reversed(work.curve(e.edge)), "", ""});
    return part;
}

void reverse(BoundaryLoop& loop) {
    std::reverse(loop.edges.begin(), loop.edges.end());
    for (OrientedEdge& e : loop.edges) e.along = !e.along;
}

/// Turns all loops counter-clockwise; a loop whose area vanishes beside its length is a problem.
std::vector<Part> turn_counter_clockwise(Work& work) {
    std::vector<Part> parts;
    for (BoundaryLoop& loop : work.result.loops) {
        Part part = alone(work, loop);
        const double a = area(part);
        const int e = loop.edges.front().edge;
        if (std::abs(a) <= work.tolerance * perimeter(part))
            work.report(e, "the loop of edge '" + work.edge(e).name + "' has no area", "remove it", work.end(e, 0));
        if (a < 0) {
            reverse(loop);
            part = alone(work, loop);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Loops inside an odd number of others are holes of the innermost of these.
void nest(Work& work, const std::vector<Part>& parts) {
    const std::size_t n = parts.size();
    std::vector<Box2> boxes(n);
    for (std::size_t l = 0; l < n; ++l) boxes[l] = bounding_box(parts[l]);
    std::vector<std::vector<int>> around(n);
    for (std::size_t l = 0; l < n; ++l) {
        const Vec2 p = point(parts[l].edges.front().curve, 0.5);
        Box2 dot;
        dot.extend(p);
        for (std::size_t o = 0; o < n; ++o)
            if (o != l && boxes[o].overlaps(dot, 0) && contains(parts[o], p)) around[l].push_back(static_cast<int>(o));
    }
    for (std::size_t l = 0; l < n; ++l) {
        if (around[l].size() % 2 == 0) continue;
        for (int o : around[l])
            if (around[static_cast<std::size_t>(o)].size() + 1 == around[l].size()) work.result.loops[l].hole_of = o;
        reverse(work.result.loops[l]);
    }
}

}  // namespace

Boundary boundary_of(const Loops& loops, const std::string& where) {
    Work work = collect(loops);
    if (work.edges.empty()) {
        work.result.problems.push_back({where, "there are no edges", "list at least one loop", {0, 0}});
        return work.result;
    }
    check_edges(work);
    if (!work.result.problems.empty()) return work.result;
    check_names(work);
    for (std::size_t l = 0; l + 1 < work.first_of_loop.size(); ++l)
        chain(work, work.first_of_loop[l], work.first_of_loop[l + 1]);
    check_crossings(work);
    if (work.result.problems.empty()) check_shared_corners(work);
    if (work.result.problems.empty()) {
        const std::vector<Part> parts = turn_counter_clockwise(work);
        if (work.result.problems.empty()) nest(work, parts);
    }
    if (!work.result.problems.empty()) work.result.loops.clear();
    return work.result;
}

}  // namespace abut::geometry
