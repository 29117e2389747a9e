// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/length_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/curves/general_curve.hpp"
#include "geometry/curves/numbers.hpp"

namespace abut::geometry {

namespace {

constexpr double settled_fraction = 1.0 / 16;  // of a rounding: what is estimated to be left after the last step

/// The halves of [t0, t1] on which the rule agrees with that of their halves.
void append_pieces(const Curve& curve, double t0, double t1, double whole, double total, int halvings, LengthTable& table) {
    const double middle = 0.5 * (t0 + t1);
    const double a = length_by_gauss(curve, t0, middle), b = length_by_gauss(curve, middle, t1);
    if (halvings > 0 && !lengths_agree(a + b, whole, total)) {
        append_pieces(curve, t0, middle, a, total, halvings - 1, table);
        append_pieces(curve, middle, t1, b, total, halvings - 1, table);
        return;
    }
    table.t.insert(table.t.end(), {middle, t1});
    table.s.insert(table.s.end(), {table.s.back() + a, table.s.back() + a + b});
}

}  // namespace

LengthTable length_table(const Curve& curve) {
    const std::vector<double> cuts = smooth_cuts(curve);
    const double total = length(curve);
    LengthTable table{{0}, {0}};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        append_pieces(curve, cuts[i], cuts[i + 1], length_by_gauss(curve, cuts[i], cuts[i + 1]), total, most_length_halvings,
                      table);
    for (const double t : table.t) table.rate.push_back(1 / general_values(curve, t)[1].norm());
    return table;
}

namespace {

/// Cubic through two entries with their rates, inside of them; where rates have no limit (a cusp), the straight line.
double first_guess(const LengthTable& table, std::size_t k, double s) {
    const double ds = table.s[k + 1] - table.s[k], dt = table.t[k + 1] - table.t[k], u = (s - table.s[k]) / ds;
    const double a = table.rate[k] * ds - dt, b = dt - table.rate[k + 1] * ds;
    const double t = table.t[k] + u * dt + u * (1 - u) * ((1 - u) * a + u * b);
    return table.t[k] < t && t < table.t[k + 1] ? t : table.t[k] + u * dt;
}

/// A step of third order towards an arc length (Chebyshev's), and about what is left after it: the step's cube, in units of the
/// interval or of how fast the speed changes. Not numbers at a cusp.
struct LengthStep {
    double by, left;
};
LengthStep length_step(const Curve& curve, double t, double missing, double interval) {
    const std::array<Vec2, 3> at = general_values(curve, t);
    const Vec2 &first = at[1], &second = at[2];
    const double newton = missing / first.norm(), turn = 0.5 * newton * newton * first.dot(second) / first.squaredNorm();
    const double by_interval = newton / interval, by_speed = turn / newton;
    return {newton - turn, std::abs(newton) * (by_interval * by_interval + by_speed * by_speed)};
}

}  // namespace

double parameter_at_length(const Curve& curve, const LengthTable& table, double s) {
    if (!(s > 0)) return 0;
    if (s >= table.s.back()) return 1;
    const auto after = std::upper_bound(table.s.begin(), table.s.end(), s) - table.s.begin();
    const auto k = static_cast<std::size_t>(after) - 1;
    const double t0 = table.t[k], s0 = table.s[k], interval = table.t[k + 1] - t0;
    double lo = t0, hi = table.t[k + 1], t = first_guess(table, k, s);
    for (;;) {
        const double reached = s0 + length_by_gauss(curve, t0, t);
        if (reached == s) return t;
        (reached < s ? lo : hi) = t;
        const LengthStep step = length_step(curve, t, s - reached, interval);
        const bool inside = lo < t + step.by && t + step.by < hi;
        const double next = inside ? t + step.by : 0.5 * (lo + hi);
        if ((inside && step.left <= settled_fraction * epsilon) || std::abs(next - t) <= epsilon || !(lo < next && next < hi))
            return next;
        t = next;
    }
}

}  // namespace abut::geometry
