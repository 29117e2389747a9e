// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed problem against displacements: one solution of every part for each row and for its loads.
#include "solver/contact/condensation.hpp"

#include <gtest/gtest.h>

#include "solver/linear_algebra/blas_threads.hpp"
#include "tests/solver/contact/two_blocks.hpp"

namespace abut::solver::condensation_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Setting {
    AssemblyProblem problem;
    Rows rows;

    /// The upper block's right side is pushed by `pushed` (dropped functions), its mean rotation held.
    Setting(int degree, double overhang, double pushed, bool with_constraint) {
        test::TwoBlocks blocks;
        blocks.degree = degree;
        blocks.lower.overhang = overhang;
        const PartInput upper = test::part_of(blocks.upper, degree);
        blocks.upper_supports = {test::side_support(upper.space, GridSide::right, 0, pushed)};
        blocks.gap = 0.01;
        problem = blocks.problem();
        std::vector<int> first_row;
        rows = interface_rows(problem.parts, problem.interfaces, first_row);
        if (with_constraint)
            append_mean_constraint(rows, problem.parts[1], 1, integrate_functions(problem.parts[1].input), 1, {0, 1, 1}, 1.4,
                                   0.1);
    }
    VectorXd opening(std::size_t part, const VectorXd& load) const {
        return rows_times(rows.by_part[part], solve(problem.parts[part], load), rows.n);
    }
    VectorXd load_of_row(std::size_t part, Index row) const {
        return transposed_times(rows.by_part[part], VectorXd::Unit(rows.n, row), 2 * problem.parts[part].n());
    }
    VectorXd expected_gap() const {
        VectorXd gap = rows.gap0;
        for (std::size_t i = 0; i < problem.parts.size(); ++i) gap += opening(i, problem.parts[i].load);
        return gap;
    }
    MatrixXd expected_compliance() const {
        MatrixXd c = MatrixXd::Zero(rows.n, rows.n);
        for (std::size_t i = 0; i < problem.parts.size(); ++i) {
            const VectorXd unloaded = opening(i, VectorXd::Zero(2 * problem.parts[i].n()));
            for (Index k = 0; k < rows.n; ++k) c.col(k) += opening(i, load_of_row(i, k)) - unloaded;
        }
        return c;
    }
};

double distance(const MatrixXd& a, const MatrixXd& b) {
    return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Rounding, times the condition number of the stiffness (about 1e3).
constexpr double rounding_bound = 1e-11;

TEST(Condensation, AgreesWithSolutionsRowByRow) {
    for (int degree : {1, 2, 3})
        for (double overhang : {0.0, 0.4})
            for (double pushed : {0.0, -0.02})
                for (bool with_constraint : {false, true}) {
                    const Setting s(degree, overhang, pushed, with_constraint);
                    const ContactQp qp = condense(s.problem.parts, s.rows, s.problem.load_scale, 1);
                    EXPECT_LT(distance(qp.compliance.dense(), s.expected_compliance()), rounding_bound);
                    EXPECT_LT(distance(qp.gap, s.expected_gap()), rounding_bound);
                    EXPECT_EQ(qp.drawn_gap, s.rows.gap0);
                }
}

TEST(Condensation, CarriesFreeMotions) {
    const Setting s(2, 0, 0, false);
    const ContactQp qp = condense(s.problem.parts, s.rows, s.problem.load_scale, 1);
    const PartSystem& upper = s.problem.parts[1];
    ASSERT_GT(upper.modes.cols(), 0);
    ASSERT_EQ(qp.modes.cols(), s.problem.parts[0].modes.cols() + upper.modes.cols());
    for (Index k = 0; k < upper.modes.cols(); ++k) {
        const Index column = s.problem.parts[0].modes.cols() + k;
        EXPECT_LT((qp.modes.col(column) - rows_times(s.rows.by_part[1], upper.modes.col(k), s.rows.n)).norm(), 1e-14);
        EXPECT_NEAR(qp.mode_load[column], upper.modes.col(k).dot(upper.load), 1e-14);
    }
}

TEST(Condensation, IsTheSameOnAnyNumberOfThreads) {
    const Setting s(2, 0.4, -0.02, true);
    const ContactQp one = condense(s.problem.parts, s.rows, s.problem.load_scale, 1);
    for (int threads : {2, 5}) {
        const ContactQp more = condense(s.problem.parts, s.rows, s.problem.load_scale, usable_threads(threads));
        EXPECT_EQ(one.compliance.dense(), more.compliance.dense());
        EXPECT_EQ(one.gap, more.gap);
    }
}

/// Whole solutions, refinement included.
TEST(Condensation, LeavesTheSolutionTheSameOnAnyNumberOfThreads) {
    const AssemblyProblem p = test::TwoBlocks{}.problem();
    const AssemblySolution one = solve_assembly(p, 1), more = solve_assembly(p, usable_threads(4));
    for (std::size_t i = 0; i < p.parts.size(); ++i) EXPECT_EQ(one.displacement[i], more.displacement[i]);
    EXPECT_EQ(one.pressure[0], more.pressure[0]);
}

TEST(Condensation, RefusesRowsOfOtherParts) {
    const Setting s(2, 0, 0, false);
    Rows fewer_parts = s.rows, fewer_gaps = s.rows;
    fewer_parts.by_part.pop_back();
    fewer_gaps.gap0.conservativeResize(s.rows.n - 1);
    EXPECT_THROW(condense(s.problem.parts, fewer_parts, 1, 1), std::logic_error);
    EXPECT_THROW(condense(s.problem.parts, fewer_gaps, 1, 1), std::logic_error);
}

}  // namespace
}  // namespace abut::solver::condensation_test
