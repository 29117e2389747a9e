// SPDX-License-Identifier: GPL-3.0-or-later
// Points and weights along edges.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/quadrature/quadrature.hpp"
#include "tests/geometry/cells/random_parts.hpp"
#include "tests/geometry/cells/swept_parts.hpp"
#include "tests/geometry/quadrature/rule_errors.hpp"

namespace boundary_rule_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
constexpr double pi = std::numbers::pi;

TEST(BoundaryRule, DivergenceTheoremOnSweptGrids) {
    on_swept_grids(all_parts(), 100, [](const Part& part, const CutCells& cells, int) {
        EXPECT_LT(divergence_error(part, whole_boundary(part, cells, 3)), boundary_tolerance);
    });
}

TEST(BoundaryRule, PointsAreOnTheEdgeWithItsNormalAndCell) {
    on_swept_grids(all_parts(), 20, [](const Part& part, const CutCells& cells, int) {
        for (const BoundaryPoint& p : whole_boundary(part, cells, 2)) {
            const Curve& curve = part.edges[static_cast<std::size_t>(p.edge)].curve;
            EXPECT_EQ(p.x, point(curve, p.t));
            EXPECT_EQ(p.normal, outward_normal(curve, p.t));
            EXPECT_EQ(p.element, piece_at(cells, p.edge, p.t).cell);
            EXPECT_GT(p.weight, 0);
        }
    });
}

/// n points a cell integrate powers of t up to 2n - 1, also over a portion that ends within cells.
TEST(BoundaryRule, ExactOnPortionsOfStraightEdges) {
    const Part part = straight_parts()[2];
    const CutCells cells = cut_cells(part, {{0, 0.4, 0.9, 1.7, 2}, {0, 0.1, 0.3, 0.5}});
    const double t0 = 0.13, t1 = 0.81;
    for (int edge = 0; edge < 3; ++edge)
        for (int n = 1; n <= 4; ++n)
            for (int k = 0; k < 2 * n; ++k) {
                double sum = 0;
                for (const BoundaryPoint& p : boundary_rule(part, cells, edge, t0, t1, n)) {
                    EXPECT_TRUE(p.t > t0 && p.t < t1);
                    sum += p.weight * std::pow(p.t, k);
                }
                const double whole = length(part.edges[static_cast<std::size_t>(edge)].curve);
                EXPECT_NEAR(sum, whole * (std::pow(t1, k + 1) - std::pow(t0, k + 1)) / (k + 1), 1e-15 * 4);
            }
}

TEST(BoundaryRule, PortionsOfAnArcAddUp) {
    const Part part = curved_samples()[0];
    const CutCells cells = cut_cells(part, {{-0.5, 0, 0.3, 1}, {-1.25, -0.7, 0.25}});
    double sum = 0;
    for (const auto& [t0, t1] : {std::pair{0.0, 0.21}, {0.21, 0.5}, {0.5, 1.0}})
        for (const BoundaryPoint& p : boundary_rule(part, cells, 0, t0, t1, 2)) sum += p.weight;
    EXPECT_NEAR(sum, 1.5 * pi, 1e-14);
    EXPECT_TRUE(boundary_rule(part, cells, 0, 0.4, 0.4, 2).empty());
}

// ---- ellipses and splines ----

/// Largest error of the integrals of u^i v^j, i + j < 2n, along all arcs or all other edges, cell by cell in the cell's own
/// frame, in units of its diagonal.
double line_error(const Part& part, const CutCells& cells, int n, bool of_arcs) {
    const GaussRule fine = repeated(gauss_rule(64), 16);
    const int most = 2 * n - 1;
    double worst = 0;
    for (const BoundaryPiece& piece : cells.pieces) {
        const Curve& curve = part.edges[static_cast<std::size_t>(piece.edge)].curve;
        if (std::holds_alternative<Arc>(curve) != of_arcs) continue;
        const LocalFrame frame = unit_frame(cells.grid, piece.cell);
        Moments sum = Moments::Zero(most + 1, most + 1);
        const auto add = [&](double t, double weight) {
            const Vec2 p = frame(point(curve, t));
            sum += weight / frame.scale.norm() * powers(p.x(), most) * powers(p.y(), most).transpose();
        };
        for (const BoundaryPoint& p : boundary_rule(part, cells, piece.edge, piece.t0, piece.t1, n)) add(p.t, p.weight);
        for (std::size_t q = 0; q < fine.points.size(); ++q) {
            const double t = piece.t0 + fine.points[q] * (piece.t1 - piece.t0);
            add(t, -fine.weights[q] * (piece.t1 - piece.t0) * derivative(curve, t).norm());
        }
        for (int i = 0; i <= most; ++i)
            for (int j = 0; i + j <= most; ++j) worst = std::max(worst, std::abs(sum(i, j)));
    }
    return worst;
}

TEST(BoundaryRule, RightOnEllipsesAndSplines) {
    Random random(41);
    for (int k = 0; k < 32; ++k) {
        const Part part = random_part(3 + k % 4, random);
        const CutCells cells = cut_cells(part, random_grid(part, random, rule_grid_limits));
        const int n = 1 + k / 4 % 4;
        EXPECT_LT(line_error(part, cells, n, false), general_tolerance) << k;
        EXPECT_LT(line_error(part, cells, n, true), 10 * arc_tolerance) << k;
    }
}

/// Of the ellipse with semi-axes 1 and b, by the arithmetic-geometric mean (std::comp_ellint_2 is right to 1e-12 only).
double ellipse_perimeter(double b) {
    long double x = 1, y = b, sum = 0.5L * (1 - static_cast<long double>(b) * b), factor = 0.5L;
    for (int k = 0; k < 12; ++k) {
        const long double half_difference = 0.5L * (x - y), mean = 0.5L * (x + y);
        y = std::sqrt(x * y);
        x = mean;
        factor *= 2;
        sum += factor * half_difference * half_difference;
    }
    return static_cast<double>(2 * std::numbers::pi_v<long double> * (1 - sum) / x);
}

/// The speed along a flat ellipse has its singularities b/a from the real parameters.
TEST(BoundaryRule, LengthOfFlatEllipses) {
    for (int digits = 0; digits <= 6; ++digits) {
        const double b = std::pow(10.0, -digits);
        Part part;
        add_loop(part, {EllipticArc{{0, 0}, {1, 0}, {0, b}, 0.3, 2 * pi}});
        const CutCells cells = cut_cells(part, {{-1, -0.3, 1}, {-b, 0.1 * b, b}});
        double sum = 0;
        int n_points = 0;
        for (const BoundaryPoint& p : boundary_rule(part, cells, 0, 0, 1, 3)) {
            sum += p.weight;
            ++n_points;
        }
        EXPECT_NEAR(sum, ellipse_perimeter(b), 4e-14) << digits;
        EXPECT_LT(n_points, 200 + 600 * digits);
    }
}

/// Curves that stand still at an end, or nearly: halved towards it, but not for ever.
TEST(BoundaryRule, LengthOfCurvesThatStandStill) {
    for (double e : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3})
        for (const std::vector<double>& weights : {std::vector<double>{}, {1, 2, 1, 1, 3, 1}}) {
            Part part;
            add_loop(part, {bezier_curve({{0, 0}, {e, 0}, {2 * e, e}, {2 * e, 2 * e}, {1, 0.2}, {1, 1}}, weights),
                            Segment{{1, 1}, {0, 0}}});
            const CutCells cells = cut_cells(part, {{0, 0.5, 1}, {0, 0.3, 1}});
            double sum = 0;
            const std::vector<BoundaryPoint> points = boundary_rule(part, cells, 0, 0, 1, 3);
            for (const BoundaryPoint& p : points) sum += p.weight;
            EXPECT_NEAR(sum, length(part.edges[0].curve), 1e-14) << e;
            EXPECT_LT(points.size(), 3000u);
        }
}

TEST(BoundaryRule, RefusesEdgesAndCellsOfOtherParts) {
    const Part part = all_parts().front();
    const CutCells cells = cut_cells(part, {{-10, 10}, {-10, 10}});
    EXPECT_THROW(boundary_rule(part, cells, static_cast<int>(part.edges.size()), 0, 1, 3), std::logic_error);
    EXPECT_THROW(boundary_rule(part, cells, -1, 0, 1, 3), std::logic_error);
    Part other = part;
    other.edges.push_back(part.edges.front());
    EXPECT_THROW(boundary_rule(other, cells, 0, 0, 1, 3), std::logic_error);
}

}  // namespace

}  // namespace boundary_rule_test
