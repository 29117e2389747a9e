// SPDX-License-Identifier: GPL-3.0-or-later
// The model space with all blocks inserted.
#pragma once
#include "geometry/dxf/dxf.hpp"
#include "geometry/dxf/dxf_prepass.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry::dxf {

/// Limits against drawings that blow up: a few nested blocks can stand for more lines than memory holds.
inline constexpr int deepest_nesting = 64;
inline constexpr std::size_t most_entities = 1'000'000;

/// Adds the curves of the model space to the drawing, and what was counted, ignored and unreadable. Counts are of the model
/// space's own entities (an INSERT is one); what is ignored is listed by block besides, once for each instance. Entities of
/// blocks that are inserted more than once bear the instance's number. A layer that is off or frozen hides an INSERT with all
/// that is in it. Arrays whose
/// rows or columns have no distance are drawn once (a repair). Blocks that contain themselves, or are missing, and drawings
/// beyond the limits are problems; where the model space is empty, paper space is read, and where there are hatches only, their
/// boundaries. Curves that were left out, and what was read in such a way, are warnings; texts, hatches and tips of arrows are
/// kept for those who tell the sheet from the parts; drawings
/// an INSERT whose array alone goes beyond them is refused whole.
void add_model_space(const Structure& structure, const LayerFilter& layers, Drawing& drawing);

}  // namespace abut::geometry::dxf
