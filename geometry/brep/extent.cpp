// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/extent.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace abut::geometry {

namespace {

constexpr double sampled_turning = 0.2;  // radians between sample points: sagittas of 0.5 % of the radius

std::vector<Vec2> sample(const Part& part) {
    std::vector<Vec2> points;
    for (const Edge& edge : part.edges) {
        const int n = std::max(1, static_cast<int>(std::ceil(turning(edge.curve, 0, 1) / sampled_turning)));
        for (int k = 0; k < n; ++k) points.push_back(point(edge.curve, static_cast<double>(k) / n));
        points.push_back(point(edge.curve, 1));
    }
    return points;
}

/// Corners of the convex hull [Andrew 1979].
std::vector<Vec2> hull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    const auto turns_left = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0;
    };
    std::vector<Vec2> corners;
    const auto chain = [&](auto begin, auto end) {
        const std::size_t fixed = corners.size();
        for (auto p = begin; p != end; ++p) {
            while (corners.size() > fixed + 1 && !turns_left(corners[corners.size() - 2], corners.back(), *p))
                corners.pop_back();
            corners.push_back(*p);
        }
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return corners;
}

}  // namespace

double extent(const Part& part) {
    const std::vector<Vec2> corners = hull(sample(part));
    double squared = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = i + 1; k < corners.size(); ++k)
            squared = std::max(squared, (corners[i] - corners[k]).squaredNorm());
    return std::sqrt(squared);
}

}  // namespace abut::geometry
