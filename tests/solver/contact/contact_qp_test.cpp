// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/contact_qp.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

namespace abut::solver::contact_qp_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::mt19937 generator(unsigned seed) {
    return std::mt19937(seed);
}

MatrixXd random_matrix(std::mt19937& random, Index rows, Index columns) {
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(rows, columns, [&]() { return number(random); });
}

/// A problem without gaps and loads; the starting guess's data as an assembly would give them.
ContactQp problem_of(const MatrixXd& compliance, const MatrixXd& modes) {
    const Index m = compliance.rows();
    ContactQp qp{compliance,
                 VectorXd::Zero(m),
                 modes,
                 VectorXd::Zero(modes.cols()),
                 std::vector<char>(static_cast<std::size_t>(m), 1),
                 VectorXd::Ones(m),
                 VectorXd::Zero(m),
                 0};
    if (m > 0) qp.foundation = compliance.diagonal().cwiseInverse();
    return qp;
}

void load_with(ContactQp& qp, const VectorXd& load) {
    qp.mode_load = load;
    qp.load_scale = load.size() > 0 ? load.cwiseAbs().maxCoeff() : 0;
}

/// Random compliance, gaps, modes, some rows bilateral; loads that pressures can balance (or any loads).
ContactQp random_problem(unsigned seed, Index m, Index n, bool balanced) {
    std::mt19937 random = generator(seed);
    const MatrixXd b = random_matrix(random, m, m);
    ContactQp qp = problem_of(b * b.transpose() + 0.05 * MatrixXd::Identity(m, m), random_matrix(random, m, n));
    qp.gap = random_matrix(random, m, 1);
    qp.drawn_gap = qp.gap + 0.1 * random_matrix(random, m, 1);
    for (Index k = 0; k < m; ++k) qp.unilateral[static_cast<std::size_t>(k)] = random() % 5 != 0;
    const VectorXd forces = random_matrix(random, m, 1).cwiseAbs();
    load_with(qp, balanced ? VectorXd(-qp.modes.transpose() * forces) : VectorXd(random_matrix(random, n, 1)));
    return qp;
}

/// The largest violation of the conditions, forces and gaps each relative to their own size.
double kkt_error(const ContactQp& qp, const VectorXd& l, const VectorXd& a) {
    const VectorXd gap = qp.gap + qp.compliance * l + qp.modes * a;
    const double force = std::max({qp.load_scale, l.size() > 0 ? l.cwiseAbs().maxCoeff() : 0.0, 1e-300});
    const VectorXd terms =
        qp.gap.cwiseAbs() + qp.compliance.to_dense().cwiseAbs() * l.cwiseAbs() + qp.modes.cwiseAbs() * a.cwiseAbs();
    const double length = std::max(terms.size() > 0 ? terms.maxCoeff() : 0.0, 1e-300);
    double worst = 0;
    for (Index k = 0; k < l.size(); ++k) {
        if (qp.unilateral[static_cast<std::size_t>(k)])
            worst = std::max({worst, -l[k] / force, -gap[k] / length, std::min(l[k] / force, gap[k] / length)});
        else
            worst = std::max(worst, std::abs(gap[k]) / length);
    }
    if (qp.modes.cols() > 0) worst = std::max(worst, (qp.modes.transpose() * l + qp.mode_load).cwiseAbs().maxCoeff() / force);
    return worst;
}
double kkt_error(const ContactQp& qp, const ContactQpResult& r) {
    return kkt_error(qp, r.multipliers, r.amplitudes());
}

/// The multipliers by trying every active set; none where no set meets the conditions.
std::optional<VectorXd> by_all_sets(const ContactQp& qp) {
    const Index m = qp.gap.size(), n = qp.modes.cols();
    for (unsigned set = 0; set < 1u << m; ++set) {
        std::vector<Index> s;
        bool holds_bilateral = true;
        for (Index k = 0; k < m; ++k) {
            if (set >> k & 1u)
                s.push_back(k);
            else
                holds_bilateral = holds_bilateral && qp.unilateral[static_cast<std::size_t>(k)];
        }
        if (!holds_bilateral) continue;
        const auto size = static_cast<Index>(s.size());
        MatrixXd k = MatrixXd::Zero(size + n, size + n);
        k.topLeftCorner(size, size) = qp.compliance.dense()(s, s);
        k.topRightCorner(size, n) = qp.modes(s, Eigen::all);
        k.bottomLeftCorner(n, size) = k.topRightCorner(size, n).transpose();
        VectorXd rhs(size + n);
        rhs << -qp.gap(s), -qp.mode_load;
        if (size + n == 0) {
            if (kkt_error(qp, VectorXd::Zero(m), VectorXd(0)) < 1e-10) return VectorXd::Zero(m);
            continue;
        }
        const VectorXd x = k.fullPivLu().solve(rhs);
        VectorXd l = VectorXd::Zero(m);
        l(s) = x.head(size);
        if (x.allFinite() && kkt_error(qp, l, x.tail(n)) < 1e-10) return l;
    }
    return std::nullopt;
}

/// Every condition of a mechanism: it opens or keeps all gaps, keeps those that are held, and the loads work in it.
void expect_mechanism(const ContactQp& qp, const ContactQpResult& r) {
    ASSERT_FALSE(r.feasible);
    ASSERT_EQ(r.mechanism.size(), qp.modes.cols());
    const double size = r.mechanism.norm();
    EXPECT_GT(qp.mode_load.dot(r.mechanism), 1e-8 * size * qp.load_scale);
    const VectorXd opening = qp.modes * r.mechanism;
    for (Index k = 0; k < opening.size(); ++k) {
        const double wrong = qp.unilateral[static_cast<std::size_t>(k)] ? -opening[k] : std::abs(opening[k]);
        EXPECT_LT(wrong, 1e-9 * size) << k;
    }
}

void expect_solved(const ContactQp& qp, const ContactQpResult& r, double bound) {
    EXPECT_TRUE(r.feasible);
    EXPECT_TRUE(r.converged);
    ASSERT_EQ(r.multipliers.size(), qp.gap.size());
    EXPECT_LT(kkt_error(qp, r), bound);
    const VectorXd gap = qp.gap + qp.compliance * r.multipliers + qp.modes * r.amplitudes();
    EXPECT_LE((r.gap - gap).norm(), 1e-12 * (1 + gap.norm()));
    for (std::size_t k = 0; k < r.active.size(); ++k) EXPECT_TRUE(r.active[k] || r.multipliers[static_cast<Index>(k)] == 0);
}

/// A problem with a known solution: l and gap complementary, rows' share `undecided` with both of them `small`.
struct Manufactured {
    ContactQp qp;
    VectorXd multipliers, amplitudes;
};

Manufactured manufactured(unsigned seed, const MatrixXd& compliance, const MatrixXd& modes, double undecided, double small) {
    std::mt19937 random = generator(seed);
    std::uniform_real_distribution<double> number(0, 1);
    const Index m = compliance.rows();
    Manufactured p{problem_of(compliance, modes), VectorXd::Zero(m), random_matrix(random, modes.cols(), 1)};
    VectorXd gap = VectorXd::Zero(m);
    for (Index k = 0; k < m; ++k) {
        const double size = number(random) < undecided ? small : 0.5 + number(random);
        (number(random) < 0.5 ? p.multipliers : gap)[k] = size;
    }
    p.qp.gap = gap - compliance * p.multipliers - modes * p.amplitudes;
    p.qp.drawn_gap = p.qp.gap;
    load_with(p.qp, -modes.transpose() * p.multipliers);
    return p;
}

/// Compliance of a half plane's surface under neighbouring strips: logarithmic, with some of the strips' own.
MatrixXd surface_compliance(Index m) {
    return MatrixXd::NullaryExpr(m, m, [&](Index i, Index j) {
        return std::log(static_cast<double>(3 * m) / (1 + std::abs(static_cast<double>(i - j)))) + (i == j ? 1.0 : 0.0);
    });
}

/// Translation and rotation of a flat body over m rows.
MatrixXd flat_modes(Index m) {
    MatrixXd modes(m, 2);
    for (Index k = 0; k < m; ++k) modes.row(k) << 1, 2 * static_cast<double>(k) / static_cast<double>(m - 1) - 1;
    return modes;
}

}  // namespace

TEST(ContactQp, AgreesWithAllActiveSets) {
    int n_solved = 0, n_open = 0, n_mechanisms = 0;
    for (unsigned trial = 0; trial < 400; ++trial) {
        SCOPED_TRACE(trial);
        const ContactQp qp = random_problem(trial, 1 + trial % 7, trial / 7 % 4, trial % 3 != 0);
        const std::optional<VectorXd> expected = by_all_sets(qp);
        const ContactQpResult r = solve_contact_qp(qp);
        EXPECT_EQ(r.feasible, expected.has_value());
        if (!expected) {
            ++n_mechanisms;
            expect_mechanism(qp, r);
            continue;
        }
        expect_solved(qp, r, 1e-9);  // equilibrium is met to 1e-10 of the load
        EXPECT_LT((r.multipliers - *expected).norm(), 1e-8 * (1 + expected->norm()));
        ++n_solved;
        n_open += expected->isZero(0);
    }
    EXPECT_GT(n_solved, 200);
    EXPECT_GT(n_open, 5);
    EXPECT_GT(n_mechanisms, 30);
}

/// What is expected decides where the search begins, never where it ends: the answer itself, part of it, all or nothing.
TEST(ContactQp, GivesTheSameAnswerWhateverIsExpected) {
    int with_the_answer = 0, without = 0;
    for (unsigned trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE(trial);
        ContactQp qp = random_problem(trial, 3 + trial % 20, trial % 4, true);
        const ContactQpResult plain = solve_contact_qp(qp);
        if (!plain.feasible) continue;
        ASSERT_TRUE(plain.converged);
        std::mt19937 random = generator(trial);
        const Index m = qp.gap.size();
        for (const VectorXd& expected : {plain.multipliers, VectorXd(VectorXd::Zero(m)), VectorXd(VectorXd::Ones(m)),
                                         VectorXd(random_matrix(random, m, 1))}) {
            qp.expected = expected;
            const ContactQpResult r = solve_contact_qp(qp);
            expect_solved(qp, r, 1e-9);
            EXPECT_LT((r.multipliers - plain.multipliers).norm(), 1e-9 * (1 + plain.multipliers.norm()));
        }
        qp.expected = plain.multipliers;
        with_the_answer += solve_contact_qp(qp).iterations;
        without += plain.iterations;
    }
    EXPECT_LT(with_the_answer, without / 2);
}

/// A loaded body, and one between two faces with clearance that nothing loads: it is kept where the neighbour's answer has it.
TEST(ContactQp, WhatNothingHoldsStaysWhereANeighbourHasIt) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const ContactQp loaded = random_problem(seed, 12, 2, true);
        MatrixXd compliance = MatrixXd::Identity(14, 14), modes = MatrixXd::Zero(14, 3);
        compliance.topLeftCorner(12, 12) = loaded.compliance.to_dense();
        modes.topLeftCorner(12, 2) = loaded.modes;
        modes(12, 2) = 1;
        modes(13, 2) = -1;
        ContactQp qp = problem_of(compliance, modes);
        qp.gap << loaded.gap, 1, 1;
        qp.drawn_gap << loaded.drawn_gap, 1, 1;
        std::copy(loaded.unilateral.begin(), loaded.unilateral.end(), qp.unilateral.begin());
        load_with(qp, (VectorXd(3) << loaded.mode_load, 0).finished());
        const ContactQpResult before = solve_contact_qp(loaded);
        ASSERT_TRUE(before.converged && before.feasible) << seed;
        std::mt19937 random = generator(seed);
        qp.expected = random_matrix(random, 14, 1);
        qp.expected.tail(2).setZero();
        const double rest = 0.5;
        qp.near = (VectorXd(3) << before.amplitudes(), rest).finished();
        const ContactQpResult r = solve_contact_qp(qp);
        ASSERT_TRUE(r.converged) << seed;
        EXPECT_LT(kkt_error(qp, r), 1e-9) << seed;
        EXPECT_LT((r.multipliers.head(12) - before.multipliers).norm(), 1e-8 * before.multipliers.norm()) << seed;
        EXPECT_NEAR(r.amplitudes()[2], rest, 1e-9) << seed;
    }
}

TEST(ContactQp, SolvesOnceWithoutUnilateralRows) {
    for (unsigned trial = 0; trial < 20; ++trial) {
        SCOPED_TRACE(trial);
        ContactQp qp = random_problem(trial, 8, trial % 4, true);
        std::fill(qp.unilateral.begin(), qp.unilateral.end(), char{0});
        const ContactQpResult r = solve_contact_qp(qp);
        expect_solved(qp, r, 1e-9);
        EXPECT_EQ(r.iterations, 0);
    }
}

TEST(ContactQp, FinishesWithTheMonotoneSetWhereThePrimalDualOneCycles) {
    // compliances far from those of solids: strongly coupled rows of either sign, starts far from the solution
    int n_fallback = 0;
    for (unsigned trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE(trial);
        std::mt19937 random = generator(300 + trial);
        const MatrixXd b = random_matrix(random, 20, 10);
        Manufactured p = manufactured(trial, b * b.transpose() + 0.001 * MatrixXd::Identity(20, 20),
                                      random_matrix(random, 20, trial % 3), 0, 0);
        p.qp.drawn_gap = random_matrix(random, 20, 1);
        const ContactQpResult r = solve_contact_qp(p.qp);
        expect_solved(p.qp, r, 1e-9);
        EXPECT_LT((r.multipliers - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
        n_fallback += r.used_fallback;
    }
    EXPECT_GT(n_fallback, 5);
    EXPECT_LT(n_fallback, 60);
}

TEST(ContactQp, FallbackRecoversFromALostSet) {
    // on its way the monotone set is empty here and there: amplitudes of load / 1e-12, from which the next steps must come back
    for (unsigned trial = 0; trial < 2000; ++trial) {
        SCOPED_TRACE(trial);
        std::mt19937 random = generator(trial * 7919 + 3);
        const MatrixXd b = random_matrix(random, 3, 1);
        ContactQp qp = problem_of(b * b.transpose() + 1e-5 * MatrixXd::Identity(3, 3), random_matrix(random, 3, 2));
        qp.gap = random_matrix(random, 3, 1);
        qp.drawn_gap = random_matrix(random, 3, 1);
        load_with(qp, -qp.modes.transpose() * random_matrix(random, 3, 1).cwiseAbs());
        expect_solved(qp, solve_contact_qp(qp), 1e-7);
    }
}

TEST(ContactQp, AgreesWithAllSetsOfTenRows) {
    for (unsigned trial = 0; trial < 12; ++trial) {
        SCOPED_TRACE(trial);
        const ContactQp qp = random_problem(1000 + trial, 10, trial % 4, true);
        const std::optional<VectorXd> expected = by_all_sets(qp);
        ASSERT_TRUE(expected.has_value());
        const ContactQpResult r = solve_contact_qp(qp);
        expect_solved(qp, r, 1e-9);
        EXPECT_LT((r.multipliers - *expected).norm(), 1e-8 * (1 + expected->norm()));
    }
}

TEST(ContactQp, ConditionsSeeAWrongSolution) {
    const Manufactured p = manufactured(3, surface_compliance(20), flat_modes(20), 0, 0);
    EXPECT_LT(kkt_error(p.qp, p.multipliers, p.amplitudes), 1e-14);
    EXPECT_GT(kkt_error(p.qp, p.multipliers * (1 + 1e-7), p.amplitudes), 1e-9);
    EXPECT_GT(kkt_error(p.qp, p.multipliers, p.amplitudes * (1 - 1e-7)), 1e-9);
    EXPECT_GT(kkt_error(p.qp, -p.multipliers, p.amplitudes), 1e-9);
}

TEST(ContactQp, MeetsItsConditionsOnLargeProblems) {
    std::mt19937 random = generator(17);
    const Index m = 200;
    const MatrixXd b = random_matrix(random, m, m);
    const MatrixXd rough = b * b.transpose() / static_cast<double>(m) + 0.1 * MatrixXd::Identity(m, m),
                   smooth = surface_compliance(m);
    for (const MatrixXd* compliance : {&rough, &smooth})
        for (Index n : {0, 2}) {
            SCOPED_TRACE(std::string(compliance == &rough ? "rough" : "smooth") + ", modes " + std::to_string(n));
            const Manufactured p = manufactured(5, *compliance, flat_modes(m).leftCols(n), 0, 0);
            const ContactQpResult r = solve_contact_qp(p.qp);
            expect_solved(p.qp, r, 1e-9);
            EXPECT_LT((r.multipliers - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
            EXPECT_LT((r.amplitudes() - p.amplitudes).norm(), 1e-8);
        }
}

TEST(ContactQp, SolvesNearlyDegenerateProblems) {
    // a third of the rows neither clearly pressed nor clearly open
    for (double small : {1e-6, 1e-10, 1e-13, 0.0})
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(testing::Message() << small << " seed " << seed);
            const Manufactured p = manufactured(40 + seed, surface_compliance(100), flat_modes(100), 0.33, small);
            const ContactQpResult r = solve_contact_qp(p.qp);
            expect_solved(p.qp, r, 1e-9);
            EXPECT_LT((r.multipliers - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
        }
}

TEST(ContactQp, PressesAFlatPunchWithoutGaps) {
    // all gaps zero: every row in contact under a central load, in order of the edges' singular pressure
    ContactQp qp = problem_of(surface_compliance(41), flat_modes(41));
    load_with(qp, Eigen::Vector2d(-3, 0));
    const ContactQpResult r = solve_contact_qp(qp);
    expect_solved(qp, r, 1e-9);
    EXPECT_NEAR(r.multipliers.sum(), 3, 1e-9);
    EXPECT_GT(r.multipliers.minCoeff(), 0);
    EXPECT_GT(r.multipliers[0], 2 * r.multipliers[20]);
    EXPECT_LT((r.multipliers - r.multipliers.reverse()).cwiseAbs().maxCoeff(), 1e-10);
    // a load on the very edge leaves the other end open, one beyond it tips the punch
    load_with(qp, Eigen::Vector2d(-3, -2.9));
    expect_solved(qp, solve_contact_qp(qp), 1e-9);
    EXPECT_EQ(solve_contact_qp(qp).multipliers[0], 0);
    load_with(qp, Eigen::Vector2d(-3, -3.1));
    expect_mechanism(qp, solve_contact_qp(qp));
    load_with(qp, Eigen::Vector2d(3, 0));
    expect_mechanism(qp, solve_contact_qp(qp));
}

TEST(ContactQp, LoadOnASingleRowIsCarriedByIt) {
    // degenerate: one row in contact, the rotation held by nothing but the limits of the other gaps
    ContactQp qp = problem_of(surface_compliance(11), flat_modes(11));
    qp.gap = qp.drawn_gap = flat_modes(11).col(1).cwiseAbs2();
    load_with(qp, Eigen::Vector2d(-1e-6, 0));
    const ContactQpResult r = solve_contact_qp(qp);
    expect_solved(qp, r, 1e-9);
    EXPECT_NEAR(r.multipliers[5], 1e-6, 1e-14);
    EXPECT_NEAR(r.multipliers.sum(), 1e-6, 1e-14);
}

TEST(ContactQp, SlidesFarUnderASmallShareOfTheLoad) {
    // a round body with clearance over rows of a trough, loaded a little beside the normal of one row: the next one has to
    // close, which takes a slide a million times longer than any elastic displacement
    const Index m = 9;
    MatrixXd modes(m, 2);
    ContactQp qp = problem_of(surface_compliance(m), modes);
    for (Index k = 0; k < m; ++k) {
        const double angle = 0.2 * static_cast<double>(k - 4);
        qp.modes.row(k) << std::sin(angle), std::cos(angle);
        qp.drawn_gap[k] = 0.01 * (1 - std::cos(angle));
    }
    qp.gap = qp.drawn_gap;
    for (double aside : {1e-3, 1e-6, 1e-9, 1e-12}) {
        load_with(qp, 1e-8 * Eigen::Vector2d(-aside, -1));
        const ContactQpResult r = solve_contact_qp(qp);
        expect_solved(qp, r, 1e-9);
        EXPECT_LT(r.residual, 1e-9) << aside;
        EXPECT_LE(r.iterations, 30) << aside;
        EXPECT_NEAR(r.multipliers.sum(), 1e-8, 1e-9);
    }
}

TEST(ContactQp, ResidualSeesEveryCondition) {
    const Manufactured p = manufactured(3, surface_compliance(20), flat_modes(20), 0, 0);
    const ContactQpResult r = solve_contact_qp(p.qp);
    EXPECT_LT(r.residual, 1e-12);
    const VectorXd balance = VectorXd::Zero(2);
    EXPECT_LT(contact_residual(p.qp, {r.multipliers, r.gap, balance}), 1e-12);
    EXPECT_GT(contact_residual(p.qp, {r.multipliers, r.gap, VectorXd::Constant(2, 1e-6 * p.qp.load_scale)}), 1e-7);
    EXPECT_GT(contact_residual(p.qp, {-1e-6 * r.multipliers, r.gap, balance}), 1e-7);
    const double closing = (p.qp.compliance * r.multipliers).cwiseAbs().maxCoeff();
    EXPECT_GT(contact_residual(p.qp, {r.multipliers, r.gap + VectorXd::Constant(20, 1e-6 * closing), balance}), 1e-7);
    EXPECT_GT(contact_residual(p.qp, {r.multipliers, r.gap - VectorXd::Constant(20, 1e-6 * closing), balance}), 1e-7);
}

TEST(ContactQp, WithoutLoadNothingHappens) {
    for (double gap : {0.0, 0.2}) {
        ContactQp qp = problem_of(surface_compliance(12), flat_modes(12));
        qp.gap = qp.drawn_gap = VectorXd::Constant(12, gap);
        const ContactQpResult r = solve_contact_qp(qp);
        EXPECT_TRUE(r.feasible);
        EXPECT_TRUE(r.converged);
        EXPECT_TRUE(r.multipliers.isZero(0));
        EXPECT_TRUE(r.amplitudes().isZero(0));
    }
}

TEST(ContactQp, AnInterferenceWithoutLoadBalancesItself) {
    // a floating body pressed between two walls that are 0.1 too close: rows 0-4 push it up, rows 5-9 down
    MatrixXd modes(10, 1);
    modes << VectorXd::Ones(5), -VectorXd::Ones(5);
    ContactQp qp = problem_of(surface_compliance(10), modes);
    qp.gap = qp.drawn_gap = VectorXd::Constant(10, -0.1);
    const ContactQpResult r = solve_contact_qp(qp);
    expect_solved(qp, r, 1e-9);
    EXPECT_GT(r.multipliers.head(5).sum(), 1e-3);
    EXPECT_NEAR(r.multipliers.head(5).sum(), r.multipliers.tail(5).sum(), 1e-12);
}

TEST(ContactQp, OpenGapsOfHeldBodiesCarryNothing) {
    ContactQp qp = problem_of(surface_compliance(6), MatrixXd(6, 0));
    qp.gap = qp.drawn_gap = VectorXd::LinSpaced(6, 0, 1);
    const ContactQpResult r = solve_contact_qp(qp);
    expect_solved(qp, r, 1e-12);
    EXPECT_TRUE(r.multipliers.isZero(0));
    qp.gap.array() -= 0.5;
    expect_solved(qp, solve_contact_qp(qp), 1e-12);
    EXPECT_GT(solve_contact_qp(qp).multipliers[0], 0);
}

TEST(ContactQp, BilateralRowsPullAsWell) {
    ContactQp qp = problem_of(surface_compliance(6), MatrixXd(6, 0));
    std::fill(qp.unilateral.begin(), qp.unilateral.end(), char{0});
    qp.gap = qp.drawn_gap = VectorXd::LinSpaced(6, -1, 1);
    const ContactQpResult r = solve_contact_qp(qp);
    expect_solved(qp, r, 1e-12);
    EXPECT_LT((qp.compliance * r.multipliers + qp.gap).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT(r.multipliers.minCoeff(), -0.1);
}

TEST(ContactQp, WithoutRows) {
    const ContactQpResult r = solve_contact_qp(problem_of(MatrixXd(0, 0), MatrixXd(0, 0)));
    EXPECT_TRUE(r.feasible);
    EXPECT_TRUE(r.converged);
    EXPECT_EQ(r.multipliers.size(), 0);
    ContactQp falling = problem_of(MatrixXd(0, 0), MatrixXd(0, 2));
    load_with(falling, Eigen::Vector2d(1, -2));
    expect_mechanism(falling, solve_contact_qp(falling));
}

/// The same problem with a compliance that is stored, and factorised, as a sparse one.
ContactQp sparse(ContactQp qp) {
    const MatrixXd dense = qp.compliance.dense();
    qp.compliance = Eigen::SparseMatrix<double>(dense.sparseView());
    return qp;
}

TEST(ContactQp, AnswersASparseProblemLikeADenseOne) {
    int n_mechanisms = 0;
    for (unsigned trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE(trial);
        const Index m = 1 + static_cast<Index>(trial % 17), n = static_cast<Index>(trial / 17 % 4);
        const ContactQp qp = random_problem(5000 + trial, m, n, trial % 5 != 0);
        const ContactQpResult dense = solve_contact_qp(qp), r = solve_contact_qp(sparse(qp));
        ASSERT_EQ(r.feasible, dense.feasible);
        n_mechanisms += !dense.feasible;
        if (!dense.feasible) continue;
        expect_solved(qp, r, 1e-9);
        EXPECT_LT((r.multipliers - dense.multipliers).norm(), 1e-8 * (1 + dense.multipliers.norm()));
    }
    EXPECT_GT(n_mechanisms, 20);
}

TEST(ContactQp, FinishesASparseProblemFromInsideWhereThePrimalDualSetCycles) {
    int n_fallback = 0;
    for (unsigned trial = 0; trial < 60; ++trial) {
        SCOPED_TRACE(trial);
        std::mt19937 random = generator(300 + trial);
        const MatrixXd b = random_matrix(random, 20, 10);
        Manufactured p = manufactured(trial, b * b.transpose() + 0.001 * MatrixXd::Identity(20, 20),
                                      random_matrix(random, 20, trial % 3), 0, 0);
        p.qp.drawn_gap = random_matrix(random, 20, 1);
        const ContactQpResult r = solve_contact_qp(sparse(p.qp));
        expect_solved(p.qp, r, 1e-9);
        EXPECT_LT((r.multipliers - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
        n_fallback += r.used_fallback;
    }
    EXPECT_GT(n_fallback, 5);
}

/// From amplitudes that are off, and a set that is none, it ends at the one answer, in the steps of an interior point method at
/// most: rows do not trade places one by one.
TEST(ContactQp, FindsASparseAnswerFromANeighboursAmplitudes) {
    int n_found = 0;
    for (unsigned trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE(trial);
        ContactQp qp = random_problem(trial, 10 + trial % 20, 1 + trial % 3, true);
        const ContactQpResult plain = solve_contact_qp(qp);
        if (!plain.feasible) continue;
        std::mt19937 random = generator(trial);
        qp.expected = random_matrix(random, qp.gap.size(), 1);
        qp.near = plain.amplitudes() + 0.1 * random_matrix(random, qp.modes.cols(), 1);
        ContactQpResult r;
        if (!solve_from_near(sparse(qp), r)) continue;
        ++n_found;
        expect_solved(qp, r, 1e-9);
        EXPECT_LT((r.multipliers - plain.multipliers).norm(), 1e-8 * (1 + plain.multipliers.norm()));
        EXPECT_LE(r.iterations, 100);
    }
    EXPECT_GT(n_found, 180);
}

TEST(ContactQp, LeavesOutRedundantRowsOfASparseProblem) {
    const Manufactured p = manufactured(3, surface_compliance(20), flat_modes(20), 0, 0);
    // a pressed row twice: both share what the one has
    Index pressed = 0;
    ASSERT_GT(p.multipliers.maxCoeff(&pressed), 0);
    const auto twice = [&](const VectorXd& v) { return VectorXd((VectorXd(21) << v, v[pressed]).finished()); };
    std::vector<Index> rows(21, pressed);
    std::iota(rows.begin(), rows.end() - 1, Index{0});
    ContactQp qp = p.qp;
    qp.compliance = Eigen::SparseMatrix<double>(p.qp.compliance.dense()(rows, rows).sparseView());
    qp.gap = twice(p.qp.gap);
    qp.drawn_gap = twice(p.qp.drawn_gap);
    qp.foundation = twice(p.qp.foundation);
    qp.modes = p.qp.modes(rows, Eigen::all).eval();
    qp.unilateral.push_back(1);
    const ContactQpResult r = solve_contact_qp(qp);
    ASSERT_TRUE(r.converged);
    VectorXd sum = r.multipliers.head(20);
    sum[pressed] += r.multipliers[20];
    EXPECT_LT((sum - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(ContactQp, DoesNotDependOnUnits) {
    const Manufactured p = manufactured(8, surface_compliance(30), flat_modes(30), 0, 0);
    const double force = 1e7, length = 1e-4;
    ContactQp scaled = p.qp;
    scaled.compliance = length / force * p.qp.compliance.dense();
    scaled.gap *= length;
    scaled.drawn_gap *= length;
    scaled.foundation *= force / length;
    scaled.mode_load *= force;
    scaled.load_scale *= force;
    const ContactQpResult r = solve_contact_qp(scaled);
    expect_solved(scaled, r, 1e-9);
    EXPECT_LT((r.multipliers / force - p.multipliers).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT((r.amplitudes() / length - p.amplitudes).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(ContactQp, SolvesOnAGivenSet) {
    const ContactQp qp = random_problem(2, 6, 1, true);
    std::vector<char> active{1, 0, 1, 0, 1, 0};
    VectorXd l, a;
    ASSERT_TRUE(solve_on_set(qp, active, l, a));
    const VectorXd gap = qp.gap + qp.compliance * l + qp.modes * a;
    for (Index k = 0; k < 6; ++k) EXPECT_NEAR(active[static_cast<std::size_t>(k)] ? gap[k] : l[k], 0, 1e-12) << k;
    EXPECT_NEAR((qp.modes.transpose() * l + qp.mode_load).norm(), 0, 1e-12);
    EXPECT_FALSE(solve_on_set(qp, std::vector<char>(6, 0), l, a));  // nothing holds the mode
}

TEST(ContactQp, RefusesShapesThatDoNotFit) {
    const ContactQp qp = random_problem(2, 6, 1, true);
    VectorXd l, a;
    EXPECT_THROW(solve_on_set(qp, std::vector<char>(5, 1), l, a), std::logic_error);
    std::vector<ContactQp> wrong(6, qp);
    wrong[0].compliance = MatrixXd(6, 5);
    wrong[1].modes.resize(5, 1);
    wrong[2].mode_load.resize(2);
    wrong[3].unilateral.pop_back();
    wrong[4].foundation.resize(0);
    wrong[5].expected.resize(5);
    for (const ContactQp& each : wrong) EXPECT_THROW(solve_contact_qp(each), std::logic_error);
}

}  // namespace abut::solver::contact_qp_test
