// SPDX-License-Identifier: GPL-3.0-or-later
// Which entities of a DXF drawing are no part of any outline, and why.
#pragma once
#include <string>

#include "geometry/dxf_prepass.hpp"

namespace abut::geometry::dxf {

bool is_in_paper_space(const Record& entity);

/// Belongs to the entity before it (VERTEX, ATTRIB, SEQEND) and is not counted by itself.
bool is_subentity(const Record& entity);

/// Are its coordinates those of a plane of its own, given by its normal? Lines and three-dimensional polylines use the
/// drawing's.
bool has_own_plane(const Record& entity);

/// Why an entity is left out; empty for those to be read. Hidden things come first: what is not shown is not asked for its
/// type.
std::string why_ignored(const Record& entity, const Structure& structure);

}  // namespace abut::geometry::dxf
