// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/parameter_range.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::parameter_range_test {
namespace {

std::string scene_with(const std::string& parameters) {
    return R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "parameters": {)" + parameters +
           R"(}, "materials": {"steel": {"E": 210000, "nu": 0.3}},
        "parts": [{"name": "disc", "material": "steel", "geometry": {"circle": {"center": [0, 0], "radius": "R"}}}],
        "supports": [{"on": "disc/*", "fix": ["x", "y"]}], "loads": []})";
}

std::string problem_of(const std::string& parameters) {
    try {
        read_scene_text(scene_with(parameters), "scene.json");
    } catch (const InputError& error) { return one_line(error.problems().front()); }
    return "";
}

TEST(ParameterRange, ValuesAreReadWithAndWithoutRange) {
    const Scene scene =
        read_scene_text(scene_with(R"("a": 2, "R": {"value": "a * 1.5 cm", "min": "20 mm", "max": "a * 30"})"), "scene.json");
    EXPECT_NEAR(area(scene.parts[0].part), 900 * 3.14159265358979, 1e-9 * 900 * 3.14159265358979);
}

TEST(ParameterRange, RangesAreToldInTheScenesUnits) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "s.json",
        scene_with(
            R"("a": 2, "R": {"value": "a * 1.5 cm", "min": "20 mm", "max": "a * 30"}, "c": {"value": 1, "min": 0, "max": 2})"));
    const std::vector<ParameterRange> ranges = parameter_ranges(file);
    ASSERT_EQ(ranges.size(), 2U);
    EXPECT_EQ(ranges[0].name, "R");
    EXPECT_EQ(ranges[0].where, "/parameters/R");
    EXPECT_DOUBLE_EQ(ranges[0].value, 30);
    EXPECT_DOUBLE_EQ(ranges[0].least, 20);
    EXPECT_DOUBLE_EQ(ranges[0].most, 60);
    EXPECT_EQ(ranges[1].name, "c");
    // another value from outside keeps the range
    EXPECT_NEAR(area(read_scene(file, {{"R", 25}}).parts[0].part), 625 * 3.14159265358979, 1e-5);
}

TEST(ParameterRange, WhatIsWrongIsToldWithItsPlace) {
    EXPECT_EQ(problem_of(R"("R": {"value": 3, "min": 2, "max": 5})"), "");
    EXPECT_NE(problem_of(R"("R": {"value": 3, "min": 2})").find("'max' is missing"), std::string::npos);
    EXPECT_NE(problem_of(R"("R": {"min": 2, "max": 3})").find("'value' is missing"), std::string::npos);
    EXPECT_NE(problem_of(R"("R": {"value": 3, "min": 5, "max": 5})").find("not below 'max'"), std::string::npos);
    EXPECT_NE(problem_of(R"("R": {"value": 6, "min": 2, "max": 5})").find("not between"), std::string::npos);
    EXPECT_NE(problem_of(R"("R": {"value": 6, "min": 2, "max": 9, "step": 1})").find("step"), std::string::npos);
    EXPECT_NE(problem_of(R"("R": {"value": "no", "min": 2, "max": 9})").find("no"), std::string::npos);
}

}  // namespace
}  // namespace abut::parameter_range_test
