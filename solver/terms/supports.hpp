// SPDX-License-Identifier: GPL-3.0-or-later
// Supports of one part along its boundary.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "solver/assembly/assembly.hpp"

namespace abut::solver {

/// A held point of the boundary: direction . u = value. direction and normal: unit; weight: arc length.
struct SupportPoint {
    int element;
    Vec2 x, normal, direction;
    double weight, value;
};

/// The outermost grid lines, on which only one row of B-splines is not zero.
enum class GridSide { left, right, bottom, top };

/// An interval along a grid side.
struct Stretch {
    double from, to;
};

/// One component held along one stretch of boundary. `side` is set where the stretch covers all of the part's boundary on that
/// grid line, with the direction along a grid axis and a constant value: the functions can then be dropped.
struct SupportSet {
    int tag = 0;
    std::vector<SupportPoint> points;
    std::optional<GridSide> side;
    int component = 0;               ///< of the grid's axes, with `side` or `by_structure`
    double value = 0;                ///< with `side`
    std::vector<Stretch> stretches;  ///< along the side, with `side`
    bool by_structure = false;       ///< imposed by the weight of `component` (solution_structure.hpp); points: where
    std::string note;                ///< why it is imposed so, as far as whoever made the set decided that
};

/// Nitsche's method for one set, added to stiffness and load:
///   - int (d.t(u)) (d.v) - int (d.t(v)) (d.u - value) + int gamma (d.u - value)(d.v),   t(u) = sigma(u) n,
///   gamma = nitsche_factor degree^2 d11 / h, h the smaller side of the cell.
/// Symmetric, and consistent: exact solutions pass. nitsche_factor degree^2 d11 is 200 E for degree 2 and nu = 0.3 in plane
/// stress, from where on the extended basis failed in no measured case; scaling with d11 keeps nu = 0.4999 coercive. With a
/// projected dilatation t and gamma are those of the local elasticity, and the pressure's traction is part of the projection.
inline constexpr double nitsche_factor = 45;
void add_nitsche(const PartInput& input, const SupportSet& set, BlockMatrix& stiffness, Eigen::VectorXd& load);

/// Force (2) and moment about the grid's origin.
struct Resultant {
    Vec2 force{0, 0};
    double moment = 0;
    void add(const Vec2& at, const Vec2& f) {
        force += f;
        moment += at.x() * f.y() - at.y() * f.x();
    }
};
/// The tractions (force per area) of a Nitsche support on the part, at its points.
std::vector<Vec2> nitsche_tractions(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement);
/// The resultant of a Nitsche support's tractions on the part.
Resultant nitsche_reaction(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement);
/// The set's share in u'Au that is not strain energy: -2 int (d.t)(d.u) + int gamma (d.u)^2; A all but what a projection adds.
/// For parts without a structure.
double nitsche_energy(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement);

/// The functions to drop so that a component vanishes on stretches of a grid side: those of the outermost row that live there.
/// None where that would not be exact: a B-spline that lives there is extended from functions that do not, or reaches into a
/// cell that holds material without being held along its whole side (beside a recess or a fillet), where it must not vanish.
std::optional<std::vector<int>> functions_on_side(const SplineSpace& space, GridSide side,
                                                  const std::vector<Stretch>& stretches);

}  // namespace abut::solver
