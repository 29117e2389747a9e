// SPDX-License-Identifier: GPL-3.0-or-later
// What of a multifrontal factorisation follows from the pattern [Liu92]: fronts, their rows, which front adds to which, and
// where the entries go.
#pragma once
#include <vector>

#include "solver/linear_algebra/grid_dissection.hpp"
#include "solver/linear_algebra/ordering.hpp"
#include "solver/linear_algebra/supernodes.hpp"

namespace abut::solver {

/// Rows begin to end of an update stand in the front above from `place` on; all of them among its own columns, or all below.
struct FrontRun {
    int begin, end, place;
};

/// A front is a supernode of L that is eliminated at once: w columns with r rows, of which the first w are its own; what it
/// leaves for the fronts above is its update, a symmetric matrix of its other r - w rows.
struct Fronts {
    std::vector<int> first_column, first_row, first_value, row, order;  ///< as in SupernodePattern
    std::vector<int> first_child, child;  ///< by front: those whose updates it takes in, each before it
    std::vector<int> first_run;           ///< by front, of its update's rows:
    std::vector<FrontRun> run;
    std::vector<int> target;  ///< by entry of the matrix: where it stands in the values of L

    int n_fronts() const { return static_cast<int>(first_column.size()) - 1; }
    int width(int front) const;
    int rows(int front) const;
    SupernodePattern pattern() const;
};

/// Pieces of a dissection of the pattern's nodes become fronts.
Fronts make_fronts(const SparseSymmetric& matrix, const MergedPattern& pattern, const DissectedNodes& dissection);

}  // namespace abut::solver
