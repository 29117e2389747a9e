// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <optional>
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

/// Least distance programming: the least |z| with H z >= h ([Lawson74], chapter 23), by its dual, non-negative least squares
/// on H' and h. Nothing where there is none, or only one a thousand times as far away as the largest row alone would have it.
std::optional<Eigen::VectorXd> least_distance(const Eigen::MatrixXd& rows, const Eigen::VectorXd& least);

}  // namespace abut::solver
