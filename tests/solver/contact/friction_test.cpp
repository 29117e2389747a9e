// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "solver/contact/friction_pivots.hpp"
#include "solver/contact/friction_states.hpp"

namespace abut::solver::friction_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rough = rough_coefficient;

struct Sizes {
    Index pairs, frictionless, bilateral, motions;
    Index rows() const { return 2 * pairs + frictionless + bilateral; }
};

/// Random compliance, gaps and motions: rows n t n t ..., frictionless ones, bilateral ones. Loads that forces well within the
/// cones balance, or any.
ContactQp random_problem(unsigned seed, const Sizes& size, double coefficient, bool balanced) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number;
    const auto matrix = [&](Index rows, Index columns) {
        return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); }));
    };
    const Index m = size.rows();
    const MatrixXd b = matrix(m, m);
    ContactQp qp{b * b.transpose() + 0.05 * MatrixXd::Identity(m, m),
                 matrix(m, 1),
                 matrix(m, size.motions),
                 VectorXd::Zero(size.motions),
                 std::vector<char>(static_cast<std::size_t>(m), 1),
                 VectorXd::Ones(m),
                 VectorXd::Zero(m),
                 0};
    qp.drawn_gap = qp.gap;
    qp.foundation = qp.compliance.diagonal().cwiseInverse();
    for (Index k = 0; k < size.pairs; ++k) {
        qp.friction.push_back({static_cast<int>(2 * k), static_cast<int>(2 * k + 1), coefficient});
        qp.unilateral[static_cast<std::size_t>(2 * k + 1)] = 0;
    }
    for (Index k = m - size.bilateral; k < m; ++k) qp.unilateral[static_cast<std::size_t>(k)] = 0;
    VectorXd forces = matrix(m, 1).cwiseAbs();
    for (const FrictionRow& f : qp.friction)
        forces[f.tangential] = std::min(coefficient, 10.0) * forces[f.normal] * std::tanh(number(random));
    qp.mode_load = balanced ? VectorXd(-qp.modes.transpose() * forces) : VectorXd(matrix(size.motions, 1));
    qp.load_scale = size.motions > 0 ? qp.mode_load.cwiseAbs().maxCoeff() : 0;
    return qp;
}

struct Point {
    VectorXd l, a;
};

constexpr double closed = 1e-10;  // pressures below are rounding

/// The largest violation, written from the conditions as they are read.
double violation(const ContactQp& qp, const Point& p) {
    const VectorXd gap = qp.gap + qp.compliance * p.l + qp.modes * p.a;
    double worst = qp.modes.cols() > 0 ? (qp.modes.transpose() * p.l + qp.mode_load).cwiseAbs().maxCoeff() : 0;
    std::vector<char> tangential(qp.unilateral.size(), 0);
    for (const FrictionRow& f : qp.friction) {
        tangential[static_cast<std::size_t>(f.tangential)] = 1;
        const double n = p.l[f.normal], t = p.l[f.tangential], slip = gap[f.tangential];
        const double bound = n > closed ? f.coefficient * n : 0;
        worst = std::max(worst, std::abs(t) - bound);
        if (n <= closed) continue;
        if (slip > 0) worst = std::max(worst, std::min(slip, std::abs(t + bound)));
        if (slip < 0) worst = std::max(worst, std::min(-slip, std::abs(t - bound)));
    }
    for (Index k = 0; k < gap.size(); ++k) {
        if (tangential[static_cast<std::size_t>(k)]) continue;
        if (qp.unilateral[static_cast<std::size_t>(k)])
            worst = std::max({worst, -p.l[k], -gap[k], std::min(p.l[k], gap[k])});
        else
            worst = std::max(worst, std::abs(gap[k]));
    }
    return worst;
}

/// Solves on one choice of states: by frictionless row 0 or 1, by pair 0 to 3.
std::optional<Point> on_states(const ContactQp& qp, const std::vector<int>& pair, const std::vector<int>& single) {
    const Index m = qp.gap.size(), n = qp.modes.cols(), p = static_cast<Index>(pair.size());
    MatrixXd a = MatrixXd::Zero(m + n, m + n);
    VectorXd b = VectorXd::Zero(m + n);
    const auto close = [&](Index k) {
        a.row(k).head(m) = qp.compliance.dense().row(k);
        if (n > 0) a.row(k).tail(n) = qp.modes.row(k);
        b[k] = -qp.gap[k];
    };
    for (Index k = 0; k < p; ++k) {
        const int state = pair[static_cast<std::size_t>(k)];
        const FrictionRow& f = qp.friction[static_cast<std::size_t>(k)];
        if (state == 0) a(f.normal, f.normal) = a(f.tangential, f.tangential) = 1;
        if (state > 0) close(f.normal);
        if (state == 1) close(f.tangential);
        if (state < 2) continue;
        a(f.tangential, f.tangential) = 1;
        a(f.tangential, f.normal) = state == 2 ? f.coefficient : -f.coefficient;
    }
    for (Index k = 2 * p; k < m; ++k) {
        const auto u = static_cast<std::size_t>(k - 2 * p);
        if (u < single.size() && single[u] == 0)
            a(k, k) = 1;
        else
            close(k);
    }
    a.bottomLeftCorner(n, m) = qp.modes.transpose();
    b.tail(n) = -qp.mode_load;
    const Eigen::FullPivLU<MatrixXd> lu(a);
    if (!lu.isInvertible()) return std::nullopt;
    const VectorXd x = lu.solve(b);
    return Point{x.head(m), x.tail(n)};
}

/// All answers, by trying all states.
std::vector<Point> all_answers(const ContactQp& qp, const Sizes& size) {
    std::vector<Point> answers;
    std::vector<int> state(static_cast<std::size_t>(size.pairs + size.frictionless), 0);
    for (;;) {
        const std::vector<int> pair(state.begin(), state.begin() + size.pairs), single(state.begin() + size.pairs, state.end());
        if (const auto p = on_states(qp, pair, single); p && violation(qp, *p) < 1e-9) answers.push_back(*p);
        std::size_t k = 0;
        for (; k < state.size(); ++k) {
            if (++state[k] < (k < static_cast<std::size_t>(size.pairs) ? 4 : 2)) break;
            state[k] = 0;
        }
        if (k == state.size()) return answers;
    }
}

bool is_among(const ContactQpResult& r, const std::vector<Point>& answers) {
    return std::any_of(answers.begin(), answers.end(), [&](const Point& p) {
        return (p.l - r.multipliers).norm() <= 1e-7 * (1 + p.l.norm()) &&
               (p.a - r.amplitudes()).norm() <= 1e-7 * (1 + p.a.norm());
    });
}

struct Tally {
    int solved = 0, unsolved = 0, none = 0, several = 0, told_several = 0, by_pivots = 0;
};

/// Every answer that the solver gives is one of the answers.
Tally compare(const Sizes& size, double coefficient, bool balanced, unsigned n_problems) {
    Tally tally;
    for (unsigned seed = 1; seed <= n_problems; ++seed) {
        ContactQp qp = random_problem(seed, size, coefficient, balanced);
        const ContactQpResult r = solve_contact_qp(qp);
        for (FrictionRow& f : qp.friction) f.coefficient = std::min(f.coefficient, r.most_friction);
        const std::vector<Point> answers = all_answers(qp, size);
        tally.several += answers.size() > 1;
        if (r.feasible && r.converged) {
            EXPECT_TRUE(is_among(r, answers)) << "seed " << seed << ": " << answers.size() << " answers";
            const bool is_one_of_several = has_another_answer(qp, r);
            EXPECT_TRUE(!is_one_of_several || answers.size() > 1) << "seed " << seed;
            tally.told_several += is_one_of_several;
            EXPECT_LT(violation(qp, {r.multipliers, r.amplitudes()}), 1e-7) << "seed " << seed;
            EXPECT_LT(r.residual, 1e-8) << "seed " << seed;
            ++tally.solved;
            tally.by_pivots += r.used_fallback;
        } else if (answers.empty()) {
            ++tally.none;
        } else {
            EXPECT_TRUE(r.feasible) << "seed " << seed << ": there is an answer, hence no mechanism";
            ++tally.unsolved;
        }
    }
    return tally;
}

TEST(Friction, IsSolvedWhereverAllStatesTriedFindAnAnswer) {
    int solved = 0, by_pivots = 0;
    for (const double coefficient : {0.1, 0.3}) {
        const Tally held = compare({3, 1, 1, 0}, coefficient, true, 100);
        EXPECT_EQ(held.unsolved, 0) << coefficient;
        const Tally free = compare({4, 1, 1, 2}, coefficient, true, 100);
        EXPECT_EQ(free.unsolved, 0) << coefficient;
        solved += held.solved + free.solved;
        by_pivots += held.by_pivots + free.by_pivots;
    }
    EXPECT_GT(solved, 380);
    EXPECT_EQ(by_pivots, 0) << "damped steps find them all";
}

/// Pivots, the last resort, find an answer by themselves.
TEST(Friction, IsSolvedByPivotsAlone) {
    int found = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const ContactQp qp = random_problem(seed, {4, 1, 1, 0}, 0.3, true);
        const ShiftedQp shifted{qp, qp.gap};
        const Proximal none{MatrixXd::Zero(0, 0), VectorXd::Zero(0)};
        ActiveSet states = bilateral_rows(qp);
        ContactState state{VectorXd::Zero(qp.gap.size()), VectorXd(0), VectorXd::Zero(qp.gap.size())};
        int pivots = 0;
        if (!pivot_states(shifted, none, states, state, pivots)) continue;
        EXPECT_LT(violation(qp, {state.multipliers, state.amplitudes}), 1e-7) << seed;
        ++found;
    }
    EXPECT_GT(found, 95);
}

/// Two faces that are stretched slip against each other, both ways; one that is pressed a thousandth more sticks. What tells
/// ties apart is larger than their tractions.
TEST(Friction, OfTheSmallestCoefficientsIsSolvedByPivots) {
    const ContactQp qp{MatrixXd(MatrixXd::Identity(4, 4)),
                       VectorXd{{-1.001, 1, -1, -1}},
                       VectorXd{{0, 1, 0, 1}},
                       VectorXd::Zero(1),
                       {1, 0, 1, 0},
                       VectorXd::Ones(4),
                       VectorXd::Zero(4),
                       1,
                       {},
                       {},
                       {{0, 1, 1e-9}, {2, 3, 1e-9}}};
    const Proximal near_rest{MatrixXd::Constant(1, 1, 1e-4), VectorXd::Constant(1, -1)};
    ActiveSet states = bilateral_rows(qp);
    ContactState state{VectorXd::Zero(4), VectorXd::Zero(1), VectorXd::Zero(4)};
    int pivots = 0;
    ASSERT_TRUE(pivot_states({qp, qp.gap}, near_rest, states, state, pivots));
    EXPECT_EQ(states[1], row_state::closed);
    EXPECT_EQ(states[3], row_state::slips_backward);
}

/// Numbers that are none, as cells too small for their coordinates give them, are no motion.
TEST(Friction, OfNoNumbersIsNotConverged) {
    for (const Index pairs : {0, 3}) {
        ContactQp qp = random_problem(1, {pairs, 3, 0, 2}, 0.3, true);
        qp.gap[0] = std::numeric_limits<double>::quiet_NaN();
        const ContactQpResult r = solve_contact_qp(qp);
        EXPECT_FALSE(r.converged);
        EXPECT_EQ(r.mechanism.size(), 0);
    }
}

/// Where coefficients are large there may be several answers, and none is found of a few problems; but never a wrong one.
TEST(Friction, OfAnySizeIsAnsweredByAnAnswerOrNotAtAll) {
    int several = 0, told = 0;
    for (const double coefficient : {0.5, 1.0, 2.0}) {
        const Tally tally = compare({4, 0, 1, 1}, coefficient, true, 100);
        EXPECT_EQ(tally.unsolved, 0) << coefficient;
        several += tally.several;
        told += tally.told_several;
    }
    EXPECT_GT(several, 0);
    EXPECT_GT(told, 0) << "the search from a second start finds some";
    EXPECT_EQ(compare({4, 1, 1, 2}, rough, true, 100).unsolved, 0);
}

TEST(Friction, ThatCannotHoldTheLoadsIsToldByAMotion) {
    int mechanisms = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const ContactQp qp = random_problem(seed, {3, 0, 0, 3}, 0.2, false);
        const ContactQpResult r = solve_contact_qp(qp);
        if (r.feasible) continue;
        ++mechanisms;
        EXPECT_TRUE(all_answers(qp, {3, 0, 0, 3}).empty()) << seed;
        EXPECT_GT(r.mechanism.dot(qp.mode_load), 0) << "the loads work in it, seed " << seed;
        if (r.holding_factor == 0) continue;
        ContactQp more = qp, less = qp;
        for (FrictionRow& f : more.friction) f.coefficient *= r.holding_factor * (1 + 1e-4);
        for (FrictionRow& f : less.friction) f.coefficient *= r.holding_factor * (1 - 1e-4);
        EXPECT_TRUE(solve_contact_qp(more).feasible) << seed;
        EXPECT_FALSE(solve_contact_qp(less).feasible) << seed;
    }
    EXPECT_GT(mechanisms, 20);
}

/// A block of weight 1 on one point, pushed sideways.
ContactQp pushed_block(double coefficient, double push) {
    ContactQp qp{Eigen::Matrix2d::Identity(),
                 Eigen::Vector2d::Zero(),
                 Eigen::Matrix2d{{0, 1}, {1, 0}},  // rows n, t; motions x, y
                 Eigen::Vector2d(push, -1),
                 {1, 0},
                 Eigen::Vector2d::Ones(),
                 Eigen::Vector2d::Zero(),
                 1};
    qp.friction = {{0, 1, coefficient}};
    return qp;
}

TEST(Friction, HoldsUpToItsCone) {
    const ContactQpResult held = solve_contact_qp(pushed_block(0.3, 0.299999));
    ASSERT_TRUE(held.feasible && held.converged);
    EXPECT_NEAR(held.multipliers[0], 1, 1e-14);
    EXPECT_NEAR(held.multipliers[1], -0.299999, 1e-14);
    EXPECT_EQ(held.active[1], row_state::closed);
    const ContactQpResult slid = solve_contact_qp(pushed_block(0.3, 0.300001));
    ASSERT_FALSE(slid.feasible);
    EXPECT_NEAR(slid.mechanism.normalized().x(), 1, 1e-14) << "along the face: what slides does not lift";
    EXPECT_NEAR(slid.holding_factor, 1 + 1e-5 / 3, 2e-5);
    EXPECT_TRUE(solve_contact_qp(pushed_block(rough, 5)).converged);
}

/// A block between two walls that press on it by their interference of 1, pushed along them: motions x, y; a stop at `gap`.
ContactQp wedged_block(double coefficient, double push, std::optional<double> gap = std::nullopt) {
    const Index m = gap ? 5 : 4;
    ContactQp qp{MatrixXd(MatrixXd::Identity(m, m)),
                 VectorXd::Zero(m),
                 MatrixXd::Zero(m, 2),
                 Eigen::Vector2d(push, 0),
                 std::vector<char>(static_cast<std::size_t>(m), 1),
                 VectorXd::Ones(m),
                 VectorXd::Zero(m),
                 push};
    qp.gap[0] = qp.gap[2] = -1;
    qp.modes(0, 1) = 1;
    qp.modes(2, 1) = -1;
    qp.modes(1, 0) = qp.modes(3, 0) = 1;
    if (gap) {
        qp.modes(4, 0) = -1;
        qp.gap[4] = *gap;
    }
    qp.drawn_gap = qp.gap;
    qp.unilateral[1] = qp.unilateral[3] = 0;
    for (int k : {0, 2}) qp.friction.push_back({k, k + 1, coefficient});
    return qp;
}

TEST(Friction, OfAFitHoldsAsMuchAsItsPressureGives) {
    const ContactQpResult held = solve_contact_qp(wedged_block(0.2, 0.399));
    ASSERT_TRUE(held.feasible && held.converged);
    EXPECT_NEAR(held.multipliers[0], 1, 1e-12);
    EXPECT_NEAR(held.multipliers[1] + held.multipliers[3], -0.399, 1e-12);
    for (const double push : {0.401, 0.6, 8.0}) {
        const ContactQpResult slid = solve_contact_qp(wedged_block(0.2, push));
        ASSERT_TRUE(!slid.converged && slid.mechanism.size() == 2) << push;
        EXPECT_TRUE(slid.feasible) << "other rows may hold it: how it slides is given";
        EXPECT_NEAR(slid.multipliers[1] + slid.multipliers[3], -0.4, 1e-12);
        EXPECT_NEAR(slid.mechanism.normalized().x(), 1, 1e-12) << push;
        EXPECT_NEAR(slid.holding_factor, push / 0.4, 1e-4 * slid.holding_factor);
    }
}

TEST(Friction, ThatIsExpectedIsFoundAtOnceBesideABodyThatNothingHolds) {
    const ContactQp block = pushed_block(0.3, 0.2);
    const Index m = block.gap.size(), n = block.modes.cols();
    ContactQp qp = block;
    MatrixXd compliance = MatrixXd::Zero(m + 2, m + 2);
    compliance.topLeftCorner(m, m) = block.compliance.to_dense();
    compliance.bottomRightCorner(2, 2).setIdentity();
    qp.compliance = compliance;
    qp.modes = MatrixXd::Zero(m + 2, n + 2);
    qp.modes.topLeftCorner(m, n) = block.modes;
    qp.modes.bottomRightCorner(2, 2).setIdentity();
    for (VectorXd* v : {&qp.gap, &qp.drawn_gap, &qp.foundation}) {
        v->conservativeResize(m + 2);
        v->tail(2) << 1, 1;
    }
    qp.mode_load.conservativeResize(n + 2);
    qp.mode_load.tail(2).setZero();
    qp.unilateral.insert(qp.unilateral.end(), {1, 0});
    qp.friction.push_back({static_cast<int>(m), static_cast<int>(m + 1), 0.3});
    qp.expected = VectorXd::Zero(m + 2);
    qp.expected.head(m) = solve_with_friction(block).multipliers;
    const ContactQpResult r = solve_with_friction(qp);
    ASSERT_TRUE(r.converged);
    EXPECT_EQ(r.iterations, 1);
    EXPECT_LT((r.multipliers - qp.expected).norm(), 1e-12 * qp.expected.norm());
    EXPECT_EQ(r.amplitudes().tail(2).norm(), 0);
}

TEST(Friction, SlidesAsFarAsAStop) {
    for (const double gap : {0.5, 50.0, 5e4}) {
        const ContactQpResult r = solve_contact_qp(wedged_block(0.2, 0.7, gap));
        ASSERT_TRUE(r.feasible && r.converged) << gap;
        EXPECT_NEAR(r.multipliers[4], 0.3, 1e-9) << gap;
        EXPECT_NEAR(r.amplitudes()[0], gap + 0.3, 1e-9 * gap) << gap;
    }
}

TEST(Friction, OfARollerThatSpreadsOnBothItsFacesIsFoundByNewtonsSteps) {
    // two pairs below and two above, pressed by 1; each face spreads to both sides by more than friction bears. Where all four
    // slip nothing would hold the roller from moving along and from turning: it takes two rows at their bound.
    ContactQp qp;
    qp.compliance = MatrixXd::Identity(8, 8);
    qp.gap = (VectorXd(8) << -1, 0.5, -1, -0.5, -1, 0.5, -1, -0.5).finished();
    qp.modes = MatrixXd::Zero(8, 2);
    for (const Index row : {1, 3}) qp.modes.row(row) << 1, 1;
    for (const Index row : {5, 7}) qp.modes.row(row) << -1, 1;
    qp.mode_load = VectorXd::Zero(2);
    qp.unilateral = {1, 0, 1, 0, 1, 0, 1, 0};
    qp.foundation = VectorXd::Ones(8);
    qp.drawn_gap = qp.gap;
    qp.load_scale = 1;
    for (int k = 0; k < 4; ++k) qp.friction.push_back({2 * k, 2 * k + 1, 0.1});
    const ContactQpResult r = solve_contact_qp(qp);
    ASSERT_TRUE(r.feasible && r.converged);
    EXPECT_FALSE(r.used_fallback);
    EXPECT_LE(r.iterations, 10);
    for (const Index row : {1, 5}) EXPECT_NEAR(r.multipliers[row], -0.1, 1e-12);
    for (const Index row : {3, 7}) EXPECT_NEAR(r.multipliers[row], 0.1, 1e-12);
    EXPECT_LT(r.residual, 1e-12);
}

TEST(Friction, ViolationsAreSeen) {
    const ContactQp qp = pushed_block(0.3, 0.2);
    const ContactQpResult r = solve_contact_qp(qp);
    ASSERT_TRUE(r.converged);
    const VectorXd no_imbalance = VectorXd::Zero(2);
    ContactConditions c{r.multipliers, r.gap, no_imbalance};
    EXPECT_LT(friction_residual(qp, c), 1e-14);
    c.multipliers[1] = -0.31;
    EXPECT_NEAR(friction_residual(qp, c), 0.01, 1e-12) << "beyond the bound";
    c.multipliers[1] = r.multipliers[1];
    c.gap[1] = 0.05;
    EXPECT_NEAR(friction_residual(qp, c), 0.05, 1e-12) << "slips although it could hold";
    c.multipliers[1] = -0.3;
    EXPECT_LT(friction_residual(qp, c), 1e-14) << "at its bound against the slip";
    c.gap[1] = -0.05;
    EXPECT_NEAR(friction_residual(qp, c), 0.05, 1e-12) << "at its bound along the slip";
}

/// A body in the plane on one spring with friction, dragged on springs that hold it: it slides by what friction leaves.
TEST(Friction, WhatSpringsHoldSlidesByWhatFrictionLeaves) {
    constexpr double spring = 1e6, drag = 10, weight = 8, push = 5, coefficient = 0.25;
    ContactQp qp{VectorXd(Eigen::Vector4d(1 / spring, 1 / spring, 1 / drag, 1 / drag)).asDiagonal().toDenseMatrix(),
                 VectorXd::Zero(4),
                 MatrixXd::Zero(4, 2),
                 Eigen::Vector2d(push, -weight),
                 {1, 0, 0, 0},
                 Eigen::Vector4d(spring, spring, drag, drag),
                 VectorXd::Zero(4),
                 weight};
    qp.modes << 0, 1, 1, 0, 1, 0, 0, 1;
    qp.friction = {{0, 1, coefficient}};
    const ContactQpResult slides = solve_held_with_friction(qp);
    ASSERT_TRUE(slides.converged);
    const double pressure = weight * spring / (spring + drag);
    EXPECT_NEAR(slides.multipliers[0], pressure, 1e-9);
    EXPECT_NEAR(slides.amplitudes()[0], (push - coefficient * pressure) / drag, 1e-9);
    qp.friction[0].coefficient = 0.7;
    const ContactQpResult sticks = solve_held_with_friction(qp);
    ASSERT_TRUE(sticks.converged);
    EXPECT_NEAR(sticks.amplitudes()[0], push / (spring + drag), 1e-12);
}

}  // namespace
}  // namespace abut::solver::friction_test
