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

/// The layer of each of several parts: that which most of its outer edges are drawn on, the first of several. Where some are
/// drawn on several layers: one that nearly all of them and of all its edges are on, no other part's alone if that can be, and
/// of these the one that fewest parts may be on. entities: by part and edge; n_outer: by part, its outer edges, the first of
/// all.
std::vector<std::string> layers_of_parts(const std::vector<std::vector<const SketchPiece*>>& entities,
                                         const std::vector<std::size_t>& n_outer);

/// What a part is called before parts of one name are numbered: the name of its group or layer; after "PIN#1:" where its
/// outline lies in that insertion of a block and the name does not say so. first: the first entity of its outer loop.
std::string part_name(const SketchPiece& first, const std::string& group_or_layer);

/// Edges are named after their entities. Pieces of one that was cut are `h2F#0`, `h2F#1`, ... along it, those of this part
/// counted; what comes from another insertion of a block than the outline is `PIN#1:h2F`. No two edges have one name.
void name_edges(Part& part, const std::vector<const SketchPiece*>& entity);

/// Parts of one name are numbered: `PLATE#0`, `PLATE#1`, ... in their order.
void number_parts(std::vector<Part>& parts);

}  // namespace abut::geometry
