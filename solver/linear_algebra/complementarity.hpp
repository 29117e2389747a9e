// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace abut::solver {

/// The z >= 0 with w = M z + q >= 0 and z'w = 0, by Lemke's pivots [Murty88, chapter 2]; nothing where they end on a ray, or
/// do not end. Ties of the ratio test are broken by moving q by a trifle (tie_fraction of its largest entry), the same each
/// time: the values are exact to that only, the set of positive entries is what it is for. Rows and columns of M should be of
/// one size. positive: which z are expected to be positive (n, or empty): pivots begin there, and from nothing where that
/// does not end (of n <= 600: of more that takes ten seconds, and seldom ends). ties: by row, the trifle's share (n, or empty:
/// 1), of rows whose terms are all small. Cost: n^2 a pivot, usually n pivots from nothing, as many as are expected wrongly
/// from a set.
std::optional<Eigen::VectorXd> complementary(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& q,
                                             const std::vector<char>& positive = {}, const Eigen::VectorXd& ties = {});

inline constexpr double tie_fraction = 1e-11;

}  // namespace abut::solver
