// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <vector>

namespace abut::solver {

/// The solution of min |A x - b| with x_k >= 0 where bounded[k] ([Lawson74], with free unknowns always in the
/// passive set).
struct NonnegativeResult {
    Eigen::VectorXd x;
    Eigen::VectorXd residual;  ///< b - A x
    bool converged = false;
};
NonnegativeResult nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b,
                                            const std::vector<char>& bounded);

}  // namespace abut::solver
