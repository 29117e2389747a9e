// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "geometry/proximity/facing.hpp"

namespace abut::geometry {

namespace {

/// From one edge to the next, positive to the left.
double turn_between(const Part& part, int before, int after) {
    return angle_between(unit_tangent(curve_of(part, before), 1), unit_tangent(curve_of(part, after), 0));
}

bool is_corner(const Part& part, int before, int after) {
    return std::abs(turn_between(part, before, after)) > chain_angle;
}

/// Positions in the loop of the edges that begin at a corner.
std::vector<std::size_t> corners_of(const Part& part, const Loop& loop) {
    std::vector<std::size_t> corners;
    const std::size_t n = loop.edges.size();
    for (std::size_t i = 0; i < n; ++i)
        if (is_corner(part, loop.edges[(i + n - 1) % n], loop.edges[i])) corners.push_back(i);
    return corners;
}

bool is_proportional(const Curve& curve) {
    return std::holds_alternative<Segment>(curve) || std::holds_alternative<Arc>(curve);
}

/// The n edges of the loop from position `first` on, as one chain.
Chain chain_from(const Part& part, const Loop& loop, std::size_t first, std::size_t n) {
    Chain chain;
    for (std::size_t i = 0; i < n; ++i) {
        const int edge = loop.edges[(first + i) % loop.edges.size()];
        chain.edges.push_back(edge);
        chain.begin.push_back(chain.length);
        chain.length += length(curve_of(part, edge));
        chain.lengths.push_back(is_proportional(curve_of(part, edge)) ? LengthTable{} : length_table(curve_of(part, edge)));
    }
    return chain;
}

/// Parameter at arc length s of a curve of the given length. That of segments and arcs is proportional to arc length.
double parameter_on(const Curve& curve, const LengthTable* table, double s, double length) {
    if (s >= length) return 1;
    if (is_proportional(curve)) return std::clamp(s / length, 0.0, 1.0);
    const double rounding = std::numeric_limits<double>::epsilon() * length;  // of a quadrature
    if (s <= rounding) return 0;
    return table ? parameter_at_length(curve, *table, s) : parameter_at_length(curve, s);
}

double wrapped(double s, double period) {
    const double r = s - period * std::floor(s / period);
    return r < period ? r : 0;  // rounding may return the period itself for s just below 0
}

}  // namespace

std::vector<Chain> smooth_chains(const Part& part) {
    std::vector<Chain> chains;
    for (const Loop& loop : part.loops) {
        if (loop.edges.empty()) continue;
        const std::vector<std::size_t> corners = corners_of(part, loop);
        if (corners.empty()) {
            chains.push_back(chain_from(part, loop, 0, loop.edges.size()));
            chains.back().closed = true;
        }
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t next = k + 1 < corners.size() ? corners[k + 1] : corners[0] + loop.edges.size();
            chains.push_back(chain_from(part, loop, corners[k], next - corners[k]));
        }
    }
    return chains;
}

ChainPoint chain_point(const Part& part, const Chain& chain, double s) {
    s = chain.closed ? wrapped(s, chain.length) : std::clamp(s, 0.0, chain.length);
    const auto next = std::upper_bound(chain.begin.begin(), chain.begin.end(), s);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - chain.begin.begin() - 1, 0));
    const double end = i + 1 < chain.begin.size() ? chain.begin[i + 1] : chain.length;

    ChainPoint p;
    p.edge = chain.edges[i];
    const Curve& curve = curve_of(part, p.edge);
    p.t = parameter_on(curve, i < chain.lengths.size() ? &chain.lengths[i] : nullptr, s - chain.begin[i], end - chain.begin[i]);
    p.x = point(curve, p.t);
    p.tangent = unit_tangent(curve, p.t);
    p.normal = right_of(p.tangent);
    p.curvature = curvature(curve, p.t);
    return p;
}

bool is_convex_corner(const Part& part, int edge, double t) {
    constexpr double at_the_end = 1e-9;
    if (t > at_the_end && t < 1 - at_the_end) return false;
    for (const Loop& loop : part.loops) {
        const auto found = std::find(loop.edges.begin(), loop.edges.end(), edge);
        if (found == loop.edges.end()) continue;
        const auto i = static_cast<std::size_t>(found - loop.edges.begin()), n = loop.edges.size();
        return t < 0.5 ? turn_between(part, loop.edges[(i + n - 1) % n], edge) > chain_angle
                       : turn_between(part, edge, loop.edges[(i + 1) % n]) > chain_angle;
    }
    return false;
}

}  // namespace abut::geometry
