// SPDX-License-Identifier: GPL-3.0-or-later
// Random connected parts with slots, cracks and thin arms, of size 1 to 3.
#pragma once
#include "tests/geometry/cells/random_parts.hpp"

namespace abut::geometry::test {

/// Of a slot: 1e-9 to 1 of `most`.
inline double random_width(double most, Random& random) {
    return most * std::pow(10.0, -9 * between(0, 1, random));
}

/// Of an arm: 1e-4 to 1 of `most`. Where thinner ones pass a corner of a cell, they may be below sliver_fraction of it.
inline double random_thickness(double most, Random& random) {
    return most * std::pow(10.0, -4 * between(0, 1, random));
}

inline Part polygon_part(const Corners& outline) {
    Part part;
    add_loop(part, closed(outline));
    return part;
}

/// Teeth on a base, with slots between them; two teeth: a U.
inline Part random_comb(int n_teeth, Random& random) {
    Corners outline{{-1, -0.8}};
    std::vector<double> xs{-1};
    for (int k = 1; k < n_teeth; ++k) {
        const double x = -1 + 2.0 * k / n_teeth, half = random_width(0.9 / n_teeth, random);
        xs.insert(xs.end(), {x - half, x + half});
    }
    xs.push_back(1);
    outline.push_back({1, -0.8});
    for (std::size_t k = xs.size(); k > 0; k -= 2) {
        const double top = between(0.3, 0.8, random);
        outline.insert(outline.end(), {{xs[k - 1], top}, {xs[k - 2], top}});
        if (k > 2) {
            const double bottom = between(-0.7, 0.2, random);
            outline.insert(outline.end(), {{xs[k - 2], bottom}, {xs[k - 3], bottom}});
        }
    }
    return polygon_part(outline);
}

/// A plate with slots inside: thin arms between two bars.
inline Part random_grating(Random& random) {
    Part part = polygon_part({{-1, -0.7}, {1, -0.7}, {1, 0.7}, {-1, 0.7}});
    const int n = 1 + static_cast<int>(random() % 6);
    double x = -1 + random_thickness(0.3 / n, random);
    for (int k = 0; k < n; ++k) {
        const double right = -1 + 2.0 * (k + 1) / n - random_thickness(1.0 / n, random);
        const double bottom = -0.7 + random_thickness(0.5, random), top = 0.7 - random_thickness(0.5, random);
        add_loop(part, closed({{x, bottom}, {x, top}, {right, top}, {right, bottom}}));
        x = -1 + 2.0 * (k + 1) / n + random_thickness(0.5 / n, random);
    }
    return part;
}

/// A band of the given half width along a square spiral.
inline Part random_spiral(Random& random) {
    const int n = 5 + static_cast<int>(random() % 8);
    const double pitch = 1.0 / n,
                 half = random() % 2 == 0 ? random_thickness(0.4 * pitch, random) : pitch - random_width(0.5 * pitch, random);
    Corners middle{{0, 0}};
    for (int k = 1; k <= n; ++k) {
        const double step = 2 * pitch * ((k + 1) / 2);
        const Vec2 d = k % 4 == 1 ? Vec2(1, 0) : k % 4 == 2 ? Vec2(0, 1) : k % 4 == 3 ? Vec2(-1, 0) : Vec2(0, -1);
        middle.push_back(middle.back() + step * d);
    }
    Corners left, right;
    for (std::size_t k = 0; k < middle.size(); ++k) {
        const Vec2 before = k > 0 ? Vec2((middle[k] - middle[k - 1]).normalized()) : Vec2(0, 0);
        const Vec2 after = k + 1 < middle.size() ? Vec2((middle[k + 1] - middle[k]).normalized()) : Vec2(0, 0);
        const Vec2 along = k == 0 ? Vec2(-after) : k + 1 == middle.size() ? before : Vec2(before - after);
        const Vec2 across = left_of(k == 0 ? after : k + 1 == middle.size() ? before : Vec2(before + after));
        const Vec2 end = k == 0 || k + 1 == middle.size() ? along : Vec2(0, 0);
        left.push_back(middle[k] + half * (across + 0.5 * end));
        right.push_back(middle[k] + half * (-across + 0.5 * end));
    }
    Corners outline = right;
    outline.insert(outline.end(), left.rbegin(), left.rend());
    return polygon_part(outline);
}

/// A ring cut open by a crack, of arcs.
inline Part random_cracked_ring(Random& random) {
    const double inner = between(0.2, 0.8, random), start = between(0, 6, random);
    const double gap = random_width(0.5, random), sweep = 2 * std::numbers::pi - gap;
    const Arc outside{{0, 0}, 1, start, sweep}, inside{{0, 0}, inner, start + sweep, -sweep};
    Part part;
    add_loop(part,
             {outside, Segment{point(outside, 1), point(inside, 0)}, inside, Segment{point(inside, 1), point(outside, 0)}});
    return part;
}

/// Thin or thick.
inline Part random_ring(Random& random) {
    const double turn = 2 * std::numbers::pi, inner = 1 - random_thickness(0.9, random);
    Part part;
    add_loop(part, {Arc{{0, 0}, 1, between(0, turn, random), turn}});
    add_loop(part, {Arc{{0, 0}, inner, between(0, turn, random), -turn}});
    return part;
}

/// Two discs and a neck.
inline Part random_dumbbell(Random& random) {
    const double half = random_thickness(0.2, random), r = 0.4, reach = std::sqrt(r * r - half * half);
    const double angle = std::asin(half / r), pi = std::numbers::pi;
    Part part;
    add_loop(part, {Segment{{-0.7 + reach, -half}, {0.7 - reach, -half}}, Arc{{0.7, 0}, r, pi + angle, 2 * (pi - angle)},
                    Segment{{0.7 - reach, half}, {-0.7 + reach, half}}, Arc{{-0.7, 0}, r, angle, 2 * (pi - angle)}});
    return part;
}

/// A rectangle with a notch: a wedge that ends in a point.
inline Part random_notched(Random& random) {
    const double x = between(-0.5, 0.5, random), half = random_width(0.3, random), tip = between(-0.7, 0.5, random);
    return polygon_part(
        {{-1, -0.8}, {1, -0.8}, {1, 0.8}, {x + half, 0.8}, {x + between(-0.2, 0.2, random), tip}, {x - half, 0.8}, {-1, 0.8}});
}

inline constexpr int n_slotted_kinds = 8;

/// Kinds 0 to n_slotted_kinds - 1; turned not at all, by a quarter, or by any angle, and moved.
inline Part slotted_part(int kind, Random& random) {
    const Part part = kind == 0   ? random_comb(2, random)
                      : kind == 1 ? random_comb(3 + static_cast<int>(random() % 6), random)
                      : kind == 2 ? random_grating(random)
                      : kind == 3 ? random_spiral(random)
                      : kind == 4 ? random_cracked_ring(random)
                      : kind == 5 ? random_ring(random)
                      : kind == 6 ? random_dumbbell(random)
                                  : random_notched(random);
    return turned_at_random(part, random);
}

}  // namespace abut::geometry::test
