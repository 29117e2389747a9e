// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_pairing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::contact_pairing_test {
namespace {

using geometry::FacingPair;
using geometry::FacingZone;

/// A disc of radius 1 above a groove of radius 2, apart by `gap`.
Scene disc_above_groove(double gap) {
    const TemporaryFolder folder;
    return read_scene(folder.write("s.json", R"({"abut": 1, "parameters": {"g": )" + std::to_string(gap) + R"(},
        "materials": {"m": {"E": 1, "nu": 0}}, "parts": [
        {"name": "disc", "material": "m", "geometry": {"circle": {"center": [0.1, "1+g"], "radius": 1}}},
        {"name": "block", "material": "m", "geometry": {"difference": [
            {"rectangle": {"min": [-3, -2], "max": [3, 1]}}, {"circle": {"center": [0, 2], "radius": 2}}]}}]})"));
}

struct Pairs {
    Scene scene;
    FacingZone zone;
    explicit Pairs(double gap) : scene(disc_above_groove(gap)), zone(find_facing_zones(part(0), part(1), 0.3).at(0)) {}
    const geometry::Part& part(std::size_t k) const { return scene.parts[k].part; }
    FacingPair at(Pairing pairing, double fraction) const {
        const double s1 = zone.begin1 + fraction * (zone.end1 - zone.begin1);
        const double guess = zone.begin2 + fraction * (zone.end2 - zone.begin2);
        return paired(part(0), part(1), zone, pairing, s1, guess);
    }
};

constexpr double rounding = 1e-12;

TEST(ContactPairing, MiddleIsTheGeometrysOwn) {
    const Pairs p(0.05);
    for (double f : {0.2, 0.5, 0.7}) {
        const FacingPair a = p.at(Pairing::middle, f);
        const FacingPair b = pair_from_first(p.part(0), p.part(1), p.zone, a.s1, a.s2);
        EXPECT_NEAR(a.s2, b.s2, rounding);
        EXPECT_NEAR(a.gap, b.gap, rounding);
    }
}

TEST(ContactPairing, MasterMeetsTheSecondBodyAlongTheFirstsNormal) {
    const Pairs p(0.05);
    for (double f = 0.1; f < 0.95; f += 0.1) {
        const FacingPair pair = p.at(Pairing::master, f);
        ASSERT_TRUE(pair.found) << f;
        EXPECT_LT((pair.normal - pair.on1.normal).norm(), rounding);
        EXPECT_LT((pair.on1.x + pair.gap * pair.normal - pair.on2.x).norm(), rounding) << f;
        EXPECT_NEAR((pair.on2.x - Vec2(0, 2)).norm(), 2, rounding);
        EXPECT_EQ(pair.length_rate, 1);
    }
}

}  // namespace
}  // namespace abut::contact_pairing_test
