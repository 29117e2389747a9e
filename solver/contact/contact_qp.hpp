// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed contact problem: a small convex quadratic program over the multipliers.
//
//   min 1/2 l'C l + g'l   subject to  G'l + h = 0,  l_k >= 0 for unilateral k,
//
// whose conditions are: gap = g + C l + G a >= 0, l >= 0, gap . l = 0 (gap = 0 for bilateral rows); a are the amplitudes of the
// rigid motions that no support holds, G'l + h = 0 their equilibrium. With friction it is no program but the same conditions
// with more rows: see friction.hpp.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "solver/linear_algebra/compliance.hpp"

namespace abut::solver {

class ClosedFactor;
class KeptStates;

/// A row of tangential traction, whose gap is the slip, and the row of the pressure that bounds it: |l_t| <= coefficient l_n,
/// l_t = -coefficient l_n sign(slip) where it slips.
struct FrictionRow {
    int normal, tangential;
    double coefficient;  ///< > 0, finite
};

/// The coefficient of rough faces, or less where that holds as well (friction.hpp). An infinite one would let tractions jump
/// from none to any where pressure begins, and such a problem need not have an answer.
inline constexpr double rough_coefficient = 1e4;

/// The problem in m multipliers and n amplitudes.
struct ContactQp {
    Compliance compliance;         ///< C, symmetric positive semidefinite (m x m)
    Eigen::VectorXd gap;           ///< g (m)
    Eigen::MatrixXd modes;         ///< G (m x n)
    Eigen::VectorXd mode_load;     ///< h (n)
    std::vector<char> unilateral;  ///< (m)
    Eigen::VectorXd foundation;    ///< stiffness of a Winkler foundation for every row, for the starting guess (m)
    Eigen::VectorXd drawn_gap;     ///< gap of the undeformed bodies, for the starting guess (m)
    double load_scale = 0;         ///< the largest load on any body: what equilibrium is measured against
    /// The multipliers of a problem much like this one, whose active set the search begins with; empty: that of the settle.
    /// Speed only.
    Eigen::VectorXd expected{};
    /// With `expected`: the amplitudes of that problem's answer (n), which bodies that nothing holds stay near; empty: not
    /// known.
    Eigen::VectorXd near{};
    std::vector<FrictionRow> friction{};  ///< their tangential rows count as bilateral in `unilateral`
    bool asks_holding_factor = true;      ///< of a mechanism; it takes as long as a hundred searches
    /// With friction: what is factored of one problem answers others that differ by gaps and loads. Speed only; null: not kept.
    std::shared_ptr<KeptStates> kept{};
};

/// The solution of the contact problem, or why there is none.
struct ContactQpResult {
    Eigen::VectorXd multipliers, gap;
    Eigen::VectorXd settled, motion;  ///< amplitudes of the rigid settle, and from there to the answer
    Eigen::VectorXd amplitudes() const { return settled + motion; }
    std::vector<char> active;  ///< by row: 1 closed, 0 open; tangential rows of friction: RowState (friction.hpp)
    int iterations = 0;
    bool converged = false;
    bool used_fallback = false;  ///< the primal-dual active set repeated or lost a set: the descending one went on
    bool feasible = true;        ///< false: no pressures >= 0 balance the loads
    Eigen::VectorXd mechanism;   ///< with !feasible: the motion (amplitudes) that the loads drive; else friction may hold it
    /// Coefficients of friction were taken as no larger than this (rough faces), and what slips works so much against them, of
    /// the elastic energy; 0 where that is next to nothing.
    double most_friction = rough_coefficient, slip_of_steep = 0;
    double holding_factor = 0;  ///< with a mechanism: coefficients of friction so many times as large would hold; 0: none do
    double residual = 0;        ///< of the conditions, scaled: see contact_residual
};

/// Solves the contact problem, in these steps:
/// 0. Where a set is expected, step 2 from it, the amplitudes measured from where the bodies would settle on it. Usually
///    the end, after one step. Where it leaves bodies free that carry nothing, they settle as in step 1 and stay there.
/// 1. A rigid settle on a Winkler foundation gives the first active set and the amplitudes that all others are measured from.
///    Where it finds no balance, non-negative least squares on the equilibrium alone: the residual is a mechanism's motion.
///    Without unilateral rows there is nothing to search, and this is left out.
/// 2. Primal-dual active set [Hueber05] from the settle's. Usually the end.
/// 3. Where it meets a set that leaves a motion free: passes of the same under a proximal term on the amplitudes, a fraction of
///    the foundation's stiffness against the rigid motions that is reduced tenfold a pass. The set of each pass is tried
///    without the term; where a single point carries all, the balance becomes exact by the passes.
/// 4. Where it repeats a set, or a pass does: the interior point method, and the active set again from the rows that it closes.
/// 5. Where that does not end either: the passes again, with the descending active set where one repeats or loses a set.
/// Where C is sparse, step 4 comes at once where step 0 does not end, no step 3 comes before it, and nothing descends after it.
/// With friction: solve_with_friction (friction.hpp) instead.
ContactQpResult solve_contact_qp(const ContactQp& qp);
/// The answer from that of a problem that differs by its loads: from its set (`expected`), the amplitudes measured from its
/// own. Motions that a set leaves free stay there, as long as the loads do no work in them. factor: of the compliance, kept
/// from one problem to the next. False: it is not found from there, and `result` has nothing.
bool solve_from_neighbour(const ContactQp& qp, const Eigen::VectorXd& amplitudes, ClosedFactor& factor,
                          ContactQpResult& result);
/// The search from a neighbour's set and amplitudes (`expected`, `near`) alone: passes as of step 3, under a proximal term that
/// is strong at first, so that what nothing holds stays near. False: it is not found from there, and `result` has no answer.
bool solve_from_near(const ContactQp& qp, ContactQpResult& result);
/// Multipliers, the gaps under them, and what they and the loads leave unbalanced of the rigid motions.
struct ContactConditions {
    Eigen::VectorXd multipliers, gap, imbalance;
};
/// The largest violation of the conditions, scaled: imbalance relative to the loads (a press fit: to the contact forces),
/// negative multipliers relative to the largest, penetration and gaps of bilateral rows relative to the largest elastic closing
/// max(C l), which clearances and rigid motions do not enlarge, or to what is prescribed, and min(l, gap) in the same units.
/// Nothing is measured by less than multipliers of 1e-8 of the loads would be: what rounding leaves where nothing is carried
/// has no other scale. Without any multiplier and load gaps are relative to the largest of them.
double contact_residual(const ContactQp& qp, const ContactConditions& conditions);

/// What residuals of a problem's conditions are measured by; 0: nothing is there to measure.
struct ResidualScales {
    double force, multiplier, length;
};
/// closing: C l.
ResidualScales residual_scales(const ContactQp& qp, const ContactConditions& conditions, const Eigen::VectorXd& closing);
/// Measures by how much a row of pressure or a bilateral one misses its conditions.
double row_residual(const ContactQp& qp, const ContactConditions& conditions, const ResidualScales& scales, Eigen::Index row);
/// A value over its scale; 0 where there is none.
double over_scale(double value, double scale);

/// Finds multipliers and amplitudes with the gaps of `active` closed and all other multipliers zero; a motion that the set
/// leaves free stays at zero. Rows of friction that slip have the multiplier that their pressure gives them. False where C is
/// singular on the set or no row of it resists any motion. With residuals in place of gap and mode_load: the correction of a
/// step of iterative refinement.
bool solve_on_set(const ContactQp& qp, const std::vector<char>& active, Eigen::VectorXd& multipliers,
                  Eigen::VectorXd& amplitudes);

}  // namespace abut::solver
