// SPDX-License-Identifier: GPL-3.0-or-later
// Which entities of a DXF drawing are no part of any outline, and why.
#pragma once
#include <string>

#include "geometry/dxf/dxf.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// How an entity is drawn, after layer and block have had their say.
struct Look {
    std::string layer = "0";
    std::string linetype = "CONTINUOUS";  ///< upper case
    int color = 7;
    bool is_interrupted = false;       ///< does the line type have gaps?
    bool frozen = false, off = false;  ///< the layer's
};

/// How an entity is drawn. `block`: the look of the insert that the entity stands in (where nothing is inserted: Look{}).
/// Entities on layer 0 of a block take the insert's layer; colours and line types may be by layer (the default) or by block.
Look look_of(const Record& entity, const Look& block, const Structure& structure);

/// Does the entity stand on a sheet instead of in the model?
bool is_in_paper_space(const Record& entity);

/// Does the record belong to the entity before it (VERTEX, ATTRIB, SEQEND), so that it is not counted by itself?
bool is_subentity(const Record& entity);

/// Beyond this angle between the entity's plane and the drawing's, degrees, it is left out, for seen in the latter it would be
/// another curve; below, its lengths change by a millionth and it is projected.
inline constexpr double most_tilt = 0.1;
/// The angle between the entity's plane and the drawing's, degrees; 0 where it has no plane of its own.
double tilt(const Record& entity);

/// Could it bound a part, so that leaving it out must be told? Texts and dimensions cannot.
bool is_curve(const Record& entity);

/// Why an entity is left out; empty for those to be read, and for those in paper space (is_in_paper_space). Hidden things come
/// first: what is not shown is not asked for its type. What lies on a layer that is asked for by name is read whatever its name
/// and line type say. An INSERT is left out only where it is hidden or tilted: lines in it are judged by their own line types
/// and layers.
std::string why_ignored(const Record& entity, const Look& look, const LayerFilter& layers);

}  // namespace abut::geometry::dxf
