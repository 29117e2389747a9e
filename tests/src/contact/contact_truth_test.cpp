// SPDX-License-Identifier: GPL-3.0-or-later
// Detection against the distances, overlaps and shared lengths that an independent kernel computed for the same assemblies,
// from every format they were exported in. Some of the files lie beside the checkout; without them their tests are skipped, and
// those of STEP files without OpenCASCADE.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

#include "geometry/foreign/reader_process.hpp"
#include "geometry/step/step.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut::contact_truth_test {

namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

/// Where exports are, and how far they may be off: those beside the checkout have six digits, and some have facets.
struct Folder {
    std::string path;
    double length_error;
    double area_error;  ///< as a fraction
};
const Folder generated{std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/generated/", 1e-3, 1e-2};
const Folder written{std::string(ABUT_SOURCE_DIR) + "/tests/geometry/step/assemblies/", 1e-6, 1e-9};
constexpr double distance = 2;

/// A file, the assembly it shows, and the drawing of the same assembly whose layers name its parts.
struct Export {
    const Folder* folder;
    const char *file, *assembly, *named_by;
};

void skip_without(const std::string& path) {
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "the file is not here";
    if (geometry::is_step_file(path) && geometry::reader_path("abut-read-step").empty())
        GTEST_SKIP() << "OpenCASCADE is not installed";
}

class ContactTruth : public testing::TestWithParam<Export> {
protected:
    void SetUp() override { skip_without(GetParam().folder->path + GetParam().file); }
};

SketchReading read_sound(const std::string& file) {
    SketchReading reading = read_sketch(file, {});
    EXPECT_TRUE(reading.drawing.problems.empty()) << file;
    EXPECT_TRUE(reading.sketch.problems.empty()) << file << ": " << reading.sketch.problems.front().what;
    return reading;
}

/// Exports that lost the names: the part of the named drawing with the same place and area.
std::string true_name(const ScenePart& part, const Scene& named) {
    for (const ScenePart& other : named.parts) {
        const double size = bounding_box(other.part).diagonal();
        if ((centroid(part.part) - centroid(other.part)).norm() < 1e-3 * size &&
            std::abs(area(part.part) - area(other.part)) < 1e-3 * area(other.part))
            return other.name;
    }
    ADD_FAILURE() << part.name << " is no part of the named drawing: area " << area(part.part) << ", centroid "
                  << centroid(part.part).transpose();
    return part.name;
}

void expect_as_true(const DetectedPair& pair, const Json& truth, const Folder& folder) {
    const double gap = truth.at("min_boundary_distance"), overlap = truth.at("overlap_area"),
                 shared = truth.at("shared_boundary_length");
    const std::string who = truth.at("a").get<std::string>() + " - " + truth.at("b").get<std::string>();
    EXPECT_NEAR(std::max(0.0, pair.gap_min), gap, folder.length_error) << who;
    EXPECT_EQ(pair.status, overlap > 0 ? "overlap" : gap == 0 ? "touching" : "gap") << who;
    EXPECT_NEAR(pair.overlap_area, overlap, folder.area_error * overlap) << who;
    EXPECT_NEAR(pair.shared_length, shared, folder.length_error * shared) << who;
}

int closeness(const DetectedPair& p) {
    return p.status == "overlap" ? 0 : p.status == "touching" ? 1 : 2;
}

/// The rows of two parts as one: truths are of pairs of parts.
std::vector<DetectedPair> by_parts(const Detection& detection) {
    std::vector<DetectedPair> pairs;
    for (const DetectedPair& row : detection.pairs) {
        const auto own = std::find_if(pairs.begin(), pairs.end(), [&](const auto& p) { return p.part == row.part; });
        if (own == pairs.end()) {
            pairs.push_back(row);
            continue;
        }
        own->gap_min = std::min(own->gap_min, row.gap_min);
        own->overlap_area += row.overlap_area;
        own->shared_length += row.shared_length;
        if (closeness(row) < closeness(*own)) own->status = row.status;
    }
    return pairs;
}

const geometry::Part& part_named(const Scene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& part) { return part.name == name; });
    if (found == scene.parts.end()) throw std::out_of_range(name);
    return found->part;
}

/// What is said of each row, numbers to seven digits of the distance; in an order that does not depend on the parts'.
std::vector<std::string> rows_of(const Detection& detection) {
    std::vector<std::string> rows;
    for (const DetectedPair& row : detection.pairs) {
        Names names(row.parts.begin(), row.parts.end());
        std::sort(names.begin(), names.end());
        std::ostringstream text;
        text << names[0] << " - " << names[1] << ": " << row.status << ", " << row.interface << ", case " << row.cells_case;
        for (const double length : {row.gap_min, row.gap_max, row.length, row.shared_length, row.overlap_area})
            text << ", " << std::lround(length * 1e6 / distance);
        rows.push_back(text.str());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

}  // namespace

TEST_P(ContactTruth, EveryListedPairAndNoOther) {
    const Folder& folder = *GetParam().folder;
    const Scene scene = read_sound(folder.path + GetParam().file).scene,
                named = read_sound(folder.path + GetParam().named_by).scene;
    ASSERT_EQ(scene.parts.size(), named.parts.size());
    std::map<std::string, std::string> name_of;
    for (const ScenePart& part : scene.parts) name_of[part.name] = true_name(part, named);

    std::ifstream file(folder.path + "contact_truth.json");
    const Json truths = Json::parse(file).at(GetParam().assembly);
    std::map<Names, Json> expected;
    for (const Json& truth : truths) {
        Names names{truth.at("a"), truth.at("b")};
        std::sort(names.begin(), names.end());
        expected[names] = truth;
    }
    for (const DetectedPair& pair : by_parts(detect_contacts(scene, distance))) {
        Names names{name_of[pair.parts[0]], name_of[pair.parts[1]]};
        std::sort(names.begin(), names.end());
        const auto truth = expected.find(names);
        if (truth == expected.end()) {
            ADD_FAILURE() << names[0] << " - " << names[1] << " is not listed";
            continue;
        }
        expect_as_true(pair, truth->second, folder);
        expected.erase(truth);
    }
    for (const auto& [names, truth] : expected) ADD_FAILURE() << names[0] << " - " << names[1] << " was not found";
}

/// Rows and areas that do not depend on how the assembly came.
struct SameAssembly : testing::TestWithParam<const char*> {};

TEST_P(SameAssembly, HasThePartsAndContactsOfItsDrawing) {
    const std::string name = written.path + GetParam();
    skip_without(name + ".step");
    if (IsSkipped()) return;
    const Scene solids = read_sound(name + ".step").scene, drawn = read_sound(name + ".dxf").scene;
    std::ifstream file(written.path + "areas.json");
    const Json areas = Json::parse(file).at(GetParam());
    ASSERT_EQ(solids.parts.size(), areas.size());
    for (const ScenePart& part : solids.parts) {
        const double size = areas.at(part.name);
        EXPECT_NEAR(area(part.part), size, 1e-9 * size) << part.name;
        EXPECT_NEAR(area(part_named(drawn, part.name)), size, 1e-9 * size) << part.name << ", drawn";
    }
    const std::vector<std::string> rows = rows_of(detect_contacts(solids, distance));
    EXPECT_EQ(rows, rows_of(detect_contacts(drawn, distance)));
    EXPECT_FALSE(rows.empty());
}

INSTANTIATE_TEST_SUITE_P(WrittenByFreecad, SameAssembly,
                         testing::Values("pin_bracket", "vise_clamp", "gears", "rocker", "dovetail"),
                         [](const auto& case_info) { return std::string(case_info.param); });

std::string test_name(const testing::TestParamInfo<Export>& case_info) {
    std::string name = case_info.param.file;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Exports, ContactTruth,
                         testing::Values(Export{&generated, "pin_bracket_r14.dxf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{&generated, "pin_bracket_r12.dxf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{&generated, "pin_bracket.obj", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{&generated, "pin_bracket.3mf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{&generated, "pin_bracket.stl", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{&generated, "vise_clamp_r14.dxf", "vise_clamp", "vise_clamp_r14.dxf"},
                                         Export{&generated, "vise_clamp.obj", "vise_clamp", "vise_clamp_r14.dxf"},
                                         Export{&generated, "vise_clamp.step", "vise_clamp", "vise_clamp_r14.dxf"},
                                         Export{&generated, "gear_pair_r14.dxf", "gear_pair", "gear_pair_r14.dxf"},
                                         // its flanks are facets up to 0.01 mm off the involute, their vertices on it
                                         Export{&generated, "gear_pair.3mf", "gear_pair", "gear_pair_r14.dxf"}),
                         test_name);

INSTANTIATE_TEST_SUITE_P(WrittenByFreecad, ContactTruth,
                         testing::Values(Export{&written, "pin_bracket.step", "pin_bracket", "pin_bracket.dxf"},
                                         Export{&written, "vise_clamp.step", "vise_clamp", "vise_clamp.dxf"},
                                         Export{&written, "gears.step", "gears", "gears.dxf"},
                                         Export{&written, "rocker.step", "rocker", "rocker.dxf"},
                                         Export{&written, "dovetail.step", "dovetail", "dovetail.dxf"}),
                         test_name);

TEST(ContactTruthOfGears, TeethMeetTeethHoweverTheFlanksAreDrawn) {
    for (const char* file : {"gear_pair_r14.dxf", "gear_pair_r14_lwpoly.dxf", "gear_pair.3mf"}) {
        if (!std::filesystem::exists(generated.path + file)) GTEST_SKIP() << "the file is not here";
        std::set<std::array<int, 2>> toothed;
        for (const DetectedPair& pair : detect_contacts(read_sound(generated.path + file).scene, distance).pairs)
            if (pair.interface == "tooth-on-tooth") toothed.insert(pair.part);
        EXPECT_EQ(toothed.size(), 1U) << file;
    }
}

}  // namespace abut::contact_truth_test
