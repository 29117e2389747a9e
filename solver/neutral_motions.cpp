// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neutral_motions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solver/condensation.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Pressures may change by this fraction in making up for the neutral motions' balance.
constexpr double largest_rebalancing = 0.02;

/// The free motions of an interface's two bodies, at most three each.
constexpr int max_motions = 6;
using PairMotions = Eigen::Matrix<double, max_motions, 1>;
using PairMatrix = Eigen::Matrix<double, max_motions, max_motions>;

/// Resistance of a pair of points to the motions of the first body, then of the second; the rest zero.
PairMotions resistance_of(const AssemblyProblem& problem, std::size_t face, std::size_t point) {
    PairMotions row = PairMotions::Zero();
    const Interface& f = problem.interfaces[face];
    Index k = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const Vec2 normal = -problem.own_normals[face][point][side];
        for (const RigidMotion& motion : problem.parts[static_cast<std::size_t>(f.part[side])].free_motions)
            row[k++] = normal.dot(motion.at(f.points[point].x[side]));
    }
    return row;
}

/// R'R of one interface, each row weighted with its share of the length.
PairMatrix pair_resistance_squared(const AssemblyProblem& problem, std::size_t face) {
    PairMatrix sum = PairMatrix::Zero();
    double total = 0;
    const std::vector<InterfacePoint>& points = problem.interfaces[face].points;
    for (std::size_t q = 0; q < points.size(); ++q) {
        const PairMotions row = resistance_of(problem, face, q);
        sum += points[q].weight * row * row.transpose();
        total += points[q].weight;
    }
    return sum / total;
}

/// Amplitudes of an interface's motions.
std::vector<Index> amplitudes_of(const Interface& face, const std::vector<Index>& offset) {
    std::vector<Index> list;
    for (int part : face.part)
        for (Index k = offset[static_cast<std::size_t>(part)]; k < offset[static_cast<std::size_t>(part) + 1]; ++k)
            list.push_back(k);
    return list;
}

/// R'R of the resistance R (rows x amplitudes).
MatrixXd resistance_squared(const AssemblyProblem& problem, const MatrixXd& modes) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    MatrixXd sum = MatrixXd::Zero(modes.cols(), modes.cols());
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        if (problem.interfaces[f].points.empty()) continue;
        const std::vector<Index> amplitude = amplitudes_of(problem.interfaces[f], offset);
        const auto n = static_cast<Index>(amplitude.size());
        sum(amplitude, amplitude) += pair_resistance_squared(problem, f).topLeftCorner(n, n);
    }
    const auto held = modes.bottomRows(static_cast<Index>(problem.constraints.size()));
    return sum + held.transpose() * held;
}

}  // namespace

MotionSplit split_motions(const AssemblyProblem& problem, const MatrixXd& modes) {
    const Index n = modes.cols();
    if (n == 0) return {MatrixXd(0, 0), MatrixXd(0, 0)};
    const MatrixXd squared = resistance_squared(problem, modes);
    // eigenvalues of R'R: squares of the singular values of R
    const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(squared, Eigen::EigenvaluesOnly).eigenvalues();
    const double limit = neutral_motion_fraction * neutral_motion_fraction * values[n - 1];
    if (!(values[n - 1] > 0)) return {MatrixXd(n, 0), MatrixXd::Identity(n, n)};
    if (values[0] >= limit) return {MatrixXd::Identity(n, n), MatrixXd(n, 0)};
    // Jacobi's rotations leave motions that nothing couples apart: one part's stays one part's among equal values, too
    const Eigen::JacobiSVD<MatrixXd> svd(squared, Eigen::ComputeFullV);
    const Index kept = (svd.singularValues().array() >= limit).count();
    return {svd.matrixV().leftCols(kept), svd.matrixV().rightCols(n - kept)};
}

std::vector<PartMotion> part_motions(const std::vector<PartSystem>& parts, const VectorXd& amplitudes) {
    const std::vector<Index> offset = mode_offsets(parts);
    constexpr double notable = 1e-3;
    std::vector<PartMotion> result;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = amplitudes.segment(offset[i], offset[i + 1] - offset[i]);
        if (share.size() == 0 || share.norm() < notable * amplitudes.norm()) continue;
        PartMotion m{static_cast<int>(i), {{0, 0}, 0, parts[i].free_motions[0].center}};
        for (Index k = 0; k < share.size(); ++k) {
            const RigidMotion& unit = parts[i].free_motions[static_cast<std::size_t>(k)];
            m.motion.translation += share[k] * unit.translation;
            m.motion.rotation += share[k] * unit.rotation;
        }
        result.push_back(m);
    }
    return result;
}

void find_driven_neutral_motion(const AssemblyProblem& problem, const MatrixXd& neutral, const VectorXd& mode_load,
                                AssemblySolution& solution) {
    const VectorXd work = neutral.transpose() * mode_load;
    if (work.size() > 0 && work.cwiseAbs().maxCoeff() > neutral_work_fraction * problem.load_scale)
        solution.mechanism = part_motions(problem.parts, neutral * work);
    else
        for (Index k = 0; k < neutral.cols(); ++k)
            for (const PartMotion& m : part_motions(problem.parts, neutral.col(k))) solution.neutral.push_back(m);
}

bool balance_neutral_motions(const MatrixXd& modes, const VectorXd& mode_load, const MotionSplit& split, HeldAnswer& answer) {
    const MatrixXd lever = modes * split.neutral;
    constexpr double least_lever = 1e-6;  // of unit motion at the part's size: below, contact cannot turn the part at all
    std::vector<Index> some;
    for (Index k = 0; k < lever.cols(); ++k)
        if (lever.rows() > 0 && lever.col(k).cwiseAbs().maxCoeff() > least_lever) some.push_back(k);
    if (some.empty()) return false;
    MatrixXd all(answer.held.rows(), answer.held.cols() + static_cast<Index>(some.size()));
    all << answer.held, split.neutral(Eigen::all, some);
    ContactQp full = answer.qp;
    full.modes = modes * all;
    full.mode_load = all.transpose() * mode_load;
    full.expected = VectorXd(0);
    ContactQpResult balanced = solve_contact_qp(full);
    balanced.iterations += answer.result.iterations;
    if (!balanced.feasible || !balanced.converged) return false;
    const double change = (balanced.multipliers - answer.result.multipliers).cwiseAbs().sum();
    if (change > largest_rebalancing * answer.result.multipliers.cwiseAbs().sum()) return false;
    answer = {std::move(full), std::move(all), std::move(balanced)};
    return true;
}

void take_least_motion(const AssemblyProblem& problem, const MatrixXd& neutral, AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    if (neutral.cols() == 0) return;
    MatrixXd gram = MatrixXd::Zero(neutral.cols(), neutral.cols());
    VectorXd rhs = VectorXd::Zero(neutral.cols());
    std::vector<MatrixXd> motion;
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        motion.push_back(problem.parts[i].modes * neutral.middleRows(offset[i], offset[i + 1] - offset[i]));
        gram += motion.back().transpose() * motion.back();
        rhs -= motion.back().transpose() * solution.displacement[i];
    }
    const VectorXd amplitude = gram.ldlt().solve(rhs);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) solution.displacement[i] += motion[i] * amplitude;
}

}  // namespace abut::solver
