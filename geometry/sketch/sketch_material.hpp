// SPDX-License-Identifier: GPL-3.0-or-later
// Which areas that outlines bound are material.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/sketch/sketch_region.hpp"

namespace abut::geometry {

/// All that closes among some entities.
struct Outlines {
    std::vector<SketchPiece> entities;
    std::vector<EntityChain> closed;
    std::vector<DividedOutline> divided;
};

/// What is known besides the outlines.
struct MaterialHints {
    const std::vector<Hatch>& hatches;
    const std::map<std::string, std::string>& choices;  ///< what regions are, by their names (SketchOptions)
    int first_number = 1;                               ///< of the first region
    bool is_one_part = false;  ///< do the outlines belong to one part (a layer's)? Then what is drawn twice is so by mistake.
    bool layers_tell = false;  ///< may layers separate the parts? Not where the user says that each outline is a part.
    const std::set<std::string>& hole_layers;           ///< of the drawing
    const std::vector<std::vector<Region>>& of_groups;  ///< outlines of all groups where what is hatched may be another's
    std::size_t group = 0;                              ///< these outlines' own
};

/// Decides which regions are filled, the outermost first:
///   1. What the user chose.
///   2. What is hatched is material; what is hatched alike beside it may be the same part (join_regions). A hole of one group
///      in which another has its outline is hatched for that.
///   3. What is drawn over other outlines is material.
///   4. An outline inside material is a hole, any other a part; so is one on a layer of its own where several other layers hold
///      what lies in no other outline: layers separate the parts then. Not where the layer's name says holes, or another
///      layer's outline lies in it. Where it is drawn twice, unless all of them are, there is material on both sides: a hole,
///      and a part that fits. Inside a hole, a strip between two outlines that is as narrow as a clearance is one: what is
///      directly around it is a bush then.
///   5. Areas that share edges are filled as walk_faces says, but for clearances: narrow areas with others on all sides none of
///   whose
///      edges is drawn twice, and of which some edge is a piece of a line that goes on beyond: nobody drew their outline. A
///      line drawn once between two areas leaves open whether both are material: all that was taken is told.
/// What floats in a hole without coming near anything is told, too: a bush, or the edge of a counterbore, is drawn the same
/// way. Returns the regions by name; which part they are is not known yet.
std::vector<SketchRegion> decide_material(std::vector<Region>& regions, const Outlines& outlines, const MaterialHints& hints,
                                          std::vector<SketchProblem>& warnings);

}  // namespace abut::geometry
