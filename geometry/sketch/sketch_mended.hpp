// SPDX-License-Identifier: GPL-3.0-or-later
// Loose entities, joined at their ends and mended until they close as far as they do.
#pragma once
#include <vector>

#include "geometry/sketch/sketch_nesting.hpp"
#include "geometry/sketch/sketch_splits.hpp"

namespace abut::geometry {

/// How well the coordinates of a drawing are known.
struct Precision {
    double rounding = 0;  ///< what their own rounding in the file amounts to
    double written = 0;   ///< what rounding to the last digit that lines are written with moves a point by; 0: not known
    double circles = 0;   ///< by how much the digits of centres and radii may have moved circles; 0: not known
};
/// Rounding of numbers as large as the drawing (`size`), and of the digits that ends of its lines, and its circles, are
/// written with (written_digits.hpp).
Precision precision_of(const Drawing& drawing, double size);

/// What is near enough to be joined, or one, among entities that may belong together.
struct JoiningTolerances {
    double joining = 0;      ///< of ends
    double coincidence = 0;  ///< of curves
    double facets = 0;       ///< of facets' joints from an arc: never more than what the size suggests
    double rounding = 0;     ///< what the coordinates' own rounding amounts to in the file
    double written = 0;      ///< what rounding to the last digit that they are written with does, if that is known
};

/// Entities, and what they make as they are now.
struct MendedLines {
    std::vector<SketchPiece> entities{};
    Joints joints{};
    EntityChains chains{};
    JoiningTolerances tolerances{};
    std::vector<Repair> repairs{};
    /// Outlines drawn over others, which are kept as they are: their entities, and chains of these.
    std::vector<SketchPiece> over{};
    std::vector<EntityChain> over_chains{};
};

/// Joins the ends anew, and walks what is joined into chains: steps 2 and 3.
void trace(MendedLines& lines);

/// Joins and mends: steps 1 to 4 of sketch_outlines.cpp. Ends of others are none of their business. The joining tolerance
/// asked for (or joining_fraction of the smaller of diagonal and total length) is lowered to half the shortest entity, but
/// never below their rounding.
enum class Mending {
    usual,             ///< what is off by more than rounding may be a clearance
    rough,             ///< what is within joining_fraction, or the coordinates' digits, is one
    cut_at_crossings,  ///< all lines are cut where they cross, and none kept as drawn over others
};
MendedLines mended_lines(const std::vector<SketchEntity>& entities, const SketchOptions& options, const Precision& precision,
                         Mending how);

/// Cuts upright lines that share areas where they cross, as in tables.
void cut_tables(MendedLines& lines);

/// Are the areas of a block of lines all there are? Where lines cross without a joint they are too few.
bool is_plane(const DividedOutline& divided, const Joints& joints, const std::vector<int>& block);

}  // namespace abut::geometry
