// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_pairing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut {

namespace {

using geometry::ChainPoint;
using geometry::FacingPair;
using geometry::Vec2;

constexpr int max_newton_steps = 30;
/// A partner this little beyond an open chain's end, as a fraction of the chain, is its end.
constexpr double end_slack = 1e-9;

/// What is zero at the partner, and its derivative by s2.
struct Condition {
    double value, slope;
};

Condition on_normal(const ChainPoint& p1, const ChainPoint& p2) {
    return {geometry::cross(p2.x - p1.x, p1.normal), geometry::cross(p2.tangent, p1.normal)};
}

/// Rounding of coordinates that are subtracted; those of a curve's points are rounded at the size of the curve.
double noise_of(const ChainPoint& p1, const geometry::Chain& chain2) {
    return 16 * std::numeric_limits<double>::epsilon() * std::max(p1.x.lpNorm<Eigen::Infinity>(), chain2.length);
}

/// Moves pair.s2 to the first body's normal by Newton steps; false where they leave the chain or do not end.
bool find_partner(const geometry::Part& part2, const geometry::Chain& chain2, FacingPair& pair) {
    const double slack = end_slack * chain2.length, noise = noise_of(pair.on1, chain2);
    for (int step = 0; step < max_newton_steps; ++step) {
        pair.on2 = chain_point(part2, chain2, pair.s2);
        const Condition c = on_normal(pair.on1, pair.on2);
        if (std::abs(c.value) <= noise) return true;
        if (c.slope == 0) return false;
        double next = pair.s2 - c.value / c.slope;
        if (!chain2.closed) {
            if (next < -slack || next > chain2.length + slack) return false;
            next = std::clamp(next, 0.0, chain2.length);
        }
        if (next == pair.s2) return true;
        pair.s2 = next;
    }
    return false;
}

}  // namespace

FacingPair paired(const geometry::Part& part1, const geometry::Part& part2, const geometry::FacingZone& zone, Pairing pairing,
                  double s1, double guess2) {
    FacingPair pair = pair_from_first(part1, part2, zone, s1, guess2);
    if (pairing == Pairing::middle || !pair.found) return pair;
    pair.found = find_partner(part2, zone.chain2, pair) && pair.on1.normal.dot(pair.on2.normal) < 0;
    pair.normal = pair.on1.normal;
    pair.gap = (pair.on2.x - pair.on1.x).dot(pair.normal);
    pair.length_rate = 1;
    return pair;
}

}  // namespace abut
