// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/run_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/brep/message_text.hpp"
#include "geometry/csg/junction.hpp"

namespace abut::geometry {

namespace {

/// Parameter of a run's end on its source, for lines and circles beyond their ends too.
double end_parameter(const RunEnd& end, const Curve& source) {
    if (const auto* line = std::get_if<Segment>(&source)) {
        const Vec2 d = line->to - line->from;
        return (end.at - line->from).dot(d) / d.squaredNorm();
    }
    const auto* arc = std::get_if<Arc>(&source);
    if (!arc) return end.t;
    const Vec2 d = end.at - arc->center;
    const double middle = arc->start + 0.5 * arc->sweep;
    return 0.5 + std::remainder(std::atan2(d.y(), d.x()) - middle, 2 * std::numbers::pi) / arc->sweep;
}

void put(RunEnd& end, double t, const Vec2& at) {
    end.t = t;
    end.at = at;
}

/// The parameter of the source's own end that the run ends at, if it does. Ends of loops may lie the merge length apart, those
/// of lines and circles are exact.
std::optional<double> own_end(const RunEnd& end, const Curve& source, const MergeLengths& lengths) {
    if (is_full(source)) return {};
    const double t = end_parameter(end, source) < 0.5 ? 0 : 1;
    const double near = is_general(source) ? lengths.merge : lengths.rounding;
    if ((point(source, t) - end.at).norm() <= near) return t;
    return {};
}

/// Puts the end on its source next to x, if the source is no farther than the merge length.
bool pulled_to(RunEnd& end, const Vec2& x, const Curve& source, const MergeLengths& lengths) {
    const double t = local_parameter(source, x, end_parameter(end, source), 0.5);
    if ((point(source, t) - x).norm() > lengths.merge) return false;
    put(end, t, x);
    return true;
}

bool at_own_ends(RunEnd& a, const Curve& curve_a, RunEnd& b, const Curve& curve_b, const MergeLengths& lengths) {
    const auto end_a = own_end(a, curve_a, lengths), end_b = own_end(b, curve_b, lengths);
    if (end_a) put(a, *end_a, point(curve_a, *end_a));
    if (end_b) put(b, *end_b, point(curve_b, *end_b));
    if (end_a && end_b) return true;
    if (end_a) return pulled_to(b, a.at, curve_b, lengths);
    if (end_b) return pulled_to(a, b.at, curve_a, lengths);
    return false;
}

/// Keeps to the source: beyond its ends by no more than the merge length counts as the end.
bool within(double& t, double guess, const Curve& source, const MergeLengths& lengths) {
    if (is_full(source)) {
        const double seam = std::nearbyint(t);
        if (std::abs(length(source, seam, t)) <= lengths.rounding) t = seam;
        return true;
    }
    const double end = std::clamp(t, 0.0, 1.0);
    if (t == end) return true;
    if (std::holds_alternative<Segment>(source) && (guess < 0 || guess > 1)) return true;  // the line of a half plane
    if ((point(source, t) - point(source, end)).norm() > lengths.merge) return false;
    if (is_general(source)) t = end;
    return true;
}

bool at_crossing(RunEnd& a, const Run& run_a, RunEnd& b, const Run& run_b, const RunContext& context) {
    const Curve &curve_a = context.curve(run_a), &curve_b = context.curve(run_b);
    const double ta = end_parameter(a, curve_a), tb = end_parameter(b, curve_b);
    const JunctionTolerance tolerance{context.tolerance(run_a) + context.tolerance(run_b), context.lengths.merge};
    auto found = find_junction(curve_a, ta, curve_b, tb, tolerance);
    if (!found || !within(found->ta, ta, curve_a, context.lengths) || !within(found->tb, tb, curve_b, context.lengths))
        return false;
    put(a, found->ta, point(curve_a, found->ta));
    put(b, found->tb, point(curve_b, found->tb));
    return true;
}

/// A line or circle that touches a circle crosses it, in exact numbers, up to the root of the rounding from there: put both at
/// the touching point.
void put_at_touching(RunEnd& a, const Curve& curve_a, RunEnd& b, const Curve& curve_b, const MergeLengths& lengths) {
    const double ta = end_parameter(a, curve_a), tb = end_parameter(b, curve_b);
    const double sine = cross(unit_tangent(curve_a, ta), unit_tangent(curve_b, tb));
    const double curving = std::abs(curvature(curve_a, ta)) + std::abs(curvature(curve_b, tb));
    if (sine * sine > 8 * curving * lengths.rounding || curving == 0) return;
    if (own_end(a, curve_a, lengths) || own_end(b, curve_b, lengths)) return;
    auto found = find_touching(curve_a, ta, curve_b, tb, {0, lengths.rounding});
    if (!found || !within(found->ta, ta, curve_a, lengths) || !within(found->tb, tb, curve_b, lengths)) return;
    put(a, found->ta, point(curve_a, found->ta));
    put(b, found->tb, point(curve_b, found->tb));
}

std::string quoted(const std::string& name) {
    return std::string("'").append(name).append("'");
}

GeometryProblem unsolved_junction(const Run& a, const Run& b, const RunContext& context) {
    const Vec2& p = a.to.vertex;
    const std::string pair = quoted(context.name(a.source)) + " and " + quoted(context.name(b.source));
    const std::string within = number_text(context.tolerance(a) + context.tolerance(b));
    return {pair, "edges " + pair + " touch within " + within + " at " + place_text(p), "move them apart or let them cross", p};
}

/// Moves the ends together where a run between them was left out.
void close_gap(Run& a, Run& b, const RunContext& context) {
    const Curve &curve_a = context.curve(a), &curve_b = context.curve(b);
    if (a.source == b.source && at_own_ends(a.to, curve_a, b.from, curve_b, context.lengths)) return;  // where it closes
    const double gap = (a.to.at - b.from.at).norm();
    const double ta = end_parameter(a.to, curve_a), tb = end_parameter(b.from, curve_b);
    auto found = find_junction(curve_a, ta, curve_b, tb, {gap, 0});
    if (found && within(found->ta, ta, curve_a, context.lengths) && within(found->tb, tb, curve_b, context.lengths)) {
        put(a.to, found->ta, point(curve_a, found->ta));
        put(b.from, found->tb, point(curve_b, found->tb));
    } else if (std::holds_alternative<Segment>(curve_a)) {
        a.to.at = b.from.at;
    } else if (std::holds_alternative<Segment>(curve_b)) {
        b.from.at = a.to.at;
    }
}

/// Does run k stand out from the source before and behind it by a rounding only, where that and its own touch?
bool is_rounding_between(const std::vector<Run>& loop, std::size_t k, const RunContext& context) {
    const std::size_t n = loop.size();
    const Run &run = loop[k], &before = loop[(k + n - 1) % n], &after = loop[(k + 1) % n];
    if (n < 2 || !goes_on(before, after, context.curve(before)) || before.source == run.source) return false;
    const Vec2 gap = after.from.at - before.to.at;
    const Curve& source = context.curve(before);
    const double size = bounding_box(source).diagonal();
    if (gap.norm() > 4 * std::sqrt(context.lengths.rounding * size)) return false;
    const Piece piece = restored(run, context.curve(run), context.lengths);
    if (length(piece.curve) > 2 * gap.norm()) return false;
    const double t = local_parameter(source, 0.5 * (before.to.at + after.from.at), end_parameter(before.to, source), 0.5);
    if ((before.along ? 1 : -1) * gap.dot(derivative(source, t)) <= 0) return false;
    return std::abs((point(source, t) - point(piece.curve, 0.5)).dot(outward_normal(source, t))) <= context.lengths.rounding;
}

/// Makes one run of two that go on over the same point of their source, which may be its seam.
void append(Run& a, const Run& b) {
    a.seams += b.seams + static_cast<int>(std::lround(a.to.t - b.from.t));
    a.to = b.to;
}

/// Takes run k out of the loop and joins its neighbours.
void leave_out(std::vector<Run>& loop, std::size_t k, const RunContext& context) {
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(k));
    if (loop.empty()) return;
    const std::size_t n = loop.size(), after = k % n, before = (k + n - 1) % n;
    if (n == 1) {
        loop.front().whole = is_full(context.curve(loop.front()));
    } else if (goes_on(loop[before], loop[after], context.curve(loop[before]))) {
        append(loop[before], loop[after]);
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(after));
        if (loop.size() == 1) loop.front().whole = is_full(context.curve(loop.front()));
    } else {
        close_gap(loop[before], loop[after], context);
    }
}

}  // namespace

std::string RunContext::name(int source) const {
    const PlacedSource& s = sources[static_cast<std::size_t>(source)];
    return s.prefix.empty() ? s.name : s.prefix + "/" + s.name;
}

void check_gaps(const std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Run &a = loop[i], &b = loop[(i + 1) % loop.size()];
        const Curve end = restored(a, context.curve(a), context.lengths).curve;
        const Curve begin = restored(b, context.curve(b), context.lengths).curve;
        if ((point(end, 1) - point(begin, 0)).norm() > 2 * context.lengths.joint_gap)
            unsolved.push_back(unsolved_junction(a, b, context));
    }
}

void check_directions(const std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (run_length(loop[i], context.curve(loop[i])) < -context.lengths.merge)
            unsolved.push_back(unsolved_junction(loop[i], loop[(i + 1) % loop.size()], context));
}

void solve_junctions(std::vector<Run>& loop, const RunContext& context, std::vector<GeometryProblem>& unsolved) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        Run &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if (a.whole) continue;
        if (!is_general(context.curve(a)) && !is_general(context.curve(b)))
            put_at_touching(a.to, context.curve(a), b.from, context.curve(b), context.lengths);
        else if (!at_own_ends(a.to, context.curve(a), b.from, context.curve(b), context.lengths) &&
                 !at_crossing(a.to, a, b.from, b, context))
            unsolved.push_back(unsolved_junction(a, b, context));
    }
    if (unsolved.empty()) check_directions(loop, context, unsolved);
}

void remove_tiny(std::vector<Run>& loop, const RunContext& context, std::vector<Repair>& repairs) {
    for (std::size_t k = 0; k < loop.size();) {
        const double l = run_length(loop[k], context.curve(loop[k]));
        const bool tiny = std::abs(l) <= context.lengths.merge;
        if (!tiny && !is_rounding_between(loop, k, context)) {
            ++k;
            continue;
        }
        if (tiny && l > context.lengths.rounding)
            repairs.push_back({"tiny edge of " + quoted(context.name(loop[k].source)) + " left out", loop[k].from.at, l});
        leave_out(loop, k, context);
        k = 0;  // what was joined may be long enough now, or gone
    }
}

}  // namespace abut::geometry
