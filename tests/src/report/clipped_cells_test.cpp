// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/clipped_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/scene/read_scene.hpp"

namespace abut::clipped_cells_test {
namespace {

using report::ClippedCells;

/// A part by its geometry as a scene has it.
geometry::Part part_of_text(const std::string& shape) {
    return read_scene_text(
               R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}}, "parts": [{"name": "p", "material": "m", "geometry": )" +
                   shape + "}]}",
               "s.json")
        .parts[0]
        .part;
}

/// Components that are linear in the place, each another one: what is linear between corners is exact for them.
FieldSample linear(const Vec2& p) {
    const auto f = [&](double a, double b, double c) { return a * p.x() + b * p.y() + c; };
    return {p, {f(1, 0.5, 2), f(-0.3, 1, 0)}, {f(2, 3, 1), f(-1, 4, 0.5), f(0.1, -0.2, 3), f(5, 0, -1)}};
}

struct PatchGrid {
    Vec2 low;
    double side, angle;
    Vec2 at(double i, double j) const {
        const Vec2 p = low + side * Vec2(i, j);
        return {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
    }
};

/// All patches of a grid around the part, and its boundary in short chords.
PartField field_of(const geometry::Part& part, const PatchGrid& grid, int n) {
    PartField field;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) field.samples.push_back(linear(grid.at(i, j)));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int k = j * (n + 1) + i;
            field.patches.push_back({{k, k + 1, k + n + 2, k + n + 1}});
        }
    for (const geometry::Loop& loop : part.loops) {
        field.boundary.emplace_back();
        for (int e : loop.edges) {
            const geometry::Curve& curve = curve_of(part, e);
            const int steps = std::max(1, static_cast<int>(std::ceil(turning(curve, 0, 1) / 0.06)));
            for (int q = 0; q < steps; ++q)
                field.boundary.back().push_back(linear(point(curve, static_cast<double>(q) / steps)));
        }
    }
    return field;
}

double polygon_area(const std::vector<FieldSample>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) sum += geometry::cross(loop[i].at, loop[(i + 1) % loop.size()].at) / 2;
    return sum;
}

void expect_fills_the_part(const geometry::Part& part, const PatchGrid& grid, int n) {
    const PartField field = field_of(part, grid, n);
    const ClippedCells mesh = report::clipped_cells(field, part);
    double area = 0, expected = 0;
    for (const auto& loop : field.boundary) expected += polygon_area(loop);
    bool is_first_kind = true;
    for (const std::vector<int>& cell : mesh.cells) {
        ASSERT_TRUE(cell.size() == 3 || cell.size() == 4);
        EXPECT_TRUE(is_first_kind || cell.size() == 4) << "triangles come first";
        is_first_kind = cell.size() == 3;
        std::vector<FieldSample> corners;
        for (int k : cell) corners.push_back(mesh.points.at(static_cast<std::size_t>(k)));
        const double own = polygon_area(corners);
        EXPECT_GT(own, 0);
        area += own;
    }
    // what is left out: rounding, and strips between chord and arc where no chord passes
    EXPECT_NEAR(area, expected, 1e-6 * expected);
    for (const FieldSample& s : mesh.points) {
        const FieldSample exact = linear(s.at);
        EXPECT_LT((s.displacement - exact.displacement).norm(), 1e-11);
        EXPECT_NEAR(s.stress.xx, exact.stress.xx, 1e-11);
        EXPECT_NEAR(s.stress.xy, exact.stress.xy, 1e-11);
        EXPECT_NEAR(s.stress.zz, exact.stress.zz, 1e-11);
    }
}

const char* shapes[] = {
    R"({"rectangle": {"min": [-1, -1], "max": [1, 1]}})", R"({"circle": {"center": [0, 0], "radius": 1}})",
    R"({"difference": [{"circle": {"center": [0, 0], "radius": 1}, "name": "o"}, {"circle": {"center": [0.1, 0], "radius": 0.8}, "name": "i"}]})",
    R"({"polygon": [[-1, -1], [1, -1], [1, -0.5], [-0.5, -0.5], [-0.5, 1], [-1, 1]]})",
    R"({"difference": [{"rectangle": {"min": [-1, -1], "max": [1, 1]}, "name": "o"}, {"slot": {"from": [-0.6, -0.5], "to": [0.6, 0.5], "radius": 0.01}, "name": "s"}]})"};

TEST(ClippedCells, FillPartsWhereverThePatchesLie) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const char* shape : shapes) {
        const geometry::Part part = part_of_text(shape);
        for (int k = 0; k < 25; ++k) {
            const int n = 2 + static_cast<int>(40 * unit(random));
            const PatchGrid grid{Vec2(-1.6 - 0.1 * unit(random), -1.6 - 0.1 * unit(random)), 3.3 / n, 6.3 * unit(random)};
            SCOPED_TRACE(std::string(shape) + ", grid " + std::to_string(k));
            expect_fills_the_part(part, grid, n);
        }
    }
}

TEST(ClippedCells, EdgesMayLieOnTheSidesOfPatches) {
    for (const char* shape : shapes)
        for (const double turn : {0.0, std::acos(0.0)}) {
            SCOPED_TRACE(shape);
            expect_fills_the_part(part_of_text(shape), {{-2, -2}, 0.125, turn}, 32);
        }
}

TEST(ClippedCells, NoFieldNoCells) {
    EXPECT_TRUE(report::clipped_cells({}, part_of_text(shapes[0])).cells.empty());
}

}  // namespace
}  // namespace abut::clipped_cells_test
