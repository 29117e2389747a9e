// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/next_candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/verification/true_errors.hpp"

namespace abut::next_candidates_test {
namespace {

/// A contact whose only stretch is this one.
SolvedAssembly with_run(const PressedStretch& stretch, bool begin_is_limit, bool end_is_limit) {
    SolvedAssembly s;
    s.contacts.emplace_back();
    s.contacts[0].zone.begin_is_limit = begin_is_limit;
    s.contacts[0].zone.end_is_limit = end_is_limit;
    s.stretches = {{stretch}};
    return s;
}

const Scene& pin_scene() {
    static const Scene scene = test::adaptive_scene({"verification/pin_in_hole.json"});
    return scene;
}

Outcome solved_pin() {
    return test::solved_to(pin_scene(), 0.05);
}

}  // namespace

TEST(NextCandidates, AZoneIsTooShortWhereContactReachesItsLimit) {
    const PressedStretch inside{0.2, 0.8, false, false, {}, {}}, whole{0, 1, true, true, {}, {}},
        left{0, 0.5, true, false, {}, {}};
    EXPECT_FALSE(zone_too_short(with_run(inside, true, true)));
    EXPECT_TRUE(zone_too_short(with_run(whole, false, true)));
    EXPECT_FALSE(zone_too_short(with_run(whole, false, false)));
    EXPECT_TRUE(zone_too_short(with_run(left, true, false)));
    EXPECT_FALSE(zone_too_short(with_run(left, false, true)));
    SolvedAssembly bonded = with_run(whole, true, true);
    bonded.contacts[0].face.bilateral = true;
    EXPECT_FALSE(zone_too_short(bonded));
}

/// A pin drawn in the middle of its hole: its zone goes all the way round, and the seam is not in the contact.
TEST(NextCandidates, SeamsMoveOutOfTheContact) {
    Outcome pin = solved_pin();
    ASSERT_EQ(pin.candidates.size(), 1u);
    ASSERT_TRUE(pin.candidates[0].zone.closed);
    ASSERT_EQ(pin.solved.stretches[0].size(), 1u);
    EXPECT_FALSE(pin.solved.stretches[0][0].from_start || pin.solved.stretches[0][0].to_end);
    // such a solution leaves its candidates alone
    std::vector<Candidate> next = pin.candidates;
    move_seams(pin_scene(), pin.solved, next);
    EXPECT_EQ(next[0].zone.begin1, pin.candidates[0].zone.begin1);
    // one whose contact reaches the seam does not
    pin.solved.stretches[0][0] = {0, 0.3 * pin.solved.contacts[0].s.back(), true, false, {}, {}};
    move_seams(pin_scene(), pin.solved, next);
    EXPECT_NE(next[0].zone.begin1, pin.candidates[0].zone.begin1);
    EXPECT_NEAR(next[0].zone.end1 - next[0].zone.begin1, next[0].zone.chain1.length, 1e-12);
}

TEST(NextCandidates, FreeEndsAreExpectedWhereTheyWereFound) {
    Outcome pin = solved_pin();
    std::vector<Candidate> next = pin.candidates;
    expect_ends(pin_scene(), pin.solved, pin.solved.stretches, next);
    ASSERT_EQ(next[0].ends.size(), 2u);
    EXPECT_TRUE(moved_ends(pin_scene(), pin.solved, next).empty());
    next[0].ends.clear();
    EXPECT_EQ(moved_ends(pin_scene(), pin.solved, next), (std::vector<std::size_t>{0}));
    pin.solved.contacts[0].face.bilateral = true;
    expect_ends(pin_scene(), pin.solved, pin.solved.stretches, next);
    EXPECT_TRUE(next[0].ends.empty());
}

TEST(NextCandidates, PressuresAreExpectedWhereTheyWereFound) {
    Outcome pin = solved_pin();
    std::vector<Candidate> next = pin.candidates;
    expect_pressures(pin.solved, next);
    const ExpectedPressure& expected = next[0].expected;
    ASSERT_EQ(expected.s1.size(), expected.pressure.size());
    ASSERT_TRUE(std::is_sorted(expected.s1.begin(), expected.s1.end()));
    const auto is_pressed = [](double p) { return p > 0; };
    const auto& coefficients = pin.solved.solution.pressure[0];
    EXPECT_EQ(std::count_if(expected.pressure.begin(), expected.pressure.end(), is_pressed),
              std::count_if(coefficients.begin(), coefficients.end(), is_pressed));
    Stopwatches seconds;
    const Eigen::VectorXd pressure = pin.solved.solution.pressure[0];
    next[0].ends = pin.candidates[0].ends;
    std::vector<Candidate> without = next;
    without[0].expected = {};
    solve_contacts_again(pin_scene(), without, pin.solved, seconds, 1);
    EXPECT_GT(pin.solved.solution.iterations, 1);
    solve_contacts_again(pin_scene(), next, pin.solved, seconds, 1);
    EXPECT_EQ(pin.solved.solution.iterations, 1);
    EXPECT_LT((pin.solved.solution.pressure[0] - pressure).norm(), 1e-9 * pressure.norm());
}

/// A wider search begins closed chains elsewhere, which may be a turn on.
TEST(NextCandidates, AWiderSearchInheritsWhatIsExpected) {
    Outcome pin = solved_pin();
    std::vector<Candidate> before = pin.candidates;
    expect_ends(pin_scene(), pin.solved, pin.solved.stretches, before);
    expect_pressures(pin.solved, before);
    std::vector<Candidate> wider = before;
    wider[0].ends.clear();
    wider[0].expected = {};
    const double turn = wider[0].zone.chain1.length;
    wider[0].zone.begin1 += turn;
    wider[0].zone.end1 += turn;
    wider.push_back(wider[0]);
    std::reverse(wider[1].zone.chain2.edges.begin(), wider[1].zone.chain2.edges.end());
    wider[1].zone.chain2.edges.push_back(0);  // other faces
    inherit_expected(before, wider);
    ASSERT_EQ(wider[0].ends.size(), before[0].ends.size());
    for (std::size_t k = 0; k < before[0].ends.size(); ++k) {
        EXPECT_NEAR(wider[0].ends[k].s1, before[0].ends[k].s1 + turn, 1e-12 * turn);
        EXPECT_EQ(wider[0].ends[k].outward, before[0].ends[k].outward);
    }
    EXPECT_EQ(wider[0].expected.pressure, before[0].expected.pressure);
    EXPECT_TRUE(wider[1].ends.empty() && wider[1].expected.s1.empty());
}

TEST(NextCandidates, TheSearchReachesAsFarAsThePartsMove) {
    Outcome pin = solved_pin();
    const double factor = needed_search_factor(pin_scene(), pin.solved);
    EXPECT_GT(factor, 0);
    for (Eigen::VectorXd& u : pin.solved.solution.displacement) u *= 3;
    EXPECT_NEAR(needed_search_factor(pin_scene(), pin.solved), 3 * factor, 1e-12 * factor);
}

}  // namespace abut::next_candidates_test
