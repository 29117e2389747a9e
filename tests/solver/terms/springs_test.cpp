// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/springs.hpp"

#include <gtest/gtest.h>

#include "solver/parts/part_system.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::springs_test {
namespace {

using Eigen::VectorXd;

constexpr double E = 1000;

/// A foundation along the left side of a 2 x 1 bar, or along its bottom.
SpringSet foundation(const PartInput& part, bool left, double normal, double tangential) {
    SpringSet set{0, {}, normal, tangential};
    const Vec2 to = left ? Vec2(0, 1) : Vec2(2, 0), n = left ? Vec2(-1, 0) : Vec2(0, -1);
    for (const test::EdgePoint& p : test::edge_points(part.space, {0, 0}, to, n, part.space.x.degree + 2))
        set.points.push_back({p.element, p.x, n, p.weight});
    return set;
}

VectorXd pull(const PartInput& part, const Vec2& traction) {
    return boundary_load(part, test::traction_on(part.space, {2, 0}, {2, 1}, {1, 0}, [&](const Vec2&) { return traction; }));
}

PartSystem on_springs(const PartInput& part, const std::vector<SpringSet>& springs, const VectorXd& load) {
    return make_part_system(part, {}, load, test::middle_of(part), test::size_of(part), springs);
}

/// Rod of length 2 pulled by s on springs k: end moves by s/k + 2 s/E. nu = 0, so that nothing contracts.
TEST(Springs, CarryARodAsTheClosedFormSays) {
    for (int degree = 1; degree <= 4; ++degree)
        for (double k : {1e-300, 1e-12, 1e-3, 1.0, 1e3, 1e6}) {
            const PartInput part = test::rectangle(2, 1, 4, 3, degree, false, plane_stress(E, 0), 0.5);
            const double s = 7;
            const PartSystem system = on_springs(part, {foundation(part, true, k, k)}, pull(part, {s, 0}));
            ASSERT_TRUE(system.failure.empty()) << system.failure;
            ASSERT_TRUE(system.free_motions.empty());
            const VectorXd u = solve(system, system.load);
            const double end = displacement_at(part, u, part.space.cell_at({2, 0.3}), {2, 0.3}).value.x();
            EXPECT_NEAR(end, s / k + 2 * s / E, 1e-12 * (s / k + 2 * s / E)) << degree << " " << k;
            const SpringAnswer answer = spring_answer(part, system.springs[0], u);
            EXPECT_NEAR(answer.force.force.x(), -s * 0.5, 1e-12 * s) << degree << " " << k;
            EXPECT_NEAR(answer.energy, 0.5 * s * s / k * 0.5, 1e-11 * s * s / k);
            if (k >= 1e-3)  // else displacements leave no digits of their strain
                EXPECT_NEAR(strain_energy(system, u), 0.5 * s * s / E * 2 * 0.5, 1e-11 * (1 + E / k) * s * s / k);
        }
}

/// A stiff block pressed on a foundation sinks and turns as a rigid body (Winkler): pressure k (v + theta (x - 1)).
TEST(Springs, AStiffBlockSinksAndTurnsOnAWinklerFoundation) {
    const double k = 1e-5;
    const PartInput part = test::rectangle(2, 1, 4, 3, 2, true, plane_stress(E, 0.3));
    const PartSystem system = on_springs(part, {foundation(part, false, k, k)}, pull(part, {0, -0.001}));
    const VectorXd u = solve(system, system.load);
    // force -0.001 at x = 2: v = F/(2k) at the middle, theta = F (2 - 1) / (k 2^3/12)
    const double v = -0.001 / (2 * k), theta = -0.001 / (k * 8 / 12);
    for (double x : {0.0, 0.7, 2.0}) {
        const double got = displacement_at(part, u, part.space.cell_at({x, 0}), {x, 0}).value.y();
        // the block's own strain is of order k / E
        EXPECT_NEAR(got, v + theta * (x - 1), 1e-5 * std::abs(v)) << x;
    }
    EXPECT_NEAR(spring_answer(part, system.springs[0], u).force.force.y(), 0.001, 1e-9);
}

TEST(Springs, HoldWhatTheyResistHoweverSoftAndNothingElse) {
    const PartInput part = test::rectangle(2, 1, 4, 3, 2);
    const VectorXd none = VectorXd::Zero(2 * part.space.n_functions);
    for (double k : {1e-4, 1.0, 1e9}) {
        EXPECT_EQ(on_springs(part, {foundation(part, true, k, 0)}, none).free_motions.size(), 1u) << k;
        EXPECT_EQ(on_springs(part, {foundation(part, true, 0, k)}, none).free_motions.size(), 2u) << k;
        EXPECT_TRUE(
            on_springs(part, {foundation(part, true, k, 0), foundation(part, false, 1e-6 * k, 0)}, none).free_motions.empty())
            << k;
    }
}

/// Motions on springs beside others: a roller that holds one direction, a spring that is stiff in one and soft in the other.
TEST(Springs, SoftOnesAreTakenBesideSupportsAndStiffOnes) {
    const PartInput part = test::rectangle(2, 1, 4, 3, 2, false, plane_stress(E, 0));
    for (double k : {1e-15, 1e-9, 1.0}) {
        const PartSystem on_roller =
            make_part_system(part, {test::by_nitsche(test::side_support(part.space, GridSide::bottom, 1))}, pull(part, {3, 0}),
                             test::middle_of(part), test::size_of(part), {foundation(part, true, k, 0)});
        const PartSystem on_stiff = on_springs(part, {foundation(part, true, k, 1e5)}, pull(part, {3, 0}));
        for (const PartSystem* system : {&on_roller, &on_stiff}) {
            ASSERT_TRUE(system->failure.empty()) << system->failure;
            EXPECT_EQ(system->sprung.cols(), system == &on_roller ? 1 : 2);  // along the rod, and turning about its stiff end
            const VectorXd u = solve(*system, system->load);
            const double end = displacement_at(part, u, part.space.cell_at({2, 0.3}), {2, 0.3}).value.x();
            EXPECT_NEAR(end, 3 / k + 6 / E, 1e-11 * (3 / k)) << k;
        }
    }
}

TEST(Springs, NoneLeaveTheSystemBitForBit) {
    const PartInput part = test::rectangle(2, 1, 4, 3, 2);
    const std::vector<SupportSet> held{test::side_support(part.space, GridSide::left, 0),
                                       test::by_nitsche(test::side_support(part.space, GridSide::bottom, 1))};
    const VectorXd load = pull(part, {1, 2});
    const PartSystem a = test::system_of(part, held, load);
    const PartSystem b = make_part_system(part, held, load, test::middle_of(part), test::size_of(part), {});
    EXPECT_EQ(test::dense(a.stiffness), test::dense(b.stiffness));
    EXPECT_EQ(a.load, b.load);
}

}  // namespace
}  // namespace abut::solver::springs_test
