// SPDX-License-Identifier: GPL-3.0-or-later
// What couples parts: contact interfaces with a spline multiplier, and bilateral constraints. Both become rows of a system
//   gap_k = gap0_k + sum over parts D_i u_i,
// whose multipliers are the contact pressure's coefficients or a constraint's force.
#pragma once
#include <array>
#include <vector>

#include "solver/bspline.hpp"
#include "solver/part_system.hpp"

namespace abut::solver {

/// A pair of points, one on each body, on their common normal.
struct InterfacePoint {
    double s;       ///< arc length along the interface's middle curve
    double weight;  ///< arc length
    double gap;     ///< drawn, positive open
    std::array<int, 2> element;
    std::array<Vec2, 2> x;       ///< in each body's frame
    std::array<Vec2, 2> normal;  ///< the direction from body 0 towards body 1, in each body's frame
};

/// The contact pressure along one interface is a B-spline in s with coefficients >= 0: degree 2 as in DESIGN 5, and no integral
/// is split at the unknown end of contact.
inline constexpr int multiplier_degree = 2;

struct Interface {
    std::array<int, 2> part;
    double thickness = 1;
    KnotVector pressure;    ///< over s
    bool periodic = false;  ///< all the way round: pressure has periodic knots
    std::vector<InterfacePoint> points;
};

/// Unknown coefficients of an interface's pressure.
inline int n_rows(const Interface& face) {
    return face.periodic ? face.pressure.n_intervals() : face.pressure.n_functions();
}
/// All coefficients of the pressure spline from the unknown ones (the periodic ones come again at its end).
Eigen::VectorXd all_coefficients(const Interface& face, const Eigen::VectorXd& unknown);

/// Entry of D: of one row, at one coefficient (2f + component) of a part.
struct RowEntry {
    int row, coefficient;
    double value;
};

struct Rows {
    int n = 0;
    std::vector<std::vector<RowEntry>> by_part;
    Eigen::VectorXd gap0;    ///< weighted: integrals of gap times pressure function
    Eigen::VectorXd weight;  ///< integral of the row's pressure function (1 for constraints)
    std::vector<char> unilateral;
};

/// One row for every pressure function of every interface, in order; row offsets by interface in first_row.
Rows interface_rows(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces,
                    std::vector<int>& first_row);

/// Mean displacement and mean rotation (half the mean curl) of a part, in its own frame: rows that hold
/// coefficient . (mean u_x, mean u_y, mean rotation * size) = value. Appended to rows; returns the row.
int append_mean_constraint(Rows& rows, const PartSystem& system, int part, const FunctionIntegrals& integrals, double area,
                           const Eigen::Vector3d& coefficient, double size, double value);

/// Value of a pressure spline with the given coefficients.
double pressure_at(const KnotVector& pressure, const Eigen::VectorXd& coefficients, double s);

}  // namespace abut::solver
