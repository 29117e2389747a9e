// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the grid lines of a part: cell sizes wanted at places, grown away from them, integrated to lines in each direction.
#pragma once
#include <array>
#include <vector>

#include "geometry/cells/cut_cells.hpp"
#include "src/discretization/frame.hpp"

namespace abut {

/// How much cells may grow per distance from where the shape wants a size.
inline constexpr double size_growth = 0.45;

/// A cell size wanted over a box of the part's local frame; it may grow with the distance from it.
struct SizeFeature {
    geometry::Box2 box;
    double size;
    double growth = size_growth;  ///< per distance
    std::vector<Vec2> line{};     ///< from point to point inside the box; empty: all of the box
};

/// A size that is asked of the grids of a pass, in assembly coordinates.
struct WantedSize {
    std::vector<Vec2> points;  ///< the cells around all of them
    double size;
    double growth;  ///< of cells per distance from there
};
using WantedSizes = std::vector<std::vector<WantedSize>>;

/// Lines from low to high whose spacing follows min over features (size + growth * distance), at most `largest`; axis 0 is
/// x.
std::vector<double> graded_lines(double low, double high, int axis, double largest, const std::vector<SizeFeature>& features);

/// Sizes that the shape itself asks for. coarseness scales them all (1: standard).
struct ShapeFeatures {
    std::vector<SizeFeature> walls;   ///< cells across every wall and slot: of whole columns or rows
    std::vector<SizeFeature> places;  ///< cells along every arc, at re-entrant corners
};
ShapeFeatures shape_features(const geometry::Part& local, double coarseness);

/// Smallest radius of curvature of the re-entrant boundary that passes the box; infinite where none does.
double reentrant_radius(const geometry::Part& local, const geometry::Box2& near);

/// The largest cell of each direction: a fraction of the part's extent and of its diagonal.
std::array<double, 2> largest_cells(const geometry::Part& local, double coarseness);

}  // namespace abut
