// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/carriers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curves/arc_spline.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Points at which an edge is compared with a carrier. Two different rational curves of the highest degree can meet in 64
/// points: more than that many common points make them one curve.
constexpr int n_compared = max_spline_degree * max_spline_degree + 1;

/// The whole curve that the source is a portion of.
Curve whole(const Curve& curve) {
    if (const auto* e = std::get_if<EllipticArc>(&curve)) return EllipticArc{e->center, e->a, e->b, 0, 2 * std::numbers::pi};
    return Spline{std::get<Spline>(curve).shape, 0, 1};
}

/// A source that has no closed form, its whole curve, and which carrier it came to lie on.
struct Member {
    int source = -1;
    Curve whole;
    double size = 0;  ///< of the whole curve
    int carrier = -1;
    bool own = false;  ///< is the carrier its own whole curve?
    double t0 = 0,
           t1 = 0;  ///< the source's ends on the carrier, not reduced to [0, 1] on closed ones; t1 < t0: runs against it
};

std::vector<Member> members_of(const std::vector<PlacedSource>& sources) {
    std::vector<Member> members;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const Curve& curve = sources[s].curve;
        if (std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve)) continue;
        Member member;
        member.source = static_cast<int>(s);
        member.whole = whole(curve);
        member.size = bounding_box(member.whole).diagonal();
        members.push_back(std::move(member));
    }
    return members;
}

bool lies_on(const Curve& curve, const Box2& box, const Curve& carrier, const Box2& carrier_box, double same) {
    if (!carrier_box.overlaps(box, same) || (box.min - carrier_box.min).minCoeff() < -same ||
        (carrier_box.max - box.max).minCoeff() < -same)
        return false;
    for (int i = 0; i < n_compared; ++i) {
        const Vec2 p = point(curve, static_cast<double>(i) / (n_compared - 1));
        if ((point(carrier, closest_parameter(carrier, p)) - p).norm() > same) return false;
    }
    return true;
}

bool is_closed(const Curve& curve, double same) {
    return (point(curve, 0) - point(curve, 1)).norm() <= same;
}

/// Parameters of the source's ends on its own whole curve.
void place_on_own(Member& member, const Curve& curve) {
    member.own = true;
    if (const auto* e = std::get_if<EllipticArc>(&curve)) {
        member.t0 = e->start / (2 * std::numbers::pi);
        member.t1 = (e->start + e->sweep) / (2 * std::numbers::pi);
    } else {
        member.t0 = std::get<Spline>(curve).begin;
        member.t1 = std::get<Spline>(curve).end;
    }
}

/// Parameters of the source's ends on another's curve, by projection. On a closed one the ends lie up to a turn from the
/// middle: they are found from there on, in the direction that the tangents show.
void place_by_projection(Member& member, const Curve& curve, const Carrier& carrier) {
    const auto project = [&](double t) { return closest_parameter(carrier.curve, point(curve, t)); };
    const double middle = project(0.5);
    const bool along = derivative(curve, 0.5).dot(derivative(carrier.curve, middle)) > 0;
    member.t0 = project(0);
    member.t1 = project(1);
    if (!carrier.closed) return;
    const auto beyond = [&](double t, bool above) {
        while (above ? t <= middle : t >= middle) t += above ? 1 : -1;
        return t;
    };
    member.t0 = beyond(member.t0, !along);
    member.t1 = beyond(member.t1, along);
}

/// Puts every member on a carrier: on the longest that holds it.
std::vector<Carrier> group(std::vector<Member>& members, const std::vector<PlacedSource>& sources, double same,
                           double fraction) {
    std::vector<Member*> by_size;
    for (Member& member : members) by_size.push_back(&member);
    std::stable_sort(by_size.begin(), by_size.end(), [](const Member* a, const Member* b) { return a->size > b->size; });
    std::vector<Carrier> carriers;
    std::vector<Box2> boxes;
    for (Member* member : by_size) {
        const Curve& curve = sources[static_cast<std::size_t>(member->source)].curve;
        const Box2 box = bounding_box(curve);
        std::size_t c = 0;
        while (c < carriers.size() && !lies_on(curve, box, carriers[c].curve, boxes[c], same)) ++c;
        member->carrier = static_cast<int>(c);
        if (c < carriers.size()) {
            place_by_projection(*member, curve, carriers[c]);
            continue;
        }
        place_on_own(*member, curve);
        Carrier carrier;
        carrier.curve = member->whole;
        carrier.closed = is_closed(member->whole, same);
        carrier.tolerance = fraction * member->size;
        carriers.push_back(std::move(carrier));
        boxes.push_back(bounding_box(member->whole));
    }
    return carriers;
}

double reduced(double t, bool closed) {
    return closed ? t - std::floor(t) : t;
}

/// Ends of members along the carrier, ascending from 0 to 1; ends nearer than `same` are one.
std::vector<double> breaks_of(const Carrier& carrier, int index, const std::vector<Member>& members, double same) {
    std::vector<double> ends{0.0, 1.0}, breaks;
    for (const Member& member : members)
        if (member.carrier == index)
            for (const double t : {member.t0, member.t1}) ends.push_back(std::clamp(reduced(t, carrier.closed), 0.0, 1.0));
    std::sort(ends.begin(), ends.end());
    for (const double t : ends)
        if (breaks.empty() || length(carrier.curve, breaks.back(), t) > same) breaks.push_back(t);
    if (breaks.size() == 1) breaks.push_back(1.0);  // shorter than `same` next to something huge: followed all the same
    breaks.back() = 1.0;
    return breaks;
}

void add_arcs(Carrier& carrier, double t0, double t1) {
    const Curve portion = trimmed(carrier.curve, t0, t1);
    for (const ArcPiece& piece : arc_spline(portion, carrier.tolerance)) {
        const double end = piece.t1 == 1 ? t1 : t0 + piece.t1 * (t1 - t0);
        carrier.arcs.push_back({point(portion, 0.5 * (piece.t0 + piece.t1)), std::holds_alternative<Segment>(piece.curve)});
        carrier.t.push_back(end);
        carrier.points.push_back(point(carrier.curve, end));
    }
}

void fill_arcs(Carrier& carrier, const std::vector<double>& breaks) {
    carrier.t = {0.0};
    carrier.points = {point(carrier.curve, 0)};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) add_arcs(carrier, breaks[i], breaks[i + 1]);
    if (carrier.closed) carrier.points.back() = carrier.points.front();
}

/// The end of an arc nearest to t.
int nearest_end(const Carrier& carrier, double t) {
    const auto after = std::lower_bound(carrier.t.begin(), carrier.t.end(), t);
    if (after == carrier.t.begin()) return 0;
    if (after == carrier.t.end()) return static_cast<int>(carrier.t.size()) - 1;
    const auto i = static_cast<int>(after - carrier.t.begin());
    return *after - t < t - *(after - 1) ? i : i - 1;
}

/// Source parameters at the ends of the run's arcs.
std::vector<double> source_parameters(const Member& member, const Curve& curve, const Carrier& carrier, const CarrierRun& run) {
    const int n = static_cast<int>(carrier.arcs.size());
    std::vector<double> t{0.0};
    for (int i = 1; i < run.n_arcs; ++i) {
        const int end = run.first + (run.along ? i : run.n_arcs - i);
        const auto k = static_cast<std::size_t>(end % n);
        double here = 0;
        if (member.own) {
            here = (carrier.t[k] - member.t0) / (member.t1 - member.t0);
            if (carrier.closed) here -= std::floor(here * std::abs(member.t1 - member.t0)) / std::abs(member.t1 - member.t0);
        } else {
            here = closest_parameter(curve, carrier.points[k]);
        }
        t.push_back(std::clamp(here, t.back(), 1.0));
    }
    t.push_back(1.0);
    return t;
}

CarrierRun run_of(const Member& member, const Curve& curve, const Carrier& carrier) {
    CarrierRun run;
    run.carrier = member.carrier;
    run.along = member.t1 > member.t0;
    const int n = static_cast<int>(carrier.arcs.size());
    const auto end = [&](double t) { return nearest_end(carrier, std::clamp(reduced(t, carrier.closed), 0.0, 1.0)); };
    int from = end(std::min(member.t0, member.t1)), to = end(std::max(member.t0, member.t1));
    if (carrier.closed) {
        from %= n;
        to %= n;
        if (to <= from) to += n;
    }
    run.first = from;
    run.n_arcs = to - from;
    run.t = source_parameters(member, curve, carrier, run);
    return run;
}

}  // namespace

Carriers carriers_of(const std::vector<PlacedSource>& sources, double same, double fraction) {
    ENSURE(same >= 0 && fraction > 0, "curves are followed by arcs within a part of their size");
    Carriers result;
    result.of_source.resize(sources.size());
    std::vector<Member> members = members_of(sources);
    result.carriers = group(members, sources, same, fraction);
    for (std::size_t c = 0; c < result.carriers.size(); ++c)
        fill_arcs(result.carriers[c], breaks_of(result.carriers[c], static_cast<int>(c), members, same));
    for (const Member& member : members) {
        const auto s = static_cast<std::size_t>(member.source);
        result.of_source[s] = run_of(member, sources[s].curve, result.carriers[static_cast<std::size_t>(member.carrier)]);
    }
    return result;
}

}  // namespace abut::geometry
