// SPDX-License-Identifier: GPL-3.0-or-later
// What exact arithmetic says of outlines, against what their making says, and against our own checks.
#include "geometry/csg/exact_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/csg/loops.hpp"
#include "geometry/curves/elliptic_arc.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/csg/outlines.hpp"

namespace exact_outline_test {

namespace {

using namespace abut::geometry;
using namespace abut::geometry::outlines;
constexpr double pi = std::numbers::pi;

Part part_of(const std::vector<std::vector<Curve>>& loops) {
    Part part;
    for (const std::vector<Curve>& curves : loops) {
        part.loops.emplace_back();
        for (const Curve& curve : curves) {
            part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back({curve, "e" + std::to_string(part.edges.size()), "", true, 0});
        }
    }
    return part;
}

std::vector<Curve> backwards(const std::vector<Curve>& loop) {
    std::vector<Curve> curves;
    for (auto curve = loop.rbegin(); curve != loop.rend(); ++curve) curves.push_back(reversed(*curve));
    return curves;
}

TEST(ExactOutline, RegionsOfEveryCurveAreRight) {
    EXPECT_FALSE(exact_fault(part_of({box(0, 0, 4, 3)})));
    EXPECT_FALSE(exact_fault(part_of({disc(0, 0, 1)})));
    EXPECT_FALSE(exact_fault(part_of({box(0, 0, 4, 3), disc(1, 1, 0.5, -1), disc(3, 2, 0.25, -1)})));
    EXPECT_FALSE(exact_fault(part_of({disc(0, 0, 3), disc(0, 0, 2, -1), disc(0, 0, 1)})));
    EXPECT_FALSE(exact_fault(part_of({{EllipticArc{{0, 0}, {2, 1}, {-0.5, 1}, 0, 2 * pi}}})));
    EXPECT_FALSE(exact_fault(part_of(
        {{Arc{{0, 0}, 1, pi / 2, pi}, Segment{{0, -1}, {3, -1}}, Arc{{3, 0}, 1, -pi / 2, pi}, Segment{{3, 1}, {0, 1}}}})));
}

TEST(ExactOutline, LoopsMayTouchAtACorner) {
    EXPECT_FALSE(exact_fault(part_of({box(0, 0, 1, 1), box(1, 1, 2, 2)})));
}

TEST(ExactOutline, WhatTangentEdgesDoNextToTheirCornerIsRounding) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(0, 2 * pi), radius(1, 9), shift(-1, 1);
    for (int k = 0; k < 500; ++k) {
        const double r = radius(random), s = r + radius(random);
        const double a = std::acos(1 - 1 / s), b = std::acos(1 - 1 / r);  // both rise as far as x = 1
        const Curve low = Arc{{s, 0}, s, pi, -a}, high = Arc{{r, 0}, r, pi, -b};
        Part part = part_of({{high, Segment{point(high, 1), point(low, 1)}, reversed(low)}});
        if (area(part) < 0) part = part_of({{low, Segment{point(low, 1), point(high, 1)}, reversed(high)}});
        const double t = angle(random);
        part = transformed(part, std::cos(t), std::sin(t), {shift(random), shift(random)});
        EXPECT_FALSE(exact_fault(part)) << k;
    }
}

TEST(ExactOutline, FaultsAreSaidWithTheirPlace) {
    const auto crossing = exact_fault(part_of({closed({{0, 0}, {2, 0}, {0, 2}, {2, 2}})}));
    ASSERT_TRUE(crossing);
    EXPECT_NE(crossing->what.find("crosses"), std::string::npos);
    EXPECT_NEAR((crossing->at - Vec2(1, 1)).norm(), 0, 1e-14);

    const auto ends_on = exact_fault(part_of({box(0, 0, 4, 4), closed({{4, 2}, {2, 3}, {2, 1}})}));
    ASSERT_TRUE(ends_on);
    EXPECT_NEAR((ends_on->at - Vec2(4, 2)).norm(), 0, 1e-14);

    // A circle through the side of a box by one unit in the last place.
    EXPECT_TRUE(exact_fault(part_of({box(0, 0, 4, 4), disc(1, 2, std::nextafter(1.0, 2.0), -1)})));
    EXPECT_FALSE(exact_fault(part_of({box(0, 0, 4, 4), disc(1, 2, std::nextafter(1.0, 0.0), -1)})));

    for (const Part& wrong : {part_of({backwards(box(0, 0, 1, 1))}), part_of({box(0, 0, 4, 4), box(1, 1, 2, 2)}),
                              part_of({box(0, 0, 1, 1), backwards(box(2, 0, 3, 1))})}) {
        const auto turned = exact_fault(wrong);
        ASSERT_TRUE(turned);
        EXPECT_NE(turned->what.find("wrong way round"), std::string::npos);
    }
    EXPECT_TRUE(exact_fault(part_of({box(0, 0, 1, 1), box(0, 0, 1, 1)}))) << "drawn twice";
}

/// Corners with random coordinates, joined by lines, arcs and splines: a third of these outlines is simple.
std::vector<Curve> random_loop(std::mt19937& random) {
    std::uniform_real_distribution<double> coordinate(-1, 1), bulge(-0.6, 0.6);
    std::uniform_int_distribution<int> count(3, 5), kind(0, 3);
    std::vector<Vec2> corners(static_cast<std::size_t>(count(random)));
    for (Vec2& p : corners) p = {coordinate(random), coordinate(random)};
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 p = corners[i], q = corners[(i + 1) % corners.size()], across(p.y() - q.y(), q.x() - p.x());
        const double b = bulge(random);
        switch (kind(random)) {
            case 0: {
                const Vec2 c = 0.5 * (p + q) + (1 - b * b) / (4 * b) * across;
                curves.push_back(Arc{c, (p - c).norm(), std::atan2(p.y() - c.y(), p.x() - c.x()), 4 * std::atan(b)});
                break;
            }
            case 1:
                curves.push_back(bezier_curve({p, 0.5 * (p + q) + b * across, q}, {}));
                break;
            default:
                curves.push_back(Segment{p, q});
        }
    }
    return curves;
}

/// Both look at the same random outlines; ours turns them the right way round first.
void expect_agreement(unsigned seed, int n) {
    std::mt19937 random(seed);
    int n_right = 0;
    for (int k = 0; k < n; ++k) {
        const std::vector<Curve> loop = random_loop(random);
        Loops loops{{{}}};
        for (std::size_t i = 0; i < loop.size(); ++i) loops.loops.front().push_back({loop[i], "e" + std::to_string(i), ""});
        const bool is_right = boundary_of(loops, "").problems.empty();
        n_right += is_right;
        const Part part = part_of({loop});
        const auto fault = exact_fault(area(part) > 0 ? part : part_of({backwards(loop)}));
        EXPECT_EQ(!fault, is_right) << "outline " << k << (fault ? fault->what : "");
    }
    EXPECT_GT(n_right, n / 5);
    EXPECT_LT(n_right, 4 * n / 5);
}

/// A region with a few random loops in it, some of which touch, lie in each other, cross, or run the wrong way round. All
/// coordinates are small multiples of a quarter, turned by an angle: corners are shared, circles touch, lines are collinear.
Part random_region(std::mt19937& random) {
    std::uniform_int_distribution<int> count(1, 3), kind(0, 5), place(1, 24), size(1, 6), turns(0, 7);
    std::vector<std::vector<Curve>> loops{box(0, 0, 7, 7)};
    for (int n = count(random); n > 0; --n) {
        const double x = 0.25 * place(random), y = 0.25 * place(random), r = 0.25 * size(random), s = 0.25 * size(random);
        std::vector<Curve> loop;
        switch (kind(random)) {
            case 0:
                loop = disc(x, y, r);
                break;
            case 1:  // a slot
                loop = {Arc{{x, y}, r, pi / 2, pi}, Segment{{x, y - r}, {x + s, y - r}}, Arc{{x + s, y}, r, -pi / 2, pi},
                        Segment{{x + s, y + r}, {x, y + r}}};
                break;
            case 2:
                loop = closed({{x, y}, {x + r, y}, {x + s, y + s}});
                break;
            case 3:  // half a disc
                loop = {Arc{{x, y}, r, 0, pi}, Segment{{x - r, y}, {x + r, y}}};
                break;
            case 4:
                loop = {EllipticArc{{x, y}, {r, 0}, {0, s}, 0, 2 * pi}};
                break;
            default:
                loop = box(x, y, x + r, y + s);
        }
        loops.push_back(turns(random) == 0 ? loop : backwards(loop));
    }
    const double angle = turns(random) < 4 ? 0 : place(random);
    return transformed(part_of(loops), std::cos(angle), std::sin(angle), {0.1 * size(random), 0});
}

/// The proof must hold against the sweep of the whole outline, and nearly all that is right be proved.
template <class Make>
void expect_proofs(int n, const Make& make) {
    int n_right = 0, n_proved = 0;
    for (int k = 0; k < n; ++k) {
        const Part part = make();
        const bool is_right = !swept_fault(part), is_proved = is_surely_right(part);
        EXPECT_TRUE(is_right || !is_proved) << "outline " << k;
        n_right += is_right;
        n_proved += is_proved;
    }
    EXPECT_GE(n_proved, 0.98 * n_right);
    EXPECT_GT(n_right, n / 10);
    EXPECT_LT(n_right, n * 9 / 10);
}

void expect_all_proofs(unsigned seed, int n) {
    std::mt19937 random(seed);
    expect_proofs(n, [&] { return random_region(random); });
    expect_proofs(n, [&] {
        const std::vector<Curve> loop = random_loop(random);
        return part_of({area(part_of({loop})) > 0 ? loop : backwards(loop)});
    });
}

TEST(ExactOutline, WhatIsProvedTheSweepFindsRight) {
    expect_all_proofs(24, 1000);
}

TEST(LongExactOutline, WhatIsProvedTheSweepFindsRight) {
    expect_all_proofs(25, 10000);
}

/// A plate with rows of slots.
TEST(ExactOutline, LargeOutlinesAreProved) {
    std::vector<std::vector<Curve>> loops{box(-1, -1, 80, 80)};
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            const double x = 2 * i, y = 2 * j;
            loops.push_back(backwards({Arc{{x, y}, 0.4, pi / 2, pi}, Segment{{x, y - 0.4}, {x + 0.6, y - 0.4}},
                                       Arc{{x + 0.6, y}, 0.4, -pi / 2, pi}, Segment{{x + 0.6, y + 0.4}, {x, y + 0.4}}}));
        }
    EXPECT_TRUE(is_surely_right(part_of(loops)));
    loops.push_back(loops[700]);
    EXPECT_FALSE(is_surely_right(part_of(loops))) << "one slot twice";
    loops.back() = backwards(disc(0.3, 0, 0.1));
    EXPECT_FALSE(is_surely_right(part_of(loops))) << "a hole in a hole";
    loops.back() = disc(0.3, 0, 0.1);
    EXPECT_TRUE(is_surely_right(part_of(loops))) << "an island";
}

TEST(ExactOutline, AgreesWithOurOwnChecksOnRandomRegions) {
    expect_agreement(22, 1000);
}

TEST(LongExactOutline, AgreesWithOurOwnChecksOnRandomRegions) {
    expect_agreement(23, 10000);
}

}  // namespace

}  // namespace exact_outline_test
