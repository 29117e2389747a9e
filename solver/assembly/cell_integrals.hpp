// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of products of a cell's functions, and the stiffness blocks that follow from them.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "solver/assembly/elasticity.hpp"
#include "solver/splines/spline_space.hpp"

namespace abut::solver {

/// A rule on [0, 1] for cells that are wholly inside; exact to degree 2p.
struct LineRule {
    std::vector<double> points, weights;
};

/// The values and derivatives of an element's local B-splines at points: (points x n_local).
struct Sampled {
    Eigen::MatrixXd value, dx, dy;
};
void sample(const SplineSpace& space, int element, const std::vector<Vec2>& points, Sampled& out);

/// The integrals of N N', N_x N_x' and N_x N' of the univariate functions of one interval.
struct LineIntegrals {
    Eigen::MatrixXd mass, stiffness, mixed;
};

/// The line integrals of every interval along an axis of a space; intervals whose integrals are those of the one before but for
/// the rounding of the grid lines share them, so that whole rows of equal cells are integrated once.
struct IntervalIntegrals {
    std::vector<LineIntegrals> integrals;
    std::vector<int> of_interval;
};
IntervalIntegrals interval_integrals(const SplineSpace& space, int axis, const LineRule& rule);

/// The integrals of gx gx', gy gy' and gx gy' over one element, gx and gy the derivatives of its functions.
struct CellIntegrals {
    Eigen::MatrixXd axx, ayy, axy;
};
void integrate_full_cell(const LineIntegrals& x, const LineIntegrals& y, CellIntegrals& out);

void integrate_cut_cell(const SplineSpace& space, int element, const std::vector<Vec2>& points,
                        const std::vector<double>& weights, CellIntegrals& out);

/// Turns the integrals of the B-splines into those of the functions that the extraction makes of them: E' A E, by E's non-zero
/// entries.
void extract(const Extraction& e, CellIntegrals& integrals);

/// The stiffness of an isotropic material, [Grishin10, eq 2.20 ff.]: block (i, j) at j * n + i.
void stiffness_blocks(const CellIntegrals& c, const Elasticity& d, double thickness, std::vector<Eigen::Matrix2d>& blocks);

}  // namespace abut::solver
