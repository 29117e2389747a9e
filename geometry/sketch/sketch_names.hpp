// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a drawing's parts and of their edges.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "geometry/sketch/sketch_piece.hpp"

namespace abut::geometry {

/// Does the name match the pattern, in which * stands for any characters and ? for one? Case does not matter.
bool matches_glob(std::string_view name, std::string_view pattern);

/// What may help where lines of a block have no areas of their own; empty where the entity stands in none.
std::string block_hint(const SketchPiece& entity);

/// The layer that most of the entities are on; of several the first one's.
std::string most_frequent_layer(const std::vector<const SketchPiece*>& outline);

/// What a part is called before parts of one name are numbered: the name of its group, or the layer that most of its outer
/// edges are on where `group` is empty; after "PIN#1:" where its outline lies in that insertion of a block and the group's name
/// does not say so. `outline`: the entities of its outer loop, the first of the file first.
std::string part_name(const std::vector<const SketchPiece*>& outline, const std::string& group);

/// Edges are named after their entities. Pieces of one that was cut are `h2F#0`, `h2F#1`, ... along it, those of this part
/// counted; what comes from another insertion of a block than the outline is `PIN#1:h2F`. No two edges have one name.
void name_edges(Part& part, const std::vector<const SketchPiece*>& entity);

/// Parts of one name are numbered: `PLATE#0`, `PLATE#1`, ... in their order.
void number_parts(std::vector<Part>& parts);

}  // namespace abut::geometry
