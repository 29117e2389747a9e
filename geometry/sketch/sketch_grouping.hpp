// SPDX-License-Identifier: GPL-3.0-or-later
// Which entities may belong to one part.
#pragma once
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// Entities that may belong to one part.
struct EntityGroup {
    std::string name;  ///< the layer, block, instance, or colour ("color3"); empty of PartsBy::loop, where all is one group
    std::vector<SketchEntity> entities;
};

/// Sorts entities into groups, in order of first appearance. Blocks: the outermost ones that differ (of ASSY/PIN and ASSY/BASE
/// these are PIN and BASE), each insertion by itself; what lies in no block is the group "". `parts_by` is not automatic.
std::vector<EntityGroup> group_entities(const std::vector<SketchEntity>& entities, PartsBy parts_by);

/// What stands in one insertion of a block that is inserted several times, by insertion; all the rest as the first group, which
/// may be empty.
std::vector<std::vector<SketchEntity>> by_instance(const std::vector<SketchEntity>& entities);

/// Does everything lie in blocks, and not all in the same?
bool is_all_in_blocks(const std::vector<SketchEntity>& entities);

/// Is there only one group but for those that lie wholly in the material of others (`group`: of each part)? Then these are its
/// holes: a layer of holes, a block that is a hole. Parts around a hole of the other are not meant: they are drawn in front of
/// it.
bool are_others_its_holes(const std::vector<Part>& parts, const std::vector<std::string>& group);

/// Do parts of one group touch, or lie in holes of, those of another (`group`: of each part), what holds all else left aside?
/// Holes never do: what looks like the holes of one group is an assembly drawn in front of it then, in a sheet's frame for
/// instance. `coincidence`: parts that are closer touch.
bool do_others_touch(const std::vector<Part>& parts, const std::vector<std::string>& group, double coincidence);

/// Are `after` the same areas as `before`, but cut into more parts?
bool are_divided(const std::vector<Part>& before, const std::vector<Part>& after);

/// Are the layers bodies of a mesh, which are parts whatever they overlap?
bool are_bodies(const std::vector<SketchEntity>& entities);

}  // namespace abut::geometry
