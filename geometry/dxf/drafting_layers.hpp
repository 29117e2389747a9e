// SPDX-License-Identifier: GPL-3.0-or-later
// Layers that hold no outlines, by their names: what CAD programs and engineers call them (data/drafting_layers.csv).
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::geometry::dxf {

/// What a layer's name says that it holds.
struct DraftingLayer {
    std::string kind;      ///< "hidden lines", "dimensions", "the sheet"; "holes" are outlines all the same
    bool is_sure = false;  ///< otherwise the word may as well name a part (axis, frame, table)
};

/// What a layer (or line type, or block) of that name holds; nothing where the table does not know it. Names are compared
/// without regard to case, blanks, hyphens, underscores, what an external reference puts before them ("file|CENTER"), numbers,
/// and the prefixes and suffixes of programs and standards ("Hatch (ISO)", "01-Mittellinien", "SLD-Border").
std::optional<DraftingLayer> drafting_layer(std::string_view name);

/// Does the name of a layer or block say that what closes on it is a hole, or its thread?
bool says_holes(std::string_view name);

/// The table, as the file holds it.
const char* drafting_layers_text();

}  // namespace abut::geometry::dxf
