// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of parts with themselves: faces of one part are candidates from when an answer has them overlap, so that slots and
// gaps that stay open cost nothing.
#pragma once
#include <set>

#include "src/scene/scene.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The parts whose own faces overlap in a solution by more than rounding, where these are no candidates (of_one_part). Every
/// zone that displacements can close is looked at. Cost: a search of each part within twice what it deforms by.
std::set<int> closed_on_themselves(const Scene& scene, const SolvedAssembly& solved);

}  // namespace abut
