// SPDX-License-Identifier: GPL-3.0-or-later
// Displacements of parts that were analysed elsewhere than where they are drawn.
#pragma once
#include "src/results/result.hpp"

namespace abut {

/// The largest displacement from where a part is drawn (by its place in the scene): of one that was analysed elsewhere that of
/// its boundary, its way there included, so that answers of other loads or grids can be compared.
ValueAt displacement_from_drawn(const Result& result, std::size_t part);

}  // namespace abut
