// SPDX-License-Identifier: GPL-3.0-or-later
// The cuts across which a part is tightened.
#pragma once
#include <vector>

#include "src/discretization/discretize.hpp"

namespace abut {

/// The preloads on a part, of all load cases, in the scene's order.
std::vector<const Load*> preloads_on(const Scene& scene, int part);

/// For each of preloads_on the displacement (2n, PartInput::pulls) that draws the sides of its cut together by a unit of
/// length. Which side a function is on follows from the elements: those that the cut goes through part the others. Throws
/// InputError where the cut does not part the part in two, where the part is rigid, nearly incompressible or held by weight
/// functions, and where, around an axis, the cut is not along the radius.
std::vector<Eigen::VectorXd> pull_displacements(const Scene& scene, const PartOnGrid& on_grid);

}  // namespace abut
