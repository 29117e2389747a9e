// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/monotone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/geometry/cells/random_parts.hpp"

namespace monotone_test {

namespace {

using namespace abut::geometry;
using test::add_loop;
constexpr double pi = std::numbers::pi;
using Pieces = std::vector<MonotonePiece>;

Part disc(double seam, double sweep) {
    Part part;
    add_loop(part, {Arc{{1, 2}, 1.5, seam, sweep}});
    return part;
}

/// Lines, tangential arcs, and a hole in two arcs that run clockwise.
Part slot() {
    Part part;
    add_loop(part, {Segment{{-1, -0.5}, {1, -0.5}}, Arc{{1, 0}, 0.5, -pi / 2, pi}, Segment{{1, 0.5}, {-1, 0.5}},
                    Arc{{-1, 0}, 0.5, pi / 2, pi}});
    add_loop(part, {Arc{{0.5, 0.125}, 0.25, 1, -4}, Arc{{0.5, 0.125}, 0.25, -3, 4 - 2 * pi}});
    return part;
}

std::vector<Part> parts() {
    std::vector<Part> all{disc(0, 2 * pi), disc(0.3, 2 * pi), disc(-pi / 2, 2 * pi), disc(3, -2 * pi), slot()};
    std::mt19937 random(17);
    std::uniform_real_distribution<double> angle(-pi, pi);
    for (int k = 0; k < 40; ++k) {
        const double a = k % 4 == 0 ? pi / 2 * (k / 4) : angle(random);
        all.push_back(transformed(slot(), std::cos(a), std::sin(a), {0.25, 3}));
    }
    return all;
}

const Curve& curve_of(const Part& part, const MonotonePiece& piece) {
    return part.edges[static_cast<std::size_t>(piece.edge)].curve;
}

/// Empty, or where consecutive pieces do not share end and parameter bit for bit.
std::string chain_problem(const Part& part, const Pieces& pieces) {
    std::size_t k = 0;
    for (const Loop& loop : part.loops) {
        const std::size_t first = k;
        for (int e : loop.edges) {
            double t = 0;
            for (; k < pieces.size() && pieces[k].edge == e; ++k) {
                if (pieces[k].t0 != t || pieces[k].t1 <= t) return "parameter of piece " + std::to_string(k);
                if (k > first && pieces[k].from != pieces[k - 1].to) return "beginning of piece " + std::to_string(k);
                t = pieces[k].t1;
            }
            if (t != 1) return "edge " + std::to_string(e);
        }
        if (k == first || pieces[k - 1].to != pieces[first].from) return "loop is not closed";
    }
    return k == pieces.size() ? "" : "pieces left over";
}

/// Largest distance between a point of the curve and the same point by the one-variable forms, and between the points of t and
/// of the parameter found. Where the curve runs along an axis, x determines y well but not y x: the better of both counts.
double form_error(const Part& part, const Pieces& pieces) {
    double worst = 0;
    for (const MonotonePiece& piece : pieces) {
        const Vec2 extent = (piece.to - piece.from).cwiseAbs();
        if (extent.norm() == 0) continue;  // an extreme point within rounding of the curve's end
        for (double s : {0.0, 1e-9, 0.01, 0.3, 0.5, 0.9, 1.0}) {
            const Curve& curve = curve_of(part, piece);
            const Vec2 p = point(curve, piece.t0 + s * (piece.t1 - piece.t0));
            const double by_x = extent.x() > 0 ? std::abs(y_at(piece, p.x()) - p.y()) : 1;
            const double by_y = extent.y() > 0 ? std::abs(x_at(piece, p.y()) - p.x()) : 1;
            worst = std::max({worst, std::min(by_x, by_y), (point(curve, parameter_at(piece, p, curve)) - p).norm()});
        }
    }
    return worst;
}

/// Number of steps against the piece's own direction along its curve, by more than rounding.
int backward_steps(const Part& part, const Pieces& pieces) {
    int count = 0;
    for (const MonotonePiece& piece : pieces) {
        const Vec2 along = piece.to - piece.from;
        Vec2 last = piece.from;
        for (int i = 1; i <= 16; ++i) {
            const Vec2 p = point(curve_of(part, piece), piece.t0 + i / 16.0 * (piece.t1 - piece.t0));
            for (int axis : {0, 1})
                if ((p - last)[axis] * along[axis] < 0 && std::abs((p - last)[axis]) > 4e-15) ++count;
            last = p;
        }
    }
    return count;
}

constexpr double tolerance = 1e-14;  // a few roundings of coordinates up to 5

TEST(Monotone, PiecesShareTheirEndsBitForBit) {
    for (const Part& part : parts()) EXPECT_EQ(chain_problem(part, monotone_pieces(part)), "");
}

TEST(Monotone, PiecesAreMonotone) {
    for (const Part& part : parts()) EXPECT_EQ(backward_steps(part, monotone_pieces(part)), 0);
}

TEST(Monotone, OneVariableFormsAgreeWithTheCurve) {
    for (const Part& part : parts()) EXPECT_LT(form_error(part, monotone_pieces(part)), tolerance);
}

TEST(Monotone, EndsAreOnTheCurve) {
    for (const Part& part : parts())
        for (const MonotonePiece& piece : monotone_pieces(part)) {
            EXPECT_LT((point(curve_of(part, piece), piece.t0) - piece.from).norm(), tolerance);
            EXPECT_LT((point(curve_of(part, piece), piece.t1) - piece.to).norm(), tolerance);
        }
}

/// Extreme points of a circle have the extreme coordinate exactly: a grid line through it touches and does not cross.
TEST(Monotone, ExtremePointsAreExact) {
    const Pieces pieces = monotone_pieces(disc(0.3, 2 * pi));
    ASSERT_EQ(pieces.size(), 5u);
    EXPECT_EQ(pieces[0].to, Vec2(1, 3.5));
    EXPECT_EQ(pieces[1].to, Vec2(-0.5, 2));
    EXPECT_EQ(pieces[2].to, Vec2(1, 0.5));
    EXPECT_EQ(pieces[3].to, Vec2(2.5, 2));
    EXPECT_EQ(pieces[0].x_side, 1);
    EXPECT_EQ(pieces[1].x_side, -1);
    EXPECT_EQ(pieces[1].y_side, 1);
    EXPECT_EQ(pieces[2].y_side, -1);
}

TEST(Monotone, FormsAreClampedToTheEnds) {
    const Pieces pieces = monotone_pieces(disc(0, 2 * pi));
    EXPECT_EQ(y_at(pieces[0], 2.5 + 1e-9), 2);
    EXPECT_EQ(x_at(pieces[0], 3.5 + 1e-9), 1);
    EXPECT_EQ(y_at({0, 0, 1, {0, 0}, {2, 1}}, 3), 1);
    EXPECT_EQ(x_at({0, 0, 1, {0, 0}, {2, 1}}, -3), 0);
    EXPECT_EQ(parameter_at(pieces[1], {2, 2}, disc(0, 2 * pi).edges[0].curve), pieces[1].t0);
}

TEST(Monotone, APartWithoutLoopsIsOneLoop) {
    Part part;
    for (const Segment& side : {Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {0, 1}}, Segment{{0, 1}, {0, 0}}})
        part.edges.push_back({side, "", ""});
    const Pieces pieces = monotone_pieces(part);
    ASSERT_EQ(pieces.size(), 3u);
    EXPECT_EQ(pieces[2].to, pieces[0].from);
    EXPECT_TRUE(contains(pieces, {0.25, 0.25}));
    EXPECT_FALSE(contains(pieces, {0.75, 0.75}));
}

/// Joints of imports are open by up to the merge length: the vertex is then the next edge's first point, for both edges.
TEST(Monotone, OpenJointsAreClosed) {
    const double gap = 1e-9;
    Part part;
    add_loop(part, {Segment{{0, 0}, {1, 0}}, Segment{{1 + gap, gap}, {0, 1}}, Segment{{0, 1}, {0, -gap}}});
    const Pieces pieces = monotone_pieces(part);
    EXPECT_EQ(chain_problem(part, pieces), "");
    EXPECT_EQ(pieces[0].to, Vec2(1 + gap, gap));
    EXPECT_EQ(pieces[2].to, Vec2(0, 0));
}

TEST(Monotone, ContainsAgreesWithThePartsOwn) {
    std::mt19937 random(19);
    std::uniform_real_distribution<double> any(-3, 5);
    for (const Part& part : parts()) {
        const Pieces pieces = monotone_pieces(part);
        for (int k = 0; k < 50; ++k) {
            const Vec2 p(any(random), any(random));
            EXPECT_EQ(contains(pieces, p), contains(part, p));
        }
    }
}

// ---- ellipses and splines ----

/// Parts of size 3 whose points take some ten roundings; the parameter found may add those of a slow stretch of the curve.
constexpr double general_tolerance = 1e-13;

std::vector<Part> general_parts() {
    test::Random random(29);
    std::vector<Part> all;
    for (int k = 0; k < 80; ++k) all.push_back(test::random_part(3 + k % 4, random));
    return all;
}

TEST(Monotone, GeneralPiecesShareTheirEndsBitForBit) {
    for (const Part& part : general_parts()) EXPECT_EQ(chain_problem(part, monotone_pieces(part)), "");
}

TEST(Monotone, GeneralPiecesAreMonotone) {
    for (const Part& part : general_parts()) EXPECT_EQ(backward_steps(part, monotone_pieces(part)), 0);
}

TEST(Monotone, OneVariableFormsAgreeWithGeneralCurves) {
    for (const Part& part : general_parts()) EXPECT_LT(form_error(part, monotone_pieces(part)), general_tolerance);
}

/// No piece runs across a knot.
TEST(Monotone, PiecesEndAtKnots) {
    int n_knots = 0;
    for (const Part& part : general_parts()) {
        const Pieces pieces = monotone_pieces(part);
        for (std::size_t e = 0; e < part.edges.size(); ++e)
            for (double t : smoothness_breaks(part.edges[e].curve)) {
                ++n_knots;
                EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(),
                                        [&](const MonotonePiece& p) { return p.edge == static_cast<int>(e) && p.t1 == t; }));
            }
    }
    EXPECT_GT(n_knots, 100);
}

/// y = x^2 from (0, 0) to (1, 1), by its one-variable form and both derivatives.
TEST(Monotone, FormsOfAParabola) {
    Part part;
    add_loop(part, {bezier_curve({{0, 0}, {0.5, 0}, {1, 1}}, {}), Segment{{1, 1}, {0, 0}}});
    const MonotonePiece piece = monotone_pieces(part)[0];
    for (double x : {0.125, 0.3, 0.77, 1.0}) {
        EXPECT_NEAR(y_at(piece, x), x * x, 1e-15);
        EXPECT_NEAR(x_at(piece, x * x), x, 1e-15);
        EXPECT_NEAR(dy_dx(piece, x), 2 * x, 1e-14);
        EXPECT_NEAR(dx_dy(piece, x * x), 0.5 / x, 1e-14);
        const LineMeeting at = line_meeting(piece, 0, x, part.edges[0].curve);
        EXPECT_EQ(at.at.x(), x);
        EXPECT_NEAR(at.t, x, 1e-15);
    }
    EXPECT_EQ(dy_dx(piece, 0), 0);
    EXPECT_TRUE(std::isinf(dx_dy(piece, 0)));
    EXPECT_EQ(y_at(piece, 1.5), 1);
    EXPECT_EQ(x_at(piece, -0.5), 0);
}

TEST(Monotone, SlopesOfLinesAndCircles) {
    EXPECT_DOUBLE_EQ(dy_dx({0, 0, 1, {0, 0}, {2, 1}}, 0.3), 0.5);
    EXPECT_DOUBLE_EQ(dx_dy({0, 0, 1, {0, 0}, {2, 1}}, 0.3), 2);
    const MonotonePiece quarter = monotone_pieces(disc(0, 2 * pi))[0];  // about (1, 2), of radius 1.5
    EXPECT_NEAR(dy_dx(quarter, 1 + 0.9), -0.9 / 1.2, 1e-14);
    EXPECT_NEAR(dx_dy(quarter, 2 + 1.2), -1.2 / 0.9, 1e-14);
    EXPECT_TRUE(std::isinf(dy_dx(quarter, 2.5)));
}

/// Random points, and the heights of all ends: where the half-open rule decides.
TEST(Monotone, SlabsGiveTheSameAnswer) {
    test::Random random(43);
    for (int k = 0; k < 70; ++k) {
        const Part part = test::random_part(k % test::n_part_kinds, random);
        const SlabbedPieces slabs = slabbed(monotone_pieces(part));
        EXPECT_LE(slabs.piece.size(), 3 * slabs.pieces.size() + 2);
        Box2 around = bounding_box(part);
        around.min.array() -= 0.1;
        around.max.array() += 0.1;
        int n_inside = 0;
        for (int i = 0; i < 40; ++i) {
            Vec2 p = test::anywhere_in(around, random);
            if (i % 2 == 0) p.y() = slabs.pieces[random() % slabs.pieces.size()].from.y();
            EXPECT_EQ(contains(slabs, p), contains(slabs.pieces, p));
            n_inside += contains(slabs, p);
        }
        EXPECT_GT(n_inside, 0);
    }
}

TEST(MonotoneChecks, NoticeAFault) {
    const Part part = slot();
    const Pieces good = monotone_pieces(part);
    Pieces pieces = good;
    pieces[1].from.x() = std::nextafter(pieces[1].from.x(), 9.0);
    EXPECT_NE(chain_problem(part, pieces), "");
    pieces = good;
    pieces.pop_back();
    EXPECT_NE(chain_problem(part, pieces), "");
    pieces = good;
    pieces[1].radius += 3 * tolerance;
    pieces[1].center.y() += 3 * tolerance;
    EXPECT_GT(form_error(part, pieces), tolerance);
    pieces = good;
    pieces[1].t1 = 0.9;  // beyond the extreme point
    pieces[1].to = point(curve_of(part, pieces[1]), 0.9);
    EXPECT_GT(backward_steps(part, pieces), 0);
}

}  // namespace

}  // namespace monotone_test
