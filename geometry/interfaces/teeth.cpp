// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/interfaces/teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Teeth lower than this fraction of the tip radius are surface texture, higher than the other a star.
constexpr double least_height = 0.01, most_height = 0.6;
/// A boundary is at a tip (root) in this upper (lower) part of the height.
constexpr double at_tip = 0.75, at_root = 0.25;
/// Pitches may differ from their mean by this part of it.
constexpr double uneven = 0.1;
constexpr double sampled_turning = 0.1;  // radians between sample points
constexpr int least_samples = 8;         // of an edge: flanks may be straight, and one edge each

std::vector<Vec2> sample(const Part& part, const Loop& loop) {
    std::vector<Vec2> points;
    for (int e : loop.edges) {
        const Curve& curve = part.edges[static_cast<std::size_t>(e)].curve;
        const int n = std::max(least_samples, static_cast<int>(std::ceil(turning(curve, 0, 1) / sampled_turning)));
        for (int k = 0; k < n; ++k) points.push_back(point(curve, static_cast<double>(k) / n));
    }
    return points;
}

double signed_area(const std::vector<Vec2>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
    return 0.5 * sum;
}

Vec2 centroid_of(const std::vector<Vec2>& p) {
    Vec2 sum(0, 0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 a = p[i] - p[0], b = p[(i + 1) % p.size()] - p[0];
        sum += cross(a, b) * (a + b);
    }
    return p[0] + sum / (6 * signed_area(p));
}

/// Turning against the loop's own sense: that of re-entrant corners and fillets.
double reentrant_turning(const std::vector<Vec2>& p, double sense) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 u = p[(i + 1) % p.size()] - p[i], v = p[(i + 2) % p.size()] - p[(i + 1) % p.size()];
        sum += std::max(0.0, -sense * angle_between(u, v));
    }
    return sum;
}

/// Angles about the centre, running on from turn to turn, where the boundary first comes to a tip after a root.
std::vector<double> tip_angles(const std::vector<Vec2>& p, const Vec2& center, double root, double tip) {
    std::vector<double> angles;
    const auto height = [&](std::size_t i) { return ((p[i % p.size()] - center).norm() - root) / (tip - root); };
    const auto lowest = static_cast<std::size_t>(
        std::min_element(p.begin(), p.end(),
                         [&](const Vec2& a, const Vec2& b) { return (a - center).norm() < (b - center).norm(); }) -
        p.begin());
    double angle = 0;
    bool up = false;
    for (std::size_t i = lowest; i < lowest + p.size(); ++i) {
        const Vec2 a = p[i % p.size()] - center, b = p[(i + 1) % p.size()] - center;
        angle += angle_between(a, b);
        if (!up && height(i + 1) >= at_tip) angles.push_back(angle);
        up = up ? height(i + 1) > at_root : height(i + 1) >= at_tip;
    }
    return angles;
}

bool are_even(const std::vector<double>& angles) {
    const double pitch = 2 * std::numbers::pi / static_cast<double>(angles.size());
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        if (std::abs(std::abs(angles[i + 1] - angles[i]) - pitch) > uneven * pitch) return false;
    return true;
}

}  // namespace

int count_teeth(const Part& part, int edge) {
    ENSURE(edge >= 0 && static_cast<std::size_t>(edge) < part.edges.size(), "the edge is one of the part's");
    const Loop* loop = loop_of(part, edge);
    if (!loop) return 0;
    const std::vector<Vec2> points = sample(part, *loop);
    const double area = signed_area(points);
    if (area == 0) return 0;
    const Vec2 center = centroid_of(points);
    double root = (points[0] - center).norm(), tip = root;
    for (const Vec2& p : points) {
        root = std::min(root, (p - center).norm());
        tip = std::max(tip, (p - center).norm());
    }
    if (tip - root < least_height * tip || tip - root > most_height * tip) return 0;
    const std::vector<double> angles = tip_angles(points, center, root, tip);
    const auto teeth = static_cast<int>(angles.size());
    if (teeth < least_teeth || !are_even(angles)) return 0;
    // an outer boundary turns inwards at every root, a hole's boundary (clockwise) outwards: by a quarter turn and more
    return reentrant_turning(points, area > 0 ? 1 : -1) > 0.25 * std::numbers::pi * teeth ? teeth : 0;
}

}  // namespace abut::geometry
