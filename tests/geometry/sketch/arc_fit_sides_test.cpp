// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs in place of facets never move a straight side: polygons with rounded corners, as exporters write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/brep/part.hpp"
#include "geometry/sketch/arc_fit.hpp"
#include "tests/geometry/sketch/drawings.hpp"

namespace abut::geometry::arc_fit_sides_test {
namespace {

using Points = std::vector<Vec2>;

/// A convex polygon whose corners are rounded by facets, and which of its sides were straight.
struct RoundedPolygon {
    Points points;
    std::vector<std::pair<int, int>> straight;  ///< begin and end by their places among the points
    double size = 0;
};

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

Vec2 rounded(const Vec2& p, int decimals) {
    const double unit = std::pow(10.0, -decimals);
    return {unit * std::round(p.x() / unit), unit * std::round(p.y() / unit)};
}

/// Sides from a hundredth of the size to all of it; radii that leave straight sides long and short.
RoundedPolygon rounded_polygon(std::mt19937& random) {
    const int n_corners = 3 + static_cast<int>(random() % 5), decimals = 2 + static_cast<int>(random() % 5);
    const int n_facets = 3 + static_cast<int>(std::pow(198.0, uniform(random, 0, 1))) - 1;
    const double size = std::pow(10.0, uniform(random, 1, 3)), share = uniform(random, 0.05, 0.98);
    std::vector<double> angles;
    for (int k = 0; k < n_corners; ++k) angles.push_back(2 * std::numbers::pi * (k + uniform(random, -0.35, 0.35)) / n_corners);
    const Vec2 stretch(1, std::pow(10.0, uniform(random, -1, 0)));
    Points corners;
    for (const double a : angles) corners.push_back(size * Vec2(std::cos(a), stretch.y() * std::sin(a)));
    RoundedPolygon polygon;
    polygon.size = size;
    std::vector<std::pair<int, int>> of_corner;
    for (int k = 0; k < n_corners; ++k) {
        const auto corner = [&](int i) { return corners[static_cast<std::size_t>((i + n_corners) % n_corners)]; };
        const Vec2 in = (corner(k) - corner(k - 1)).normalized(), out = (corner(k + 1) - corner(k)).normalized();
        const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        const double shorter = std::min((corner(k) - corner(k - 1)).norm(), (corner(k + 1) - corner(k)).norm());
        const double radius = share * shorter / 2 / std::tan(turn / 2);
        const Vec2 begin = corner(k) - radius * std::tan(turn / 2) * in, center = begin + radius * Vec2(-in.y(), in.x());
        const int first = static_cast<int>(polygon.points.size());
        for (int i = 0; i <= n_facets; ++i) {
            const double a = turn * i / n_facets;
            const Vec2 d = begin - center;
            polygon.points.push_back(rounded(
                center + Vec2(std::cos(a) * d.x() - std::sin(a) * d.y(), std::sin(a) * d.x() + std::cos(a) * d.y()), decimals));
        }
        of_corner.emplace_back(first, static_cast<int>(polygon.points.size()) - 1);
    }
    for (int k = 0; k < n_corners; ++k)
        polygon.straight.emplace_back(of_corner[static_cast<std::size_t>(k)].second,
                                      of_corner[static_cast<std::size_t>((k + 1) % n_corners)].first);
    return polygon;
}

double area_of(const Points& points) {
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec2 &p = points[k], &q = points[(k + 1) % points.size()];
        sum += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    return sum;
}

Part part_of(const std::vector<FittedPiece>& pieces) {
    Part part;
    for (const FittedPiece& piece : pieces) part.edges.push_back({piece.curve, {}, {}, true, 0.0});
    return part;
}

/// How far the middle and the quarters of a side are from the nearest piece.
double distance_of_side(const std::vector<FittedPiece>& pieces, const Vec2& from, const Vec2& to) {
    double worst = 0;
    for (const double t : {0.25, 0.5, 0.75}) {
        const Vec2 p = from + t * (to - from);
        double least = std::numeric_limits<double>::infinity();
        for (const FittedPiece& piece : pieces)
            least = std::min(least, (point(piece.curve, closest_parameter(piece.curve, p)) - p).norm());
        worst = std::max(worst, least);
    }
    return worst;
}

/// Rounding leaves facets of no length in one place, which drawings do not have.
void drop_repeated(RoundedPolygon& polygon) {
    Points kept;
    std::vector<int> place(polygon.points.size());
    for (std::size_t k = 0; k < polygon.points.size(); ++k) {
        if (kept.empty() || kept.back() != polygon.points[k]) kept.push_back(polygon.points[k]);
        place[k] = static_cast<int>(kept.size()) - 1;
    }
    if (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
    const int n = static_cast<int>(kept.size());
    for (auto& [begin, end] : polygon.straight) {
        begin = place[static_cast<std::size_t>(begin)] % n;
        end = place[static_cast<std::size_t>(end)] % n;
    }
    polygon.points = std::move(kept);
}

TEST(ArcFitSides, NoStraightSideMoves) {
    std::mt19937 random(20);
    int n_with_arcs = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        RoundedPolygon polygon = rounded_polygon(random);
        drop_repeated(polygon);
        const double tolerance = joining_fraction * 2 * polygon.size;
        const std::vector<FittedPiece> pieces = fit_lines_and_arcs(polygon.points, true, tolerance);
        bool has_arc = false;
        double bulges = 0;  // what arcs of alike facets add beyond the tolerance, at most
        for (const FittedPiece& piece : pieces)
            if (const auto* arc = std::get_if<Arc>(&piece.curve)) {
                has_arc = true;
                const int n = static_cast<int>(polygon.points.size());
                for (int k = piece.first; k != piece.last; k = (k + 1) % n) {
                    const double facet =
                        (polygon.points[static_cast<std::size_t>((k + 1) % n)] - polygon.points[static_cast<std::size_t>(k)])
                            .norm();
                    bulges += facet * facet * facet / (12 * arc->radius);
                }
            }
        n_with_arcs += has_arc ? 1 : 0;
        for (const auto& [begin, end] : polygon.straight) {
            const Vec2 &from = polygon.points[static_cast<std::size_t>(begin)],
                       &to = polygon.points[static_cast<std::size_t>(end)];
            if (from == to) continue;
            EXPECT_LE(distance_of_side(pieces, from, to), tolerance) << "trial " << trial;
        }
        const Part part = part_of(pieces);
        double length_of_facets = 0;
        for (std::size_t k = 0; k < polygon.points.size(); ++k)
            length_of_facets += (polygon.points[(k + 1) % polygon.points.size()] - polygon.points[k]).norm();
        EXPECT_LE(std::abs(area(part) - area_of(polygon.points)), tolerance * length_of_facets + bulges) << "trial " << trial;
        EXPECT_LE(std::abs(perimeter(part) - length_of_facets), 0.01 * length_of_facets) << "trial " << trial;
    }
    EXPECT_GE(n_with_arcs, 500);
}

TEST(ArcFitSides, LongSideAfterFineCornerStaysStraight) {
    const double tolerance = 2e-3;
    Points points;
    for (int k = 0; k <= 40; ++k) {
        const double a = 0.5 * std::numbers::pi * k / 40;
        points.push_back(rounded(Vec2(99 + std::sin(a), 1 - std::cos(a)), 3));
    }
    points.emplace_back(100, 50);
    points.emplace_back(0, 50);
    points.emplace_back(0, 0);
    for (const FittedPiece& piece : fit_lines_and_arcs(points, true, tolerance))
        if (std::holds_alternative<Arc>(piece.curve)) { EXPECT_LE(length(piece.curve), 0.5 * std::numbers::pi + tolerance); }
}

}  // namespace
}  // namespace abut::geometry::arc_fit_sides_test
