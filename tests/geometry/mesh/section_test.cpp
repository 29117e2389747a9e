// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "geometry/brep/part.hpp"
#include "geometry/dxf/dxf.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::section_test {
namespace {

std::vector<const SketchEntity*> of_body(const Drawing& drawing, const std::string& body) {
    std::vector<const SketchEntity*> found;
    for (const SketchEntity& entity : drawing.entities)
        if (entity.layer == body) found.push_back(&entity);
    return found;
}

/// By Green's theorem over the entities themselves: material on their left.
double enclosed(const Drawing& drawing) {
    double sum = 0;
    for (const SketchEntity& entity : drawing.entities) {
        const Vec2 a = point(entity.curve, 0), b = point(entity.curve, 1);
        sum += 0.5 * cross(a, b);
        if (const Arc* arc = std::get_if<Arc>(&entity.curve))
            sum += 0.5 * arc->radius * arc->radius * (arc->sweep - std::sin(arc->sweep));
    }
    return sum;
}

const Repair* find_repair(const Section& section, const std::string& text) {
    for (const Repair& repair : section.repairs)
        if (repair.what.find(text) != std::string::npos) return &repair;
    return nullptr;
}

void round_to_single(Mesh& mesh) {
    for (Vec3& v : mesh.vertices)
        for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(static_cast<float>(v[k]));
}

/// Corners of a plate with rounded ends of n facets each.
std::vector<Vec2> slot(double half_length, double radius, int n) {
    std::vector<Vec2> points;
    for (int side = 0; side < 2; ++side)
        for (int i = 0; i <= n; ++i) {
            const double a = std::numbers::pi * (side + static_cast<double>(i) / n) - std::numbers::pi / 2;
            points.push_back(Vec2(side == 0 ? half_length : -half_length, 0) + radius * Vec2(std::cos(a), std::sin(a)));
        }
    return points;
}

TEST(Section, DefaultPlaneIsTheMiddleOfTheThinnestDirection) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 high(10, 20, 30);
        high[axis] = 4;
        const SectionPlane plane = plane_of({}, {box({0, 0, 0}, high)});
        EXPECT_EQ(plane.axis, axis);
        EXPECT_EQ(plane.at, 2);
    }
    EXPECT_EQ(plane_of({}, {box({0, 0, 0}, {1, 1, 1})}).axis, 2);
    EXPECT_EQ(plane_of({}, {box({0, 0, 0}, {1, 1, 4}), box({0, 0, 4}, {1, 5, 5})}).axis, 0) << "all bodies together";
    EXPECT_EQ(plane_of({}, std::vector<Mesh>{}).at, 0);
}

TEST(Section, DefaultPlaneIsAcrossTheWalls) {
    // A prism of six sides along each axis in turn, longer than wide.
    for (int axis = 0; axis < 3; ++axis) {
        Mesh prism;
        for (const double height : {0.0, 30.0})
            for (int k = 0; k < 6; ++k) {
                Vec3 p;
                p[axis] = height;
                p[(axis + 1) % 3] = 5 * std::cos(k + 0.2);
                p[(axis + 2) % 3] = 5 * std::sin(k + 0.2);
                prism.vertices.push_back(p);
            }
        for (int k = 0; k < 6; ++k) {
            const int next = (k + 1) % 6;
            prism.triangles.push_back({k, next, 6 + next});
            prism.triangles.push_back({k, 6 + next, 6 + k});
            if (k >= 1 && k <= 4) prism.triangles.push_back({0, k + 1, k});
            if (k >= 1 && k <= 4) prism.triangles.push_back({6, 6 + k, 6 + k + 1});
        }
        EXPECT_EQ(plane_of({}, {prism}).axis, axis);
        EXPECT_EQ(plane_of({}, {prism}).at, 15);
    }
}

TEST(Section, ABoxGivesFourLinesOnEveryAxis) {
    const Mesh given = box({1, 2, 3}, {5, 12, 33}, "block");
    const std::vector<std::array<double, 4>> rectangles = {{2, 3, 12, 33}, {1, 3, 5, 33}, {1, 2, 5, 12}};
    for (int axis = 0; axis < 3; ++axis) {
        const Drawing drawing = section(bodies_of({given}), {axis, 4}, 0);
        ASSERT_EQ(drawing.entities.size(), 4u);
        Box2 bounds;
        for (std::size_t k = 0; k < 4; ++k) {
            const SketchEntity& entity = drawing.entities[k];
            EXPECT_EQ(entity.layer, "block");
            EXPECT_EQ(entity.block, "block");
            EXPECT_EQ(entity.kind, "SECTION");
            EXPECT_EQ(entity.name, "e" + std::to_string(k));
            EXPECT_TRUE(std::holds_alternative<Segment>(entity.curve));
            EXPECT_EQ(point(entity.curve, 1), point(drawing.entities[(k + 1) % 4].curve, 0));
            bounds.extend(bounding_box(entity.curve));
        }
        const auto& r = rectangles[static_cast<std::size_t>(axis)];
        EXPECT_EQ(bounds.min, Vec2(r[0], r[1]));
        EXPECT_EQ(bounds.max, Vec2(r[2], r[3]));
        EXPECT_NEAR(enclosed(drawing), (r[2] - r[0]) * (r[3] - r[1]), 1e-12) << "counter-clockwise";
    }
}

/// The cut of every facet has a point in its middle, on the diagonal between two triangles: it must not spoil the circle.
TEST(Section, FacettedCylindersAreCircles) {
    for (int n : {24, 36, 64, 84, 200, 720})
        for (double radius : {0.5, 10.0, 400.0}) {
            Mesh pin = prism(regular_polygon({3, -7}, radius, n, 0.1), 0, 8, "pin");
            round_to_single(pin);
            const Section cut_at = cut(bodies_of({pin}), {2, 3.3}, 0);
            ASSERT_EQ(cut_at.drawing.entities.size(), 1u) << n << " facets of radius " << radius;
            const Arc& arc = std::get<Arc>(cut_at.drawing.entities[0].curve);
            EXPECT_NEAR(arc.radius, radius, 2e-6 * radius + 1e-6);
            EXPECT_NEAR((arc.center - Vec2(3, -7)).norm(), 0, 2e-6 * radius + 1e-6);
            EXPECT_EQ(arc.start, 0);
            EXPECT_EQ(arc.sweep, 2 * std::numbers::pi);
            const Repair* repair = find_repair(cut_at, "circle of radius");
            ASSERT_TRUE(repair);
            EXPECT_NE(repair->what.find("through " + std::to_string(n) + " points of pin"), std::string::npos) << repair->what;
            EXPECT_LE(repair->size, arc_fraction * 2 * std::sqrt(2.0) * radius);
        }
}

TEST(Section, CoarsePolygonsStayWhatTheyAre) {
    for (int n : {3, 4, 6, 8, 12}) {
        const Section cut_at = cut(bodies_of({prism(regular_polygon({0, 0}, 10, n), 0, 8, "nut")}), {2, 4}, 0);
        EXPECT_EQ(cut_at.drawing.entities.size(), static_cast<std::size_t>(n));
    }
}

TEST(Section, ASlotIsTwoLinesAndTwoArcsAtAnyHeightAndFineness) {
    for (int n : {16, 32, 100})
        for (double z : {0.1, 1.0, 3.9999}) {
            Mesh plate = prism(slot(20, 5, n), 0, 4, "slot");
            round_to_single(plate);
            const Drawing drawing = section(bodies_of({plate}), {2, z}, 0);
            ASSERT_EQ(drawing.entities.size(), 4u) << n << " " << z;
            const auto n_arcs = std::count_if(drawing.entities.begin(), drawing.entities.end(), [](const SketchEntity& entity) {
                return std::holds_alternative<Arc>(entity.curve);
            });
            EXPECT_EQ(n_arcs, 2);
            EXPECT_NEAR(enclosed(drawing), 400 + 25 * std::numbers::pi, 1e-3);
        }
}

/// Whatever the plane and the pose: the loops close, and what they enclose is what the polygon encloses.
TEST(Section, AreasOfRandomPrismsInRandomPosesAgree) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int round = 0; round < 300; ++round) {
        const int n = 3 + static_cast<int>(random() % 9), axis = static_cast<int>(random() % 3);
        const double radius = 1 + 9 * unit(random);
        Mesh mesh = prism(regular_polygon({0, 0}, radius, n, unit(random)), 0, 6, "p");
        // Sheared along the plane: every height has the same section, moved.
        const double sx = unit(random) - 0.5, sy = unit(random) - 0.5;
        for (Vec3& v : mesh.vertices) {
            v = Vec3(v.x() + sx * v.z(), v.y() + sy * v.z(), v.z());
            if (axis == 0) v = Vec3(v.z(), v.x(), v.y());
            if (axis == 1) v = Vec3(v.y(), v.z(), v.x());
        }
        const Drawing drawing = section(bodies_of({mesh}), {axis, 0.01 + 5.98 * unit(random)}, 0);
        EXPECT_TRUE(drawing.problems.empty());
        const double area = 0.5 * n * radius * radius * std::sin(2 * std::numbers::pi / n);
        EXPECT_NEAR(enclosed(drawing), area, 1e-6 * area) << round;
    }
}

TEST(Section, APlaneAlongFacesIsMovedOffThemAndSaysSo) {
    const MeshFile stepped = bodies_of({box({0, 0, 0}, {10, 10, 2}, "low"), box({20, 0, 0}, {30, 10, 5}, "high")});
    const double size = Vec3(30, 10, 5).norm();
    for (double z : {0.0, 2.0, 5.0}) {
        const Section moved = cut(stepped, {2, z}, 0);
        const Repair* repair = find_repair(moved, "runs along faces");
        ASSERT_TRUE(repair) << z;
        EXPECT_NEAR(repair->size, nudge_fraction * size, 1e-12);
        EXPECT_NEAR(std::abs(moved.plane.at - z), repair->size, 1e-12);
        EXPECT_EQ(moved.drawing.entities.size(), z < 5 ? 8u : 4u) << "the side that meets more bodies, at " << z;
    }
    EXPECT_FALSE(find_repair(cut(stepped, {2, 1}, 0), "runs along faces"));
    EXPECT_FALSE(find_repair(cut(stepped, {2, 2 + 0.5 * nudge_fraction * size}, 0), "runs along faces"));
}

TEST(Section, BodiesThatThePlaneMissesAreIgnoredAndNoneAtAllIsAProblem) {
    const MeshFile file = bodies_of({box({0, 0, 0}, {10, 10, 2}, "low"), box({20, 0, 0}, {30, 10, 5}, "high")});
    const Drawing one = section(file, {2, 3}, 0);
    EXPECT_EQ(one.entities.size(), 4u);
    ASSERT_EQ(one.ignored.size(), 1u);
    EXPECT_EQ(one.ignored[0].what, "body low");
    EXPECT_EQ(one.counts.at("body").used, 1);
    EXPECT_TRUE(one.problems.empty());
    const Drawing none = section(file, {2, 7}, 0);
    ASSERT_EQ(none.problems.size(), 1u);
    EXPECT_NE(none.problems[0].what.find("meets no body"), std::string::npos);
}

TEST(Section, HolesMatterWhereThePlaneMeetsThem) {
    Mesh open = box({0, 0, 0}, {10, 10, 4}, "tray");
    open.triangles.erase(open.triangles.begin());  // of the wall y = 0
    const Section torn = cut(bodies_of({open}), {2, 1}, 0);
    ASSERT_EQ(torn.drawing.problems.size(), 2u);
    EXPECT_NE(torn.drawing.problems[0].what.find("does not close"), std::string::npos);
    EXPECT_NE(torn.drawing.problems[1].what.find("has holes"), std::string::npos);
    EXPECT_EQ(torn.drawing.problems[0].at.y(), 0);
    EXPECT_TRUE(torn.drawing.entities.empty());

    Mesh lidless = box({0, 0, 0}, {10, 10, 4}, "tray");
    std::erase_if(lidless.triangles, [](const auto& t) { return t[0] >= 4 && t[1] >= 4 && t[2] >= 4; });
    const Section whole = cut(bodies_of({lidless}), {2, 1}, 0);
    EXPECT_TRUE(whole.drawing.problems.empty());
    EXPECT_EQ(whole.drawing.entities.size(), 4u);
    EXPECT_TRUE(find_repair(whole, "closes all the same"));
}

TEST(Section, NarrowCracksAreClosedAndWideOnesReported) {
    for (const auto& [gap, closes] : {std::pair{1e-4, true}, std::pair{1e-2, false}}) {
        Mesh cracked = box({0, 0, 0}, {10, 10, 4}, "b");
        for (auto& t : cracked.triangles)  // the wall y = 0 with corners of its own at x = 10
            if (t[0] % 4 < 2 && t[1] % 4 < 2 && t[2] % 4 < 2)
                for (int& i : t)
                    if (i % 4 == 1) {
                        cracked.vertices.push_back(cracked.vertices[static_cast<std::size_t>(i)] - Vec3(gap, 0, 0));
                        i = static_cast<int>(cracked.vertices.size()) - 1;
                    }
        const Section found = cut(bodies_of({cracked}), {2, 1}, 0);
        EXPECT_EQ(found.drawing.problems.empty(), closes) << gap;
        const Repair* repair = find_repair(found, "crack");
        ASSERT_EQ(repair != nullptr, closes);
        if (repair) { EXPECT_NEAR(repair->size, gap, 1e-9); }
    }
}

TEST(Section, TouchingBodiesKeepTheirOwnOutlines) {
    const MeshFile file = bodies_of({together(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}))});
    const Drawing drawing = section(file, {2, 0.5}, 0);
    EXPECT_EQ(of_body(drawing, "shell1").size(), 4u);
    EXPECT_EQ(of_body(drawing, "shell2").size(), 4u);
    EXPECT_TRUE(drawing.problems.empty());
}

TEST(Section, DamagedBodiesAreProblems) {
    MeshFile file = bodies_of({box({0, 0, 0}, {1, 1, 1}, "good")});
    Mesh bad = box({0, 0, 0}, {1, 1, 1}, "index");
    bad.triangles[0][0] = 99;
    file.bodies.push_back(bad);
    bad = box({0, 0, 0}, {1, 1, 1}, "number");
    bad.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
    file.bodies.push_back(bad);
    const Drawing drawing = section(file, {2, 0.5}, 0);
    EXPECT_EQ(drawing.problems.size(), 2u);
    EXPECT_EQ(drawing.entities.size(), 4u);
}

// ---- real files ----

const std::filesystem::path inputs = std::filesystem::path(ABUT_SOURCE_DIR) / "../shared/inputs";

std::vector<double> areas(const Drawing& drawing) {
    EXPECT_TRUE(drawing.problems.empty());
    std::vector<double> found;
    for (const Part& part : parts_of(drawing, {.parts_by = PartsBy::layer}).parts) found.push_back(area(part));
    return found;
}

/// FreeCAD's meshes have their vertices on the true curves, written with six digits at least.
TEST(Section, MeshesOfAnAssemblyGiveTheAreasOfItsDrawing) {
    if (!std::filesystem::exists(inputs)) GTEST_SKIP();
    for (const auto& [drawing, meshes] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"pin_bracket_r14.dxf", {"pin_bracket.obj", "pin_bracket.stl", "pin_bracket.3mf"}},
             {"vise_clamp_r14.dxf", {"vise_clamp.obj"}}}) {
        const std::vector<double> truth = areas(read_dxf((inputs / "generated" / drawing).string()));
        for (const std::string& name : meshes) {
            const MeshFile mesh = read_mesh_file((inputs / "generated" / name).string());
            const std::vector<double> found = areas(section(mesh, plane_of({}, mesh.bodies), 0));
            ASSERT_EQ(found.size(), truth.size()) << name;
            for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_NEAR(found[k], truth[k], 1e-6 * truth[k]) << name;
        }
    }
}

TEST(Section, GearsOfOneSoupAreToldApart) {
    if (!std::filesystem::exists(inputs)) GTEST_SKIP();
    const MeshFile mesh = read_mesh_file((inputs / "generated/gear_pair.3mf").string());
    EXPECT_EQ(mesh.bodies.size(), 4u);
    const std::vector<double> truth = areas(read_dxf((inputs / "generated/gear_pair_r14.dxf").string()));
    const std::vector<double> found = areas(section(mesh, plane_of({}, mesh.bodies), 0));
    ASSERT_EQ(found.size(), truth.size());
    // Facets of the involutes, of 0.01 of a tooth, are chords.
    for (std::size_t k = 0; k < truth.size(); ++k) EXPECT_NEAR(found[k], truth[k], 5e-4 * truth[k]);
}

}  // namespace
}  // namespace abut::geometry::section_test
