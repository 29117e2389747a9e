// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/part_system.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::part_system_test {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using test::SpaceCase;

const PartInput plate = test::rectangle(2, 1, 4, 3, 2);
const VectorXd unloaded = VectorXd::Zero(2 * plate.space.n_functions);

SupportSet held(GridSide side, int component) {
    return test::side_support(plate.space, side, component);
}

/// Rollers along a circular arc inside the plate, normal to it.
SupportSet round_rollers(const Vec2& center, double radius) {
    SupportSet set;
    for (int k = 0; k < 16; ++k) {
        const double angle = 2 * M_PI * k / 16;
        const Vec2 n(std::cos(angle), std::sin(angle)), x = center + radius * n;
        set.points.push_back({plate.space.cell_at(x), x, n, n, 2 * M_PI * radius / 16, 0});
    }
    return set;
}

SupportSet single_point(const Vec2& x, const Vec2& direction) {
    SupportSet set;
    set.points.push_back({plate.space.cell_at(x), x, direction, direction, 0.1, 0});
    return set;
}

struct FreeCase {
    std::string name;
    std::vector<SupportSet> supports;
    std::vector<RigidMotion> free;
};

std::vector<FreeCase> free_cases() {
    const RigidMotion x{{1, 0}, 0, {0, 0}}, y{{0, 1}, 0, {0, 0}}, turn{{0, 0}, 1, {1, 0.5}};
    const auto both = [](GridSide side) { return std::vector<SupportSet>{held(side, 0), held(side, 1)}; };
    const double inclined = std::sqrt(0.5);
    return {{"none", {}, {x, y, turn}},
            {"clamped", both(GridSide::left), {}},
            {"clamped weakly", {test::by_nitsche(held(GridSide::left, 0)), test::by_nitsche(held(GridSide::left, 1))}, {}},
            {"roller", {held(GridSide::bottom, 1)}, {x}},
            {"roller on a vertical side", {held(GridSide::right, 0)}, {y}},
            {"rollers on opposite sides", {held(GridSide::bottom, 1), held(GridSide::top, 1)}, {x}},
            {"rollers on perpendicular sides", {held(GridSide::bottom, 1), held(GridSide::left, 0)}, {}},
            {"two symmetry lines, weakly",
             {test::by_nitsche(held(GridSide::bottom, 1)), test::by_nitsche(held(GridSide::left, 0))},
             {}},
            {"side held along itself", {held(GridSide::left, 1)}, {x, {{0, 0}, 1, {0, 0.5}}}},
            {"round rollers", {round_rollers({0.9, 0.55}, 0.3)}, {{{0, 0}, 1, {0.9, 0.55}}}},
            {"one point", {single_point({0.4, 0.6}, {1, 0})}, {y, {{0, 0}, 1, {0.4, 0.6}}}},
            {"inclined roller",
             {single_point({0.4, 0.6}, {inclined, inclined}), single_point({0.7, 0.3}, {inclined, inclined})},
             {{{inclined, -inclined}, 0, {0, 0}}}},
            {"two hinged bars that meet",
             {single_point({0.4, 0.2}, {1, 0}), single_point({0.8, 0.6}, {0, 1})},
             {{{0, 0}, 1, {0.8, 0.2}}}}};
}

/// Distance of a motion from the span of others, by its values at three points, relative to its own size.
double distance_from_span(const RigidMotion& motion, const std::vector<RigidMotion>& span) {
    const auto values = [](const RigidMotion& m) {
        Eigen::Matrix<double, 6, 1> v;
        v << m.at({0, 0}), m.at({2, 0}), m.at({1, 1});
        return v;
    };
    const Eigen::Matrix<double, 6, 1> v = values(motion);
    Eigen::MatrixXd m(6, static_cast<Index>(span.size()));
    for (std::size_t k = 0; k < span.size(); ++k) m.col(static_cast<Index>(k)) = values(span[k]);
    if (span.empty()) return 1;
    return (v - m * m.colPivHouseholderQr().solve(v)).norm() / v.norm();
}

}  // namespace

TEST(RigidMotion, TurnsAboutItsCenter) {
    const RigidMotion m{{0.1, 0.2}, 0.5, {1, 2}};
    EXPECT_EQ(m.at({1, 2}), Vec2(0.1, 0.2));
    EXPECT_LT((m.at({3, 2}) - Vec2(0.1, 1.2)).norm(), 1e-15);
    EXPECT_LT((m.at({1, 3}) - Vec2(-0.4, 0.2)).norm(), 1e-15);
}

TEST(PartSystem, FindsTheMotionsThatSupportsLeaveFree) {
    for (const FreeCase& c : free_cases()) {
        SCOPED_TRACE(c.name);
        const PartSystem s = test::system_of(plate, c.supports, unloaded);
        EXPECT_EQ(s.failure, "");
        ASSERT_EQ(s.free_motions.size(), c.free.size());
        for (const RigidMotion& m : s.free_motions) EXPECT_LT(distance_from_span(m, c.free), 1e-7);
        for (const RigidMotion& m : c.free) EXPECT_LT(distance_from_span(m, s.free_motions), 1e-7);
    }
    EXPECT_GT(distance_from_span({{1, 0}, 1e-3, {0, 0}}, {{{1, 0}, 0, {0, 0}}}), 1e-7);
}

TEST(PartSystem, FreeMotionsCostNoEnergyAndKeepWhatIsHeld) {
    for (const FreeCase& c : free_cases()) {
        SCOPED_TRACE(c.name);
        const PartSystem s = test::system_of(plate, c.supports, unloaded);
        ASSERT_EQ(s.modes.cols(), static_cast<Index>(c.free.size()));
        const double scale = test::dense(s.stiffness).cwiseAbs().maxCoeff();
        for (Index k = 0; k < s.modes.cols(); ++k) {
            // unit displacement at the part's size: half of that at the corners for a rotation about the middle
            EXPECT_GT(s.modes.col(k).cwiseAbs().maxCoeff(), 0.4);
            EXPECT_LT(s.modes.col(k).cwiseAbs().maxCoeff(), 1.1);
            EXPECT_LT(multiply(s.stiffness, s.modes.col(k)).cwiseAbs().maxCoeff(), 1e-9 * scale);
            for (std::size_t i = 0; i < s.dropped.size(); ++i)
                EXPECT_TRUE(!s.dropped[i] || s.modes(static_cast<Index>(i), k) == 0) << i;
        }
    }
}

TEST(PartSystem, NumbersWhatIsNeitherDroppedNorPinned) {
    for (const FreeCase& c : free_cases()) {
        SCOPED_TRACE(c.name);
        const PartSystem s = test::system_of(plate, c.supports, unloaded);
        const auto n_dropped = std::count(s.dropped.begin(), s.dropped.end(), 1);
        EXPECT_EQ(s.n_kept, 2 * s.n() - n_dropped - static_cast<long>(c.free.size()));
        int next = 0;
        for (std::size_t i = 0; i < s.number.size(); ++i) {
            if (s.number[i] < 0) continue;
            EXPECT_EQ(s.number[i], next++);
            EXPECT_FALSE(s.dropped[i]);
        }
        EXPECT_EQ(next, s.n_kept);
    }
}

TEST(PartSystem, PinsDoNotShowWhereTheLoadsBalance) {
    // uniform stress on a part that nothing holds: exact up to a rigid motion, no force in the pins
    for (const SpaceCase& c : test::all_space_cases()) {
        if (c.basis == Basis::plain) continue;
        SCOPED_TRACE(test::name_of(c));
        const PartInput part = test::part_of({{0, 0, 2, 1}}, test::grid_lines(-0.3, 2.1, 6, c.uniform),
                                             test::grid_lines(-0.01, 1.3, 5, c.uniform), c.degree, c.basis);
        VectorXd load = boundary_load(
            part, test::traction_on(part.space, {0, 0}, {0, 1}, {-1, 0}, [](const Vec2&) { return Vec2(-5, 0); }));
        load +=
            boundary_load(part, test::traction_on(part.space, {2, 0}, {2, 1}, {1, 0}, [](const Vec2&) { return Vec2(5, 0); }));
        const PartSystem s = test::system_of(part, {}, load);
        ASSERT_EQ(s.failure, "");
        VectorXd diagonal = test::dense(s.stiffness).diagonal();
        std::vector<double> pinned;
        for (std::size_t i = 0; i < s.number.size(); ++i)
            if (s.number[i] < 0) pinned.push_back(diagonal[static_cast<Index>(i)]);
        EXPECT_EQ(pinned.size(), 3u);
        std::sort(diagonal.begin(), diagonal.end());
        for (double stiffness : pinned) EXPECT_GE(stiffness, 0.499 * diagonal[diagonal.size() / 2]);  // no weak springs
        const VectorXd u = solve(s, s.load);
        EXPECT_LT((multiply(s.stiffness, u) - s.load).cwiseAbs().maxCoeff(), 1e-9);
        for (const Vec2& x : {Vec2(0.1, 0.1), Vec2(1.9, 0.9)}) {
            const Eigen::Matrix2d g = displacement_at(part.space, u, part.space.cell_at(x), x).gradient;
            const Eigen::Vector3d stress = stress_of(part.elasticity, g);
            EXPECT_LT((stress - Eigen::Vector3d(5, 0, 0)).norm(), 1e-8);
        }
        EXPECT_NEAR(strain_energy(s, u), 0.5 * 25 / 1000.0 * 2, 1e-9);
    }
}

TEST(PartSystem, PrescribedValuesAreTaken) {
    const SupportSet right = test::side_support(plate.space, GridSide::right, 0, 0.02);
    const PartSystem s = test::system_of(plate, {held(GridSide::left, 0), held(GridSide::bottom, 1), right}, unloaded);
    const VectorXd u = solve(s, s.load);
    for (double y : {0.0, 0.4, 1.0}) {
        EXPECT_NEAR(displacement_at(plate.space, u, plate.space.cell_at({2, y}), {2, y}).value.x(), 0.02, 1e-15);
        EXPECT_NEAR(displacement_at(plate.space, u, plate.space.cell_at({1, y}), {1, y}).value.x(), 0.01, 1e-12);
        EXPECT_NEAR(displacement_at(plate.space, u, plate.space.cell_at({1, y}), {1, y}).value.y(), -0.003 * y, 1e-12);
    }
    const std::vector<Resultant> r = support_reactions(s, u, s.load);
    EXPECT_NEAR(r[0].force.x(), -10, 1e-10);
    EXPECT_NEAR(r[2].force.x(), 10, 1e-10);
    EXPECT_NEAR(r[2].moment, -5, 1e-10);
    EXPECT_NEAR(strain_energy(s, u), 0.5 * 1000 * 0.01 * 0.01 * 2, 1e-12);
}

TEST(PartSystem, AFunctionIsDroppedForOneSupportOnly) {
    // the lower left corner belongs to both sides
    const PartSystem s = test::system_of(plate, {held(GridSide::bottom, 1), held(GridSide::left, 1)}, unloaded);
    std::set<int> seen;
    for (const SupportRecord& record : s.supports)
        for (int f : record.dropped) EXPECT_TRUE(seen.insert(f).second);
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(plate.space.x.n_functions() + plate.space.y.n_functions() - 1));
}

TEST(PartSystem, WorkOfTheLoadIsTwiceTheEnergy) {
    const VectorXd load = body_load(plate, [](const Vec2& x) { return Vec2(x.y(), -2); });
    const PartSystem s = test::system_of(plate, {held(GridSide::left, 0), held(GridSide::left, 1)}, load);
    const VectorXd u = solve(s, s.load);
    EXPECT_NEAR(strain_energy(s, u), 0.5 * load.dot(u), 1e-12 * load.dot(u));
    EXPECT_GT(load.dot(u), 0.01);
    EXPECT_EQ(s.applied, load);
}

TEST(PartSystem, GradientIsThatOfTheDisplacement) {
    const VectorXd u = test::interleave(test::monomial(plate.space, 2, 1), test::monomial(plate.space, 1, 2));
    const Vec2 x(0.7, 0.4);
    const DisplacementAt d = displacement_at(plate.space, u, plate.space.cell_at(x), x);
    EXPECT_NEAR(d.value.x(), 0.49 * 0.4, 1e-14);
    EXPECT_NEAR(d.value.y(), 0.7 * 0.16, 1e-14);
    const Eigen::Matrix2d exact = (Eigen::Matrix2d() << 2 * 0.7 * 0.4, 0.49, 0.16, 2 * 0.7 * 0.4).finished();
    EXPECT_LT((d.gradient - exact).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(PartSystem, TellsThatAStiffnessIsNotPositiveDefinite) {
    PartInput part = plate;
    part.elasticity.d33 = -1;
    EXPECT_NE(test::system_of(part, {held(GridSide::left, 0), held(GridSide::left, 1)}, unloaded).failure, "");
}

/// A material that shears the wrong way: the factorisation ends, and says where and what that means.
TEST(PartSystem, SaysWhereTheFactorisationEnded) {
    Elasticity wrong = plane_stress(1000, 0.3);
    wrong.d33 = -300;
    const PartInput part = test::rectangle(2, 1, 4, 3, 2, true, wrong);
    const PartSystem s = test::system_of(part, {held(GridSide::left, 0), held(GridSide::left, 1)}, unloaded);
    EXPECT_NE(s.failure.find("not positive definite"), std::string::npos) << s.failure;
    EXPECT_NE(s.failure.find("; "), std::string::npos) << "what to do: " << s.failure;
    ASSERT_TRUE(s.failed_at.has_value());
    const int component = s.failed_at->component;
    bool is_a_function = false;
    for (int f = 0; f < part.space.n_functions; ++f)
        is_a_function |=
            greville_point(part.space, f) == s.failed_at->at && !s.dropped[static_cast<std::size_t>(2 * f + component)];
    EXPECT_TRUE(is_a_function);
}

TEST(PartSystem, RefusesLoadsAndRulesThatAreNotThePartsOwn) {
    const std::vector<SupportSet> supports{held(GridSide::left, 0), held(GridSide::left, 1)};
    const VectorXd one_less = unloaded.head(unloaded.size() - 1);
    EXPECT_THROW(test::system_of(plate, supports, one_less), std::logic_error);
    const PartSystem s = test::system_of(plate, supports, unloaded);
    EXPECT_THROW(solve(s, one_less), std::logic_error);
    EXPECT_THROW(stiffness_times(s, one_less), std::logic_error);
    EXPECT_THROW(support_reactions(s, unloaded, one_less), std::logic_error);
    const CellRule rule{0, {{0.1, 0.1}}, {0.01}};
    CellRule outside = rule, unweighted = rule, odd = rule;
    outside.element = 12;
    unweighted.weights.clear();
    odd.weights = {std::nan("")};
    for (const CellRule& wrong : {outside, unweighted, odd}) {
        PartInput part = plate;
        part.cut_rules = {wrong};
        EXPECT_THROW(test::system_of(part, supports, unloaded), std::logic_error);
    }
}

TEST(PartSystem, SaysWhyASupportIsImposedAsItIs) {
    const PartSystem s = test::system_of(plate,
                                         {held(GridSide::left, 0), test::side_support(plate.space, GridSide::bottom, 0, 0.1),
                                          test::by_nitsche(held(GridSide::left, 1))},
                                         unloaded);
    EXPECT_NE(s.supports[0].why.find("exact"), std::string::npos);
    EXPECT_NE(s.supports[1].why.find("prescribes another value"), std::string::npos) << s.supports[1].why;
    EXPECT_NE(s.supports[2].why.find("outermost lines"), std::string::npos) << s.supports[2].why;
}

}  // namespace abut::solver::part_system_test
