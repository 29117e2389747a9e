// SPDX-License-Identifier: GPL-3.0-or-later
// Halved cells pushed over a disc's rim in steps that leave slivers of any size: condition numbers do not depend on the cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/scene_answers.hpp"

namespace abut::halved_cells_test {
namespace {

/// A disc held along its rim and pressed in its middle, on cells of 0.25 that are halved five times in a box on the rim.
std::string scene_text(double offset, int degree, const std::string& basis) {
    std::string x, y;
    for (int k = 0; k < 12; ++k) {
        x += (k ? ", " : "") + test::number(-1.3 + offset + 0.25 * k);
        y += (k ? ", " : "") + test::number(-1.4 + 0.7 * offset + 0.25 * k);
    }
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}},
        "parts": [{"name": "p", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": 1}}}],
        "supports": [{"on": "p/circle", "fix": ["x", "y"]}], "loads": [{"part": "p", "body_force": [1, 2]}],
        "accuracy": {"basis": ")" +
           basis + R"(", "degree": )" + std::to_string(degree) + R"(, "grids": {"p": {"x": [)" + x + R"(], "y": [)" + y +
           R"(], "refine": [{"from": [0.6, 0.5], "to": [0.8, 0.7], "levels": 5}]}}}})";
}

/// Shifts by a cell's fractions, and to slivers of 1e-1 to 1e-12 of the part.
std::vector<double> shifts() {
    std::vector<double> all;
    for (int k = 1; k <= 12; ++k) all.push_back(0.05 + std::pow(10.0, -k));
    for (int k = 0; k < 12; ++k) all.push_back(0.013 * k);
    return all;
}

class HalvedCells : public testing::TestWithParam<int> {};

TEST_P(HalvedCells, ConditionNumbersDoNotDependOnTheCut) {
    std::vector<double> condition;
    double smallest = 1;
    for (const double offset : shifts()) {
        const Result r = test::answer(scene_text(offset, GetParam(), "web"));
        ASSERT_EQ(r.status, "ok") << offset << ": " << r.message;
        condition.push_back(r.solver.condition_estimate);
        smallest = std::min(smallest, r.parts[0].quality.smallest_fraction);
    }
    EXPECT_LT(smallest, 1e-11);
    std::sort(condition.begin(), condition.end());
    EXPECT_LT(condition.back(), 6 * condition[condition.size() / 2]);
    EXPECT_LT(condition.back(), 2e4);
}

INSTANTIATE_TEST_SUITE_P(Degrees, HalvedCells, testing::Values(1, 2));

/// The check above can fail: without extension slivers are seen.
TEST(HalvedCellsChecks, PlainFunctionsSeeSlivers) {
    int failed = 0;
    double worst = 0;
    for (const double offset : shifts()) {
        const Result r = test::answer(scene_text(offset, 2, "plain"));
        failed += r.status != "ok";
        worst = std::max(worst, r.solver.condition_estimate);
    }
    EXPECT_TRUE(failed > 0 || worst > 1e6) << failed << " failed, " << worst;
}

}  // namespace
}  // namespace abut::halved_cells_test
