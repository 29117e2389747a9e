// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/cut_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/geometry/cells/clipped_polygon.hpp"
#include "tests/geometry/cells/random_grids.hpp"

namespace cut_cells_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::test;
constexpr double pi = std::numbers::pi;

// ---- the oracle: areas of polygons and discs inside a convex polygon, without any walk along a boundary ----

double polygon_area(const Corners& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return twice / 2;
}

double common_area(const Corners& polygon, const Corners& convex) {
    const Corners both = common(polygon, convex);
    return both.empty() ? 0 : polygon_area(both);
}

/// Sectors for the parts of the polygon's sides outside the circle, triangles for those inside.
double disc_area(const Corners& polygon, const Vec2& center, double r) {
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

Corners box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Corners backwards(Corners polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// A part and the area of it inside any convex polygon.
struct Sample {
    std::string name;
    Part part;
    std::function<double(const Corners&)> area_in;
};

Sample polygon_sample(const std::string& name, const Corners& outline) {
    Sample sample{name, {}, [=](const Corners& cell) { return common_area(outline, cell); }};
    add_loop(sample.part, closed(outline));
    return sample;
}

Sample disc(const Vec2& center, double r, double seam) {
    Sample sample{"disc", {}, [=](const Corners& cell) { return disc_area(cell, center, r); }};
    add_loop(sample.part, {Arc{center, r, seam, 2 * pi}});
    return sample;
}

Sample ring() {
    Sample sample{"ring", {}, [](const Corners& cell) {
                      return disc_area(cell, {0, 0}, 1) - disc_area(cell, {0.125, 0}, 0.5);
                  }};
    add_loop(sample.part, {Arc{{0, 0}, 1, 0.7, pi}, Arc{{0, 0}, 1, 0.7 + pi, pi}});
    add_loop(sample.part, {Arc{{0.125, 0}, 0.5, 0, -2 * pi}});
    return sample;
}

Sample plate_with_holes() {
    const Corners plate = box(-1, -0.5, 1, 0.5), hole = {{0.75, 0}, {0.5, 0.25}, {0.25, 0}, {0.5, -0.25}};
    Sample sample{"plate with a round and a square hole", {}, [=](const Corners& cell) {
                      return common_area(plate, cell) - disc_area(cell, {-0.5, 0}, 0.25) - common_area(hole, cell);
                  }};
    add_loop(sample.part, closed(plate));
    add_loop(sample.part, {Arc{{-0.5, 0}, 0.25, pi, -pi}, Arc{{-0.5, 0}, 0.25, 0, -pi}});
    add_loop(sample.part, closed(backwards(hole)));
    return sample;
}

/// Two half discs on a rectangle: lines and arcs meet tangentially.
Sample slot() {
    Sample sample{"slot", {}, [](const Corners& cell) {
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
    const auto back = [=](const Vec2& p) {
        return Vec2(c * (p - d).x() + s * (p - d).y(), -s * (p - d).x() + c * (p - d).y());
    };
    return {sample.name, transformed(sample.part, c, s, d), [=, area_in = sample.area_in](Corners cell) {
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

CellClass class_of(const CutCells& cells, int column, int row) {
    return cells.cell_class[static_cast<std::size_t>(cells.grid.cell(column, row))];
}
double fraction_of(const CutCells& cells, int column, int row) {
    return cells.fraction[static_cast<std::size_t>(cells.grid.cell(column, row))];
}

// ---- what must hold on any grid ----

/// Up to sliver_fraction is rounded away on purpose; as much again for a dozen roundings of 1e-16 over least_width.
constexpr double fraction_tolerance = 2 * sliver_fraction;

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

/// Number of points that an inner cell has outside the part, or an outer one inside; points nearer the boundary than 1e-9
/// apart.
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

/// Calls check(sample, cells, random) for each sample on 200 grids, turned and unturned, until a check fails.
template <class Check>
void on_swept_grids(Check check) {
    for (const Sample& original : samples()) {
        Random random(7);
        for (int k = 0; k < 200; ++k) {
            const Sample sample = placed(original, k, random);
            const CutCells cells = cut_cells(sample.part, random_grid(sample.part, random));
            SCOPED_TRACE(sample.name + ", placement " + std::to_string(k));
            check(sample, cells, random);
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(CutCells, AreasSumToThePartOnSweptGrids) {
    on_swept_grids([](const Sample& sample, const CutCells& cells, Random&) {
        const double whole = area(sample.part);
        EXPECT_NEAR(cells.area, whole, 1e-12 * whole);
        EXPECT_LT(fraction_error(sample, cells), fraction_tolerance);
    });
}

TEST(CutCells, ClassesAgreeWithPointsOnSweptGrids) {
    on_swept_grids([](const Sample& sample, const CutCells& cells, Random& random) {
        EXPECT_EQ(partition_problem(cells), "");
        EXPECT_EQ(wrong_points(sample.part, cells, random), 0);
    });
}

TEST(CutCells, PiecesCoverEveryEdgeOnSweptGrids) {
    on_swept_grids(
        [](const Sample& sample, const CutCells& cells, Random&) { EXPECT_EQ(cover_problem(sample.part, cells), ""); });
}

TEST(CutCells, PiecesLieInCellsWithMaterialOnSweptGrids) {
    on_swept_grids(
        [](const Sample& sample, const CutCells& cells, Random&) { EXPECT_EQ(location_problem(sample.part, cells), ""); });
}

TEST(CutCells, ATipCutOffByAGridLineHasACell) {
    // the tip right of the line fills 1e-13 of its cell and less, and the normal of its lower edge never comes back into the
    // part
    const Sample wedge = polygon_sample("wedge", {{0, 0}, {2, 0}, {0.25, 0.5}});
    for (double tip : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-15}) {
        const CutCells cells = cut_cells(wedge.part, {{0, 1, 2 - tip, 3}, {0, 0.25, 0.5}});
        EXPECT_EQ(location_problem(wedge.part, cells), "") << "tip " << tip;
    }
}

/// Its area is a rounding in every cell right of the first: the pieces there take the first one's cell, through cells on all
/// sides that are outer.
TEST(CutCells, ANeedleThroughManyCellsHasACell) {
    Grid grid;
    for (int i = 0; i <= 12; ++i) grid.x.push_back(i);
    grid.y = {-1, 0, 1, 2};
    const Sample needle = polygon_sample("needle", {{0.5, 0.25}, {1, 0.5}, {11.5, 0.5}, {1, 0.5 + 1e-14}, {0.5, 0.75}});
    const CutCells cells = cut_cells(needle.part, grid);
    EXPECT_EQ(cover_problem(needle.part, cells), "");
    EXPECT_GT(cells.pieces.size(), 20u);
    for (const BoundaryPiece& piece : cells.pieces) EXPECT_EQ(piece.cell, grid.cell(0, 1)) << piece.edge << " " << piece.t0;
}

/// Many pieces with nothing but outer cells around, on a large grid: a search over rings of cells would take minutes.
TEST(CutCells, APartOfNoAreaOnALargeGridHasNoCellsAndTakesNoTime) {
    Corners sliver;
    for (int i = 0; i <= 500; ++i) sliver.emplace_back(i / 500.0, 0.5001 + 1e-18 * i);
    sliver.emplace_back(0.5, 0.5001 + 1e-16);
    Grid grid;
    for (int i = 0; i <= 400; ++i) grid.x.push_back(i / 400.0);
    grid.y = grid.x;
    const CutCells cells = cut_cells(polygon_sample("sliver", sliver).part, grid);
    EXPECT_EQ(cells.area, 0);
    for (const BoundaryPiece& piece : cells.pieces) EXPECT_EQ(piece.cell, -1);
}

/// A million equal cells, added one by one, would be off by 1e-11.
TEST(CutCells, TheAreaDoesNotDriftWithTheNumberOfCells) {
    Grid grid;
    for (int i = 0; i <= 700; ++i) grid.x.push_back(0.1 * i);
    grid.y = grid.x;
    const Part part = polygon_sample("square", box(0, 0, 70, 70)).part;
    EXPECT_NEAR(cut_cells(part, grid).area, 4900, 4900 * 2e-15);
}

// ---- the stated rule for what lies on a grid line ----

TEST(CutCells, HalfOpenIntervals) {
    const std::vector<double> lines{0, 1, 3};
    EXPECT_EQ(interval_of(lines, -1e-300), -1);
    EXPECT_EQ(interval_of(lines, 0), 0);
    EXPECT_EQ(interval_of(lines, std::nextafter(1.0, 0.0)), 0);
    EXPECT_EQ(interval_of(lines, 1), 1);
    EXPECT_EQ(interval_of(lines, 3), 2);
    EXPECT_EQ(interval_of(lines, 9), 2);
}

TEST(CutCells, GridNumbersCellsRowByRow) {
    const Grid grid{{0, 1, 2, 3}, {0, 1, 2}};
    EXPECT_EQ(grid.columns(), 3);
    EXPECT_EQ(grid.rows(), 2);
    EXPECT_EQ(grid.cell(2, 1), 5);
    EXPECT_EQ(grid.column_of(5), 2);
    EXPECT_EQ(grid.row_of(5), 1);
}

/// The cell on the material's side is inner, the one on the other side outer, on all four sides.
TEST(CutCells, EdgesOnGridLinesSeparateInnerFromOuter) {
    const Part part = polygon_sample("square", box(1, 1, 2, 2)).part;
    const CutCells cells = cut_cells(part, {{0, 1, 2, 3}, {0, 1, 2, 3}});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(class_of(cells, i, j), i == 1 && j == 1 ? CellClass::inner : CellClass::outer) << i << " " << j;
    ASSERT_EQ(cells.pieces.size(), 4u);
    for (const BoundaryPiece& piece : cells.pieces) EXPECT_EQ(piece.cell, cells.grid.cell(1, 1)) << "edge " << piece.edge;
    EXPECT_EQ(cells.area, 1.0);
}

TEST(CutCells, HoleOnGridLinesIsOneOuterCell) {
    Part part = polygon_sample("plate", box(0, 0, 3, 3)).part;
    add_loop(part, closed(backwards(box(1, 1, 2, 2))));
    const CutCells cells = cut_cells(part, {{0, 1, 2, 3}, {0, 1, 2, 3}});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(class_of(cells, i, j), i == 1 && j == 1 ? CellClass::outer : CellClass::inner) << i << " " << j;
    // the hole's edges run up its left side, along its top, down its right side, back along its bottom
    const std::vector<int> neighbour{cells.grid.cell(0, 1), cells.grid.cell(1, 2), cells.grid.cell(2, 1),
                                     cells.grid.cell(1, 0)};
    for (std::size_t e = 4; e < 8; ++e) {
        const Vec2 middle = point(part.edges[e].curve, 0.5);
        const int side = middle.x() == 1 ? 0 : middle.y() == 2 ? 1 : middle.x() == 2 ? 2 : 3;
        EXPECT_EQ(piece_at(cells, static_cast<int>(e), 0.5).cell, neighbour[static_cast<std::size_t>(side)]);
    }
}

/// As a contour the edge on a line belongs to the cell on its right or above, where it bounds no area; the cell on its left
/// sees the material through its own right side.
TEST(CutCells, ContoursOfEdgesOnGridLines) {
    // material left of x = 1: the rows cut by a slanted top, so that the cells have contours
    const Part part = polygon_sample("slanted", {{0, 0}, {1, 0}, {1, 1.5}, {0, 1.25}}).part;
    const CutCells cells = cut_cells(part, {{0, 1, 2}, {0, 1, 2}});
    EXPECT_EQ(class_of(cells, 0, 0), CellClass::inner);
    EXPECT_EQ(class_of(cells, 0, 1), CellClass::boundary);
    EXPECT_EQ(class_of(cells, 1, 0), CellClass::outer);
    EXPECT_EQ(class_of(cells, 1, 1), CellClass::outer);
    EXPECT_DOUBLE_EQ(fraction_of(cells, 0, 1), 0.375);
    std::vector<ContourPiece> sides;
    for (const ContourPiece& c : cells.contours) {
        if (c.edge < 0) sides.push_back(c);
        if (c.edge == 1) { EXPECT_EQ(cells.grid.column_of(c.cell), 1); }
    }
    ASSERT_EQ(sides.size(), 2u);
    EXPECT_EQ(sides[1].cell, cells.grid.cell(0, 1));
    EXPECT_EQ(sides[1].t0, 1.0);
    EXPECT_EQ(sides[1].t1, 1.5);
    for (const BoundaryPiece& piece : cells.pieces) EXPECT_EQ(cells.grid.column_of(piece.cell), 0);
}

TEST(CutCells, CircleTangentToItsFourLines) {
    // the lines touch the circle: four cells cut, nothing outside them
    const CutCells cells = cut_cells(disc({0, 0}, 1, 0.3).part, {{-2, -1, 0, 1, 2}, {-2, -1, 0, 1, 2}});
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const bool within = (i == 1 || i == 2) && (j == 1 || j == 2);
            EXPECT_EQ(class_of(cells, i, j), within ? CellClass::boundary : CellClass::outer) << i << " " << j;
            EXPECT_NEAR(fraction_of(cells, i, j), within ? pi / 4 : 0, 1e-15);
        }
}

TEST(CutCells, HoleTangentToGridLines) {
    Part part = polygon_sample("plate", box(0, 0, 4, 4)).part;
    add_loop(part, {Arc{{2, 2}, 1, 0, -2 * pi}});
    const CutCells cells = cut_cells(part, {{0, 1, 3, 4}, {0, 1, 3, 4}});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(class_of(cells, i, j), i == 1 && j == 1 ? CellClass::boundary : CellClass::inner) << i << " " << j;
    EXPECT_NEAR(fraction_of(cells, 1, 1), 1 - pi / 4, 1e-15);
}

TEST(CutCells, OneCellThatIsThePartsBox) {
    const CutCells square = cut_cells(polygon_sample("square", box(0, 0, 1, 2)).part, {{0, 1}, {0, 2}});
    EXPECT_EQ(square.cell_class[0], CellClass::inner);
    const CutCells round = cut_cells(disc({0, 0}, 1, 0).part, {{-1, 1}, {-1, 1}});
    EXPECT_EQ(round.cell_class[0], CellClass::boundary);
    EXPECT_NEAR(round.fraction[0], pi / 4, 1e-15);
}

// ---- slivers ----

/// A rectangle that reaches beyond a line, or stays short of it, by s of a cell: seen down to 1e-12, rounded away below 1e-13.
TEST(CutCells, SliversAreSeenDownToTheSliverFraction) {
    for (int k = 1; k <= 12; ++k) {
        const double s = std::pow(10.0, -k);
        const CutCells over = cut_cells(polygon_sample("over", box(0, 0, 1 + s, 1)).part, {{0, 1, 2}, {0, 1}});
        EXPECT_EQ(over.cell_class[0], CellClass::inner);
        EXPECT_EQ(over.cell_class[1], CellClass::boundary) << s;
        EXPECT_NEAR(over.fraction[1], s, 3e-16);
        const CutCells shy = cut_cells(polygon_sample("short", box(0, 0, 1 - s, 1)).part, {{0, 1, 2}, {0, 1}});
        EXPECT_EQ(shy.cell_class[0], CellClass::boundary) << s;
        EXPECT_NEAR(shy.fraction[0], 1 - s, 3e-16);
        EXPECT_EQ(shy.cell_class[1], CellClass::outer);
    }
    const double below = 0.5 * sliver_fraction;
    const CutCells over = cut_cells(polygon_sample("over", box(0, 0, 1 + below, 1)).part, {{0, 1, 2}, {0, 1}});
    EXPECT_EQ(over.cell_class[1], CellClass::outer);
    for (const BoundaryPiece& piece : over.pieces) EXPECT_EQ(piece.cell, 0);
    const CutCells shy = cut_cells(polygon_sample("short", box(0, 0, 1 - below, 1)).part, {{0, 1, 2}, {0, 1}});
    EXPECT_EQ(shy.cell_class[0], CellClass::inner);
}

TEST(CutCells, AGridThatMissesThePartFallsShortInArea) {
    const Part part = polygon_sample("square", box(0, 0, 1, 1)).part;
    EXPECT_DOUBLE_EQ(cut_cells(part, {{0, 0.75}, {0, 1}}).area, 0.75);
    EXPECT_DOUBLE_EQ(cut_cells(part, {{0.25, 1}, {-1, 0.5}}).area, 0.375);
}

TEST(CutCells, PieceAtFindsThePieceThatHoldsAParameter) {
    const CutCells cells = cut_cells(polygon_sample("square", box(0, 0, 1, 1)).part, {{0, 0.25, 1}, {0, 1}});
    EXPECT_EQ(piece_at(cells, 0, 0).cell, 0);
    EXPECT_EQ(piece_at(cells, 0, 0.2).cell, 0);
    EXPECT_EQ(piece_at(cells, 0, 0.25).cell, 1);
    EXPECT_EQ(piece_at(cells, 0, 1).cell, 1);
    EXPECT_EQ(piece_at(cells, 2, 0.7).t1, 0.75);
    EXPECT_EQ(piece_at(cells, 2, 0.8).cell, 0);
}

// ---- the checks notice a fault ----

TEST(CutCellsChecks, NoticeAFault) {
    const Sample sample = plate_with_holes();
    const CutCells good = cut_cells(sample.part, {{-1, -0.5, 0, 1}, {-0.5, 0.25, 0.5}});
    Random random(7);
    ASSERT_LT(fraction_error(sample, good), fraction_tolerance);

    CutCells cells = good;
    cells.fraction[1] += 2 * fraction_tolerance;
    EXPECT_GT(fraction_error(sample, cells), fraction_tolerance);

    cells = good;
    const auto inner = static_cast<std::size_t>(std::find(good.cell_class.begin(), good.cell_class.end(), CellClass::inner) -
                                                good.cell_class.begin());
    ASSERT_LT(inner, good.cell_class.size());
    cells.cell_class[inner] = CellClass::outer;
    EXPECT_NE(partition_problem(cells), "");
    EXPECT_GT(wrong_points(sample.part, cells, random), 0);
    EXPECT_NE(location_problem(sample.part, cells), "");

    cells = good;
    cells.pieces[1].t0 = std::nextafter(cells.pieces[1].t0, 2.0);
    EXPECT_NE(cover_problem(sample.part, cells), "");

    cells = good;
    cells.pieces[0].cell = -1;
    EXPECT_NE(location_problem(sample.part, cells), "");
}

}  // namespace

}  // namespace cut_cells_test
