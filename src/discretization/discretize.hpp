// SPDX-License-Identifier: GPL-3.0-or-later
// A part on its grid, as geometry and as what the solver is told of it.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "geometry/cells/elements.hpp"
#include "geometry/quadrature/quadrature.hpp"
#include "solver/assembly/assembly.hpp"
#include "src/base/once.hpp"
#include "src/discretization/frame.hpp"
#include "src/scene/scene.hpp"

namespace abut::solver {
struct StressFitFactor;
}  // namespace abut::solver

namespace abut {

/// A part on its grid: frame, cells and elements, and the solver's input made of them.
struct PartOnGrid {
    int part;               ///< index into Scene::parts
    int model = -1;         ///< the part that this one is a copy of and shares grid, stiffness and factor with; -1: none
    bool is_rigid = false;  ///< one cell of bilinear functions, which hold its motions; no stiffness
    Frame frame;
    geometry::Part local;  ///< in the grid's frame; edges and parameters as in the scene's part
    geometry::CutCells cells;
    geometry::Elements elements;
    double area = 0;    ///< of the part
    double size = 0;    ///< its diagonal
    Vec2 center{0, 0};  ///< its centroid, local
    solver::PartInput input;
    /// The ends of the lines, local, whose sides input.pulls draw together: the side on the left of each moves.
    std::vector<std::array<Vec2, 2>> cuts{};
    /// What the stress fits of several displacements have in common; none: there is one only.
    std::shared_ptr<Once<solver::StressFitFactor>> fit{};
    Once<std::vector<std::pair<int, Vec2>>> cut_samples{};  ///< cut_cell_samples() asks for them
    double too_fine = 0;  ///< size of cells that were wanted and halving does not reach; 0: none
};

/// The frame of a part's grid, turned by `angle` (radians), its origin in the middle of the part's box.
Frame frame_for(const geometry::Part& part, double angle);

/// Puts a part on its grid. Throws InputError where the grid misses a part of the part. A basis that cannot be made is left in
/// input.space.failure.
PartOnGrid discretize(const Scene& scene, int part, const Frame& frame, const geometry::Grid& grid, std::array<int, 2> degree);

/// A part that is a copy of one on its grid, put on the same grid. frame: of the copy.
PartOnGrid copied(const Scene& scene, int part, const Frame& frame, const PartOnGrid& model);

/// The element of a cell that holds a point of it, or is nearest to it.
int element_in(const PartOnGrid& on_grid, int cell, const Vec2& local);

/// The sample points for the stress fit in the cut cells, each with its element: inside the part, or on its boundary.
const std::vector<std::pair<int, Vec2>>& cut_cell_samples(const PartOnGrid& on_grid);

}  // namespace abut
