// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks of our pictures: SVG text of parts, and the mapping from the assembly's coordinates to the picture's.
#pragma once
#include <string>
#include <vector>

#include "geometry/brep/part.hpp"

namespace abut {

using geometry::Box2;
using geometry::Vec2;

/// Assembly coordinates to picture coordinates: y turned down, margins around the model.
struct View {
    Box2 box;
    double scale = 1;
    Vec2 offset{0, 0};
    double width = 0, height = 0;  ///< of the picture, pixels
    Vec2 operator()(const Vec2& p) const { return {offset.x() + scale * p.x(), offset.y() - scale * p.y()}; }
};
/// Fits box into width x max_height with the margin (pixels) on all sides; the height follows the model.
View fit_view(const Box2& box, double width, double max_height, double margin);

/// "M ... A ... Z" path data of all loops of a part (fill-rule evenodd); arcs stay arcs, also of ellipses; splines are drawn as
/// arcs within a twentieth of a pixel.
std::string path_data(const geometry::Part& part, const View& view);
/// Path data of a portion of one curve, not closed.
std::string path_data(const geometry::Curve& curve, double t0, double t1, const View& view);
/// Path data of closed polylines.
std::string path_data(const std::vector<std::vector<Vec2>>& loops, const View& view);

/// Fill colour ("#rrggbb") of the i-th part; neighbours in the list are well apart.
std::string part_color(int i);
/// Colour of a perceptually uniform sequential map (0..1), readable by the colour-blind and in grey print.
std::string map_color(double t);
/// Ticks at 1, 2, 5 x 10^k covering [low, high], about n of them: the first is at or below low, the last at or above high.
std::vector<double> nice_ticks(double low, double high, int n);

}  // namespace abut
