// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of several views of one part: every command tells, until all but one are left out.
#include <gtest/gtest.h>

#include <algorithm>

#include "src/scene/read_scene.hpp"
#include "src/scene/read_sketch.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::drawing_views_test {
namespace {

const std::string views = geometry::dxf_file(geometry::dxf_rectangle("A", "PART", 0, 0, 100, 60) +
                                             geometry::dxf_rectangle("B", "PART", 0, 90, 100, 130) +
                                             geometry::dxf_rectangle("C", "PART", 130, 0, 170, 60));

int n_told(const std::vector<std::string>& warnings) {
    return static_cast<int>(std::count_if(warnings.begin(), warnings.end(), [](const std::string& warning) {
        return warning.find("look like views of one part") != std::string::npos;
    }));
}

}  // namespace

TEST(DrawingViews, AreToldOfABareDrawing) {
    const TemporaryFolder folder;
    const SketchReading reading = read_sketch(folder.write("d.dxf", views), {});
    EXPECT_EQ(n_told(reading.scene.warnings), 1);
    EXPECT_NE(reading.scene.warnings.back().find(R"("parts": {"PART#1": "ignore", "PART#2": "ignore"})"), std::string::npos)
        << reading.scene.warnings.back();
}

TEST(DrawingViews, AreToldOfAScene) {
    const TemporaryFolder folder;
    folder.write("d.dxf", views);
    const auto warnings_with = [&](const std::string& parts) {
        return read_scene(
                   folder.write(
                       "s.json",
                       R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "assembly": {"file": "d.dxf", "material": "steel",
            "parts": {)" + parts +
                           "}}}"))
            .warnings;
    };
    EXPECT_EQ(n_told(warnings_with("")), 1);
    EXPECT_EQ(n_told(warnings_with(R"("PART#1": "ignore")")), 1);
    EXPECT_EQ(n_told(warnings_with(R"("PART#1": "ignore", "PART#2": "ignore")")), 0);
}

}  // namespace abut::drawing_views_test
