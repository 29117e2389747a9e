// SPDX-License-Identifier: GPL-3.0-or-later
// Supports by the solution structure u_c = w_c (sum of N_i d_ic) + phi_c, component by component [Grishin10, eqs 3.7-3.8,
// 4.12-4.16]: the weight w vanishes where the component is held, phi takes the prescribed values there, and whatever the
// coefficients d are, the support is met.
//
// Legend: N the space's ("plain") functions, w N the weighted ones. Vectors of size 2n are ordered (function, component);
// "plain load": the work of forces on the N, whose resultant a spline part's own functions can tell (they hold the rigid
// motions, the weighted ones do not).
#pragma once
#include <array>
#include <functional>
#include <optional>

#include "solver/assembly/assembly.hpp"
#include "solver/splines/displacement.hpp"

namespace abut::solver {

/// A scalar and its gradient at a point.
struct ScalarAt {
    double value = 0;
    Vec2 gradient{0, 0};
};
using ScalarField = std::function<ScalarAt(const Vec2&)>;

/// The weights and data of a part's supports, and the rules that products with them are integrated by.
struct SolutionStructure {
    std::array<ScalarField, 2> weight;  ///< w by component, between 0 and 1 on the part; empty: 1, the component is not held
    std::array<ScalarField, 2> data;    ///< phi by component; empty: 0
    /// What w N is multiplied by, by component and function, as 1 / w_h [Grishin10, eq 4.1]; empty: 1.
    std::array<Eigen::VectorXd, 2> scale;
    /// The rules of every element that holds material, full cells too. Weights are no polynomials: points inside the part and
    /// positive weights, more than the space's degree asks for.
    std::vector<CellRule> rules;
};

/// The functions of the two displacement components at a point, and what is there without them (phi).
struct DisplacementBasis {
    PointBasis x;                 ///< of u_x; of u_y, too, where y is empty
    std::optional<PointBasis> y;  ///< with a structure
    DisplacementAt data;
    const PointBasis& of(int component) const { return component == 1 && y ? *y : x; }
};
/// The functions of both components at a point of an element, which everything that needs displacements at a point goes
/// through.
DisplacementBasis displacement_basis(const PartInput& input, int element, const Vec2& p);

/// The displacement at a point of a part, with or without a structure.
DisplacementAt displacement_at(const PartInput& input, const Eigen::VectorXd& displacement, int element, const Vec2& x);

// What follows is for parts with a structure only.

/// The stiffness of the weighted functions, and the load (2n) by which phi strains the part.
struct WeightedStiffness {
    BlockMatrix stiffness;
    Eigen::VectorXd load;
};
/// Assembles the weighted functions. Cost: of order (points of the rules) times (p + 1)^4, besides the weights themselves.
/// Measured for the whole assembly stage against Nitsche's method: 1.8 times with linear weights, about 8 with those of curved
/// edges on fine grids and 11 to 42 on coarse ones, at errors 1.4 and 2.5 times as large (Kirsch's plate and the ring, degree
/// 2).
WeightedStiffness assemble_weighted(const PartInput& input);

/// The load vectors (2n) of body_load and boundary_load on the weighted functions.
Eigen::VectorXd weighted_body_load(const PartInput& input, const std::function<Vec2(const Vec2&)>& force);
Eigen::VectorXd weighted_boundary_load(const PartInput& input, const std::vector<TractionPoint>& points);

/// The work (2n) of the stresses of a displacement on the strains of the plain functions.
Eigen::VectorXd internal_forces(const PartInput& input, const Eigen::VectorXd& displacement);
/// The strain energy of a displacement: the integral of stress times strain, halved.
double weighted_strain_energy(const PartInput& input, const Eigen::VectorXd& displacement);
/// The largest displacement at the rules' points.
double largest_weighted_displacement(const PartInput& input, const Eigen::VectorXd& displacement);

}  // namespace abut::solver
