// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cut_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/monotone.hpp"

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;
using Polygon = std::vector<Vec2>;
using Random = std::mt19937;

// ---- the oracle: areas of polygons and discs inside a convex polygon, without any walk along a boundary ----

double area_of(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return twice / 2;
}

/// What of `polygon` lies left of the line from a to b [Sutherland, Hodgman 1974]; of a non-convex one with bridges of no area.
Polygon left_half(const Polygon& polygon, const Vec2& a, const Vec2& b) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    return kept;
}

Polygon common(Polygon polygon, const Polygon& convex) {
    for (std::size_t i = 0; i < convex.size() && !polygon.empty(); ++i)
        polygon = left_half(polygon, convex[i], convex[(i + 1) % convex.size()]);
    return polygon;
}

double common_area(const Polygon& polygon, const Polygon& convex) {
    const Polygon both = common(polygon, convex);
    return both.empty() ? 0 : area_of(both);
}

/// Sectors for the parts of the polygon's sides outside the circle, triangles for those inside.
double disc_area(const Polygon& polygon, const Vec2& center, double r) {
    const auto sector = [&](const Vec2& a, const Vec2& b) { return r * r / 2 * std::atan2(cross(a, b), a.dot(b)); };
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - center, b = polygon[(i + 1) % polygon.size()] - center, d = b - a;
        const double dd = d.squaredNorm(), middle = -a.dot(d) / dd;
        const double half = std::sqrt(std::max(0.0, middle * middle - (a.squaredNorm() - r * r) / dd));
        const double t0 = std::max(0.0, middle - half), t1 = std::min(1.0, middle + half);
        if (t0 >= t1) {
            sum += sector(a, b);
        } else {
            const Vec2 p = a + t0 * d, q = t1 < 1 ? Vec2(a + t1 * d) : b;  // near the centre rounding would turn q by any angle
            sum += sector(a, p) + cross(p, q) / 2 + sector(q, b);
        }
    }
    return sum;
}

// ---- parts ----

void add_loop(Part& part, const std::vector<Curve>& curves) {
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "", ""});
    }
}

std::vector<Curve> closed(const Polygon& points) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < points.size(); ++i) curves.push_back(Segment{points[i], points[(i + 1) % points.size()]});
    return curves;
}

Polygon box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Polygon backwards(Polygon polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// A part and the area of it inside any convex polygon.
struct Sample {
    std::string name;
    Part part;
    std::function<double(const Polygon&)> area_in;
};

Sample polygon_sample(const std::string& name, const Polygon& outline) {
    Sample sample{name, {}, [=](const Polygon& cell) { return common_area(outline, cell); }};
    add_loop(sample.part, closed(outline));
    return sample;
}

Sample disc(const Vec2& center, double r, double seam) {
    Sample sample{"disc", {}, [=](const Polygon& cell) { return disc_area(cell, center, r); }};
    add_loop(sample.part, {Arc{center, r, seam, 2 * pi}});
    return sample;
}

Sample ring() {
    Sample sample{"ring", {}, [](const Polygon& cell) { return disc_area(cell, {0, 0}, 1) - disc_area(cell, {0.125, 0}, 0.5); }};
    add_loop(sample.part, {Arc{{0, 0}, 1, 0.7, pi}, Arc{{0, 0}, 1, 0.7 + pi, pi}});
    add_loop(sample.part, {Arc{{0.125, 0}, 0.5, 0, -2 * pi}});
    return sample;
}

Sample plate_with_holes() {
    const Polygon plate = box(-1, -0.5, 1, 0.5), hole = {{0.75, 0}, {0.5, 0.25}, {0.25, 0}, {0.5, -0.25}};
    Sample sample{"plate with a round and a square hole", {}, [=](const Polygon& cell) {
                      return common_area(plate, cell) - disc_area(cell, {-0.5, 0}, 0.25) - common_area(hole, cell);
                  }};
    add_loop(sample.part, closed(plate));
    add_loop(sample.part, {Arc{{-0.5, 0}, 0.25, pi, -pi}, Arc{{-0.5, 0}, 0.25, 0, -pi}});
    add_loop(sample.part, closed(backwards(hole)));
    return sample;
}

/// Two half discs on a rectangle: lines and arcs meet tangentially.
Sample slot() {
    Sample sample{"slot", {}, [](const Polygon& cell) {
                      return common_area(box(-1, -0.5, 1, 0.5), cell) + disc_area(common(cell, box(1, -9, 9, 9)), {1, 0}, 0.5) +
                             disc_area(common(cell, box(-9, -9, -1, 9)), {-1, 0}, 0.5);
                  }};
    add_loop(sample.part, {Segment{{-1, -0.5}, {1, -0.5}}, Arc{{1, 0}, 0.5, -pi / 2, pi}, Segment{{1, 0.5}, {-1, 0.5}},
                           Arc{{-1, 0}, 0.5, pi / 2, pi}});
    return sample;
}

std::vector<Sample> samples() {
    return {polygon_sample("square", box(-0.5, -0.5, 0.5, 0.5)),
            polygon_sample("angle section", {{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}}),
            polygon_sample("thin triangle", {{0, 0}, {2, 0.125}, {0.25, 0.5}}),
            disc({0.25, -0.5}, 0.75, 0),
            disc({0, 0}, 1, 0.3),
            ring(),
            plate_with_holes(),
            slot()};
}

Sample moved(const Sample& sample, double c, double s, const Vec2& d) {
    const auto back = [=](const Vec2& p) { return Vec2(c * (p - d).x() + s * (p - d).y(), -s * (p - d).x() + c * (p - d).y()); };
    return {sample.name, transformed(sample.part, c, s, d), [=, area_in = sample.area_in](Polygon cell) {
                for (Vec2& p : cell) p = back(p);
                return area_in(cell);
            }};
}

/// Not at all, by quarter turns, and by any angle, in turn.
Sample placed(const Sample& sample, int k, Random& random) {
    if (k % 4 == 0) return sample;
    if (k % 4 == 1) return moved(sample, 0, 1, {0, 0});
    const double angle = std::uniform_real_distribution<double>(-pi, pi)(random);
    return moved(sample, std::cos(angle), std::sin(angle), {0.125, -0.25});
}

// ---- grids ----

/// Coordinates where something happens: vertices and extreme points, along one axis.
std::vector<double> special_values(const Part& part, int axis) {
    std::vector<double> values;
    for (const MonotonePiece& piece : monotone_pieces(part)) values.push_back(piece.from[axis]);
    return values;
}

/// No two lines are closer than this part of the extent: narrower cells would only test the rounding of their own width.
constexpr double least_width = 0.02;

/// From box side to box side, exactly on it, beyond it by a sliver, or well beyond; between them, lines through special values,
/// or a sliver of 1e-1 to 1e-12 of the extent beside them, and lines anywhere.
std::vector<double> random_lines(const Part& part, int axis, Random& random) {
    const Box2 extent = bounding_box(part);
    const double low = extent.min[axis], high = extent.max[axis], size = high - low;
    std::uniform_real_distribution<double> unit(0, 1);
    const auto sliver = [&] { return size * std::pow(10.0, -1 - std::floor(12 * unit(random))); };
    const auto beyond = [&] {
        const double choice = unit(random);
        return choice < 0.4 ? 0.0 : choice < 0.7 ? sliver() : size * unit(random);
    };
    std::vector<double> wanted;
    for (double v : special_values(part, axis)) {
        const double choice = unit(random);
        if (choice < 0.4) wanted.push_back(v);
        else if (choice < 0.6) wanted.push_back(v + sliver());
        else if (choice < 0.8) wanted.push_back(v - sliver());
    }
    const int n_free = static_cast<int>(6 * unit(random));
    for (int i = 0; i < n_free; ++i) wanted.push_back(low + size * unit(random));

    std::vector<double> lines{low - beyond(), high + beyond()};
    for (double v : wanted) {
        const bool free = std::none_of(lines.begin(), lines.end(), [&](double x) { return std::abs(x - v) < least_width * size; });
        if (free && v > lines[0] && v < lines[1]) lines.push_back(v);
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

Box2 box_of(const Grid& grid, int cell) {
    const auto i = static_cast<std::size_t>(grid.column_of(cell)), j = static_cast<std::size_t>(grid.row_of(cell));
    return {{grid.x[i], grid.y[j]}, {grid.x[i + 1], grid.y[j + 1]}};
}

double area_of(const Box2& b) { return b.size().prod(); }

int n_cells(const Grid& grid) { return grid.columns() * grid.rows(); }

CellClass class_of(const CutCells& cells, int column, int row) {
    return cells.cell_class[static_cast<std::size_t>(cells.grid.cell(column, row))];
}
double fraction_of(const CutCells& cells, int column, int row) {
    return cells.fraction[static_cast<std::size_t>(cells.grid.cell(column, row))];
}

// ---- what must hold on any grid ----

/// The fraction of a cell is as exact as its width: 1e-16 of a coordinate over least_width, times a dozen roundings.
constexpr double fraction_tolerance = 1e-13;

/// Largest difference between a cell's fraction and the oracle's.
double fraction_error(const Sample& sample, const CutCells& cells) {
    double worst = 0;
    for (int c = 0; c < n_cells(cells.grid); ++c) {
        const Box2 b = box_of(cells.grid, c);
        const double expected = sample.area_in(box(b.min.x(), b.min.y(), b.max.x(), b.max.y())) / area_of(b);
        worst = std::max(worst, std::abs(cells.fraction[static_cast<std::size_t>(c)] - expected));
    }
    return worst;
}

/// Empty, or what is wrong with classes and fractions taken by themselves.
std::string partition_problem(const CutCells& cells) {
    for (int c = 0; c < n_cells(cells.grid); ++c) {
        const CellClass kind = cells.cell_class[static_cast<std::size_t>(c)];
        const double f = cells.fraction[static_cast<std::size_t>(c)];
        const bool fits = kind == CellClass::outer ? f == 0 : kind == CellClass::inner ? f == 1 : f > 0 && f < 1;
        if (!fits) return "cell " + std::to_string(c) + " has fraction " + std::to_string(f);
    }
    return "";
}

double distance_to_boundary(const Part& part, const Vec2& p) {
    double least = 1e300;
    for (const Edge& e : part.edges) least = std::min(least, (point(e.curve, closest_parameter(e.curve, p)) - p).norm());
    return least;
}

/// Number of points that an inner cell has outside the part, or an outer one inside; points nearer the boundary than 1e-9 apart.
int wrong_points(const Part& part, const CutCells& cells, Random& random) {
    const std::vector<MonotonePiece> pieces = monotone_pieces(part);
    std::uniform_real_distribution<double> unit(0, 1);
    int wrong = 0;
    for (int c = 0; c < n_cells(cells.grid); ++c) {
        const CellClass kind = cells.cell_class[static_cast<std::size_t>(c)];
        const Box2 b = box_of(cells.grid, c);
        for (int k = 0; k < 3 && kind != CellClass::boundary; ++k) {
            const Vec2 p = b.min + Vec2(unit(random), unit(random)).cwiseProduct(b.size());
            if (contains(pieces, p) != (kind == CellClass::inner) && distance_to_boundary(part, p) > 1e-9) ++wrong;
        }
    }
    return wrong;
}

/// Empty, or where the pieces fail to cover their edge from 0 to 1, each beginning where the one before it ended.
std::string cover_problem(const Part& part, const CutCells& cells) {
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
        double t = 0;
        for (int k = cells.first_piece[e]; k < cells.first_piece[e + 1]; ++k) {
            const BoundaryPiece& piece = cells.pieces[static_cast<std::size_t>(k)];
            if (piece.edge != static_cast<int>(e) || piece.t0 != t || piece.t1 <= t)
                return "edge " + std::to_string(e) + " at " + std::to_string(t);
            t = piece.t1;
        }
        if (t != 1) return "edge " + std::to_string(e) + " ends at " + std::to_string(t);
    }
    return "";
}

/// How far a piece of the boundary may lie outside its cell: where the corner that it belongs to fills less than sliver_fraction
/// of its own cell, the neighbour takes it, and such a corner of a cell of size 1 is sqrt(1e-13 / tan) long; of the samples here
/// the sharpest is 12 degrees wide, and the depth is tried in steps of 8.
constexpr double piece_reach = 1e-5;

/// Empty, or the first piece whose cell is outer or elsewhere.
std::string location_problem(const Part& part, const CutCells& cells) {
    for (const BoundaryPiece& piece : cells.pieces) {
        const std::string name = "piece " + std::to_string(piece.edge) + " from " + std::to_string(piece.t0);
        if (piece.cell < 0 || piece.cell >= n_cells(cells.grid)) return name + " has no cell";
        if (cells.cell_class[static_cast<std::size_t>(piece.cell)] == CellClass::outer) return name + " has an outer cell";
        const Vec2 p = point(part.edges[static_cast<std::size_t>(piece.edge)].curve, 0.5 * (piece.t0 + piece.t1));
        if (!box_of(cells.grid, piece.cell).overlaps({p, p}, piece_reach)) return name + " is far from its cell";
    }
    return "";
}

TEST(CutCells, AreasClassesAndPiecesOnSweptGrids) {
    for (const Sample& original : samples()) {
        Random random(7);
        for (int k = 0; k < 200; ++k) {
            const Sample sample = placed(original, k, random);
            const CutCells cells = cut_cells(sample.part, random_grid(sample.part, random));
            SCOPED_TRACE(sample.name + ", placement " + std::to_string(k));
            const double whole = area(sample.part);
            ASSERT_NEAR(cells.area, whole, 1e-12 * whole);
            ASSERT_LT(fraction_error(sample, cells), fraction_tolerance);
            ASSERT_EQ(partition_problem(cells), "");
            ASSERT_EQ(wrong_points(sample.part, cells, random), 0);
            ASSERT_EQ(cover_problem(sample.part, cells), "");
            ASSERT_EQ(location_problem(sample.part, cells), "");
        }
    }
}
