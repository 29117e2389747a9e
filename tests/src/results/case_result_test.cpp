// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/case_result.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/results/result_difference.hpp"

namespace abut::case_result_test {
namespace {

/// A square of side 2 about a point, all of which is displaced alike.
Result square_at(const Vec2& center, const Vec2& displacement) {
    Result r;
    r.status = "ok";
    r.parts.emplace_back();
    r.parts[0].name = "square";
    r.parts[0].max_displacement = {displacement.norm(), center};
    const std::array<Vec2, 4> corners{center + Vec2(-1, -1), center + Vec2(1, -1), center + Vec2(1, 1), center + Vec2(-1, 1)};
    r.geometry.emplace_back();
    r.fields.emplace_back();
    r.fields[0].boundary.emplace_back();
    geometry::Loop loop;
    for (std::size_t i = 0; i < 4; ++i) {
        r.geometry[0].edges.push_back({geometry::Segment{corners[i], corners[(i + 1) % 4]}, "e", "e"});
        loop.edges.push_back(static_cast<int>(i));
        r.fields[0].boundary[0].push_back({corners[i], displacement, {}});
    }
    r.geometry[0].loops.push_back(loop);
    return r;
}

}  // namespace

/// A part that one case has where it is drawn, and another far from there.
TEST(CaseResult, DisplacementsOfTheEnvelopeAreFromWherePartsAreDrawn) {
    Result moved = square_at({10, 0}, {0.1, 0});
    moved.parts[0].placement = PartResult::Moved{{3, 0}, 0};
    const Envelope shifted = envelope_of({{"near", {}, square_at({7, 0}, {0, 2})}, {"far", {}, moved}});
    EXPECT_EQ(shifted.parts.at(0).max_displacement.in_case, 1U);
    EXPECT_NEAR(shifted.parts.at(0).max_displacement.value, 3.1, 1e-12);
    moved.parts[0].placement = PartResult::Moved{{0, 0}, std::acos(-1) / 2};
    moved.fields[0].boundary[0][0].displacement = {0, 0};
    const Envelope turned = envelope_of({{"far", {}, moved}});
    EXPECT_NEAR(turned.parts.at(0).max_displacement.value, std::hypot(2, 0.1),
                0.1);  // a side's length, but for what it strains
}

/// So has result.json, and `compare` takes it: the same answer may be told from there, or from the drawing.
TEST(CaseResult, ResultsOfPartsThatWereTakenElsewhereCanBeCompared) {
    const Result as_drawn = square_at({7, 0}, {3.1, 0});
    Result moved = square_at({10, 0}, {0.1, 0});
    moved.parts[0].placement = PartResult::Moved{{3, 0}, 0};
    const ResultDifference d = compare_results(result_json(as_drawn), "a.json", result_json(moved), "b.json");
    const auto found = std::find_if(d.numbers.begin(), d.numbers.end(),
                                    [](const ComparedNumber& n) { return n.quantity == "max displacement"; });
    ASSERT_NE(found, d.numbers.end());
    EXPECT_NEAR(found->a.value(), 3.1, 1e-12);
    EXPECT_NEAR(found->b.value(), 3.1, 1e-12);
}

}  // namespace abut::case_result_test
