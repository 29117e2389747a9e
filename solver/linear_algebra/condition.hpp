// SPDX-License-Identifier: GPL-3.0-or-later
// Condition numbers of symmetric positive definite matrices that are known by their products and solutions only.
#pragma once
#include <Eigen/Core>
#include <functional>

namespace abut::solver {

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Lanczos' method is ended when two steps changed its largest Ritz value by less than this.
inline constexpr double ritz_change = 0.01;
inline constexpr int max_lanczos_steps = 60;

/// The largest eigenvalue of a symmetric positive definite map of size n, from below; typically to a few per cent, after 5 to
/// 30 applications. The start is the same pseudo-random vector every time.
double largest_eigenvalue(int n, const LinearMap& map);

/// The 2-norm condition number of a symmetric positive definite matrix of size n, from below.
double condition_by_lanczos(int n, const LinearMap& product, const LinearMap& solve);

/// The 1-norm of a symmetric map of size n, from below; 4 to 5 applications [Higham88], LAPACK's dlacn2. Nearly always within a
/// factor 3.
double norm_one(int n, const LinearMap& map);

}  // namespace abut::solver
