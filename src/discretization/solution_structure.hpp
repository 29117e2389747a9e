// SPDX-License-Identifier: GPL-3.0-or-later
// Supports by weight functions: u = w Phi + phi [Grishin10, eqs 3.7-3.8, 4.12-4.16] out of the scene's supports and a part's
// edges.
//
// w, by component of the grid's axes: the R-conjunction of the normalised distances (divided by the part's size) to all edges
// and points that hold the component. The distance to a straight edge on the outline's hull is linear (the whole line's, so
// that polynomials stay polynomials), to other edges that of geometry::edge_field; accuracy.weights takes others (EdgeWeights,
// weight_fields.hpp). phi: the prescribed values, blended between
// supports by the inverse squares of the distances to them.
#pragma once
#include <memory>
#include <vector>

#include "solver/terms/solution_structure.hpp"
#include "src/discretization/discretize.hpp"
#include "src/plan/boundary_conditions.hpp"

namespace abut {

/// What one support holds by weights on one part.
struct HeldByWeight {
    int support;
    int component;             ///< of the grid's axes
    std::vector<int> edges;    ///< whole
    std::vector<Vec2> points;  ///< local
};

/// What a part's supports hold by weights, with accuracy.dirichlet "solution_structure": whole edges that are fixed or
/// displaced in both components or along the grid's axes, straight edges of symmetry along these, and points. Not on parts
/// with a rigid support, whose mean motion the weighted functions do not know.
std::vector<HeldByWeight> held_by_weight(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid);

/// Why a support of edges that structures could hold is (in part) not held by one here.
std::string why_not_by_weight(const Scene& scene, int support, const PartOnGrid& on_grid);

/// Makes a part's solution structure; null where nothing is held by weights. Throws InputError where prescribed values are not
/// finite on the part.
std::shared_ptr<const solver::SolutionStructure> make_structure(const Scene& scene, const ResolvedConditions& conditions,
                                                                const PartOnGrid& on_grid);

/// Gauss points in each direction of a cell beyond those for the space's functions times linear weights, where weights are not
/// linear: beside kinks, in cells that an end of a held edge or a held point is in or next to, and elsewhere. Measured: on a
/// ring held along its circles (no kinks) 0 to 6 more give the same error to three digits; on a rectangle of 6 x 6, 12 x 12, 24
/// x 24 cells held all round to a linear field, which quadrature alone keeps from being exact, the largest error of stress
/// is 5.3 %, 1.6 %, 0.9 % with 0 more; 0.7 %, 0.15 %, 0.08 % with 2; 0.2 %, 0.04 %, 0.02 % with 4; 0.08 %, 0.02 %, 0.005 %
/// with 6.
inline constexpr int extra_points_at_kinks = 4, extra_points_elsewhere = 1;

}  // namespace abut
