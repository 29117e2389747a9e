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

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;
using Polygon = std::vector<Vec2>;
using Random = std::mt19937;
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

Box2 box_of(const Grid& grid, int cell) {
    const auto i = static_cast<std::size_t>(grid.column_of(cell)), j = static_cast<std::size_t>(grid.row_of(cell));
    return {{grid.x[i], grid.y[j]}, {grid.x[i + 1], grid.y[j + 1]}};
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

void add_loop(Part& part, const std::vector<Curve>& curves) {
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "", ""});
    }
}

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

/// From box side to box side, some beyond; in between through ends of edges, slivers beside them, and anywhere.
std::vector<double> random_lines(const Part& part, int axis, Random& random) {
    const Box2 extent = bounding_box(part);
    const double low = extent.min[axis], high = extent.max[axis], size = high - low;
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> wanted;
    for (const Edge& e : part.edges) {
        const double sliver = size * std::pow(10.0, -1 - std::floor(12 * unit(random)));
        wanted.push_back(point(e.curve, 0)[axis] + sliver * std::floor(3 * unit(random) - 1));
        wanted.push_back(low + size * unit(random));
    }
    const double beyond = unit(random) < 0.5 ? 0 : 0.3 * size * unit(random);
    std::vector<double> lines{low - beyond, high + beyond};
    for (double v : wanted) {
        const bool free = std::none_of(lines.begin(), lines.end(), [&](double x) { return std::abs(x - v) < 0.05 * size; });
        if (free && v > lines[0] && v < lines[1] && unit(random) < 0.7) lines.push_back(v);
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

Grid random_grid(const Part& part, Random& random) {
    Grid grid;
    grid.x = random_lines(part, 0, random);
    grid.y = random_lines(part, 1, random);
    return grid;
}

/// Calls check(part, cells, degree) for turned parts on random grids, degrees 1 to 4 in turn, until a check fails.
template <class Check>
void on_swept_grids(const std::vector<Part>& parts, int n_placements, Check check) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
        Random random(23);
        for (int k = 0; k < n_placements; ++k) {
            const Turn turn = random_turn(k, random);
            const Part part = transformed(parts[which], turn.c, turn.s, {0.125, -0.25});
            SCOPED_TRACE("part " + std::to_string(which) + ", placement " + std::to_string(k));
            check(part, cut_cells(part, random_grid(part, random)), 1 + k % 4);
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
        const LocalFrame frame = unit_frame(cells.grid, rule.cell);
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

/// Of each cell by its contours, with so many Gauss points that nothing is missing.
double contour_error(const Part& part, const CutCells& cells, const std::vector<CellRule>& rules, int degree) {
    const GaussRule& gauss = gauss_rule(64);
    double worst = 0;
    for (const CellRule& rule : rules) {
        const LocalFrame frame = unit_frame(cells.grid, rule.cell);
        Moments sum = -rule_moments(rule, frame, 2 * degree);
        const auto c = static_cast<std::size_t>(rule.cell);
        for (int k = cells.first_contour[c]; k < cells.first_contour[c + 1]; ++k) {
            const ContourPiece& piece = cells.contours[static_cast<std::size_t>(k)];
            for (std::size_t q = 0; q < gauss.points.size(); ++q) {
                const double t = piece.t0 + gauss.points[q] * (piece.t1 - piece.t0);
                const Box2 b = box_of(cells.grid, rule.cell);
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
        found.push_back(rule.cell);
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
            EXPECT_EQ(p.cell, piece_at(cells, p.edge, p.t).cell);
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

    std::vector<BoundaryPoint> points = whole_boundary(round, arcs, 3);
    ASSERT_LT(divergence_error(round, points), boundary_tolerance);
    points[0].weight += 1e-12;
    EXPECT_GT(divergence_error(round, points), boundary_tolerance);
}

}  // namespace
