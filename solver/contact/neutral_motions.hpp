// SPDX-License-Identifier: GPL-3.0-or-later
// Free motions of an assembly that its contacts do not resist: they are left out of the contact problem, which they would make
// singular, and looked at apart.
#pragma once
#include <vector>

#include "solver/contact/assembly_solve.hpp"

namespace abut::solver {

/// Orthonormal bases of the motions that something resists, as far as rows move in them, and of the neutral ones (amplitudes x
/// motions), one part's each where that can be. balanced: neutral motions in which contact forces have levers all the same,
/// since a force on a round part acts on the line that both bodies share, not through the part's own centre (scaled to levers
/// of one). Pressures are made to balance in them.
struct MotionSplit {
    Eigen::MatrixXd resisted, neutral, balanced;
};
/// Mean squares of what the candidates' points close by in motions (amplitudes squared), each interface's over its length, so
/// that a motion straight against a face has 1. acting: along the lines that contact forces act on. contact: the same but for
/// motions that contact does not resist: across all of these lines, and of a body that turns or slides in its own outline.
struct Resistance {
    Eigen::MatrixXd contact, acting;
};
Resistance candidate_resistance(const AssemblyProblem& problem);
/// What some of the interfaces resist alone (interfaces: 1 of those that count).
Resistance resistance_of(const AssemblyProblem& problem, const std::vector<char>& interfaces);
/// Splits the free motions by what resists them. modes: G of the rows, of which the constraints' resist as they are.
MotionSplit split_motions(const AssemblyProblem& problem, const Resistance& resistance, const Eigen::MatrixXd& modes);

/// The motion of every part that takes a notable share in a combination of the free motions.
std::vector<PartMotion> part_motions(const std::vector<PartSystem>& parts, const Eigen::VectorXd& amplitudes);

/// Names the neutral motions in the solution: as its mechanism, where the loads work in them. load_scale: the largest load on
/// any body, prescribed displacements' included. A motion that is neutral only nearly, since an outline is drawn with rounding,
/// takes as much of the loads as the little that resists it.
void find_driven_neutral_motion(const AssemblyProblem& problem, const Resistance& resistance, const Eigen::MatrixXd& neutral,
                                const Eigen::VectorXd& mode_load, double load_scale, AssemblySolution& solution);

/// What the mean square over the parts is made of: integrals' displacement is that of a part's free motions times a
/// displacement (2n x free motions, by part; empty where no neutral motion moves the part), gram that of the neutral motions
/// among themselves.
struct NeutralMeasure {
    std::vector<Eigen::MatrixXd> integrals;
    Eigen::MatrixXd gram;
};
NeutralMeasure neutral_measure(const AssemblyProblem& problem, const Eigen::MatrixXd& neutral, int threads);

/// The amplitudes that the gram takes to this make displacements (by part) least: minus their integrals times the motions.
Eigen::VectorXd pull_of(const AssemblyProblem& problem, const NeutralMeasure& measure, const Eigen::MatrixXd& neutral,
                        const std::vector<Eigen::VectorXd>& displacement);

/// The amplitudes of each part's free motions that make its displacement (by part) least, in the mean square over it.
Eigen::VectorXd least_amplitudes(const std::vector<PartSystem>& parts, const std::vector<Eigen::VectorXd>& displacement);

/// Displaces parts by rigid motions. amplitudes: of all free motions of the parts, one after the other.
void add_rigid_motions(const AssemblyProblem& problem, const Eigen::VectorXd& amplitudes, AssemblySolution& solution);

/// A basis of what motions span beside others; all are orthonormal.
Eigen::MatrixXd motions_beside(const Eigen::MatrixXd& others, const Eigen::MatrixXd& motions);

/// Takes the neutral motions' amplitudes that make the displacement least, in the mean square over the parts.
void take_least_motion(const AssemblyProblem& problem, const Eigen::MatrixXd& neutral, int threads, AssemblySolution& solution);

}  // namespace abut::solver
