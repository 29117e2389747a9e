// SPDX-License-Identifier: GPL-3.0-or-later
// What of a drawing is its sheet, and what explains it: frames, title blocks, tables, balloons and leaders.
#pragma once
#include <optional>
#include <vector>

#include "geometry/sketch/sketch_mended.hpp"

namespace abut::geometry {

/// What belongs to the sheet or explains the drawing.
struct DraftingFound {
    std::vector<bool> is_drafting;        ///< by entity
    std::vector<SketchProblem> warnings;  ///< one for each kind of thing found, and what may be one
    /// All entities, no curve recognised yet; where nothing was set aside and no outlines share lines.
    std::optional<MendedLines> mended{};
};

/// Finds the sheet and its explanations, whatever layers they are on. All lines are closed to outlines together; then
///   1. a table is a rectangle divided into rectangles, at least two of which and a third of all hold a text, on fewer layers
///   than parts beside each other have; what lies in it belongs to it (title block, parts list);
///   2. a frame is an upright rectangle with all outlines in it but those of other frames and balloons, which all but tables
///   keep clear of, and that has texts in it and the proportions of a sheet of paper, but for a plate with its holes, or
///   another frame; or a table; or whose outlines share lines, as holes do not, and fill less than most_filled of it. Of a
///   frame all that is not in its largest area goes;
///   3. a leader is a line that bounds nothing and has an end at a balloon, a text, the tip of an arrow, or the middle of a
///   dot;
///   4. a balloon is a circle with a leader that points to its middle from another outline, or with a text of three letters at
///   most in it; it is clear of all other outlines. A dot is a circle about the end of a leader that is small beside it. Where
///   nothing else is drawn, they are what is drawn.
/// All is told by kind, with its place; so is a rectangle around all else that may be a frame as well as a plate.
DraftingFound find_drafting(const Drawing& drawing, const SketchOptions& options);

}  // namespace abut::geometry
