// SPDX-License-Identifier: GPL-3.0-or-later
// E1 of data/README.md: a constant stress field must come out exactly, wherever the grid cuts the part.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/cells/random_parts.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::patch_test {
namespace {

using geometry::test::between;
using geometry::test::Random;

constexpr double exx = 1e-3, eyy = -2e-3, gxy = 1.5e-3, E = 1e5, nu = 0.3;

struct Exact {
    double xx, yy, xy;
};
constexpr Exact plane_stress_field{43.956043956043956, -186.81318681318681, 57.69230769230769};
constexpr Exact plane_strain_field{19.230769230769230, -211.53846153846155, 57.69230769230769};

struct Shape {
    std::string geometry;                // a node of the scene format
    std::vector<std::string> tractions;  // loads that carry the exact stress
    Vec2 centroid;
    std::vector<Vec2> probes;
};

std::string traction(const std::string& on, const Exact& s, double nx, double ny) {
    return R"({"on": "part/)" + on + R"(", "traction": )" + test::pair_text(s.xx * nx + s.xy * ny, s.xy * nx + s.yy * ny) + "}";
}

Shape polygon(const std::vector<Vec2>& points, const Vec2& centroid, const Exact& s) {
    Shape shape{R"({"polygon": [)", {}, centroid, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
        const Vec2 n = Vec2(b.y() - a.y(), a.x() - b.x()).normalized();
        shape.geometry += (i ? ", " : "") + test::pair_text(a.x(), a.y());
        shape.tractions.push_back(traction("e" + std::to_string(i), s, n.x(), n.y()));
        shape.probes.push_back(0.999 * a + 0.001 * centroid);
        shape.probes.push_back(0.5 * a + 0.5 * centroid);
    }
    shape.geometry += "]}";
    return shape;
}

Vec2 moved(double x, double y) {
    const double a = 17 * M_PI / 180;
    return {std::cos(a) * x - std::sin(a) * y + 0.137, std::sin(a) * x + std::cos(a) * y - 0.211};
}

Shape square(const Exact& s) {
    return polygon({moved(0, 0), moved(1, 0), moved(1, 1), moved(0, 1)}, moved(0.5, 0.5), s);
}

Shape ell(const Exact& s) {
    Shape shape = polygon({moved(0, 0), moved(1, 0), moved(1, 0.5), moved(0.5, 0.5), moved(0.5, 1), moved(0, 1)},
                          moved(5.0 / 12, 5.0 / 12), s);
    return shape;
}

Shape disc(const Exact& s) {
    Shape shape{R"({"circle": {"center": [0.3, 0.2], "radius": 0.5}})", {}, {0.3, 0.2}, {}};
    const std::string nx = "(x-0.3)/0.5", ny = "(y-0.2)/0.5";
    const auto component = [&](double a, double b) {
        return "\"" + test::number(a) + "*" + nx + " + (" + test::number(b) + ")*" + ny + "\"";
    };
    shape.tractions = {R"({"on": "part/circle", "traction": [)" + component(s.xx, s.xy) + ", " + component(s.xy, s.yy) + "]}"};
    for (int k = 0; k < 8; ++k) shape.probes.push_back(shape.centroid + 0.4999 * Vec2(std::cos(0.7 * k), std::sin(0.7 * k)));
    return shape;
}

std::string scene_text(const Shape& shape, const std::string& analysis, const std::string& conditions, const std::string& grid,
                       int degree) {
    std::string probes;
    for (const Vec2& p : shape.probes)
        probes +=
            (probes.empty() ? "" : ", ") + std::string(R"({"part": "part", "at": )") + test::pair_text(p.x(), p.y()) + "}";
    return R"({"abut": 1, "analysis": ")" + analysis +
           R"(", "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [{"name": "part", "material": "m", "geometry": )" +
           shape.geometry + "}], " + conditions + R"(, "accuracy": {"degree": )" + std::to_string(degree) +
           R"(, "grids": {"part": )" + grid + R"(}}, "output": {"probes": [)" + probes + "]}}";
}

std::string grid_text(double offset, double angle, const std::string& refine = "") {
    return R"({"cells": [7, 6], "offset": )" + test::pair_text(offset, 0.6 * offset) + R"(, "angle": )" + test::number(angle) +
           refine + "}";
}

/// Boxes somewhere on the shapes, their borders anywhere in and along them.
const std::string halved_boxes = R"(, "refine": [{"from": [0.2, 0.1], "to": [0.45, 0.2], "levels": 4},
                                                 {"from": [0.6, 0.5], "to": [0.62, 2], "levels": 2},
                                                 {"from": [-0.2, 0.3], "to": [0.1, 0.9], "levels": 1}])";

std::string by_tractions(const Shape& shape) {
    std::string loads;
    for (const std::string& t : shape.tractions) loads += (loads.empty() ? "" : ", ") + t;
    return R"("supports": [{"part": "part", "rigid": {"translation": [0, 0], "rotation": 0}}], "loads": [)" + loads + "]";
}

std::string by_displacements() {
    return R"("supports": [{"on": "part/*", "displacement": {"x": "1e-3*x + 0.75e-3*y", "y": "0.75e-3*x - 2e-3*y"}}], "loads": [])";
}

void expect_field(const Result& r, const Exact& s, const Vec2& origin, double tolerance, const std::string& what) {
    ASSERT_EQ(r.status, "ok") << what << ": " << r.message;
    ASSERT_FALSE(r.probes.empty());
    const double largest = std::hypot(s.xx, s.yy, s.xy);
    for (const ProbeResult& p : r.probes) {
        const Vec2 d = p.at - origin;
        const Vec2 u(exx * d.x() + gxy / 2 * d.y(), gxy / 2 * d.x() + eyy * d.y());
        EXPECT_NEAR(p.stress.xx, s.xx, tolerance * largest) << what;
        EXPECT_NEAR(p.stress.yy, s.yy, tolerance * largest) << what;
        EXPECT_NEAR(p.stress.xy, s.xy, tolerance * largest) << what;
        EXPECT_LT((p.displacement - u).norm(), tolerance * 2e-3) << what;
    }
}

/// Offsets from a cell to a sliver of 1e-8 of one.
const std::vector<double> offsets{0.0, 0.05, 0.0713, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, -1e-3, -1e-8};

TEST(Patch, TractionsAndRigidHoldGiveTheExactField) {
    for (const auto& [name, shape] :
         {std::pair{"square", square(plane_stress_field)}, {"L", ell(plane_stress_field)}, {"disc", disc(plane_stress_field)}})
        for (int degree : {1, 2, 3})
            for (double offset : offsets)
                for (double angle : {0.0, 31.0}) {
                    const std::string what =
                        std::string(name) + " degree " + std::to_string(degree) + " offset " + test::number(offset);
                    const Result r =
                        test::answer(scene_text(shape, "plane_stress", by_tractions(shape), grid_text(offset, angle), degree));
                    expect_field(r, plane_stress_field, shape.centroid, 1e-9, what);
                }
}

TEST(Patch, HalvedCellsGiveTheExactField) {
    for (const auto& [name, shape] :
         {std::pair{"square", square(plane_stress_field)}, {"L", ell(plane_stress_field)}, {"disc", disc(plane_stress_field)}})
        for (int degree : {1, 2, 3, 4})
            for (double offset : {0.0, 0.0713, 1e-4, 1e-8})
                for (const std::string& conditions : {by_tractions(shape), by_displacements()}) {
                    const std::string what =
                        std::string(name) + " degree " + std::to_string(degree) + " offset " + test::number(offset);
                    const std::string grid = grid_text(offset, 31, halved_boxes);
                    const Result r = test::answer(scene_text(shape, "plane_stress", conditions, grid, degree));
                    const bool held = conditions == by_displacements();
                    expect_field(r, plane_stress_field, held ? Vec2(0, 0) : shape.centroid, held ? 1e-6 : 1e-9, what);
                    EXPECT_GT(
                        r.unknowns,
                        test::answer(scene_text(shape, "plane_stress", conditions, grid_text(offset, 31), degree)).unknowns);
                }
}

TEST(Patch, PlaneStrain) {
    const Shape shape = square(plane_strain_field);
    expect_field(test::answer(scene_text(shape, "plane_strain", by_tractions(shape), grid_text(0.03, 10), 2)),
                 plane_strain_field, shape.centroid, 1e-9, "plane strain");
}

TEST(Patch, NitscheGivesTheExactField) {
    for (const auto& [name, shape] :
         {std::pair{"square", square(plane_stress_field)}, {"L", ell(plane_stress_field)}, {"disc", disc(plane_stress_field)}})
        for (int degree : {1, 2, 3})
            for (double offset : offsets) {
                const std::string what =
                    std::string(name) + " degree " + std::to_string(degree) + " offset " + test::number(offset);
                const Result r =
                    test::answer(scene_text(shape, "plane_stress", by_displacements(), grid_text(offset, 12), degree));
                expect_field(r, plane_stress_field, {0, 0}, 1e-6, what);
            }
}

/// A star of 5 to 9 corners, near or far from the middle, so that most are re-entrant somewhere; or a square with a slot
/// 1e-6 to 0.1 wide.
Shape random_shape(Random& random) {
    std::vector<Vec2> points;
    if (std::bernoulli_distribution(0.3)(random)) {
        const double width = std::pow(10, between(-6, -1, random)), at = between(0.3, 0.7, random),
                     depth = between(0.2, 0.8, random);
        for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(at + width, 1), Vec2(at + width, 1 - depth),
                              Vec2(at, 1 - depth), Vec2(at, 1), Vec2(0, 1)})
            points.push_back(moved(p.x(), p.y()));
    } else {
        const int n = std::uniform_int_distribution<int>(5, 9)(random);
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * M_PI * (k + between(-0.3, 0.3, random)) / n, radius = between(0.25, 0.7, random);
            points.push_back(moved(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)));
        }
    }
    double twice_area = 0;
    Vec2 moment(0, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
        const double cross = a.x() * b.y() - a.y() * b.x();
        twice_area += cross;
        moment += cross * (a + b) / 3;
    }
    Shape shape = polygon(points, moment / twice_area, plane_stress_field);
    // polygon() asks for values towards the centroid, which may lie outside of these
    shape.probes.clear();
    for (std::size_t i = 0; i < points.size(); ++i) shape.probes.push_back((points[i] + points[(i + 1) % points.size()]) / 2);
    return shape;
}

/// Boxes around places on the shape's boundary, in the axes of a grid at this angle.
std::string random_boxes(const Shape& shape, double angle, Random& random) {
    const double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
    std::string boxes;
    for (int k = std::uniform_int_distribution<int>(1, 4)(random); k > 0; --k) {
        const Vec2& p = shape.probes[std::uniform_int_distribution<std::size_t>(0, shape.probes.size() - 1)(random)];
        const Vec2 place(c * p.x() + s * p.y(), c * p.y() - s * p.x()),
            below(between(0.01, 0.3, random), between(0.01, 0.3, random)),
            above(between(0.01, 0.3, random), between(0.01, 0.3, random));
        boxes += (boxes.empty() ? "" : ", ") +
                 (R"({"from": )" + test::pair_text(place.x() - below.x(), place.y() - below.y())) + R"(, "to": )" +
                 test::pair_text(place.x() + above.x(), place.y() + above.y()) + R"(, "levels": )" +
                 std::to_string(std::uniform_int_distribution<int>(1, 5)(random)) + "}";
    }
    return R"(, "refine": [)" + boxes + "]";
}

/// Any shape, cut and slot, any tree, all degrees.
TEST(LongPatch, RandomTreesGiveTheExactField) {
    for (unsigned seed = 0; seed < 1000 && !testing::Test::HasFailure(); ++seed) {
        Random random(seed);
        const Shape shape = random_shape(random);
        const int degree = 1 + static_cast<int>(seed % 4);
        const bool held = seed / 4 % 2 != 0;
        const double offset = std::pow(10, -between(0, 9, random)), angle = between(-45, 45, random);
        const Result r = test::answer(scene_text(shape, "plane_stress", held ? by_displacements() : by_tractions(shape),
                                                 grid_text(offset, angle, random_boxes(shape, angle, random)), degree));
        expect_field(r, plane_stress_field, held ? Vec2(0, 0) : shape.centroid, held ? 1e-6 : 1e-9,
                     "seed " + std::to_string(seed));
    }
}

/// A wrong load must be seen: the checks above can fail.
TEST(Patch, AWrongTractionIsSeen) {
    Shape shape = square(plane_stress_field);
    shape.tractions[0] =
        traction("e0", {plane_stress_field.xx, plane_stress_field.yy, 1.001 * plane_stress_field.xy}, 0.3, -0.95);
    const Result r = test::answer(scene_text(shape, "plane_stress", by_tractions(shape), grid_text(0.03, 10), 2));
    double worst = 0;
    for (const ProbeResult& p : r.probes) worst = std::max(worst, std::abs(p.stress.xy - plane_stress_field.xy));
    EXPECT_GT(worst, 1e-6 * 203);
}

}  // namespace
}  // namespace abut::patch_test
