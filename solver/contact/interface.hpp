// SPDX-License-Identifier: GPL-3.0-or-later
// What couples parts: contact interfaces and bilateral constraints. Both become rows of a system
//   gap_k = gap0_k + sum over parts D_i u_i + softness_k l_k,
// whose multipliers l are the contact pressure's coefficients or a constraint's force.
//
// Mortar: one row for every function of the pressure spline. Penalty: one row for every point q, its multiplier the pressure
// there, its softness w_q / beta_q. Closed rows then say l_q = -beta_q gap_q; put into the equilibrium K u = F - D'l they give
// (K + k^c) u = F + F^c with k^c, F^c summed over the closed points [Grishin10, eqs 4.22-4.24 and 4.36], and the active set
// iteration is the Newton loop that switches points on and off [Grishin10, Figure 2.32]: the same problem in other unknowns.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "solver/parts/part_system.hpp"
#include "solver/splines/bspline.hpp"

namespace abut::solver {

/// A pair of points, one on each body, on their common normal.
struct InterfacePoint {
    double s;       ///< arc length along the interface's middle curve
    double weight;  ///< arc length
    double gap;     ///< drawn, positive open; of friction it is no slip, but what its tractions act midway of
    std::array<int, 2> element;
    std::array<Vec2, 2> x;       ///< in each body's frame
    std::array<Vec2, 2> normal;  ///< the direction from body 0 towards body 1, in each body's frame
};

/// The degree of the pressure spline in the arc length s. Its coefficients are >= 0, hence the pressure; no integral is split
/// at the unknown end of contact.
inline constexpr int multiplier_degree = 2;

/// A stretch along which two parts, or two faces of one, are coupled: its points and its unknowns.
struct Interface {
    std::array<int, 2> part{-1, -1};
    double thickness = 1;
    KnotVector pressure{};   ///< over s; penalty: polyline_knots
    bool bilateral = false;  ///< holds both ways: bonded edges
    bool periodic = false;   ///< all the way round: mortar's pressure has periodic knots
    std::vector<InterfacePoint> points{};
    std::vector<double> penalty{};  ///< by point: pressure per penetration (beta of eq 4.23); empty: mortar
    /// The coefficient of friction, > 0, infinite for rough faces (rough_coefficient). Set: this is the tangential traction of
    /// the interface before it in the list, which has the same points and spline with normals turned left, and is bounded by so
    /// much of its pressure; gaps are slips. Such an interface is bilateral.
    std::optional<double> friction{};
    /// The interface's unknown coefficients, about, from a solution before; empty: nothing is known. Speed, and
    /// whether contact is resolved (begin_touching).
    std::vector<double> expected{};
};

/// The knots of the polyline through the pressures at a penalty interface's points: its places are begin, the points in order,
/// end.
KnotVector polyline_knots(const std::vector<InterfacePoint>& points, double begin, double end);

/// The number of unknown coefficients of an interface's pressure.
inline int n_rows(const Interface& face) {
    if (!face.penalty.empty()) return static_cast<int>(face.penalty.size());
    return face.pressure.n_functions() - (face.periodic ? face.pressure.degree : 0);
}
/// All coefficients of the pressure spline from the unknown ones: the periodic ones come again at its end; a polyline is
/// continued to its ends, or closed around.
Eigen::VectorXd all_coefficients(const Interface& face, const Eigen::VectorXd& unknown);

/// An entry of D: of one row, at one coefficient (2f + component) of a part.
struct RowEntry {
    int row, coefficient;
    double value;
};

/// How a part's mean rotation moves rows: tractions of friction act on the surfaces, but their couples are those of tractions
/// midway between the bodies, so that what acts on both leaves none. What differs is spread over the whole body: continued from
/// the surface by gradients there, it would count more the smaller the cells are.
struct Turning {
    Eigen::VectorXd
        rotation;         ///< (2n) its product with coefficients is the mean rotation; empty: no row of the part has an arm
    Eigen::VectorXd arm;  ///< by row, weighted: D u + arm * mean rotation is what the row opens by
};

/// Rows of the system over all parts: matrices D by part, gaps of the undeformed bodies, and what kind each row is.
struct Rows {
    int n = 0;
    std::vector<std::vector<RowEntry>> by_part;  ///< by row, then coefficient, each pair once; without turnings
    std::vector<Turning> turning;                ///< by part
    Eigen::VectorXd gap0;                        ///< weighted: integrals of gap times pressure function
    Eigen::VectorXd weight;                      ///< integral of the row's pressure function (1 for constraints)
    Eigen::VectorXd softness;  ///< of the interfaces' rows, weighted: what a unit multiplier opens; empty: no penalty anywhere
    std::vector<char> unilateral;
};

/// Makes one row for every pressure function (penalty: point) of every interface, in order; row offsets by interface in
/// first_row. Those of parts are made side by side, the same on any number of threads.
Rows interface_rows(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces, std::vector<int>& first_row,
                    int threads = 1);

/// Lets faces that their functions do not resolve yet begin as far apart as they are. Gaps are means over pressure functions:
/// round faces that touch have some between them, which is much more than they yield where functions are wider than contact.
/// Bodies that nothing holds would sink into it, with friction roll and slip on the way, and neighbours that they lean on would
/// not be met. Where six functions press (`expected`) the mean is what brings pressures to their order, and a 36th of the
/// approach at most.
void begin_touching(const std::vector<PartSystem>& parts, const std::vector<Interface>& interfaces,
                    const std::vector<int>& first_row, Rows& rows);

/// Appends the row that holds a part's mean displacement and mean rotation (half the mean curl), in its own frame, at
/// coefficient . (mean u_x, mean u_y, mean rotation * size) = value. Returns the row's number.
int append_mean_constraint(Rows& rows, const PartSystem& system, int part, const FunctionIntegrals& integrals, double area,
                           const Eigen::Vector3d& coefficient, double size, double value);

/// The products of one part's entries: D u (n_rows), and D'l (n_coefficients).
Eigen::VectorXd rows_times(const std::vector<RowEntry>& entries, const Eigen::VectorXd& u, int n_rows);
Eigen::VectorXd transposed_times(const std::vector<RowEntry>& entries, const Eigen::VectorXd& multipliers, int n_coefficients);

/// What a displacement of one part opens the rows by (n), and the load (2n) of multipliers on it, turnings included.
Eigen::VectorXd opening_of(const Rows& rows, std::size_t part, const Eigen::VectorXd& displacement);
Eigen::VectorXd load_of(const Rows& rows, std::size_t part, const Eigen::VectorXd& multipliers, int n_coefficients);

/// The value of a pressure spline with the given coefficients at s.
double pressure_at(const KnotVector& pressure, const Eigen::VectorXd& coefficients, double s);

}  // namespace abut::solver
