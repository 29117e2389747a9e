// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that name STEP files: as an assembly, and one solid as a part. Skipped without OpenCASCADE.
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_process.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::step_import_test {
namespace {

const std::string bracket = ABUT_SOURCE_DIR "/data/sketches/pin_bracket.step";

class StepImport : public testing::Test {
protected:
    void SetUp() override {
        if (geometry::reader_path("abut-read-step").empty()) GTEST_SKIP() << "OpenCASCADE is not installed";
    }

    Scene read(const std::string& rest, const std::string& unit = "mm") {
        return read_scene(folder_.write("scene.json", R"({"abut": 1, "units": {"length": ")" + unit +
                                                          R"(", "force": "N"}, "materials": {"m": {"E": 1, "nu": 0}}, )" +
                                                          rest + "}"));
    }

    TemporaryFolder folder_;
};

TEST_F(StepImport, AnAssemblyIsInTheUnitOfTheScene) {
    const Scene scene = read(R"("assembly": {"file": ")" + bracket + R"(", "material": "m"})", "cm");
    ASSERT_EQ(scene.parts.size(), 3u);
    EXPECT_EQ(scene.parts[1].name, "pin");
    EXPECT_NEAR(area(scene.parts[1].part), std::numbers::pi, 1e-9);
    ASSERT_EQ(scene.imports.size(), 1u);
    EXPECT_EQ(scene.imports[0].unit, "mm");
}

TEST_F(StepImport, OneSolidIsAPart) {
    const std::string part = R"("parts": [{"name": "p", "material": "m", "geometry": {"step": {"file": ")" + bracket +
                             R"(", "node": "base", "section": {"axis": "z", "at": 2})";
    const Scene scene = read(part + "}}}]");
    ASSERT_EQ(scene.parts.size(), 1u);
    EXPECT_NEAR(area(scene.parts[0].part), 2400, 1e-6);
    EXPECT_THROW(read(part + R"(, "recognise_arcs": true}}}])"), InputError) << "there are no facets";
}

}  // namespace
}  // namespace abut::step_import_test
