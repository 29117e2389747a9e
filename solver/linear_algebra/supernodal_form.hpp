// SPDX-License-Identifier: GPL-3.0-or-later
// B' A^-1 B from a supernodal factor, for right-hand sides of few entries.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "solver/linear_algebra/supernodal_factor.hpp"

namespace abut::solver {

/// P A P' = L S L', L at `values` as the pattern says, S = diag(sign) by position; sign null: S = I. Forward solution only:
/// every supernode carries the columns of B that reach it from below and no others, its share of the form is added at once, and
/// its numbers are freed. Cost: twice the sum over the supernodes of (entries of L + columns * width) * columns.
Eigen::MatrixXd inverse_form(const SupernodePattern& pattern, const double* values, const double* sign,
                             const Eigen::SparseMatrix<double>& b);

}  // namespace abut::solver
