// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts and bonds over a few cells only, ends of which are held by supports: where pressures could have more coefficients
// than there are displacements to press on.
#include <gtest/gtest.h>

#include "src/results/result.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::test::coarse_contact_test {
namespace {

/// A block 6 wide pressed with 50 on a wider one, so many cells over the contact.
Result pressed(int cells) {
    return answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, "parts": [
        {"name": "body", "material": "m", "geometry": {"rectangle": {"min": [-10, 0], "max": [10, 8]}}},
        {"name": "pin", "material": "m", "geometry": {"rectangle": {"min": [-2, 8], "max": [4, 12]}}}],
        "supports": [{"on": "body/bottom", "fix": ["x", "y"]},
                     {"part": "pin", "rigid": {"translation": [0, null], "rotation": 0}}],
        "loads": [{"part": "pin", "force": [0, -50]}], "accuracy": {"cell_size": )" +
                  number(6.0 / cells) + "}}");
}

/// Two halves of a bar, bonded; the bond's ends on supports, at one end or at both.
Result pulled(int cells, bool both_ends) {
    const std::string more = both_ends ? R"(, "a/top", "b/top")" : "";
    return answer(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0}}, "parts": [
        {"name": "a", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]}}},
        {"name": "b", "material": "m", "geometry": {"rectangle": {"min": [2, 0], "max": [4, 1]}}}],
        "contacts": {"pairs": [{"between": ["a/right", "b/left"], "kind": "bonded"}]},
        "supports": [{"on": ["a/left", "a/bottom", "b/bottom")" +
                  more +
                  R"(], "symmetry": true}], "loads": [{"on": "b/right", "traction": [3, 0]}], "accuracy": {"cell_size": )" +
                  number(1.0 / cells) + "}}");
}

}  // namespace

TEST(CoarseContact, BlocksOverAFewCells) {
    for (int cells = 1; cells <= 8; ++cells) {
        SCOPED_TRACE(cells);
        const Result r = pressed(cells);
        ASSERT_EQ(r.status, "ok") << r.message;
        ASSERT_EQ(r.contacts.size(), 1u);
        EXPECT_NEAR(r.contacts[0].force.y(), -50, 1e-9 * 50);
        EXPECT_LT(r.equilibrium.relative_residual, 1e-9);
        for (double p : r.contacts[0].profile.pressure) EXPECT_GE(p, 0);
        EXPECT_LT(r.contacts[0].max_pressure.value, 5 * 50.0 / 6);
    }
}

TEST(CoarseContact, BondsThatEndOnSupports) {
    for (bool both_ends : {false, true})
        for (int cells = 1; cells <= 8; ++cells) {
            SCOPED_TRACE(std::to_string(cells) + (both_ends ? " cells, both ends held" : " cells"));
            const Result r = pulled(cells, both_ends);
            ASSERT_EQ(r.status, "ok") << r.message;
            ASSERT_EQ(r.contacts.size(), 1u);
            for (double p : r.contacts[0].profile.pressure) EXPECT_NEAR(p, -3, 1e-8);
            EXPECT_NEAR(r.strain_energy, 0.5 * 3 * 3 * 4 / 1000, 1e-10);
        }
}

}  // namespace abut::test::coarse_contact_test
