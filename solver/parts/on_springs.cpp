// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/on_springs.hpp"

#include <Eigen/Eigenvalues>

#include "solver/parts/pins.hpp"

namespace abut::solver {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd springs_times(const PartSystem& system, const MatrixXd& motions) {
    MatrixXd forces = MatrixXd::Zero(motions.rows(), motions.cols());
    for (Index k = 0; k < motions.cols(); ++k)
        for (const SpringSet& set : system.springs) forces.col(k) -= spring_load(system.input, set, motions.col(k));
    return forces;
}

MatrixXd soft_motions(const PartSystem& system, const std::vector<RigidMotion>& on_springs) {
    const MatrixXd motions = coefficients_of(system.input.space, on_springs);
    if (on_springs.empty()) return motions;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(motions.transpose() * springs_times(system, motions));
    const double of_material = median_stiffness(system);
    Index soft = 0;
    while (soft < motions.cols() && eigen.eigenvalues()[soft] <= of_material) ++soft;
    return motions * eigen.eigenvectors().leftCols(soft);
}

MatrixXd sprung_motions(const PartSystem& system, const MatrixXd& motions) {
    if (motions.cols() == 0) return motions;
    const MatrixXd forces = springs_times(system, motions);
    MatrixXd balanced = motions, stiffness = motions.transpose() * forces;
    for (Index k = 0; k < motions.cols() && !system.body; ++k) {
        const VectorXd yielding = response(system, forces.col(k));
        balanced.col(k) -= yielding;
        stiffness.col(k) -= forces.transpose() * yielding;
    }
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (stiffness + stiffness.transpose()));
    return balanced * eigen.operatorInverseSqrt();
}

}  // namespace abut::solver
