// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "solver/assembly/assembly.hpp"
#include "solver/linear_algebra/factorization.hpp"

namespace abut::solver {

/// The places of the rows on the part's grid (none with a tree, whose functions have none), and the rows of its contact
/// elements. number: (2n) row of every coefficient, negative: none.
RowHints row_hints(const PartInput& input, const std::vector<int>& number);

/// The places of a space's functions, one row each.
RowHints row_hints(const SplineSpace& space);

}  // namespace abut::solver
