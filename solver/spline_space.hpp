// SPDX-License-Identifier: GPL-3.0-or-later
// The tensor-product spline space of one part, and how its functions are made from local B-splines.
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "solver/bspline.hpp"

namespace abut::solver {

using Vec2 = Eigen::Vector2d;

enum class Basis { plain, web };

/// A cell counts as inner for the extension from this filled fraction on (measured: condition numbers stay at 1e3 for any cut).
inline constexpr double inner_cell_fraction = 0.25;

/// Every B-spline whose support meets the part is a combination of the space's functions ("extraction"): itself, where it is
/// one of them; for an extended basis, where its support holds no inner cell, the continuation of the polynomials of the
/// nearest inner cell. Nothing downstream knows which basis it is.
struct SplineSpace {
    KnotVector x, y;
    int n_functions = 0;           ///< of the space, per displacement component
    std::vector<double> fraction;  ///< filled fraction by cell (row-major, row = y)
    std::vector<int> first;        ///< n_tensor + 1 offsets: the row of tensor function j * x.n_functions() + i
    std::vector<int> function;     ///< functions of the space in each row, ascending
    std::vector<double> coefficient;
    std::vector<int> tensor_of;  ///< tensor function of each function of the space
    int n_extended = 0;          ///< tensor functions that are extended
    std::string failure;         ///< not empty: no such space (no inner cell to extend from), and why

    int columns() const { return x.n_intervals(); }
    int rows() const { return y.n_intervals(); }
    int cell_at(const Vec2& p) const { return interval_of(y, p.y()) * columns() + interval_of(x, p.x()); }
    bool has_row(int tensor) const {
        return first[static_cast<std::size_t>(tensor)] < first[static_cast<std::size_t>(tensor) + 1];
    }
};

/// fraction: filled fraction of every cell, 0 for outer ones.
SplineSpace make_space(std::vector<double> x_lines, std::vector<double> y_lines, int degree_x, int degree_y,
                       std::vector<double> fraction, Basis basis);

/// Tensor functions of a cell, (q+1)(p+1), x fastest.
std::vector<int> tensor_functions(const SplineSpace& space, int cell);

/// Functions of the space that are not zero on a cell, and how its B-splines combine them: n_local x n_functions.
struct Extraction {
    std::vector<int> functions;
    Eigen::MatrixXd matrix;
    bool identity = false;  ///< the B-splines themselves: matrix left empty
};
Extraction extraction(const SplineSpace& space, int cell);

/// Values and gradients of the space's functions at a point.
struct PointBasis {
    std::vector<int> functions;
    Eigen::VectorXd value, dx, dy;
};
PointBasis evaluate(const SplineSpace& space, int cell, const Vec2& p);

/// Coefficients of a linear function of position: value at each function's Greville point.
Vec2 greville_point(const SplineSpace& space, int function);

}  // namespace abut::solver
