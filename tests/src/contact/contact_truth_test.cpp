// SPDX-License-Identifier: GPL-3.0-or-later
// Detection against the distances, overlaps and shared lengths that an independent kernel computed for the same assemblies,
// from every format they were exported in. The files lie beside the checkout; without them these tests are skipped.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "src/contact/detect.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut::contact_truth_test {

namespace {

using Json = nlohmann::json;
using Names = std::vector<std::string>;

const std::string generated = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/generated/";
constexpr double distance = 2;

/// A file, the assembly it shows, and the drawing of the same assembly whose layers name its parts.
struct Export {
    const char *file, *assembly, *named_by;
};

class ContactTruth : public testing::TestWithParam<Export> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(generated + GetParam().file)) GTEST_SKIP() << "the file is not here";
    }
};

SketchReading read_sound(const std::string& file) {
    SketchReading reading = read_sketch(generated + file, {});
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

void expect_as_true(const DetectedPair& pair, const Json& truth) {
    const double gap = truth.at("min_boundary_distance"), overlap = truth.at("overlap_area"),
                 shared = truth.at("shared_boundary_length");
    const std::string who = truth.at("a").get<std::string>() + " - " + truth.at("b").get<std::string>();
    EXPECT_NEAR(std::max(0.0, pair.gap_min), gap, 1e-3) << who;
    EXPECT_EQ(pair.status, overlap > 0 ? "overlap" : gap == 0 ? "touching" : "gap") << who;
    EXPECT_NEAR(pair.overlap_area, overlap, 0.01 * overlap) << who;
    EXPECT_NEAR(pair.shared_length, shared, 1e-3 * shared) << who;
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

}  // namespace

TEST_P(ContactTruth, EveryListedPairAndNoOther) {
    const Scene scene = read_sound(GetParam().file).scene, named = read_sound(GetParam().named_by).scene;
    ASSERT_EQ(scene.parts.size(), named.parts.size());
    std::map<std::string, std::string> name_of;
    for (const ScenePart& part : scene.parts) name_of[part.name] = true_name(part, named);

    std::ifstream file(generated + "contact_truth.json");
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
        expect_as_true(pair, truth->second);
        expected.erase(truth);
    }
    for (const auto& [names, truth] : expected) ADD_FAILURE() << names[0] << " - " << names[1] << " was not found";
}

INSTANTIATE_TEST_SUITE_P(Exports, ContactTruth,
                         testing::Values(Export{"pin_bracket_r14.dxf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{"pin_bracket_r12.dxf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{"pin_bracket.obj", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{"pin_bracket.3mf", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{"pin_bracket.stl", "pin_bracket", "pin_bracket_r14.dxf"},
                                         Export{"vise_clamp_r14.dxf", "vise_clamp", "vise_clamp_r14.dxf"},
                                         Export{"vise_clamp.obj", "vise_clamp", "vise_clamp_r14.dxf"},
                                         Export{"gear_pair_r14.dxf", "gear_pair", "gear_pair_r14.dxf"},
                                         // its flanks are facets up to 0.01 mm off the involute, their vertices on it
                                         Export{"gear_pair.3mf", "gear_pair", "gear_pair_r14.dxf"}),
                         [](const auto& case_info) {
                             std::string name = case_info.param.file;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(ContactTruthOfGears, TeethMeetTeethHoweverTheFlanksAreDrawn) {
    for (const char* file : {"gear_pair_r14.dxf", "gear_pair_r14_lwpoly.dxf", "gear_pair.3mf"}) {
        if (!std::filesystem::exists(generated + file)) GTEST_SKIP() << "the file is not here";
        std::set<std::array<int, 2>> toothed;
        for (const DetectedPair& pair : detect_contacts(read_sound(file).scene, distance).pairs)
            if (pair.interface == "tooth-on-tooth") toothed.insert(pair.part);
        EXPECT_EQ(toothed.size(), 1U) << file;
    }
}

}  // namespace abut::contact_truth_test
