// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace abut::solver {

/// A semidefinite matrix by what it does.
struct Semidefinite {
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> times;
    std::function<Eigen::MatrixXd(const std::vector<Eigen::Index>&)> among;  ///< its entries in these rows and columns
    Eigen::VectorXd diagonal;
};

/// The x with lower <= x <= upper (either may be infinite) that minimises x'Ax / 2 + b'x, from `start` moved between the
/// bounds: a primal-dual active set [Hintermueller02]; where that does not end, one that only descends [Nocedal06, 16.5].
/// Nothing where it does not end. steps: the systems solved, of the entries between their bounds, are added.
std::optional<Eigen::VectorXd> minimize_in_box(const Semidefinite& a, const Eigen::VectorXd& b, const Eigen::VectorXd& lower,
                                               const Eigen::VectorXd& upper, const Eigen::VectorXd& start, int& steps);

}  // namespace abut::solver
