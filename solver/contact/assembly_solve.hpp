// SPDX-License-Identifier: GPL-3.0-or-later
// Solves an assembly: parts, their interfaces and constraints, condensed to the multipliers and the free rigid motions.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "solver/contact/contact_qp.hpp"
#include "solver/contact/interface.hpp"

namespace abut::solver {

/// A bilateral condition on the means over one part, in its own frame: coefficient . (mean u_x, mean u_y, mean rotation * size)
/// = value. A mean may be that over a single point: `integrals` are then the functions there, and `area` is 1.
struct MeanConstraint {
    int tag = 0;
    int part = 0;
    Eigen::Vector3d coefficient{0, 0, 0};
    double value = 0;
    double area = 0, size = 1;
    FunctionIntegrals integrals;
};

/// A rigid motion of one part, by its number.
struct PartMotion {
    int part;
    RigidMotion motion;
};

/// A free motion is neutral where contact resists it by less than this, of what it resists a motion straight against a face
/// (rotations measured at the part's size): kept, it would turn rounding into large rotations.
inline constexpr double neutral_motion_fraction = 1e-3;
/// The loads may do this much work in a neutral motion, relative to load times size: outlines are drawn no more exactly, so
/// that a load straight against a face is inclined to it by so much.
inline constexpr double neutral_work_fraction = 1e-6;
/// Contact forces below this share of the loads are their rounding: the contact is open.
inline constexpr double open_force_fraction = 1e-10;

/// What is known of a part in the state that slips count from.
struct StateBefore {
    Eigen::VectorXd displacement;      ///< (2n)
    Eigen::VectorXd load, under_load;  ///< (2n) its own loads there, and its displacement under these alone, as of solve()
};

/// Parts, what couples them, and the scales that rounding is measured by.
struct AssemblyProblem {
    std::vector<PartSystem> parts;
    std::vector<Interface> interfaces;
    std::vector<MeanConstraint> constraints;
    std::vector<double> foundation;  ///< by interface: pressure per penetration of a Winkler foundation, for the start
    double load_scale = 0;           ///< the largest single load
    std::vector<double> part_load;   ///< largest load on each part; empty: not known
    /// The state before, by part, from which loads grow evenly with friction; empty: at rest as drawn, without loads.
    std::vector<StateBefore> before;
    bool is_way_before_broken = false;  ///< `is_way_broken` of the state before: friction remembers
    /// What the increments of friction may change pressures and tractions by in all, see follow_path; empty: the loads are put
    /// on at once.
    std::optional<double> path_tolerance{};
    /// Leave out what contact cannot balance of the loads, where that is no more than outlines are inclined by
    /// (`neutral_work_fraction`), and nothing has friction: parts side by side on a slope that the loads press straight against
    /// are driven by the rounding of their coordinates.
    bool drops_imbalance = false;
    /// There will be finer rows: see begin_touching (interface.hpp).
    bool begins_touching = false;
    /// `amplitudes` of a solution of the same parts under other rows, which the search begins from; empty: none. Speed only.
    std::vector<Eigen::VectorXd> near;
    /// The outward normals of the interfaces' points, by interface, point and body, in the body's frame: a motion across all of
    /// them slides the body in its own outline.
    std::vector<std::vector<std::array<Vec2, 2>>> own_normals;
};

/// The wall time of the steps, seconds.
struct SolveSeconds {
    double rows = 0;           ///< of interfaces and constraints
    double condensation = 0;   ///< to the multipliers
    double contact = 0;        ///< start, active sets, neutral motions
    double displacements = 0;  ///< with the refinement
};

/// What friction came to on the way of the loads, by interface of tractions.
struct FrictionOnWay {
    double error = 0;  ///< of its pressure (L2) and of its traction (over the bound) by the size of the increments, relative
    double work = 0, work_error = 0;  ///< done against slip since the state before
};

/// The displacements and forces of an assembly, or the motions that it cannot resist.
struct AssemblySolution {
    std::vector<Eigen::VectorXd> displacement;  ///< (2n) by part
    std::vector<Eigen::VectorXd> load;          ///< (2n) by part, contact and constraints included
    std::vector<Eigen::VectorXd> contact_load;  ///< (2n) by part, contact alone
    std::vector<Eigen::VectorXd> pressure;      ///< by interface
    std::vector<double> constraint_force;       ///< by constraint
    /// The amplitudes of each part's free motions, where pressures balance in neutral motions, too, only with these; empty
    /// elsewhere.
    std::vector<Eigen::VectorXd> amplitudes;
    std::vector<PartMotion> neutral;    ///< motions left out: nothing resists and nothing drives them
    std::vector<PartMotion> mechanism;  ///< not empty: the loads drive these motions, nothing else is filled in
    std::vector<PartMotion> sliding;    ///< not empty: they do so at these cells, the rest is how they slide there
    double holding_factor = 0;  ///< of a mechanism: coefficients of friction so many times as large would hold; 0: none do
    int n_multipliers = 0, iterations = 0;
    int groups = 1, contact_problems = 0;  ///< parts that do not interact are apart; problems with unilateral rows
    bool converged = false, used_fallback = false;
    int increments = 1;                   ///< that friction took the way of the loads in
    std::vector<FrictionOnWay> friction;  ///< by interface, where any has friction
    bool is_way_broken = false;           ///< there are loads on that way under which no answer was found
    bool is_one_of_several = false;       ///< friction: another answer was found from another start
    double residual = 0;  ///< violation of the contact conditions by these displacements and pressures (contact_residual)
    SolveSeconds seconds;
};

/// Solves an assembly; mechanisms and failed convergence are told in the solution. Parts are condensed and solved side by side
/// on `threads` threads (see usable_threads); the solution is the same for any number.
AssemblySolution solve_assembly(const AssemblyProblem& problem, int threads = 1);

}  // namespace abut::solver
