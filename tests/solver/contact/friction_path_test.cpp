// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace abut::solver::friction_path_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A point on springs of stiffness 1 across and along a face, at a gap, that loads push down and aside.
struct Point {
    double gap = 0, down = 1, aside = 0;
};

/// Points that do not feel each other, rows n t n t ... by point.
struct Springs {
    ContactQp qp;
    PathStart start;

    explicit Springs(const std::vector<Point>& points, double coefficient) {
        const auto n = static_cast<Index>(points.size()), m = 2 * n;
        qp.compliance = MatrixXd::Identity(m, m);
        qp.gap = start.gap = VectorXd::Zero(m);
        qp.modes = MatrixXd::Zero(m, 0);
        qp.mode_load = start.mode_load = VectorXd::Zero(0);
        qp.foundation = VectorXd::Ones(m);
        qp.load_scale = 1;
        for (Index k = 0; k < n; ++k) {
            const Point& p = points[static_cast<std::size_t>(k)];
            start.gap[2 * k] = p.gap;
            qp.gap[2 * k] = p.gap - p.down;
            qp.gap[2 * k + 1] = p.aside;
            qp.unilateral.insert(qp.unilateral.end(), {1, 0});
            qp.friction.push_back({static_cast<int>(2 * k), static_cast<int>(2 * k + 1), coefficient});
        }
        qp.drawn_gap = start.gap;
    }

    FrictionPath follow(std::optional<double> tolerance = 0.005) const {
        const MatrixXd none(0, 0);
        return follow_path(qp, start, VectorXd::Zero(qp.modes.cols()), VectorXd::Ones(qp.gap.size()), {none, none, none},
                           MatrixXd::Zero(qp.gap.size(), 0), tolerance);
    }
};

VectorXd forces_of(const FrictionPath& path) {
    EXPECT_TRUE(path.end.has_answer());
    return path.end.result.multipliers;
}

}  // namespace

TEST(FrictionPath, WhatTouchesLateSticksWhereItTouches) {
    for (const double gap : {0.0, 1e-6, 0.1, 0.25, 0.4, 0.5, 0.77, 0.999}) {
        const FrictionPath path = Springs({{gap, 1, 0.3}}, 0.5).follow();
        const VectorXd forces = forces_of(path);
        EXPECT_NEAR(forces[0], 1 - gap, 1e-12) << gap;
        EXPECT_NEAR(forces[1], -0.3 * (1 - gap), 1e-3) << gap << ": it goes " << 0.3 * gap << " aside before it touches";
        EXPECT_NEAR(path.way.work.sum(), 0, 1e-3) << gap;
        EXPECT_LE(std::abs(forces[1] + 0.3 * (1 - gap)), path.way.error[1] + 0.005 * 0.3)
            << gap << ", touching but for a tolerance";
    }
}

/// Where the loads are put on at once, too: held bodies go where these take them.
TEST(FrictionPath, WhatTouchesIsHeldFromThereAtOnce) {
    for (const double gap : {0.1, 0.5, 0.999}) {
        const VectorXd forces = forces_of(Springs({{gap, 1, 3}, {gap, 1, -0.1}}, rough_coefficient).follow(std::nullopt));
        EXPECT_NEAR(forces[0], 1 - gap, 1e-12) << gap;
        EXPECT_NEAR(forces[1], -3 * (1 - gap), 1e-12) << gap;
        EXPECT_NEAR(forces[3], 0.1 * (1 - gap), 1e-12) << gap;
    }
}

TEST(FrictionPath, ManyPointsThatTouchOneAfterTheOther) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Point> points;
        for (int k = 0; k < 12; ++k) points.push_back({number(random), 1, 0.8 * number(random) - 0.4});
        const VectorXd forces = forces_of(Springs(points, 0.5).follow());
        for (std::size_t k = 0; k < points.size(); ++k)
            EXPECT_NEAR(forces[static_cast<Index>(2 * k + 1)], -points[k].aside * (1 - points[k].gap), 5e-3)
                << trial << " " << k;
    }
}

TEST(FrictionPath, SlipsAtItsBoundAndSaysWhatThatTakes) {
    // pressed by 1 at the start, then pulled by 2: it sticks up to 0.5 and slips by 1.5
    Springs springs({{0, 1, 2}}, 0.5);
    springs.start.gap[0] = -1;
    springs.start.is_loaded = true;
    const FrictionPath path = springs.follow();
    EXPECT_NEAR(forces_of(path)[1], -0.5, 1e-12);
    EXPECT_NEAR(path.way.work.sum(), 0.5 * 1.5, 1e-12);
    EXPECT_NEAR(path.way.work_error.sum(), 0, 1e-12);
}

TEST(FrictionPath, InProportionOneIncrementIsAsGoodAsMany) {
    const FrictionPath path = Springs({{0, 1, 0.3}, {0, 2, -0.1}, {0, 1, 0.9}}, 0.5).follow();
    EXPECT_EQ(path.way.increments, 2) << "the least that tells";
    EXPECT_NEAR(path.way.error.norm(), 0, 1e-12);
    const VectorXd forces = forces_of(path);
    EXPECT_NEAR(forces[1], -0.3, 1e-12);
    EXPECT_NEAR(forces[5], -0.5, 1e-12);
    // bound and slip both grow evenly: the work is half of what they come to
    EXPECT_NEAR(path.way.work.sum(), 0.5 * 0.5 * 0.4, 1e-12);
}

TEST(FrictionPath, RoughFacesToo) {
    const VectorXd forces = forces_of(Springs({{0.4, 1, 3}}, rough_coefficient).follow());
    EXPECT_NEAR(forces[1], -3 * 0.6, 1e-2);
}

TEST(FrictionPath, OfWhatStaysOpenIsOneIncrement) {
    const FrictionPath path = Springs({{2, 1, 1}, {1.5, 1, -1}}, 0.3).follow();
    EXPECT_EQ(path.way.increments, 1);
    EXPECT_NEAR(forces_of(path).norm(), 0, 1e-15);
    EXPECT_EQ(path.way.error.norm(), 0);
}

TEST(FrictionPath, WhatFallsOnOthersDoesSoInOneIncrement) {
    // nothing holds the body against its load down; it lies on the face from the first load on, and sticks there as it goes
    // aside
    Springs body({{0.5, 0, 0.3}}, 0.5);
    body.qp.modes = MatrixXd{{1}, {0}};
    body.qp.mode_load = VectorXd{{-1}};
    body.start.mode_load = VectorXd{{0}};
    const MatrixXd one = MatrixXd::Identity(1, 1), none(1, 0);
    const FrictionPath path =
        follow_path(body.qp, body.start, VectorXd::Zero(1), VectorXd::Ones(2), {one, none, none}, MatrixXd::Zero(2, 0), 0.005);
    const VectorXd forces = forces_of(path);
    EXPECT_NEAR(forces[0], 1, 1e-12);
    EXPECT_NEAR(forces[1], -0.3, 1e-12);
    EXPECT_EQ(path.way.increments, 3);
}

TEST(FrictionPath, FollowsMoreCloselyWhereMoreIsAskedFor) {
    // springs that feel each other: no prediction is exact
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    for (int trial = 0; trial < 10; ++trial) {
        std::vector<Point> points;
        for (int k = 0; k < 8; ++k) points.push_back({0.1 * k, 1, 0.3 * number(random)});
        Springs springs(points, 0.4);
        const Index m = springs.qp.gap.size();
        const MatrixXd b = MatrixXd::NullaryExpr(m, m, [&]() { return 0.15 * number(random); });
        springs.qp.compliance = MatrixXd(MatrixXd::Identity(m, m) + b * b.transpose());
        const FrictionPath closely = springs.follow(1e-6);
        for (const double tolerance : {0.1, 0.01, 0.001}) {
            const FrictionPath path = springs.follow(tolerance);
            ASSERT_TRUE(path.end.has_answer()) << trial;
            const double away = (path.end.result.multipliers - forces_of(closely)).norm();
            EXPECT_LE(away, 2 * tolerance * forces_of(closely).norm()) << trial << " " << tolerance;
            EXPECT_LE(path.way.increments, closely.way.increments) << trial;
        }
    }
}

}  // namespace abut::solver::friction_path_test
