// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abut::report {

namespace {

constexpr double clearance = 2;     ///< pixels between a label and what it must not cover
constexpr double outside_cost = 8;  ///< leaving the frame is worse than covering something

Box2 around(const Vec2& middle, const Vec2& size) {
    Box2 box;
    box.extend(Vec2(middle - 0.5 * size));
    box.extend(Vec2(middle + 0.5 * size));
    return box;
}

double common_area(const Box2& a, const Box2& b) {
    const Vec2 size = (a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min)).cwiseMax(0);
    return size.x() * size.y();
}

}  // namespace

void LabelPlaces::block(const Vec2& point, double radius) {
    block(around(point, Vec2::Constant(2 * radius)));
}

double LabelPlaces::overlap(const Box2& box) const {
    double sum = outside_cost * (box.size().prod() - common_area(box, frame_));
    for (const Box2& taken : taken_) sum += common_area(box, taken);
    return sum;
}

Vec2 LabelPlaces::place(const Vec2& anchor, const Vec2& size, const Vec2& preferred) {
    const double base = preferred.isZero(0) ? -std::numbers::pi / 4 : std::atan2(preferred.y(), preferred.x());
    const Vec2 needed = size + Vec2::Constant(2 * clearance);
    Vec2 best = anchor;
    double least = std::numeric_limits<double>::infinity();
    for (double distance : {8.0, 14.0, 22.0, 34.0, 50.0, 72.0, 100.0, 140.0})
        for (int k = 0; k < 16; ++k) {
            const int turn = (k + 1) / 2 * (k % 2 ? 1 : -1);  // 0, 1, -1, 2, -2, ...
            const double angle = base + turn * std::numbers::pi / 8;
            const Vec2 direction(std::cos(angle), std::sin(angle));
            const Vec2 middle = anchor + distance * direction + 0.5 * size.cwiseProduct(direction);
            const double covered = overlap(around(middle, needed));
            if (covered >= least - 1e-9) continue;
            least = covered;
            best = middle;
            if (covered > 0) continue;
            block(around(best, size));
            return best;
        }
    block(around(best, size));
    return best;
}

bool LabelPlaces::take(const Vec2& middle, const Vec2& size) {
    const Box2 box = around(middle, size + Vec2::Constant(2 * clearance));
    if (overlap(box) > 0) return false;
    block(box);
    return true;
}

}  // namespace abut::report
