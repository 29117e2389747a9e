// SPDX-License-Identifier: GPL-3.0-or-later
// The tensor-product spline space of one part, and how its functions are made from local B-splines.
//
// Elements are the connected components of (cell and part): 0 to n_cells - 1 the cells themselves, or the first component of
// cells in several pieces, whose other components follow. A tensor B-spline whose support inside the part falls into several
// connected pieces, the arms beside a slot, is as many functions, its branches: each lives on one of
// them, and nothing ties the arms together.
//
// With a quadtree of cells the space is a hierarchical one (tree_space.hpp): the cells are its leaves, each has the B-splines
// of its own level, and what these are of the space's functions is a matter of the element.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "solver/splines/bspline.hpp"
#include "src/base/quadtree.hpp"

namespace abut::solver {

using Vec2 = Eigen::Vector2d;

/// The functions of a space. plain: the B-splines whose support meets the part. normalized: these, but divided by their largest
/// value in the part where they meet it in one cut cell only [Grishin10, eqs 4.1 and B.1]. web: extended (weighted extended
/// B-splines without the weight).
enum class Basis { plain, normalized, web };

/// A cell counts as inner for the extension from this filled fraction on (measured: condition numbers stay at 1e3 for any cut).
inline constexpr double inner_cell_fraction = 0.25;

/// The cells that are in several pieces, and neighbours that share no material. Empty for a part without slots.
struct Splits {
    std::vector<int> cell_of_extra;  ///< of elements n_cells, n_cells + 1, ...
    /// Elements across the four sides through material, ascending; of those elements for which these are not simply the cells
    /// around that hold material.
    std::map<int, std::vector<int>> neighbours;
};

/// The intervals along one axis of all nodes of a quadtree, each once: by level, then along the axis.
struct LevelIntervals {
    std::vector<double> knots;  ///< level_knots() of each
    std::vector<int> of_node;
};

/// Every branch is a combination of the space's functions ("extraction"): itself, where it is one of them; for an extended
/// basis, where its support holds no inner cell, the continuation of the polynomials of the nearest inner element, or the mean
/// of the continuations where several are equally near. Nothing downstream knows which basis it is. With a tree every element
/// has branches of its own, as many as B-splines live on it: n_local() times its number and on, x fastest.
struct SplineSpace {
    KnotVector x, y;  ///< with a tree: of its base
    std::shared_ptr<const Quadtree> tree{};
    std::array<LevelIntervals, 2> level_intervals{};  ///< along x and y; with a tree only
    Basis basis = Basis::web;
    std::vector<double> fraction;  ///< filled fraction of the cell (row-major, row = y), by element
    Splits splits;
    int n_functions = 0;               ///< of the space, per displacement component
    std::vector<int> tensor_of_extra;  ///< tensor functions of branches n_tensor, n_tensor + 1, ...; below, branch = tensor
    std::map<int, std::vector<int>> branches;  ///< of the elements that have other than first branches, x fastest
    std::vector<int> first;                    ///< n_branches + 1 offsets: the row of a branch
    std::vector<int> function;                 ///< functions of the space in each row, ascending
    std::vector<double> coefficient;
    std::vector<int> tensor_of;              ///< tensor function of each function of the space; without a tree
    std::vector<Vec2> place;                 ///< greville_point() of each function; with a tree
    std::vector<std::uint8_t> on_sides;      ///< sides of the grid, by bit, on which each is not zero; with a tree
    std::vector<double> coefficient_of_one;  ///< of each function in the function 1; empty: all 1
    int n_extended = 0;                      ///< branches that are extended; with a tree functions
    int n_apart = 0;                         ///< functions more than B-splines of a tree, since arms are not tied together
    std::string failure;                     ///< not empty: no such space (no inner cell to extend from), and why

    int columns() const { return x.n_intervals(); }  ///< of the base
    int rows() const { return y.n_intervals(); }
    int n_cells() const { return tree ? tree->n_leaves() : columns() * rows(); }
    int n_local() const { return (x.degree + 1) * (y.degree + 1); }  ///< B-splines of an element
    /// The intervals along an axis on which cells have B-splines: a grid's columns (rows), a tree's of all levels.
    int n_intervals(int axis) const;
    IntervalKnots interval(int axis, int i) const;
    int n_tensor() const { return x.n_functions() * y.n_functions(); }
    int cell_of(int element) const {
        return element < n_cells() ? element : splits.cell_of_extra[static_cast<std::size_t>(element - n_cells())];
    }
    /// The intervals that an element's cell lies on.
    int column_of(int element) const {
        const int cell = cell_of(element);
        return tree ? level_intervals[0].of_node[at(tree->node_of(cell))] : cell % columns();
    }
    int row_of(int element) const {
        const int cell = cell_of(element);
        return tree ? level_intervals[1].of_node[at(tree->node_of(cell))] : cell / columns();
    }
    IntervalKnots along_x(int element) const { return interval(0, column_of(element)); }
    IntervalKnots along_y(int element) const { return interval(1, row_of(element)); }
    Vec2 low_corner(int element) const { return {along_x(element).low(), along_y(element).low()}; }
    Vec2 cell_size(int element) const { return Vec2(along_x(element).high(), along_y(element).high()) - low_corner(element); }
    /// The cell that holds a point: in parts without slots its element, too; elsewhere whoever knows the part's shape has to
    /// tell the element.
    int cell_at(const Vec2& p) const;
    int taken_apart() const { return tree ? n_apart : static_cast<int>(tensor_of_extra.size()); }
};

/// Is a cell full of material?
inline bool is_full(const SplineSpace& s, int cell) {
    return s.fraction[static_cast<std::size_t>(cell)] == 1;
}

/// What a space is made for.
struct SpaceInput {
    KnotVector x, y;
    std::vector<double> fraction;  ///< by element, 0 for outer cells
    Splits splits;
    Basis basis = Basis::web;
    /// Points of the boundary of (element and part), asked for only by the normalized basis: of cut elements.
    std::function<std::vector<Vec2>(int element)> outline;
    std::shared_ptr<const Quadtree> tree{};  ///< leaves are the cells; its neighbours are at most one level apart
};
/// Makes a space; what cannot be made is told in `failure`.
SplineSpace make_space(SpaceInput input);

/// Makes a space with simple knots on a part without slots.
SplineSpace make_space(std::vector<double> x_lines, std::vector<double> y_lines, int degree_x, int degree_y,
                       std::vector<double> fraction, Basis basis);

/// The branches of the tensor functions of an element, (q+1)(p+1), x fastest.
std::vector<int> tensor_functions(const SplineSpace& space, int element);
/// Writes the branches of an element's tensor functions into `result`, without memory of its own, and gives their number.
using LocalFunctions = std::array<int, (max_degree + 1) * (max_degree + 1)>;
std::size_t local_functions(const SplineSpace& space, int element, LocalFunctions& result);

/// The functions of the space that are not zero on an element, and how its B-splines combine them: n_local x n_functions.
struct Extraction {
    std::vector<int> functions;
    Eigen::MatrixXd matrix;
    bool identity = false;  ///< the B-splines themselves: matrix left empty
};
Extraction extraction(const SplineSpace& space, int element);

/// The values and gradients of the space's functions at a point.
struct PointBasis {
    std::vector<int> functions;
    Eigen::VectorXd value, dx, dy;
};
PointBasis evaluate(const SplineSpace& space, int element, const Vec2& p);

/// The point at which a linear function f of position has its coefficient: f(greville_point) times the coefficient of the
/// function 1.
Vec2 greville_point(const SplineSpace& space, int function);
inline double coefficient_of_one(const SplineSpace& space, int function) {
    return space.coefficient_of_one.empty() ? 1 : space.coefficient_of_one[static_cast<std::size_t>(function)];
}

}  // namespace abut::solver
