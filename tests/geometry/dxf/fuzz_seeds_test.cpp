// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzzers begin with, and every input that once broke a reader, through the fuzzers' own entries.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "tests/fuzz/dxf_target.hpp"
#include "tests/fuzz/scene_target.hpp"
#include "tests/fuzz/section_target.hpp"

namespace abut::fuzz::fuzz_seeds_test {

namespace {

namespace fs = std::filesystem;
using geometry::Vec2;

const fs::path seeds = fs::path(ABUT_SOURCE_DIR) / "tests/fuzz/seeds";

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> files_of(const std::string& target) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(seeds / target)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void replay(const std::string& target, std::string (*fault_of)(const std::string&)) {
    const std::vector<fs::path> files = files_of(target);
    EXPECT_GE(files.size(), 10U);
    for (const fs::path& path : files) {
        const std::string bytes = bytes_of(path);
        EXPECT_FALSE(bytes.empty()) << path;
        EXPECT_EQ(fault_of(bytes), "") << path;
    }
}

geometry::Part square(double side) {
    const Vec2 corners[] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    geometry::Part part;
    part.name = "square";
    part.loops.push_back({{0, 1, 2, 3}});
    for (std::size_t i = 0; i < 4; ++i) part.edges.push_back({geometry::Segment{corners[i], corners[(i + 1) % 4]}, "e", "e"});
    return part;
}

geometry::SketchParts parts_of_section(const std::string& seed) {
    SectionInput input = section_input_of(bytes_of(seeds / "section" / seed));
    const geometry::MeshFile file = mesh_file_of(input);
    const geometry::SectionPlane plane = input.plane.value_or(geometry::plane_of({}, file.bodies));
    return geometry::parts_of(geometry::section(file, plane, input.tolerance), {});
}

}  // namespace

TEST(FuzzSeeds, drawings) {
    replay("dxf", fault_of_dxf);
}

TEST(FuzzSeeds, scenes) {
    replay("scene", fault_of_scene);
}

TEST(FuzzSeeds, sections) {
    replay("section", fault_of_section);
}

TEST(FuzzSeeds, drawings_reach_the_parts) {
    const auto drawing = geometry::read_dxf_bytes("", bytes_of(seeds / "dxf/plate_with_hole.dxf"));
    const auto parts = geometry::parts_of(drawing, {}).parts;
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(geometry::count_holes(parts[0]), 1);
}

TEST(FuzzSeeds, scenes_reach_the_evaluation) {
    int n_parts = 0;
    for (const fs::path& path : files_of("scene")) {
        try {
            n_parts += static_cast<int>(read_scene_text(bytes_of(path), path.string()).parts.size());
        } catch (const InputError&) {}
    }
    EXPECT_GE(n_parts, 15);
}

TEST(FuzzSeeds, sections_reach_the_parts) {
    const geometry::SketchParts box = parts_of_section("box_split");
    ASSERT_EQ(box.parts.size(), 1U);
    EXPECT_DOUBLE_EQ(geometry::area(box.parts[0]), 200);
    EXPECT_EQ(parts_of_section("two_boxes").parts.size(), 2U);
    const geometry::SketchParts tube = parts_of_section("tube");
    ASSERT_EQ(tube.parts.size(), 1U);
    EXPECT_DOUBLE_EQ(geometry::area(tube.parts[0]), 18 * 18 - 8 * 8);
}

/// Else the tolerance would be half the shortest outline: ellipses drawn in each other were one, and circles had no area.
TEST(FuzzSeeds, a_stray_line_far_away_does_not_widen_the_tolerance) {
    const auto drawing = geometry::read_dxf_bytes("", bytes_of(seeds / "dxf/stray_line_far_away.dxf"));
    const geometry::SketchParts sketch = geometry::parts_of(drawing, {});
    double total = 0;
    for (const auto& entity : drawing.entities) total += geometry::length(entity.curve);
    EXPECT_LE(sketch.tolerance, geometry::joining_fraction * total);
    ASSERT_EQ(sketch.parts.size(), 2U);
    EXPECT_EQ(geometry::count_holes(sketch.parts[0]), 1);
    EXPECT_EQ(geometry::count_holes(sketch.parts[1]), 0);
    EXPECT_TRUE(sketch.problems.empty());
    const auto& warnings = sketch.warnings;
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const geometry::SketchProblem& warning) {
        return warning.what.find("bounds nothing") != std::string::npos ||
               warning.what.find("bound nothing") != std::string::npos;
    })) << "the stray line is open";
}

/// Columns without a distance between them: once, a damaged count of them was drawn up to the limit of a million circles.
TEST(FuzzSeeds, an_array_in_one_place_is_drawn_once) {
    const auto drawing = geometry::read_dxf_bytes("", bytes_of(seeds / "dxf/array_in_one_place.dxf"));
    ASSERT_EQ(drawing.entities.size(), 1U);
    EXPECT_EQ(drawing.entities[0].instance, "") << "the block is inserted once";
    EXPECT_TRUE(drawing.problems.empty());
    ASSERT_EQ(drawing.repairs.size(), 1U);
    EXPECT_NE(drawing.repairs[0].what.find("drawn once"), std::string::npos);
    EXPECT_EQ(drawing.repairs[0].at, Vec2(2, 4));
}

/// Refused before it is drawn: to read and compare the first million took minutes.
TEST(FuzzSeeds, an_array_of_millions_is_refused_whole) {
    const auto drawing = geometry::read_dxf_bytes("", bytes_of(seeds / "dxf/array_of_millions.dxf"));
    EXPECT_TRUE(drawing.entities.empty());
    ASSERT_EQ(drawing.problems.size(), 1U);
    EXPECT_NE(drawing.problems[0].what.find("more than"), std::string::npos);
    EXPECT_EQ(drawing.counts.at("INSERT").ignored, 1);
}

/// What is large, closed or not, has no say in how small blocks nest that stand beside it: by its tolerance their ellipses were
/// without area, and lay on each other all along.
TEST(FuzzSeeds, blocks_nest_beside_what_is_large) {
    for (const auto& [seed, n_others, n_warnings] :
         {std::tuple("blocks_and_a_long_line.dxf", 0U, 1U), std::tuple("blocks_and_a_large_frame.dxf", 1U, 0U)}) {
        const auto drawing = geometry::read_dxf_bytes("", bytes_of(seeds / "dxf" / seed));
        for (const auto by : {geometry::PartsBy::automatic, geometry::PartsBy::layer, geometry::PartsBy::loop}) {
            geometry::SketchOptions options;
            options.parts_by = by;
            const geometry::SketchParts sketch = geometry::parts_of(drawing, options);
            ASSERT_EQ(sketch.parts.size(), 3 + n_others) << seed;
            for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(geometry::count_holes(sketch.parts[k]), 1) << seed;
            EXPECT_TRUE(sketch.problems.empty()) << seed;
            EXPECT_EQ(sketch.warnings.size(), n_warnings) << seed;
        }
    }
}

/// An ellipse shorter than what counts as one point of the model was followed by no arc at all.
TEST(FuzzSeeds, an_ellipse_inside_a_huge_circle_is_seen) {
    const std::string text = bytes_of(seeds / "scene/ellipse_inside_a_huge_circle.json");
    EXPECT_THROW((void)read_scene_text(text, "huge.json"), InputError) << "nothing is left";
    const std::size_t radius = text.find("1e91");
    ASSERT_NE(radius, std::string::npos);
    const Scene small = read_scene_text(std::string(text).replace(radius, 4, "1"), "small.json");
    ASSERT_EQ(small.parts.size(), 1U);
    EXPECT_EQ(small.parts[0].part.edges.size(), 2U);
}

TEST(FuzzSeeds, faults_of_parts_are_seen) {
    EXPECT_EQ(fault_of_part(square(2)), "");
    geometry::Part part = square(2);
    part.loops[0].edges = {3, 2, 1, 0};
    EXPECT_NE(fault_of_part(part), "");
    part = square(2);
    std::get<geometry::Segment>(part.edges[1].curve).to.x() += 1e-4;
    EXPECT_NE(fault_of_part(part), "");
    part = square(2);
    part.edges[2].curve = geometry::Segment{{2, 2}, {std::numeric_limits<double>::quiet_NaN(), 2}};
    EXPECT_NE(fault_of_part(part), "");
    part = square(2);
    for (geometry::Edge& edge : part.edges) edge.curve = geometry::reversed(edge.curve);
    std::reverse(part.loops[0].edges.begin(), part.loops[0].edges.end());
    EXPECT_NE(fault_of_part(part), "") << "clockwise";
}

TEST(FuzzSeeds, lost_entities_are_seen) {
    geometry::Drawing drawing;
    drawing.counts["LINE"] = {3, 2, 1};
    EXPECT_EQ(fault_of_drawing(drawing), "");
    drawing.counts["LINE"] = {3, 2, 0};
    EXPECT_NE(fault_of_drawing(drawing), "");
}

TEST(FuzzSeeds, large_geometry_is_not_evaluated) {
    std::string points;
    for (int i = 0; i < 200; ++i) points += "[0, 0], ";
    const auto is_small_polygon = [](const std::string& polygon) {
        return is_small(parse_json(R"({"parts": [{"geometry": {"polygon": [)" + polygon + "[1, 1]]}}]}", "").root);
    };
    EXPECT_TRUE(is_small_polygon("[0, 0], "));
    EXPECT_FALSE(is_small_polygon(points));
}

}  // namespace abut::fuzz::fuzz_seeds_test
