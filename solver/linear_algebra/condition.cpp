// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/condition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "solver/linear_algebra/blas.hpp"
#include "solver/linear_algebra/dense.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Uniform in (-1, 1) from the generator's bits themselves: the library's distributions differ from one to another.
VectorXd start_vector(int n) {
    std::mt19937 random(1);
    VectorXd v(n);
    for (double& x : v) x = (static_cast<double>(random()) + 0.5) * 0x1p-31 - 1;
    return v.normalized();
}

double largest_ritz_value(const std::vector<double>& diagonal, const std::vector<double>& side) {
    const auto n = static_cast<Index>(diagonal.size());
    const VectorXd d = VectorXd::Map(diagonal.data(), n), s = VectorXd::Map(side.data(), n - 1);
    return tridiagonal_eigenvalues(d, s)[n - 1];
}

}  // namespace

double largest_eigenvalue(int n, const LinearMap& map) {
    // without reorthogonalisation: what it loses is repeated eigenvalues, not the largest one
    VectorXd v = start_vector(n), last = VectorXd::Zero(n);
    std::vector<double> diagonal, side;
    double largest = 0, before = 0;
    for (int step = 0; step < std::min(n, max_lanczos_steps); ++step) {
        VectorXd w = map(v);
        if (step > 0) w -= side.back() * last;
        diagonal.push_back(v.dot(w));
        w -= diagonal.back() * v;
        const double two_before = before;
        before = largest;
        largest = largest_ritz_value(diagonal, side);
        const double rest = w.norm();
        if (step > 1 && largest - two_before <= ritz_change * largest) break;
        if (rest <= std::numeric_limits<double>::epsilon() * largest) break;  // an invariant subspace
        side.push_back(rest);
        last = std::move(v);
        v = w / rest;
    }
    return largest;
}

double condition_by_lanczos(int n, const LinearMap& product, const LinearMap& solve) {
    return n == 0 ? 1 : largest_eigenvalue(n, product) * largest_eigenvalue(n, solve);
}

double norm_one(int n, const LinearMap& map) {
    VectorXd v(n), x(n);
    std::vector<int> sign(static_cast<std::size_t>(n));
    double estimate = 0;
    int task = 0, state[3] = {};
    do {
        dlacn2_(&n, v.data(), x.data(), sign.data(), &estimate, &task, state);
        if (task != 0) x = map(x);  // asks for the product with the map or its transpose, which are the same
    } while (task != 0);
    return estimate;
}

}  // namespace abut::solver
