// SPDX-License-Identifier: GPL-3.0-or-later
// The same assembly as careless exporters write it: gaps, duplicates, splines for arcs, facets, nested mirrored blocks, inches,
// binary, far from the origin, hidden layers. The files lie beside the checkout; without them these tests are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>

#include "geometry/brep/input_error.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut::messy_drawings_test {

namespace {

namespace fs = std::filesystem;
const std::string inputs = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/";
const std::string messy = inputs + "generated/messy/";

struct Variant {
    const char* file;
    double tolerance = 0;
};

/// The variants that mean the same as the clean drawing; names of parts are lost in one of them.
const std::vector<Variant> same{{"all_on_layer_0.dxf"},
                                {"arcs_as_splines.dxf"},
                                {"circles_as_two_arcs_angle_gt_360.dxf"},
                                {"circles_faceted_64.dxf"},
                                {"crlf_lowercase_padding.dxf"},
                                {"decimal_comma.dxf"},
                                {"drawing_with_centrelines_dims_hidden_paper.dxf"},
                                {"duplicates_reversed.dxf"},
                                {"extrusion_minus_z.dxf"},
                                {"far_from_origin_1e6.dxf"},
                                {"gap_1e-3mm.dxf"},
                                {"gap_1e-6mm.dxf"},
                                {"inches_insunits1.dxf"},
                                {"inches_unitless_measurement0.dxf"},
                                {"nested_mirrored_scaled_blocks.dxf"},
                                {"partial_overlaps.dxf"},
                                {"r12_binary.dxf"},
                                {"r2018_binary.dxf"},
                                {"shuffled_reversed_zero_length.dxf"},
                                {"gap_0.02mm_smaller_than_clearance.dxf", 0.05},
                                {"all_on_layer_0.dxf", 0.05}};

/// The one file that does not state its unit is in inches.
SketchReading reading_of(const std::string& path, double tolerance = 0) {
    ImportOptions options;
    if (path.ends_with("inches_unitless_measurement0.dxf")) options.units = "in";
    options.tolerance = tolerance;
    return read_sketch(path, options);
}

/// In millimetres; the clean drawing states them.
double factor_of(const SketchReading& reading) {
    return reading.drawing.unit.empty() ? 1 : geometry::unit_factor(reading.drawing.unit, "mm");
}

/// Parts by size: base, bracket and pin are told apart by it in any unit.
std::vector<const geometry::Part*> by_size(const SketchReading& reading) {
    std::vector<const geometry::Part*> parts;
    for (const ScenePart& part : reading.scene.parts) parts.push_back(&part.part);
    std::sort(parts.begin(), parts.end(), [](const auto* a, const auto* b) { return area(*a) < area(*b); });
    return parts;
}

class MessyDrawing : public testing::TestWithParam<Variant> {
protected:
    void SetUp() override {
        if (!fs::exists(messy)) GTEST_SKIP() << "the files are not here";
    }
};

}  // namespace

TEST_P(MessyDrawing, HasThePartsAndContactsOfTheCleanOne) {
    const SketchReading reading = reading_of(messy + GetParam().file, GetParam().tolerance);
    for (const auto& problem : reading.drawing.problems) ADD_FAILURE() << problem.what;
    for (const auto& problem : reading.sketch.problems) ADD_FAILURE() << problem.what;
    const double factor = factor_of(reading);
    const auto parts = by_size(reading);
    ASSERT_EQ(parts.size(), 3u);
    const bool has_names = GetParam().file != std::string("all_on_layer_0.dxf");
    const std::array<std::string, 3> names = has_names
                                                 ? std::array<std::string, 3>{"pin", "base", "bracket"}
                                                 : std::array<std::string, 3>{parts[0]->name, parts[1]->name, parts[2]->name};
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(parts[k]->name, names[k]);
    constexpr double pi = std::numbers::pi;
    // pin, base, bracket (base plate, web, half disc and two fillets, less the bores), from the drawing's dimensions
    const double areas[] = {100 * pi, 2400, 120 * 12 + 40 * 38 + 200 * pi + 2 * (36 - 9 * pi) - pi * (9 + 9 + 10.05 * 10.05)};
    const int holes[] = {0, 0, 3};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(area(*parts[k]) * factor * factor, areas[k], 1e-6 * areas[k]);
        EXPECT_EQ(count_holes(*parts[k]), holes[k]);
    }

    const Detection found = detect_contacts(reading.scene, 2 / factor);
    ASSERT_EQ(found.pairs.size(), 2u);
    for (const DetectedPair& pair : found.pairs) {
        EXPECT_EQ(pair.status, "touching") << pair.parts[0] << " - " << pair.parts[1] << ": " << pair.why;
        const bool is_pin = pair.interface == "pin-in-hole";
        EXPECT_EQ(pair.interface, is_pin ? "pin-in-hole" : "flat-on-flat");
        EXPECT_NEAR(pair.shared_length * factor, is_pin ? 0 : 120, 1e-3);
        const std::set<std::string> who(pair.parts.begin(), pair.parts.end());
        EXPECT_EQ(who, (std::set<std::string>{names[2], is_pin ? names[0] : names[1]}));
    }
    EXPECT_NE(found.pairs[0].interface, found.pairs[1].interface);
}

INSTANTIATE_TEST_SUITE_P(Variants, MessyDrawing, testing::ValuesIn(same), [](const auto& case_info) {
    std::string name = case_info.param.file;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name + (case_info.param.tolerance > 0 ? "_with_tolerance" : "");
});

/// What a reading must tell of a variant: repairs of which each has the words, and what is left out, for which reason.
struct Told {
    const char* file;
    std::size_t n_repairs;
    std::string words;
    std::map<std::string, int> n_left_out;
};

TEST(MessyDrawings, WhatWasMendedOrLeftOutIsTold) {
    if (!fs::exists(messy)) GTEST_SKIP() << "the files are not here";
    const Told all[] = {
        {"arcs_as_splines.dxf", 7, "recognised as", {}},
        {"circles_faceted_64.dxf", 4, "64 lines recognised as a circle", {}},
        {"duplicates_reversed.dxf", 15, "removed: it lies on", {}},
        {"gap_1e-3mm.dxf", 11, "gap closed between", {}},
        {"gap_1e-6mm.dxf", 11, "gap closed between", {}},
        {"shuffled_reversed_zero_length.dxf", 1, "without length removed", {}},
        {"drawing_with_centrelines_dims_hidden_paper.dxf",
         0,
         "",
         {{"layer of center lines", 2}, {"layer is off", 1}, {"layer is frozen", 1}, {"annotation", 2}, {"in paper space", 1}}},
        {"far_from_origin_1e6.dxf", 0, "", {}},
        {"nested_mirrored_scaled_blocks.dxf", 0, "", {}},
        {"extrusion_minus_z.dxf", 0, "", {}}};
    for (const Told& told : all) {
        const SketchReading reading = reading_of(messy + told.file);
        const ImportRecord& record = reading.scene.imports.at(0);
        EXPECT_EQ(record.repairs.size(), told.n_repairs) << told.file;
        for (const geometry::Repair& repair : record.repairs)
            EXPECT_NE(repair.what.find(told.words), std::string::npos) << told.file << ": " << repair.what;
        std::map<std::string, int> n_left_out;
        for (const geometry::Ignored& ignored : record.ignored) n_left_out[ignored.why] += ignored.count;
        EXPECT_EQ(n_left_out, told.n_left_out) << told.file;
    }
    EXPECT_EQ(reading_of(messy + "inches_insunits1.dxf").drawing.unit, "in");
    EXPECT_EQ(read_sketch(messy + "inches_unitless_measurement0.dxf", {}).drawing.unit, "");
    EXPECT_EQ(reading_of(messy + "r2018_binary.dxf").drawing.format, "binary DXF AC1032");
    EXPECT_GT(bounding_box(*by_size(reading_of(messy + "far_from_origin_1e6.dxf"))[0]).min.norm(), 1e6);
}

TEST(MessyDrawings, WideGapsAreReportedWhereTheyAre) {
    if (!fs::exists(messy)) GTEST_SKIP() << "the files are not here";
    for (const auto& [file, gap, tolerance] : {std::tuple{"gap_0.02mm_smaller_than_clearance.dxf", "0.02", 0.0},
                                               std::tuple{"gap_0.5mm_must_be_reported.dxf", "0.5", 0.0},
                                               std::tuple{"gap_0.5mm_must_be_reported.dxf", "0.5", 0.05}}) {
        const SketchReading reading = reading_of(messy + file, tolerance);
        ASSERT_EQ(reading.sketch.problems.size(), 11u) << file;
        for (const auto& problem : reading.sketch.problems) {
            EXPECT_NE(problem.what.find(std::string("are ") + gap + " apart"), std::string::npos) << problem.what;
            EXPECT_GT(problem.line, 0);
            EXPECT_TRUE(problem.what.find("layer bracket") != std::string::npos ||
                        problem.what.find("layer base") != std::string::npos);
        }
    }
}

TEST(MessyDrawings, ATruncatedFileIsRefused) {
    if (!fs::exists(messy)) GTEST_SKIP() << "the files are not here";
    EXPECT_THROW(reading_of(messy + "truncated.dxf"), InputError);
}

TEST(MessyDrawings, EveryFileIsListedHere) {
    if (!fs::exists(messy)) GTEST_SKIP() << "the files are not here";
    for (const auto& entry : fs::directory_iterator(messy)) {
        const std::string name = entry.path().filename().string();
        const bool is_same = std::any_of(same.begin(), same.end(), [&](const Variant& v) { return v.file == name; });
        EXPECT_TRUE(is_same || name == "truncated.dxf" || name == "gap_0.5mm_must_be_reported.dxf") << name;
    }
}

TEST(MessyDrawings, PublicDrawingsAreReadOrRefusedAtOnce) {
    const std::string folder = inputs + "public/dxf/";
    if (!fs::exists(folder)) GTEST_SKIP() << "the files are not here";
    int n_sound = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto begin = std::chrono::steady_clock::now();
        try {
            const SketchReading reading = reading_of(entry.path().string());
            n_sound += reading.drawing.problems.empty() && reading.sketch.problems.empty() && !reading.sketch.parts.empty();
            for (const geometry::Part& part : reading.sketch.parts)
                EXPECT_GT(area(part), 0) << entry.path() << " " << part.name;
            EXPECT_FALSE(reading.sketch.why.empty());
        } catch (const InputError& error) { EXPECT_EQ(error.problems().size(), 1u) << entry.path(); }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_LT(seconds.count(), 5) << entry.path();
    }
    EXPECT_GE(n_sound, 22);  // the others are drawn open, branching or crossing: manifest.csv
}

TEST(MessyDrawings, DrawingsThatCloseGiveTheirParts) {
    const std::string folder = inputs + "public/dxf/";
    if (!fs::exists(folder)) GTEST_SKIP() << "the files are not here";
    // outlines as an independent tool counts them (manifest.csv), as parts and holes
    const std::tuple<const char*, std::size_t, int> nests[] = {{"trimesh__ChuteHolderPrint.DXF", 8, 35},
                                                               {"trimesh__1002_tray_bottom.DXF", 1, 23},
                                                               {"trimesh__apu-mount.DXF", 2, 17},
                                                               {"cadquery__1001.dxf", 1, 4},
                                                               {"trimesh__sliding-base.dxf", 4, 5},
                                                               {"bots__BalloonBot_proto_v01.dxf", 15, 83},
                                                               {"trimesh__wrench.dxf", 1, 1},
                                                               {"cadquery__gear.dxf", 1, 1}};
    for (const auto& [file, n_parts, n_holes] : nests) {
        const SketchReading reading = reading_of(folder + file);
        EXPECT_TRUE(reading.sketch.problems.empty()) << file;
        EXPECT_EQ(reading.sketch.parts.size(), n_parts) << file;
        int n = 0;
        for (const geometry::Part& part : reading.sketch.parts) n += count_holes(part);
        EXPECT_EQ(n, n_holes) << file;
    }
}

}  // namespace abut::messy_drawings_test
