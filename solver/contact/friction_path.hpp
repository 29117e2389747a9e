// SPDX-License-Identifier: GPL-3.0-or-later
// The contact problem with friction at the end of a way of the loads: what slips, and what sticks where, depends on the way.
#pragma once
#include "solver/contact/assembly_rows.hpp"

namespace abut::solver {

/// Where gaps and loads on motions begin, from where they grow evenly to those of a problem: at the state before or, without
/// one, at the bodies as drawn, without loads, and without what overlaps. Bodies that nothing holds there move least.
struct PathStart {
    Eigen::VectorXd gap, mode_load;  ///< of scaled rows, of all free motions
    bool is_loaded = false;          ///< contacts may be pressed there
};
/// modes: of scaled rows, all.
PathStart path_start(const AssemblyProblem& problem, const AssemblyRows& all, const Eigen::MatrixXd& modes);

/// The amplitudes of free motions by which bodies move least under their loads alone: where they would be, if nothing held
/// them. What touches on the way sticks there.
Eigen::VectorXd unheld_amplitudes(const std::vector<PartSystem>& parts, int threads);

/// What comes together on a path.
struct OnWay {
    int increments = 1;
    Eigen::VectorXd error;             ///< of the multipliers by the increments' size (m)
    Eigen::VectorXd work, work_error;  ///< done against slip, by tangential row (m)
    bool is_broken = false;            ///< there are loads on it under which no answer was found
};

/// The answer at the end of a path.
struct FrictionPath {
    HeldAnswer end;
    OnWay way;
    int iterations = 0;
    Eigen::VectorXd moved{};  ///< amplitudes that come to those of `end`
};

/// Follows a path in increments: each is one problem in which slips count from where the one before ended, so that what comes
/// into contact sticks where it touches, to within an increment. An increment is taken as two halves, and these are halved in
/// turn where they change pressures (L2, relative to the largest of the path's ends) or tractions (over their bounds) by more
/// than `tolerance` times the increment's share of the path; where an answer is not found, too. The changes add up to the
/// error. What falls onto others under any load at all does so in a first, least increment. Before anything is known of the
/// way, bodies go where the loads alone would take them until they touch, and give way to each other, without friction, until
/// something presses: the path begins there. qp: of scaled rows, slips from the start; unheld:
/// unheld_amplitudes of its loads; weight: of the rows; split, levers: as of solve_held; no tolerance: the loads are put on at
/// once. Where bodies slide, or there is no answer at the end however small the increments, it is that of one increment.
FrictionPath follow_path(ContactQp qp, const PathStart& start, const Eigen::VectorXd& unheld, const Eigen::VectorXd& weight,
                         const MotionSplit& split, const Eigen::MatrixXd& levers, std::optional<double> tolerance);

}  // namespace abut::solver
