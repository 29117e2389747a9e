// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's contact search where it decides: which pairs, along which stretches.
#include "src/contact/cell_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/contact/candidates.hpp"
#include "src/contact/detect.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::cell_search_test {
namespace {

Scene scene_of(const std::string& parts, const std::string& accuracy) {
    return read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [)" + parts +
                               R"(], "accuracy": {)" + accuracy + "}}",
                           "s.json");
}

std::string block(const std::string& name, const std::string& min, const std::string& max) {
    return R"({"name": ")" + name + R"(", "material": "m", "geometry": {"rectangle": {"min": )" + min + R"(, "max": )" + max +
           "}}}";
}

std::string by_cells(double size) {
    return R"("method": "dissertation", "cell_size": )" + std::to_string(size);
}

const std::string floor_part = block("floor", "[0, 0]", "[10, 2]");

TEST(CellSearch, DecidesWhichPairsAreInContact) {
    // gaps of 0.2 and 0.9: whether cells of 0.4 meet depends on where the grid's lines are, not on the distance alone
    const std::string parts =
        floor_part + ", " + block("near", "[1, 2.2]", "[3, 4]") + ", " + block("far", "[5, 2.9]", "[7, 4]");
    EXPECT_EQ(find_candidates(scene_of(parts, by_cells(0.4)), 1).size(), 1U);
    EXPECT_EQ(find_candidates(scene_of(parts, by_cells(1)), 1).size(), 2U);
    EXPECT_TRUE(find_candidates(scene_of(parts, by_cells(0.05)), 1).empty());
    // `abut contacts` lists the same
    const Scene coarse = scene_of(parts, by_cells(1)), fine = scene_of(parts, by_cells(0.05));
    EXPECT_EQ(detect_contacts(coarse, std::nullopt).pairs.size(), 2U);
    EXPECT_TRUE(detect_contacts(fine, std::nullopt).pairs.empty());
    EXPECT_EQ(detect_contacts(coarse, std::nullopt).pairs[0].cells_case, std::string(1, CellSearch(coarse).case_of(0, 1)));
}

TEST(CellSearch, LetsInWhatLiesInContactCellsAlone) {
    // a roller of radius 2 on a floor: cells of h meet where the gap is below h, about
    const std::string parts =
        floor_part + R"(, {"name": "roller", "material": "m", "geometry": {"circle": {"center": [5, 4], "radius": 2}}})";
    double before = 0;
    for (const double h : {0.1, 0.2, 0.4}) {
        const std::vector<Candidate> found = find_candidates(scene_of(parts, by_cells(h)), 1);
        ASSERT_EQ(found.size(), 1U);
        const geometry::FacingZone& zone = found[0].zone;
        EXPECT_TRUE(zone.begin_is_limit && zone.end_is_limit);
        EXPECT_NEAR(zone.gap_min, 0, 1e-9);
        EXPECT_LE(zone.gap_max, std::sqrt(5.0) * h);
        const double length = zone.end1 - zone.begin1;
        // along the straight floor the stretch ends at grid lines, and is one
        EXPECT_NEAR(length / h, std::round(length / h), 1e-6);
        EXPECT_GT(length, before);
        before = length;
    }
}

TEST(CellSearch, KeepsAClosedZoneClosed) {
    const std::string parts =
        R"({"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-3, -3], "max": [3, 3]}},
           {"circle": {"center": [0, 0], "radius": 1}}]}},
           {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 0.98}}})";
    const std::vector<Candidate> found = find_candidates(scene_of(parts, by_cells(0.2)), 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].zone.closed);
    EXPECT_NEAR(found[0].zone.end1 - found[0].zone.begin1, 2 * std::numbers::pi, 1e-9);
}

TEST(CellSearch, FacesOnGridLinesMeetAllAlong) {
    // the interface y = 2 is a line of the grid: inner cells beside inner ones, and at the top block's sides boundary cells
    const std::string parts = floor_part + ", " + block("top", "[1.25, 2]", "[8.75, 3.75]");
    const std::vector<Candidate> found = find_candidates(scene_of(parts, by_cells(0.5)), 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].zone.end1 - found[0].zone.begin1, 7.5, 1e-9);
}

TEST(CellSearch, IsNotThereWithoutTheMethod) {
    EXPECT_FALSE(cell_search(scene_of(floor_part + ", " + block("b", "[1, 2]", "[3, 4]"), "")));
}

TEST(CellSearch, RefusesAGridOfTooManyCells) {
    const Scene scene =
        scene_of(floor_part + ", " + block("b", "[1, 2]", "[3, 4]"), R"("method": "dissertation", "cell_size": 1e-3)");
    try {
        search_grid(scene);
        FAIL();
    } catch (const InputError& error) { EXPECT_EQ(error.problems().front().where, "/accuracy/cell_size"); }
}

}  // namespace
}  // namespace abut::cell_search_test
