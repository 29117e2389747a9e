// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/supernodes.hpp"

#include <limits>

#include "solver/linear_algebra/blas.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Supernode SupernodePattern::operator[](int s) const {
    const std::size_t k = at(s);
    return {first_column[k], first_column[k + 1] - first_column[k], first_row[k + 1] - first_row[k], row.data() + first_row[k],
            first_value[k]};
}

double Supernodes::smallest_pivot(int& row) const {
    double least = std::numeric_limits<double>::infinity();
    for (int s = 0; s < pattern.count(); ++s) {
        const Supernode node = pattern[s];
        for (int k = 0; k < node.width; ++k) {
            const double pivot = values[at(node.first_value) + at(k) * (at(node.rows) + 1)];
            if (pivot >= least) continue;
            least = pivot;
            row = pattern.order[at(node.begin + k)];
        }
    }
    return least * least;
}

MatrixXd Supernodes::solve_lower(const MatrixXd& b) const {
    MatrixXd y = b(pattern.permutation(), Eigen::all);
    const int n = static_cast<int>(y.cols()), ld = static_cast<int>(y.rows());
    const double one = 1, zero = 0;
    MatrixXd below;
    for (int s = 0; s < pattern.count(); ++s) {
        const Supernode node = pattern[s];
        const double* l = values + node.first_value;
        const int under = node.under();
        dtrsm_("L", "L", "N", "N", &node.width, &n, &one, l, &node.rows, &y(node.begin, 0), &ld);
        if (under == 0) continue;
        below.resize(under, n);
        dgemm_("N", "N", &under, &n, &node.width, &one, l + node.width, &node.rows, &y(node.begin, 0), &ld, &zero, below.data(),
               &under);
        y(node.rows_below(), Eigen::all) -= below;
    }
    return y;
}

VectorXd Supernodes::solve(const VectorXd& b) const {
    VectorXd x = b(pattern.permutation()), below;
    const int step = 1;
    const double one = 1, minus = -1, zero = 0;
    for (int s = 0; s < pattern.count(); ++s) {
        const Supernode node = pattern[s];
        const double* l = values + node.first_value;
        const int under = node.under();
        dtrsv_("L", "N", "N", &node.width, l, &node.rows, &x[node.begin], &step);
        below.resize(under);
        dgemv_("N", &under, &node.width, &one, l + node.width, &node.rows, &x[node.begin], &step, &zero, below.data(), &step);
        x(node.rows_below()) -= below;
    }
    if (sign != nullptr) x.array() *= Eigen::Map<const VectorXd>(sign, x.size()).array();
    for (int s = pattern.count() - 1; s >= 0; --s) {
        const Supernode node = pattern[s];
        const double* l = values + node.first_value;
        const int under = node.under();
        below = x(node.rows_below());
        dgemv_("T", &under, &node.width, &minus, l + node.width, &node.rows, below.data(), &step, &one, &x[node.begin], &step);
        dtrsv_("L", "T", "N", &node.width, l, &node.rows, &x[node.begin], &step);
    }
    VectorXd result(x.size());
    result(pattern.permutation()) = x;
    return result;
}

VectorXd Supernodes::product(const VectorXd& x) const {
    const VectorXd px = x(pattern.permutation());
    VectorXd y = VectorXd::Zero(x.size()), below, part;
    const int step = 1;
    const double one = 1, zero = 0;
    for (int s = 0; s < pattern.count(); ++s) {
        // y += L_s S (L_s' x): the whole columns of one supernode, L S L' being the sum over all of them
        const Supernode node = pattern[s];
        const double* l = values + node.first_value;
        const int under = node.under();
        part = px.segment(node.begin, node.width);
        below = px(node.rows_below());
        dtrmv_("L", "T", "N", &node.width, l, &node.rows, part.data(), &step);
        dgemv_("T", &under, &node.width, &one, l + node.width, &node.rows, below.data(), &step, &one, part.data(), &step);
        if (sign != nullptr) part.array() *= Eigen::Map<const VectorXd>(sign + node.begin, node.width).array();
        dgemv_("N", &under, &node.width, &one, l + node.width, &node.rows, part.data(), &step, &zero, below.data(), &step);
        dtrmv_("L", "N", "N", &node.width, l, &node.rows, part.data(), &step);
        y.segment(node.begin, node.width) += part;
        y(node.rows_below()) += below;
    }
    VectorXd result(x.size());
    result(pattern.permutation()) = y;
    return result;
}

}  // namespace abut::solver
