// SPDX-License-Identifier: GPL-3.0-or-later
// How far the parts of a scene are searched for others, and how much of what is found is shown.
#pragma once
#include <vector>

#include "geometry/curves/curve.hpp"
#include "geometry/sketch/sketch.hpp"
#include "src/scene/part_levels.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Distance up to which two parts are candidates at first, as a fraction of the smaller part's extent; it grows where contact
/// reaches the end of a zone. Overlaps drawn deeper than this are no fits: strains are small.
inline constexpr double first_search_fraction = 0.05;
/// Pairs that come as close as this fraction of the smaller part's extent are what an assembly shows without any loads.
inline constexpr double shown_fraction = 0.02;
/// Gaps and overlaps below this fraction of the smaller extent are touching: above the six digits that drawings are commonly
/// written with, below the joining tolerance of imports and any clearance that means something.
inline constexpr double touching_fraction = 1e-6;

/// Overlaps below this fraction of the smaller extent are no deeper than drawings are precise, whose ends are joined within as
/// much, and so are those that the digits of coordinates explain, up to the second fraction, which light press fits (H7/p6)
/// exceed in the mean: the parts are taken as touching, and a warning says so.
inline constexpr double precision_fraction = geometry::joining_fraction, written_precision_fraction = 2e-4;

/// The gap up to which two parts touch: touching_fraction of the smaller extent.
double touching_length(const geometry::Part& first, const geometry::Part& second);

/// Boxes, extents and levels of all parts, once for all distances between them: lengths do not depend on how the assembly lies.
class SearchDistances {
public:
    explicit SearchDistances(const Scene& scene);

    /// The smaller extent of two parts (geometry::extent).
    double size(int first, int second) const;
    /// The distance up to which two parts are searched; factor: on the first search distance.
    double searched(int first, int second, double factor) const;
    double shown(int first, int second) const;
    /// The deepest overlap that counts as touching.
    double precision(int first, int second) const;
    double touching(int first, int second) const { return touching_fraction * size(first, second); }
    /// Do the parts have a level in common, and come their boxes as near as this? Those that do not have nothing to do with
    /// each other.
    bool within(int first, int second, double distance) const;

private:
    std::optional<double> given_;  // by the scene
    std::vector<geometry::Box2> boxes_;
    std::vector<double> extents_, roundings_;
    std::vector<Levels> levels_;
};

}  // namespace abut
