// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness and loads of one part.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "solver/assembly/cell_integrals.hpp"
#include "solver/assembly/elasticity.hpp"
#include "solver/linear_algebra/block_matrix.hpp"
#include "solver/splines/spline_space.hpp"

namespace abut::solver {

/// The quadrature of one element of a cut cell: points (n) and weights (n).
struct CellRule {
    int element;
    std::vector<Vec2> points;
    std::vector<double> weights;
};

struct SolutionStructure;
struct Dilatation;

/// What the solver is told of a part: its space, how to integrate over it, and what it is made of.
struct PartInput {
    SplineSpace space;
    std::vector<CellRule> cut_rules;  ///< every cell with 0 < fraction < 1
    LineRule line_rule;
    Elasticity elasticity;
    double thickness = 1;
    /// The weight functions of supports (solution_structure.hpp); none: the functions as they are.
    std::shared_ptr<const SolutionStructure> structure{};
    /// Is the volume strain projected, against locking (dilatation.hpp)? Not with a structure.
    bool is_projected = false;
    std::shared_ptr<const Dilatation> dilatation{};  ///< filled in by make_part_system
    /// The elements where interfaces have points, if that is known beforehand: the factor is made for their rows. Speed only.
    std::vector<int> contact_elements{};
    /// Factorised by CHOLMOD, as a second opinion on the factor that the part would have. Not where the volume strain is
    /// projected: CHOLMOD has no supernodal factor with signs.
    bool by_cholmod = false;
    /// The most threads that the part's stiffness, factor and stresses are made on; the numbers are the same for any.
    int threads = 1;
    /// The free strain (thermal expansion times temperature rise) at a point; empty: none, and nothing is computed of it.
    std::function<double(const Vec2&)> free_strain{};
    /// The place x of the axis of revolution (ring.hpp): the weights of all rules and points carry the radius, thickness is 2
    /// pi.
    std::optional<double> axis{};
    /// Displacements (2n) that draw the two sides of a cut together by a unit (pull.hpp), by cut. Not with a structure nor with
    /// a projected volume strain.
    std::vector<Eigen::VectorXd> pulls{};
    /// The displacement (2n) that leaves no stress: that of the pulls, as far as they are shortened. Empty: none.
    Eigen::VectorXd stress_free{};
    bool touches_axis = false;  ///< an edge of the part lies on the axis, which is the first grid line
};

/// The elasticity that gives stresses from a displacement's own gradient; with a projection without lambda's share.
inline Elasticity local_elasticity(const PartInput& input) {
    return input.is_projected ? without_volume(input.elasticity) : input.elasticity;
}

/// Calls f(rule) for the quadrature of every element that holds material, of full cells too.
void for_all_cells(const PartInput& input, const std::function<void(const CellRule&)>& f);

/// The stiffness of the local elasticity over the whole space, supports not yet applied. [Grishin10, eq 2.20 ff.]; full cells
/// by products of 1D matrices, once for each run of equal cells. Cost: of order (cells + points of cut cells) times (p + 1)^4.
BlockMatrix assemble_stiffness(const PartInput& input);

/// Adds integrals with an element's B-splines to a component of a load vector (2n).
void add_to_component(Eigen::VectorXd& load, int component, const Extraction& e, const Eigen::VectorXd& local);

/// The integrals of every function and of its derivatives over the part (not times the thickness), (n) each.
struct FunctionIntegrals {
    Eigen::VectorXd value, dx, dy;
};
FunctionIntegrals integrate_functions(const PartInput& input);

/// The load vector (2n) of a force per volume given as a field.
Eigen::VectorXd body_load(const PartInput& input, const std::function<Vec2(const Vec2&)>& force);

/// A traction (force per area) at a boundary point; weight: arc length.
struct TractionPoint {
    int element;
    Vec2 x;
    double weight;
    Vec2 traction;
};
/// The load vector (2n) of tractions at boundary points.
Eigen::VectorXd boundary_load(const PartInput& input, const std::vector<TractionPoint>& points);

}  // namespace abut::solver
