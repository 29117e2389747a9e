// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of solve_assembly: the rows of an assembly, and the solution under them.
#pragma once
#include <optional>
#include <vector>

#include "solver/contact/contact_qp.hpp"
#include "solver/contact/neutral_motions.hpp"

namespace abut::solver {

/// The rows of an assembly, in order, with what the start of the search needs.
struct AssemblyRows {
    Rows rows;                   ///< of the interfaces, then one for each constraint
    std::vector<int> first_row;  ///< by interface
    Eigen::VectorXd foundation;  ///< by row, of the start
    Eigen::VectorXd expected;    ///< multipliers; empty: nothing is known of them
    std::vector<FrictionRow> friction;
};
AssemblyRows assembly_rows(const AssemblyProblem& problem, int threads = 1);
/// Those of the rows that are taken (by row), alone, but for `first_row`. With a row of friction's pressure its tangential one
/// has to be taken.
AssemblyRows rows_among(const AssemblyRows& all, const std::vector<char>& taken);

/// The rows' motions (rows x motions) combined, as a rule each of few: G B.
Eigen::MatrixXd times_few(const Eigen::MatrixXd& modes, const Eigen::MatrixXd& combinations);

/// Pressures times 1 + a combination of levers, such that neutral motions balance, too, and the others as before. levers: of
/// the rows in the neutral motions (rows x motions). What closed gaps change by is as small as the imbalance was. Nothing where
/// pressures would change by more than a trifle, of their own or of the largest.
std::optional<Eigen::VectorXd> balanced(const ContactQp& qp, const Eigen::MatrixXd& levers, const Eigen::VectorXd& forces);

/// The contact problem under the motions `held` (amplitudes x motions), and its answer.
struct HeldAnswer {
    ContactQp qp;
    Eigen::MatrixXd held;
    ContactQpResult result;

    HeldAnswer(ContactQp of_all, Eigen::MatrixXd motions);
    /// The answer from a neighbour's, whose multipliers are those expected, if it is found from there. start: its amplitudes.
    HeldAnswer(ContactQp of_all, Eigen::MatrixXd motions, const Eigen::VectorXd& start);
    bool has_answer() const { return result.feasible && result.converged; }
};
/// Under the motions that something resists. Where pressures on few cells are too far from the balance of the others, under
/// these, too: their amplitudes mean nothing. levers: as of `balanced`. start: amplitudes of a neighbour's answer under all of
/// these; empty: none is known.
HeldAnswer solve_held(const ContactQp& qp, const MotionSplit& split, const Eigen::MatrixXd& levers,
                      const Eigen::VectorXd& start = {});

/// A solution in which pressures and constraint forces are not filled in: multipliers has them, by row; empty with a mechanism.
struct RowsSolution {
    AssemblySolution solution;
    Eigen::VectorXd multipliers{};
};
/// Solves an assembly under its rows. resistance: candidate_resistance of the problem's motions. The problem's interfaces are
/// not read.
RowsSolution solve_rows(const AssemblyProblem& problem, const AssemblyRows& all, const Resistance& resistance, int threads);

/// Fills in the loads of one part, those of contact alone and all.
void set_loads(const AssemblyProblem& problem, const Rows& rows, const Eigen::VectorXd& multipliers, std::size_t part,
               AssemblySolution& solution);

/// Writes the multipliers into the solution, as pressures of the interfaces and forces of the constraints.
void split_multipliers(const AssemblyProblem& problem, const AssemblyRows& all, const Eigen::VectorXd& multipliers,
                       AssemblySolution& solution);

}  // namespace abut::solver
