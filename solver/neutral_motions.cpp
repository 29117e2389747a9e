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

/// Force along the normal at a point, and its moment about a center: times (translation, rotation) about it, the motion that it
/// resists.
using Wrench = std::array<double, 3>;

/// Where a side's motions turn about.
Vec2 center_of(const PartSystem& part) {
    return part.free_motions.empty() ? Vec2(0, 0) : part.free_motions.front().center;
}

/// A part's free motions by column: (translation, rotation) about the center.
Eigen::Matrix3Xd free_twists(const PartSystem& part) {
    Eigen::Matrix3Xd twists(3, static_cast<Index>(part.free_motions.size()));
    for (Index k = 0; k < twists.cols(); ++k) {
        const RigidMotion& motion = part.free_motions[static_cast<std::size_t>(k)];
        twists.col(k) << motion.at(center_of(part)), motion.rotation;
    }
    return twists;
}

/// Sums of weight times products of the wrenches of two sides, over the points of an interface.
struct WrenchProducts {
    Eigen::Matrix3d first = Eigen::Matrix3d::Zero(), both = first, second = first;
    double weight = 0;
};

void add_product(double weight, const Wrench& a, const Wrench& b, Eigen::Matrix3d& sum) {
    for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 3; ++i) sum(i, j) += weight * a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
}

WrenchProducts wrench_products(const AssemblyProblem& problem, std::size_t face) {
    const Interface& f = problem.interfaces[face];
    const std::vector<std::array<Vec2, 2>>& normals = problem.own_normals[face];
    const PartSystem &first = problem.parts[static_cast<std::size_t>(f.part[0])],
                     &second = problem.parts[static_cast<std::size_t>(f.part[1])];
    const std::array<Vec2, 2> center{center_of(first), center_of(second)};
    const auto wrench = [&](std::size_t q, std::size_t side) {
        const Vec2 &n = normals[q][side], &x = f.points[q].x[side], &c = center[side];
        return Wrench{n.x(), n.y(), (x.x() - c.x()) * n.y() - (x.y() - c.y()) * n.x()};
    };
    const bool is_first_free = !first.free_motions.empty(), is_second_free = !second.free_motions.empty();
    WrenchProducts sum;
    for (std::size_t q = 0; q < f.points.size(); ++q) {
        const double weight = f.points[q].weight;
        sum.weight += weight;
        const Wrench a = is_first_free ? wrench(q, 0) : Wrench{}, b = is_second_free ? wrench(q, 1) : Wrench{};
        if (is_first_free) add_product(weight, a, a, sum.first);
        if (is_first_free && is_second_free) add_product(weight, a, b, sum.both);
        if (is_second_free) add_product(weight, b, b, sum.second);
    }
    return sum;
}

/// R'R of one interface, each row weighted with its share of the length: the first body's motions, then the second's.
MatrixXd pair_resistance_squared(const AssemblyProblem& problem, std::size_t face) {
    const Interface& f = problem.interfaces[face];
    const Eigen::Matrix3Xd a = free_twists(problem.parts[static_cast<std::size_t>(f.part[0])]),
                           b = free_twists(problem.parts[static_cast<std::size_t>(f.part[1])]);
    const WrenchProducts sum = wrench_products(problem, face);
    MatrixXd squared(a.cols() + b.cols(), a.cols() + b.cols());
    squared.topLeftCorner(a.cols(), a.cols()) = a.transpose() * sum.first * a;
    squared.topRightCorner(a.cols(), b.cols()) = a.transpose() * sum.both * b;
    squared.bottomLeftCorner(b.cols(), a.cols()) = squared.topRightCorner(a.cols(), b.cols()).transpose();
    squared.bottomRightCorner(b.cols(), b.cols()) = b.transpose() * sum.second * b;
    return squared / sum.weight;
}

/// Amplitudes of an interface's motions.
std::vector<Index> amplitudes_of(const Interface& face, const std::vector<Index>& offset) {
    std::vector<Index> list;
    for (int part : face.part)
        for (Index k = offset[static_cast<std::size_t>(part)]; k < offset[static_cast<std::size_t>(part) + 1]; ++k)
            list.push_back(k);
    return list;
}

/// True: every motion is resisted by far more than a neutral one. False: not known. The product of the other eigenvalues of R'R
/// is at most (trace / (n - 1))^(n - 1), so that the least one is at least det over that: for a few motions, cheap and enough.
bool resists_every_motion(const MatrixXd& squared) {
    const Index n = squared.cols();
    const Eigen::LDLT<MatrixXd> factor(squared);
    const VectorXd pivots = factor.vectorD();
    const double trace = squared.trace();
    if (factor.info() != Eigen::Success || !(pivots.minCoeff() > 0)) return false;
    const double others = n > 1 ? trace / static_cast<double>(n - 1) : 1.0;
    double least = pivots[0];
    for (Index k = 1; k < n; ++k) least *= pivots[k] / others;
    return least > neutral_motion_fraction * trace;  // the limit is its square: rounding does not matter
}

}  // namespace

MatrixXd candidate_resistance(const AssemblyProblem& problem) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    MatrixXd sum = MatrixXd::Zero(offset.back(), offset.back());
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        const std::vector<Index> amplitude = amplitudes_of(problem.interfaces[f], offset);
        if (problem.interfaces[f].points.empty() || amplitude.empty()) continue;
        sum(amplitude, amplitude) += pair_resistance_squared(problem, f);
    }
    return sum;
}

MotionSplit split_motions(const AssemblyProblem& problem, const MatrixXd& resistance, const MatrixXd& modes) {
    const Index n = modes.cols();
    if (n == 0) return {MatrixXd(0, 0), MatrixXd(0, 0)};
    const auto held = modes.bottomRows(static_cast<Index>(problem.constraints.size()));
    const MatrixXd squared = resistance + held.transpose() * held;
    if (resists_every_motion(squared)) return {MatrixXd::Identity(n, n), MatrixXd(n, 0)};
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
    full.expected = answer.result.multipliers;
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
