// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/clear_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/csg/exact_outline.hpp"

namespace abut::geometry::clear_pieces_test {
namespace {

OutlinePiece arc(const Vec2& center, double radius, double from_degrees, double to_degrees) {
    const auto at = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vec2(center + radius * Vec2(std::cos(angle), std::sin(angle)));
    };
    return {at(from_degrees), at(0.5 * (from_degrees + to_degrees)), at(to_degrees), to_degrees > from_degrees ? 1 : -1};
}

OutlinePiece line(const Vec2& from, const Vec2& to) {
    return {from, from, to, 0};
}

std::vector<CommonOfPieces> exactly_common(const OutlinePiece& a, const OutlinePiece& b) {
    const Outline first = outline_of({{a}}), second = outline_of({{b}});
    return PieceMeetings(first, second).of(0, 0);
}

/// The arc of a ball of a bearing and the rim of its cage on both sides of the pocket: their hulls overlap, and the circles
/// cross, but on the other side of the ball and in the pocket.
TEST(ClearPieces, MayLieOnCirclesThatCrossElsewhere) {
    const OutlinePiece ball = arc({0, 16.75}, 2.55, 90, 180), rim = arc({0, 0}, 17.9, 97.72, 122.28);
    EXPECT_TRUE(clearly_meet_at_corners_only(hulled(ball), hulled(rim)));
    EXPECT_TRUE(clearly_meet_at_corners_only(hulled(rim), hulled(ball)));
    EXPECT_TRUE(exactly_common(ball, rim).empty());
    const OutlinePiece longer = arc({0, 0}, 17.9, 97.5, 122.28), whole = arc({0, 0}, 17.9, 90, 122.28);
    EXPECT_EQ(clearly_meet_at_corners_only(hulled(ball), hulled(longer)), exactly_common(ball, longer).empty());
    EXPECT_FALSE(clearly_meet_at_corners_only(hulled(ball), hulled(whole)));
    EXPECT_EQ(exactly_common(ball, whole).size(), 1U);
}

/// Ends at whole numbers, so that pieces touch and share corners; arcs up to half a turn.
TEST(ClearPieces, HaveNothingButCornersInCommonExactly) {
    std::mt19937 random(3);
    const auto number = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto place = [&] { return Vec2(number(8), number(8)); };
    const auto piece = [&] {
        const Vec2 from = place();
        const double begin = 15 * number(24), turn = 15 * (1 + number(12));
        if (number(3) == 0) return line(from, from + Vec2(1 + number(5), number(5)));
        return arc(from, 1 + number(5), begin, number(2) ? begin + turn : begin - turn);
    };
    int n_clear = 0, n_common = 0;
    for (int round = 0; round < 4000; ++round) {
        const OutlinePiece a = piece(), b = piece();
        const HulledPiece first = hulled(a), second = hulled(b);
        if (first.hull.empty() || second.hull.empty() || !first.box.overlaps(second.box, 0)) continue;
        const std::vector<CommonOfPieces> common = exactly_common(a, b);
        n_common += !common.empty();
        if (!clearly_meet_at_corners_only(first, second)) continue;
        ++n_clear;
        for (const CommonOfPieces& c : common) EXPECT_TRUE(c.is_shared_corner) << round << " at " << c.begin.transpose();
    }
    EXPECT_GT(n_clear, 500);
    EXPECT_GT(n_common, 200);
}

}  // namespace
}  // namespace abut::geometry::clear_pieces_test
