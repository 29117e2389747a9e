// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A free part that moves by more than its own size, or turns by more than a radian, does not come to rest where small
/// displacements have it: the first such part is told in `failure`.
void tell_lost(const Scene& scene, SolvedAssembly& solved);

}  // namespace abut
