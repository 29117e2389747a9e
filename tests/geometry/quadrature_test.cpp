// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quadrature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "geometry/gauss.hpp"
#include "geometry/gauss_portions.hpp"
#include "tests/geometry/random_parts.hpp"

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
constexpr double pi = std::numbers::pi;
using Moments = Eigen::MatrixXd;  // (i, j): the integral of u^i v^j

// ---- moments about an origin, in units of a scale, in closed form by Green's theorem: of u^(i+1) / (i+1) v^j dv ----

struct LocalFrame {
    Vec2 origin, scale;
    Vec2 operator()(const Vec2& p) const { return (p - origin).cwiseQuotient(scale); }
};

/// Coefficients of t^k; about the segment's middle, where nothing cancels.
using Polynomial = std::vector<double>;

Polynomial times(const Polynomial& p, double constant, double slope) {
    Polynomial product(p.size() + 1, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        product[k] += constant * p[k];
        product[k + 1] += slope * p[k];
    }
    return product;
}

/// Over t from -1/2 to 1/2.
double integral(const Polynomial& p) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); k += 2)
        sum += p[k] * std::pow(0.5, static_cast<double>(k)) / static_cast<double>(k + 1);
    return sum;
}

Moments segment_moments(const Vec2& a, const Vec2& b, int degree) {
    Moments m(degree + 1, degree + 1);
    const Vec2 middle = 0.5 * (a + b), d = b - a;
    Polynomial power_u{1};
    for (int i = 0; i <= degree; ++i) {
        power_u = times(power_u, middle.x(), d.x());
        Polynomial product = power_u;
        for (int j = 0; j <= degree; ++j) {
            m(i, j) = integral(product) * d.y() / (i + 1);
            product = times(product, middle.y(), d.y());
        }
    }
    return m;
}

/// Coefficients of z^-n ... z^n with z = exp(i angle).
using Laurent = std::vector<std::complex<double>>;

/// Times (below / z + constant + above z).
Laurent times(const Laurent& p, std::complex<double> below, double constant, std::complex<double> above) {
    Laurent product(p.size() + 2, 0.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        product[k] += below * p[k];
        product[k + 1] += constant * p[k];
        product[k + 2] += above * p[k];
    }
    return product;
}

double integral(const Laurent& p, double from, double to) {
    const int n = static_cast<int>(p.size()) / 2;
    double sum = 0;
    for (int k = -n; k <= n; ++k) {
        const std::complex<double> ik(0, k);
        const std::complex<double> wave = k == 0 ? to - from : (std::exp(ik * to) - std::exp(ik * from)) / ik;
        sum += (p[static_cast<std::size_t>(k + n)] * wave).real();
    }
    return sum;
}

/// Of an arc in the frame, whose scale is the same both ways and not much below the radius: the coefficients grow as their
/// ratio.
Moments arc_moments(const Arc& arc, const LocalFrame& frame, int degree) {
    Moments m(degree + 1, degree + 1);
    const Vec2 center = frame(arc.center);
    const double half = 0.5 * arc.radius / frame.scale.x();
    const std::complex<double> i_half(0, half);
    Laurent power_u{1};
    for (int i = 0; i <= degree; ++i) {
        power_u = times(power_u, half, center.x(), half);
        Laurent product = times(power_u, half, 0, half);  // dv = r cos(angle) d(angle)
        for (int j = 0; j <= degree; ++j) {
            m(i, j) = integral(product, arc.start, arc.start + arc.sweep) / (i + 1);
            product = times(product, i_half, center.y(), -i_half);
        }
    }
    return m;
}

Moments part_moments(const Part& part, const LocalFrame& frame, int degree) {
    Moments sum = Moments::Zero(degree + 1, degree + 1);
    for (const Edge& e : part.edges) {
        const auto* arc = std::get_if<Arc>(&e.curve);
        sum += arc ? arc_moments(*arc, frame, degree)
                   : segment_moments(frame(point(e.curve, 0)), frame(point(e.curve, 1)), degree);
    }
    return sum;
}

/// What of `polygon` lies in the convex one [Sutherland, Hodgman 1974], with bridges of no area.
Polygon common(Polygon polygon, const Polygon& convex) {
    for (std::size_t s = 0; s < convex.size(); ++s) {
        const Vec2 &a = convex[s], &b = convex[(s + 1) % convex.size()];
        Polygon kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
            if (at_p >= 0) kept.push_back(p);
            if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
        }
        polygon = kept;
    }
    return polygon;
}

// ---- moments by the rules ----

Eigen::VectorXd powers(double x, int degree) {
    Eigen::VectorXd p(degree + 1);
    p[0] = 1;
    for (int k = 1; k <= degree; ++k) p[k] = x * p[k - 1];
    return p;
}

Moments rule_moments(const CellRule& rule, const LocalFrame& frame, int degree) {
    Moments sum = Moments::Zero(degree + 1, degree + 1);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const Vec2 p = frame(rule.points[q]);
        sum += rule.weights[q] / frame.scale.prod() * powers(p.x(), degree) * powers(p.y(), degree).transpose();
    }
    return sum;
}

/// The cell as the unit square: moments are then fractions of the cell.
LocalFrame unit_frame(const Grid& grid, int cell) {
    const Box2 b = box_of(grid, cell);
    return {b.min, b.size()};
}

double worst_of(const Moments& difference) {
    return difference.cwiseAbs().maxCoeff();
}

// ---- parts and grids ----

/// An outline counter-clockwise, holes clockwise.
Part of_polygons(const std::vector<Polygon>& polygons) {
    Part part;
    for (const Polygon& polygon : polygons) {
        std::vector<Curve> sides;
        for (std::size_t i = 0; i < polygon.size(); ++i)
            sides.push_back(Segment{polygon[i], polygon[(i + 1) % polygon.size()]});
        add_loop(part, sides);
    }
    return part;
}

std::vector<std::vector<Polygon>> straight_samples() {
    return {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
            {{{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}}},
            {{{0, 0}, {2, 0.125}, {0.25, 0.5}}},
            {{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}, {{0.75, 0}, {0.5, -0.25}, {0.25, 0}, {0.5, 0.25}}}};
}

std::vector<Part> curved_samples() {
    Part disc, ring, slot, plate;
    add_loop(disc, {Arc{{0.25, -0.5}, 0.75, 0.3, 2 * pi}});
    add_loop(ring, {Arc{{0, 0}, 1, 0.7, pi}, Arc{{0, 0}, 1, 0.7 + pi, pi}});
    add_loop(ring, {Arc{{0.125, 0}, 0.5, 0, -2 * pi}});
    add_loop(slot, {Segment{{-1, -0.5}, {1, -0.5}}, Arc{{1, 0}, 0.5, -pi / 2, pi}, Segment{{1, 0.5}, {-1, 0.5}},
                    Arc{{-1, 0}, 0.5, pi / 2, pi}});
    plate = of_polygons({{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}});
    add_loop(plate, {Arc{{-0.5, 0}, 0.25, pi, -pi}, Arc{{-0.5, 0}, 0.25, 0, -pi}});
    return {disc, ring, slot, plate};
}

struct Turn {
    double c, s;
    Vec2 operator()(const Vec2& p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
};

/// Not at all, by a quarter, and by any angle, in turn.
Turn random_turn(int k, Random& random) {
    if (k % 3 == 0) return {1, 0};
    if (k % 3 == 1) return {0, 1};
    const double angle = std::uniform_real_distribution<double>(-pi, pi)(random);
    return {std::cos(angle), std::sin(angle)};
}

/// Wider cells, and less far beyond the part, than in tests of areas: monomials to the power of 8 magnify roundings.
constexpr GridLimits limits{0.05, 0.3};

/// Calls check(part, cells, degree) for turned parts on random grids, degrees 1 to 4 in turn, until a check fails.
template <class Check>
void on_swept_grids(const std::vector<Part>& parts, int n_placements, Check check) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
        Random random(23);
        for (int k = 0; k < n_placements; ++k) {
            const Turn turn = random_turn(k, random);
            const Part part = transformed(parts[which], turn.c, turn.s, {0.125, -0.25});
            SCOPED_TRACE("part " + std::to_string(which) + ", placement " + std::to_string(k));
            check(part, cut_cells(part, random_grid(part, random, limits)), 1 + k % 4);
            if (testing::Test::HasFailure()) return;
        }
    }
}

std::vector<Part> straight_parts() {
    std::vector<Part> parts;
    for (const auto& polygons : straight_samples()) parts.push_back(of_polygons(polygons));
    return parts;
}

std::vector<Part> all_parts() {
    std::vector<Part> parts = straight_parts();
    for (const Part& part : curved_samples()) parts.push_back(part);
    return parts;
}

// ---- cut cells ----

/// Coordinates of 1 over cells of 0.05: roundings of 2e-15 to the power of 2 x degree <= 8 in each direction.
constexpr double straight_tolerance = 1e-12;
/// The header promises exactness on straight edges only; along arcs the Gauss points are chosen for less than this.
constexpr double arc_tolerance = 1e-10;

/// Largest error of the moments of a straight part's boundary cells, against each cell cut out of the polygons.
double straight_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree) {
    double worst = 0;
    for (const CellRule& rule : rules) {
        const LocalFrame frame = unit_frame(cells.grid, rule.element);
        Moments expected = Moments::Zero(2 * degree + 1, 2 * degree + 1);
        for (const Loop& loop : part.loops) {
            Polygon polygon;
            for (int e : loop.edges) polygon.push_back(frame(point(part.edges[static_cast<std::size_t>(e)].curve, 0)));
            const Polygon inside = common(polygon, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
            for (std::size_t i = 0; i < inside.size(); ++i)
                expected += segment_moments(inside[i], inside[(i + 1) % inside.size()], 2 * degree);
        }
        worst = std::max(worst, worst_of(rule_moments(rule, frame, 2 * degree) - expected));
    }
    return worst;
}

/// Of any part, about its centre and in units of half its size: the boundary cells' rules, with full products of inner cells,
/// against the part's own edges.
double whole_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree) {
    const Box2 extent = bounding_box(part);
    const LocalFrame frame{extent.center(), Vec2::Constant(0.5 * extent.size().maxCoeff())};
    Moments sum = -part_moments(part, frame, 2 * degree);
    for (const CellRule& rule : rules) sum += rule_moments(rule, frame, 2 * degree);
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c) {
        if (cells.cell_class[c] != CellClass::inner) continue;
        const Box2 b = box_of(cells.grid, static_cast<int>(c));
        const Vec2 low = frame(b.min), high = frame(b.max);
        sum += segment_moments({high.x(), low.y()}, high, 2 * degree) + segment_moments({low.x(), high.y()}, low, 2 * degree);
    }
    return worst_of(sum);
}

GaussRule repeated(const GaussRule& rule, int n_parts) {
    GaussRule whole;
    for (int k = 0; k < n_parts; ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            whole.points.push_back((k + rule.points[i]) / n_parts);
            whole.weights.push_back(rule.weights[i] / n_parts);
        }
    return whole;
}

/// Of each cell by its contours, with so many Gauss points that nothing is missing: 64 on each of `n_parts` parts.
double contour_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree, int n_parts = 1) {
    const GaussRule gauss = repeated(gauss_rule(64), n_parts);
    double worst = 0;
    for (const CellRule& rule : rules) {
        const LocalFrame frame = unit_frame(cells.grid, rule.element);
        Moments sum = -rule_moments(rule, frame, 2 * degree);
        const auto c = static_cast<std::size_t>(rule.element);
        for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k) {
            const ContourPiece& piece = cells.contours[static_cast<std::size_t>(k)];
            for (std::size_t q = 0; q < gauss.points.size(); ++q) {
                const double t = piece.t0 + gauss.points[q] * (piece.t1 - piece.t0);
                const Box2 b = box_of(cells.grid, rule.element);
                const Curve curve = piece.edge < 0 ? Segment{{b.max.x(), 0}, {b.max.x(), 1}}
                                                   : part.edges[static_cast<std::size_t>(piece.edge)].curve;
                const Vec2 p = frame(point(curve, t));
                const double dv = gauss.weights[q] * (piece.t1 - piece.t0) * derivative(curve, t).y() / frame.scale.y();
                Eigen::VectorXd u = p.x() * powers(p.x(), 2 * degree);
                for (int i = 0; i <= 2 * degree; ++i) u[i] /= i + 1;
                sum += dv * u * powers(p.y(), 2 * degree).transpose();
            }
        }
        worst = std::max(worst, worst_of(sum));
    }
    return worst;
}

TEST(CellRules, ExactInEveryCellOfStraightParts) {
    on_swept_grids(straight_parts(), 120, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(straight_error(part, cells, cell_rules(part, cells, degree), degree), straight_tolerance);
    });
}

TEST(CellRules, ExactOverTheWholePart) {
    on_swept_grids(straight_parts(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(whole_error(part, cells, cell_rules(part, cells, degree), degree), straight_tolerance);
    });
    on_swept_grids(curved_samples(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(whole_error(part, cells, cell_rules(part, cells, degree), degree), arc_tolerance);
    });
}

TEST(CellRules, NearlyExactInEveryCellWithArcs) {
    on_swept_grids(curved_samples(), 60, [](const Part& part, const CutCells& cells, int degree) {
        EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree), arc_tolerance);
    });
}

/// The longest arcs that a piece can have: quarters of circles as large as their only cell.
TEST(CellRules, OneCellAroundTheWholePart) {
    for (const Part& part : curved_samples()) {
        const Box2 b = bounding_box(part);
        const CutCells cells = cut_cells(part, {{b.min.x(), b.max.x()}, {b.min.y(), b.max.y()}});
        for (int degree = 1; degree <= 4; ++degree) {
            const std::vector<CellRule> rules = cell_rules(part, cells, degree);
            EXPECT_LT(whole_error(part, cells, rules, degree), arc_tolerance) << degree;
            EXPECT_LT(contour_error(part, cells, rules, degree), arc_tolerance) << degree;
        }
    }
}

TEST(CellRules, OneForEachBoundaryCellInOrder) {
    const Part part = curved_samples()[1];
    const CutCells cells = cut_cells(part, {{-1, -0.5, 0, 0.5, 1}, {-1, -0.5, 0, 0.5, 1}});
    std::vector<int> expected, found;
    for (std::size_t c = 0; c < cells.cell_class.size(); ++c)
        if (cells.cell_class[c] == CellClass::boundary) expected.push_back(static_cast<int>(c));
    for (const CellRule& rule : cell_rules(part, cells, 2)) {
        found.push_back(rule.element);
        EXPECT_EQ(rule.points.size(), rule.weights.size());
    }
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
}

TEST(CellRules, NoneWhereTheGridIsTheBoundary) {
    const Part square = straight_parts()[0];
    EXPECT_TRUE(cell_rules(square, cut_cells(square, {{0, 0.5, 1}, {0, 1}}), 2).empty());
}

// ---- the boundary ----

std::vector<BoundaryPoint> whole_boundary(const Part& part, const CutCells& cells, int n) {
    std::vector<BoundaryPoint> points;
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        const std::vector<BoundaryPoint> more = boundary_rule(part, cells, static_cast<int>(e), 0, 1, n);
        points.insert(points.end(), more.begin(), more.end());
    }
    return points;
}

/// The integral of n is zero, that of x.n twice the area, that of 1 the perimeter; the largest difference.
double divergence_error(const Part& part, const std::vector<BoundaryPoint>& points) {
    Vec2 normal(0, 0);
    double flux = 0, around = 0;
    for (const BoundaryPoint& p : points) {
        normal += p.weight * p.normal;
        flux += p.weight * p.x.dot(p.normal);
        around += p.weight;
    }
    return std::max({normal.norm(), std::abs(flux - 2 * area(part)), std::abs(around - perimeter(part))});
}

/// A few hundred points of coordinates of 1: their roundings.
constexpr double boundary_tolerance = 1e-13;

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

/// gauss_tolerance is far below; what is left are roundings of the points, to the power of up to 8.
constexpr double general_tolerance = 1e-12;

TEST(CellRules, RightInEveryCellWithEllipsesAndSplines) {
    Random random(31);
    for (int k = 0; k < 60; ++k) {
        const Part part = random_part(3 + k % 4, random);
        const CutCells cells = cut_cells(part, random_grid(part, random, limits));
        const int degree = 1 + k / 4 % 4;
        EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree, 4), general_tolerance) << k;
    }
}

/// Closed in one cell, so that portions are as long as monotone pieces can be.
TEST(CellRules, OneCellAroundPartsOfEllipsesAndSplines) {
    Random random(37);
    for (int k = 0; k < 40; ++k) {
        const Part part = random_part(3 + k % 4, random);
        const Box2 b = bounding_box(part);
        const CutCells cells = cut_cells(part, {{b.min.x(), b.max.x()}, {b.min.y(), b.max.y()}});
        for (int degree = 1; degree <= 4; ++degree)
            EXPECT_LT(contour_error(part, cells, cell_rules(part, cells, degree), degree, 4), general_tolerance) << k;
    }
}

/// A quarter of the unit circle as a rational curve, the first and last weight times `low`: the same points, reached unevenly.
Curve uneven_quarter(double low) {
    return bezier_curve({{1, 0}, {1, 1}, {0, 1}}, {low * low, low * std::sqrt(0.5), 1});
}

TEST(GaussPortions, WeightsOfAnyRatioAreHalvedUntilTheRuleHolds) {
    for (int digits = 0; digits <= 6; ++digits) {
        const Curve curve = uneven_quarter(std::pow(10.0, -digits));
        std::vector<GaussPortion> portions;
        append_area_portions(portions, curve, 0, 1, 2, {1, 1});
        double sum = 0, t = 0;
        int n_points = 0;
        for (const GaussPortion& portion : portions) {
            EXPECT_EQ(portion.t0, t);
            t = portion.t1;
            n_points += portion.n;
            const GaussRule& rule = gauss_rule(portion.n);
            for (std::size_t i = 0; i < rule.points.size(); ++i) {
                const double at = portion.t0 + rule.points[i] * (portion.t1 - portion.t0);
                const Vec2 p = point(curve, at);
                sum += rule.weights[i] * (portion.t1 - portion.t0) * derivative(curve, at).y() * std::pow(p.x(), 5) *
                       std::pow(p.y(), 4) / 5;
            }
        }
        EXPECT_EQ(t, 1);
        // the integral of sin^4 cos^6 over a quarter turn is 3 pi / 512
        EXPECT_NEAR(sum, 3 * pi / 512 / 5, 1e-15) << digits;
        EXPECT_LT(n_points, 60 + 300 * digits);
    }
}

/// Not more than the degree of the integrand asks for, and less on short portions.
TEST(GaussPortions, PolynomialsTakeTheirExactCountAtMost) {
    for (int n = 2; n <= max_spline_degree; ++n) {
        std::vector<Vec2> points;
        for (int i = 0; i <= n; ++i) points.emplace_back(i, std::sin(2.0 * i));
        const Curve curve = bezier_curve(points, {});
        for (int degree = 1; degree <= 4; ++degree) {
            std::vector<GaussPortion> portions;
            append_area_portions(portions, curve, 0, 1, degree, {1, 1});
            ASSERT_EQ(portions.size(), 1u);
            EXPECT_LE(portions[0].n, n * (2 * degree + 1));
            append_area_portions(portions, curve, 0.5, 0.501, degree, {1, 1});
            EXPECT_LE(portions[1].n, portions[0].n);
        }
        std::vector<GaussPortion> portions;
        append_area_portions(portions, curve, 0.5, 0.501, 4, {1, 1});
        EXPECT_LT(portions[0].n, 20);  // 9 times 8 for the whole of degree 8
    }
}

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
        const CutCells cells = cut_cells(part, random_grid(part, random, limits));
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

// ---- the checks notice a fault ----

/// Polynomial and Laurent oracles against integrals known by heart.
TEST(QuadratureChecks, OraclesAreRight) {
    const LocalFrame same{{0, 0}, {1, 1}};
    const Moments square = part_moments(straight_parts()[0], same, 3);
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) EXPECT_NEAR(square(i, j), 1.0 / ((i + 1) * (j + 1)), 1e-15);
    Part disc;
    add_loop(disc, {Arc{{0, 0}, 1, 0.4, 2 * pi}});
    const Moments round = part_moments(disc, same, 4);
    EXPECT_NEAR(round(0, 0), pi, 1e-14);
    EXPECT_NEAR(round(1, 2), 0, 1e-14);
    EXPECT_NEAR(round(2, 0), pi / 4, 1e-14);
    EXPECT_NEAR(round(0, 2), pi / 4, 1e-14);
    EXPECT_NEAR(round(2, 2), pi / 24, 1e-14);
    EXPECT_NEAR(round(4, 0), pi / 8, 1e-14);
}

TEST(QuadratureChecks, NoticeAFault) {
    const Part straight = straight_parts()[2], round = curved_samples()[0];
    const CutCells cells = cut_cells(straight, {{0, 1, 2}, {0, 0.25, 0.5}});
    std::vector<CellRule> rules = cell_rules(straight, cells, 2);
    ASSERT_LT(straight_error(straight, cells, rules, 2), straight_tolerance);
    EXPECT_GT(straight_error(straight, cells, cell_rules(straight, cells, 1), 2), straight_tolerance);  // a degree too low
    rules[0].points[0].x() += 1e-6;
    EXPECT_GT(straight_error(straight, cells, rules, 2), straight_tolerance);
    EXPECT_GT(whole_error(straight, cells, rules, 2), straight_tolerance);

    const CutCells arcs = cut_cells(round, {{-0.5, 0, 1}, {-1.25, 0, 0.25}});
    rules = cell_rules(round, arcs, 2);
    ASSERT_LT(contour_error(round, arcs, rules, 2), arc_tolerance);
    rules[0].weights[0] *= 1 + 1e-6;
    EXPECT_GT(contour_error(round, arcs, rules, 2), arc_tolerance);
    EXPECT_GT(whole_error(round, arcs, rules, 2), arc_tolerance);

    Random random(41);
    const Part general = random_part(4, random);
    const CutCells general_cells = cut_cells(general, random_grid(general, random, limits));
    rules = cell_rules(general, general_cells, 2);
    ASSERT_LT(contour_error(general, general_cells, rules, 2, 4), general_tolerance);
    rules[0].weights[0] *= 1 + 1e-9;
    EXPECT_GT(contour_error(general, general_cells, rules, 2, 4), general_tolerance);

    std::vector<BoundaryPoint> points = whole_boundary(round, arcs, 3);
    ASSERT_LT(divergence_error(round, points), boundary_tolerance);
    points[0].weight += 1e-12;
    EXPECT_GT(divergence_error(round, points), boundary_tolerance);
}

// ---- elements ----

/// Left of a slot, right of it, and below.
Part u_shape() {
    return of_polygons({{{0, 0}, {2, 0}, {2, 2}, {0.75, 2}, {0.75, 0.5}, {0.625, 0.5}, {0.625, 2}, {0, 2}}});
}

TEST(ElementRules, OneForEachArmBesideASlot) {
    const Part part = u_shape();
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    const std::vector<CellRule> rules = cell_rules(part, cells, elements, 2);
    ASSERT_EQ(rules.size(), 3u);
    const std::vector<Polygon> expected{{{0, 0}, {1, 0}, {1, 1}, {0.75, 1}, {0.75, 0.5}, {0.625, 0.5}, {0.625, 1}, {0, 1}},
                                        {{0, 0}, {0.625, 0}, {0.625, 1}, {0, 1}},
                                        {{0.75, 0}, {1, 0}, {1, 1}, {0.75, 1}}};
    const std::vector<int> numbers{0, 2, 4};
    for (std::size_t r = 0; r < 3; ++r) {
        EXPECT_EQ(rules[r].element, numbers[r]);
        Moments moments = rule_moments(rules[r], unit_frame(cells.grid, elements.cell_of(numbers[r])), 4);
        for (std::size_t i = 0; i < expected[r].size(); ++i)
            moments -= segment_moments(expected[r][i], expected[r][(i + 1) % expected[r].size()], 4);
        EXPECT_LT(worst_of(moments), 1e-15) << r;
    }
}

TEST(ElementRules, TheSameBitForBitWithoutSlots) {
    on_swept_grids(curved_samples(), 3, [](const Part& part, const CutCells& cells, int degree) {
        const Elements elements = find_elements(part, cells);
        if (!elements.cell_of_extra.empty()) return;
        const std::vector<CellRule> a = cell_rules(part, cells, degree), b = cell_rules(part, cells, elements, degree);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t r = 0; r < a.size(); ++r) {
            EXPECT_EQ(a[r].element, b[r].element);
            EXPECT_EQ(a[r].points, b[r].points);
            EXPECT_EQ(a[r].weights, b[r].weights);
        }
    });
}

/// The arms' faces along the slot, in one cell each, belong to different elements.
TEST(ElementRules, BoundaryPointsCarryTheElement) {
    const Part part = u_shape();
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    const Elements elements = find_elements(part, cells);
    const auto elements_along = [&](int edge) {
        std::vector<int> all;
        for (const BoundaryPoint& p : boundary_rule(part, cells, elements, edge, 0, 1, 2)) {
            EXPECT_EQ(p.element, element_at(part, cells, elements, p.x - 1e-9 * p.normal));
            if (all.empty() || all.back() != p.element) all.push_back(p.element);
        }
        return all;
    };
    EXPECT_EQ(elements_along(3), (std::vector<int>{4, 0}));  // down the right face
    EXPECT_EQ(elements_along(5), (std::vector<int>{0, 2}));  // up the left one
    EXPECT_EQ(elements_along(2), (std::vector<int>{3, 4}));  // the tops
    EXPECT_EQ(elements_along(6), (std::vector<int>{2}));
}

}  // namespace
