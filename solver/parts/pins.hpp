// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// Chooses as many coefficients as a part has free motions so that holding them holds the motions: pivoted elimination on the
/// modes' rows. Reads stiffness, modes and dropped.
std::vector<Eigen::Index> pins(const PartSystem& system);

}  // namespace abut::solver
