// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/loose_motions.hpp"

#include "solver/contact/condensation.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/nonnegative.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The interfaces that hold: bonds, and those whose pressure bears something, with their friction.
std::vector<char> holding(const AssemblyProblem& problem, const AssemblyRows& all, const VectorXd& multipliers) {
    std::vector<char> holds;
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        const Interface& face = problem.interfaces[f];
        if (face.friction) {
            holds.push_back(holds.back());
        } else {
            const auto own = Eigen::seqN(all.first_row[f], n_rows(face));
            const double force = multipliers(own).cwiseAbs().dot(all.rows.weight(own)) * face.thickness;
            holds.push_back(static_cast<char>(face.bilateral || force > open_force_fraction * problem.load_scale));
        }
    }
    return holds;
}

/// The motions that move a part which something holds.
MatrixXd of_held_parts(const AssemblyProblem& problem, const std::vector<char>& holds, const MatrixXd& motions) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    std::vector<char> is_held(problem.parts.size(), 0);
    for (std::size_t f = 0; f < holds.size(); ++f)
        for (const int part : problem.interfaces[f].part) is_held[at(part)] = is_held[at(part)] || holds[f];
    const auto moves_held = [&](Index k) {
        for (std::size_t i = 0; i < is_held.size(); ++i)
            if (is_held[i] && !motions.col(k).segment(offset[i], offset[i + 1] - offset[i]).isZero(0)) return true;
        return false;
    };
    std::vector<Index> kept;
    for (Index k = 0; k < motions.cols(); ++k)
        if (moves_held(k)) kept.push_back(k);
    return motions(Eigen::all, kept);
}

/// The rows that hold nothing yet.
std::vector<Index> open_rows(const AssemblyProblem& problem, const AssemblyRows& all, const std::vector<char>& holds) {
    std::vector<Index> open;
    for (std::size_t f = 0; f < holds.size(); ++f)
        for (int k = 0; !holds[f] && !problem.interfaces[f].bilateral && k < n_rows(problem.interfaces[f]); ++k)
            open.push_back(all.first_row[f] + k);
    return open;
}

VectorXd gaps_of(const AssemblyProblem& problem, const AssemblyRows& all, const AssemblySolution& solution) {
    VectorXd gap = all.rows.gap0;
    for (std::size_t i = 0; i < problem.parts.size(); ++i) gap += opening_of(all.rows, i, solution.displacement[i]);
    return gap.cwiseQuotient(all.rows.weight);
}

}  // namespace

void take_least_loose_motion(const AssemblyProblem& problem, const AssemblyRows& all, const VectorXd& multipliers,
                             const MatrixXd& neutral, int threads, AssemblySolution& solution) {
    const std::vector<char> holds = holding(problem, all, multipliers);
    const std::vector<Index> open = open_rows(problem, all, holds);
    if (open.empty() || neutral.rows() == 0) return;
    ContactQp qp = rigid_problem(problem.parts, all.rows, problem.load_scale);
    scale_rows(qp, all.rows.weight);
    const MotionSplit split = split_motions(problem, resistance_of(problem, holds), qp.modes);
    const MatrixXd motions = motions_beside(neutral, of_held_parts(problem, holds, split.neutral));
    if (motions.cols() == 0) return;
    const NeutralMeasure measure = neutral_measure(problem, motions, threads);
    const SymmetricEigen gram = symmetric_eigen(measure.gram);
    if (!(gram.values[0] > 0)) return;
    const MatrixXd units = gram.vectors * gram.values.cwiseSqrt().cwiseInverse().asDiagonal();  // orthonormal in the measure
    const VectorXd unbounded = units * (units.transpose() * pull_of(problem, measure, motions, solution.displacement));
    const MatrixXd moved = times_few(qp.modes(open, Eigen::all), motions);
    const VectorXd gap = gaps_of(problem, all, solution)(open).cwiseMax(0);
    const std::optional<VectorXd> back = least_distance(moved * units, -(gap + moved * unbounded));
    if (!back) return;
    add_rigid_motions(problem, motions * (unbounded + units * *back), solution);
    for (Index k = 0; k < motions.cols(); ++k)
        for (const PartMotion& m : part_motions(problem.parts, motions.col(k))) solution.neutral.push_back(m);
}

}  // namespace abut::solver
