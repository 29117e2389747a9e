// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::geometry {

// With n = right_of(t) and dt/ds = kappa left_of(t): dn/ds = kappa t. For d = x2 - x1 and F = d x N, N = 2 (w1 n1 - w2 n2):
//   dF/ds2 =  t2 x N - 2 w2 kappa2 (d x t2)      dF/ds1 = -t1 x N + 2 w1 kappa1 (d x t1)
// Where the normals oppose each other both are 2 plus gap times curvature, hence positive unless the gap reaches the radius of
// a concave side: F grows through its root, which decides on which side of a trial point the partner lies. Where the weights
// change along a curve there is a further term, dw (d x (n1 + n2)), of third order in the distance from the nearest points.

namespace {

struct Weights {
    double w1, w2;
};
/// The round side's own normal in a hollow of up to twice its radius, the hollow's where that is flat. ratio: of curvatures.
Weights conforming(double ratio) {
    const double w = std::min(1.0, 2 * ratio);
    return {w, 1 - w};
}

Weights weights(const FacingZone& zone, const ChainPoint& p1, const ChainPoint& p2) {
    if (!zone.is_acting) return {0.5, 0.5};
    if (zone.at_corner[0] != zone.at_corner[1]) return zone.at_corner[0] ? Weights{0, 1} : Weights{1, 0};
    if (zone.in_hollow[0] != zone.in_hollow[1]) return zone.in_hollow[0] ? Weights{1, 0} : Weights{0, 1};
    // a round part in a hollow
    if (p1.curvature > 0 && p2.curvature < 0) return conforming(-p2.curvature / p1.curvature);
    if (p2.curvature > 0 && p1.curvature < 0) {
        const Weights swapped = conforming(-p1.curvature / p2.curvature);
        return {swapped.w2, swapped.w1};
    }
    const double k1 = std::abs(p1.curvature) + zone.sharpness[0], k2 = std::abs(p2.curvature) + zone.sharpness[1];
    return k1 + k2 > 0 ? Weights{k2 / (k1 + k2), k1 / (k1 + k2)} : Weights{0.5, 0.5};
}

/// N.
Vec2 line(const Weights& w, const ChainPoint& p1, const ChainPoint& p2) {
    return 2 * (w.w1 * p1.normal - w.w2 * p2.normal);
}

/// F and its derivatives.
struct Condition {
    double value, by_s1, by_s2;
};
Condition condition(const FacingZone& zone, const ChainPoint& p1, const ChainPoint& p2) {
    const Weights w = weights(zone, p1, p2);
    const Vec2 N = line(w, p1, p2), d = p2.x - p1.x;
    return {cross(d, N), -cross(p1.tangent, N) + 2 * w.w1 * p1.curvature * cross(d, p1.tangent),
            cross(p2.tangent, N) - 2 * w.w2 * p2.curvature * cross(d, p2.tangent)};
}

FacingPair completed(const FacingZone& zone, double s1, double s2, const ChainPoint& p1, const ChainPoint& p2) {
    FacingPair pair;
    pair.s1 = s1;
    pair.s2 = s2;
    pair.on1 = p1;
    pair.on2 = p2;
    const Vec2 N = line(weights(zone, p1, p2), p1, p2);
    pair.normal = N.squaredNorm() > 0 ? N.normalized() : p1.normal;
    pair.gap = (p2.x - p1.x).dot(pair.normal);
    const Condition F = condition(zone, p1, p2);
    pair.slope = -F.by_s1 / F.by_s2;
    pair.length_rate = std::abs(cross(pair.normal, 0.5 * (p1.tangent + pair.slope * p2.tangent)));
    return pair;
}

/// A root of an increasing function inside [low, high], by Newton steps from `start`, halving the bracket where they leave it.
struct Root {
    double s = 0;
    bool found = false;
};

/// value_and_slope(s) -> {F, dF/ds}; |F| up to `noise` is rounding; a root outside the limits by less than `slack` counts as
/// lying on the limit.
template <class Function>
Root increasing_root(Function value_and_slope, double start, double low, double high, double slack, double noise) {
    constexpr int most_steps = 100;
    constexpr double flat = 0.05;  // of the usual slope 2: a Newton step from there may land anywhere
    const double longest_step = (high - low) / 8;
    const double resolution = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    bool below = false, above = false;  // has a point with F < 0 (F > 0) been seen at low (high)?
    double s = std::clamp(start, low, high), before = 0, longer = 1;
    const double lowest = low, highest = high;
    for (int k = 0; k < most_steps; ++k) {
        const auto [F, slope] = value_and_slope(s);
        if (std::abs(F) <= noise) return {s, true};
        (F < 0 ? low : high) = s;
        (F < 0 ? below : above) = true;
        // far from the centre of its circle a point stays as it is over many steps, and then jumps by more than the noise
        longer = F == before ? 2 * longer : 1;
        before = F;
        double step = slope > flat ? std::clamp(-longer * F / slope, -longest_step, longest_step)
                                   : (F < 0 ? longest_step : -longest_step);
        if ((F < 0 && s == highest) || (F > 0 && s == lowest)) return {s, slope > flat && std::abs(F / slope) <= slack};
        double next = s + step;
        if (below && above && (next <= low || next >= high)) next = 0.5 * (low + high);
        next = std::clamp(next, lowest, highest);
        if (std::abs(next - s) <= resolution || (below && above && high - low <= resolution)) return {next, true};
        s = next;
    }
    return {s, false};
}

/// Where on a chain to look for a partner: all of an open one, half a turn either way of a closed one.
struct Range {
    double low, high;
};
Range search_range(const Chain& chain, double guess) {
    if (!chain.closed) return {0, chain.length};
    return {guess - chain.length / 2, guess + chain.length / 2};
}

/// Rounding of the condition at a point: what is left when coordinates are subtracted.
double noise_at(const Vec2& x) {
    return 16 * std::numeric_limits<double>::epsilon() * x.lpNorm<Eigen::Infinity>();
}

bool opposed(const ChainPoint& p1, const ChainPoint& p2) {
    return p1.normal.dot(p2.normal) < 0;
}

}  // namespace

FacingPair pair_from_first(const Part& part1, const Part& part2, const FacingZone& zone, double s1, double guess2) {
    const ChainPoint p1 = chain_point(part1, zone.chain1, s1);
    const auto F = [&](double s2) {
        const ChainPoint p2 = chain_point(part2, zone.chain2, s2);
        const Condition c = condition(zone, p1, p2);
        return std::pair(c.value, c.by_s2);
    };
    const Range range = search_range(zone.chain2, guess2);
    const Root root = increasing_root(F, guess2, range.low, range.high, end_slack * zone.chain2.length, noise_at(p1.x));
    FacingPair pair = completed(zone, s1, root.s, p1, chain_point(part2, zone.chain2, root.s));
    pair.found = root.found && opposed(pair.on1, pair.on2);
    return pair;
}

FacingPair pair_from_second(const Part& part1, const Part& part2, const FacingZone& zone, double s2, double guess1) {
    const ChainPoint p2 = chain_point(part2, zone.chain2, s2);
    const auto F = [&](double s1) {
        const ChainPoint p1 = chain_point(part1, zone.chain1, s1);
        const Condition c = condition(zone, p1, p2);
        return std::pair(c.value, c.by_s1);
    };
    const Range range = search_range(zone.chain1, guess1);
    const Root root = increasing_root(F, guess1, range.low, range.high, end_slack * zone.chain1.length, noise_at(p2.x));
    FacingPair pair = completed(zone, root.s, s2, chain_point(part1, zone.chain1, root.s), p2);
    pair.found = root.found && opposed(pair.on1, pair.on2);
    return pair;
}

}  // namespace abut::geometry
