// SPDX-License-Identifier: GPL-3.0-or-later
// A scalar field as filled bands of colour.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::report {

using geometry::Vec2;

/// A quadrilateral in picture coordinates (pixels) and its values on the colour scale (0..1) at its corners and in the middle.
struct Patch {
    std::array<Vec2, 4> at;
    std::array<double, 4> value;
    double middle;
};

/// Number of colour bands: enough to look smooth, few enough to keep the picture small.
inline constexpr int n_bands = 24;

/// The fill colour of a band ("#rrggbb").
std::string band_color(int band);

/// The bands of a field as SVG paths, one per band. Within a patch the field is interpolated linearly, on four triangles
/// around its middle where it is not nearly linear; all pieces of one band are merged (their common edges cancel), so that the
/// size of the text follows the length of the contour lines and not the number of patches. Values outside 0..1 take the first
/// or last colour; patches with a value that is not finite are left out. Cost O(patches).
std::string filled_bands(const std::vector<Patch>& patches);

}  // namespace abut::report
