// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>

#include "solver/linear_algebra/factorization.hpp"

namespace abut::solver {

/// Lower triangle of a symmetric matrix, its diagonal kept where it is 0.
inline SparseSymmetric sparse(const Eigen::MatrixXd& m) {
    SparseSymmetric s;
    s.n = static_cast<int>(m.cols());
    s.first.push_back(0);
    for (int c = 0; c < s.n; ++c) {
        for (int r = c; r < s.n; ++r)
            if (r == c || m(r, c) != 0) {
                s.row.push_back(r);
                s.value.push_back(m(r, c));
            }
        s.first.push_back(static_cast<int>(s.row.size()));
    }
    return s;
}

}  // namespace abut::solver
