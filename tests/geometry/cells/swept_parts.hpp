// SPDX-License-Identifier: GPL-3.0-or-later
// The parts on which rules are tested, of straight sides and of arcs, and sweeps of them over random placements and grids.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/geometry/cells/random_grids.hpp"

namespace abut::geometry::test {

/// An outline counter-clockwise, holes clockwise.
inline Part of_polygons(const std::vector<Corners>& polygons) {
    Part part;
    for (const Corners& polygon : polygons) add_loop(part, closed(polygon));
    return part;
}

inline std::vector<std::vector<Corners>> straight_samples() {
    return {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
            {{{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}}},
            {{{0, 0}, {2, 0.125}, {0.25, 0.5}}},
            {{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}, {{0.75, 0}, {0.5, -0.25}, {0.25, 0}, {0.5, 0.25}}}};
}

inline std::vector<Part> curved_samples() {
    constexpr double pi = std::numbers::pi;
    Part disc, ring, slot, plate;
    add_loop(disc, {Arc{{0.25, -0.5}, 0.75, 0.3, 2 * pi}});
    add_loop(ring, {Arc{{0, 0}, 1, 0.7, pi}, Arc{{0, 0}, 1, 0.7 + pi, pi}});
    add_loop(ring, {Arc{{0.125, 0}, 0.5, 0, -2 * pi}});
    add_loop(slot, {Segment{{-1, -0.5}, {1, -0.5}}, Arc{{1, 0}, 0.5, -pi / 2, pi}, Segment{{1, 0.5}, {-1, 0.5}},
                    Arc{{-1, 0}, 0.5, pi / 2, pi}});
    plate = of_polygons({{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}});
    add_loop(plate, {Arc{{-0.5, 0}, 0.25, pi, -pi}, Arc{{-0.5, 0}, 0.25, 0, -pi}});
    return {disc, ring, slot, plate};
}

struct Turn {
    double c, s;
};

/// Not at all, by a quarter, and by any angle, in turn.
inline Turn random_turn(int k, Random& random) {
    if (k % 3 == 0) return {1, 0};
    if (k % 3 == 1) return {0, 1};
    const double angle = std::uniform_real_distribution<double>(-std::numbers::pi, std::numbers::pi)(random);
    return {std::cos(angle), std::sin(angle)};
}

/// Wider cells, and less far beyond the part, than in tests of areas: monomials to the power of 8 magnify roundings.
inline constexpr GridLimits rule_grid_limits{0.05, 0.3};

/// Calls check(part, cells, degree) for turned parts on random grids, degrees 1 to 4 in turn, until a check fails.
template <class Check>
inline void on_swept_grids(const std::vector<Part>& parts, int n_placements, Check check) {
    for (std::size_t which = 0; which < parts.size(); ++which) {
        Random random(23);
        for (int k = 0; k < n_placements; ++k) {
            const Turn turn = random_turn(k, random);
            const Part part = transformed(parts[which], turn.c, turn.s, {0.125, -0.25});
            SCOPED_TRACE("part " + std::to_string(which) + ", placement " + std::to_string(k));
            check(part, cut_cells(part, random_grid(part, random, rule_grid_limits)), 1 + k % 4);
            if (::testing::Test::HasFailure()) return;
        }
    }
}

inline std::vector<Part> straight_parts() {
    std::vector<Part> parts;
    for (const auto& polygons : straight_samples()) parts.push_back(of_polygons(polygons));
    return parts;
}

inline std::vector<Part> all_parts() {
    std::vector<Part> parts = straight_parts();
    for (const Part& part : curved_samples()) parts.push_back(part);
    return parts;
}

}  // namespace abut::geometry::test
