// SPDX-License-Identifier: GPL-3.0-or-later
// Free motions of an assembly that its contacts do not resist: they are left out of the contact problem, which they would make
// singular, and looked at apart.
#pragma once
#include <vector>

#include "solver/assembly_solve.hpp"

namespace abut::solver {

/// Orthonormal bases of the motions that something resists, and of the neutral ones (amplitudes x motions).
struct MotionSplit {
    Eigen::MatrixXd resisted, neutral;
};
/// R'R of the candidates' resistance R along the bodies' own normals, root-mean-square over each interface (amplitudes
/// squared).
Eigen::MatrixXd candidate_resistance(const AssemblyProblem& problem);
/// resistance: of the candidates; modes: G of the rows, of which the constraints' resist as they are.
MotionSplit split_motions(const AssemblyProblem& problem, const Eigen::MatrixXd& resistance, const Eigen::MatrixXd& modes);

/// Motion of every part that takes a notable share in a combination of the free motions.
std::vector<PartMotion> part_motions(const std::vector<PartSystem>& parts, const Eigen::VectorXd& amplitudes);

/// Names the neutral motions in the solution: as its mechanism, where the loads work in them.
void find_driven_neutral_motion(const AssemblyProblem& problem, const Eigen::MatrixXd& neutral,
                                const Eigen::VectorXd& mode_load, AssemblySolution& solution);

/// The contact problem under the motions `held`, and its answer.
struct HeldAnswer {
    ContactQp qp;
    Eigen::MatrixXd held;
    ContactQpResult result;
};
/// Pairs act along the normal of the middle curve, not along a round part's own: with the neutral motions left out, their
/// balance is off by what that difference does (1e-8 to 1e-5 of the load). Where the pressures can make up for it, they do so
/// with the neutral motions as unknowns; their amplitudes, which mean nothing, are taken out again by take_least_motion. modes,
/// mode_load: of all motions. False: nothing is changed.
bool balance_neutral_motions(const Eigen::MatrixXd& modes, const Eigen::VectorXd& mode_load, const MotionSplit& split,
                             HeldAnswer& answer);

/// The neutral motions' amplitudes that make the displacement least (in the coefficients).
void take_least_motion(const AssemblyProblem& problem, const Eigen::MatrixXd& neutral, AssemblySolution& solution);

}  // namespace abut::solver
