// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the largest displacements of parts that lift off: these go by where contacts end.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/scene_answers.hpp"

namespace abut::displacement_errors_test {
namespace {

/// A beam that a cylinder presses on a soft pad on a table: both lift off at their ends. copies: of it, side by side.
Result on_pad(int copies, const std::string& level) {
    std::string parts, supports, loads;
    const auto rectangle = [](double x0, double y0, double x1, double y1) {
        return R"("geometry": {"rectangle": {"min": )" + test::pair_text(x0, y0) + R"(, "max": )" + test::pair_text(x1, y1) +
               "}}}";
    };
    for (int k = 0; k < copies; ++k) {
        const std::string n = std::to_string(k), comma = k > 0 ? ", " : "";
        const double x = 200 * k;
        parts += comma + R"({"name": "table)" + n + R"(", "material": "steel", )" + rectangle(x - 60, -20, x + 60, 0) +
                 R"(, {"name": "pad)" + n + R"(", "material": "soft", )" + rectangle(x - 40, 0, x + 40, 1) +
                 R"(, {"name": "beam)" + n + R"(", "material": "steel", )" + rectangle(x - 30, 1, x + 30, 5) +
                 R"(, {"name": "roller)" + n + R"(", "material": "steel", "geometry": {"circle": {"center": )" +
                 test::pair_text(x + 3, 11) + R"(, "radius": 6}}})";
        supports += comma + R"({"on": "table)" + n + R"(/bottom", "fix": ["x", "y"]}, {"part": "roller)" + n +
                    R"(", "rigid": {"translation": [0, null], "rotation": 0}})";
        loads += comma + R"({"part": "roller)" + n + R"(", "force": [0, -300]})";
    }
    return test::answer(R"({"abut": 1, "materials": {"steel": {"E": 210000, "nu": 0.3}, "soft": {"E": 3000, "nu": 0.38}},
        "parts": [)" + parts +
                        R"(], "supports": [)" + supports + R"(], "loads": [)" + loads + R"(], "accuracy": {"level": ")" +
                        level + R"("}})");
}

}  // namespace

TEST(DisplacementErrors, AreNotStatedTooLowWherePartsLiftOff) {
    const Result r = on_pad(1, "draft"), finer = on_pad(1, "fine");
    ASSERT_EQ(r.status, "ok") << r.message;
    ASSERT_EQ(finer.status, "ok") << finer.message;
    for (std::size_t k = 0; k < r.parts.size(); ++k) {
        const double truth = finer.parts[k].max_displacement.value;
        ASSERT_TRUE(r.parts[k].max_displacement_error && finer.parts[k].max_displacement_error);
        EXPECT_LE(std::abs(r.parts[k].max_displacement.value / truth - 1),
                  2 * *r.parts[k].max_displacement_error + *finer.parts[k].max_displacement_error)
            << r.parts[k].name;
    }
}

TEST(DisplacementErrors, AreThoseOfEachAssemblyWhereSeveralStandSideBySide) {
    const Result one = on_pad(1, "draft"), two = on_pad(2, "draft");
    ASSERT_EQ(two.status, "ok") << two.message;
    ASSERT_EQ(two.solver.groups, 2);
    for (std::size_t k = 0; k < two.parts.size(); ++k) {
        const PartResult& alone = one.parts[k % one.parts.size()];
        EXPECT_NEAR(*two.parts[k].max_displacement_error, *alone.max_displacement_error, 0.01 * *alone.max_displacement_error)
            << two.parts[k].name;
    }
}

}  // namespace abut::displacement_errors_test
