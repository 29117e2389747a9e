// SPDX-License-Identifier: GPL-3.0-or-later
// One part ready to be solved: stiffness with supports, its free rigid motions, its factor.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/linear_algebra/factorization.hpp"
#include "solver/terms/pull.hpp"
#include "solver/terms/springs.hpp"
#include "solver/terms/supports.hpp"
#include "src/base/once.hpp"

namespace abut::solver {

/// A small rigid motion in the plane: u(x) = translation + rotation * (-(y - center.y), x - center.x).
struct RigidMotion {
    Vec2 translation{0, 0};
    double rotation = 0;
    Vec2 center{0, 0};
    Vec2 at(const Vec2& x) const { return translation + rotation * Vec2(-(x.y() - center.y()), x.x() - center.x()); }
};

/// The way in which a support set was imposed.
enum class SupportMethod { aligned, nitsche, structure };

/// A support of the part, and how it is imposed.
struct SupportRecord {
    SupportSet set;
    SupportMethod method;
    std::vector<int> dropped;  ///< functions whose `component` the set holds (aligned); each belongs to one set only
    std::string why;           ///< the method, in words
};

/// The fraction of all weights of the supports' Gram matrix, with rotations measured at the part's size, up to which a motion
/// counts as free.
inline constexpr double rigid_mode_fraction = 1e-10;

/// The unknown at which a factorisation ended.
struct FailedPivot {
    Vec2 at;  ///< of its function
    int component;
};

/// The condition number up to which springs are solved with: softer ones against a part's material leave less than four digits
/// of its answer. (Of the matrix scaled to a unit diagonal; measured: the balance of forces is off by 1e-16 to 1e-18 times the
/// condition number.)
inline constexpr double largest_spring_condition = 1e12;

struct RigidBody;

/// A part ready to be solved. Sizes: n functions, vectors (2n) ordered (function, component).
struct PartSystem {
    PartInput input;
    std::shared_ptr<const RigidBody> body{};  ///< of a rigid part (rigid_body.hpp): no stiffness, no factor, no unknowns
    /// The stiffness with Nitsche's terms, nothing dropped; without what a projected dilatation adds: stiffness_times() has
    /// that, too.
    BlockMatrix stiffness;
    Eigen::VectorXd load;     ///< (2n) all: external ones, on the weighted functions where there is a structure, and held_load
    Eigen::VectorXd applied;  ///< (2n) external loads only, on the plain functions
    Eigen::VectorXd held_load;  ///< (2n) what supports, springs, the free strain and pulls add to them
    std::vector<Pull> pulls;    ///< of input.pulls
    std::vector<SupportRecord> supports;
    std::vector<SpringSet> springs;
    std::string axis_hold;       ///< how u_x is held on the axis that the part touches; empty: it touches none
    Eigen::VectorXd prescribed;  ///< (2n) values of dropped coefficients, 0 elsewhere
    std::vector<int> number;     ///< (2n) row in the factorised matrix; negative: dropped or pinned
    std::vector<char> dropped;   ///< (2n)
    int n_kept = 0;
    std::vector<RigidMotion> free_motions;  ///< 0 to 3 (around an axis 0 or 1), unit displacement at the part's size
    Eigen::MatrixXd modes;                  ///< (2n x free motions) their coefficients
    Eigen::MatrixXd sprung;                 ///< (2n x some) w of on_springs.hpp; no columns: the factor is of all
    Factorization factor;
    std::string failure;                       ///< not empty: not solvable, what that means and what to do
    std::optional<FailedPivot> failed_at;      ///< where the factorisation ended
    Once<Eigen::MatrixXd> motion_integrals{};  ///< motion_integrals() asks for them
    Once<Eigen::VectorXd> mean_rotation{};     ///< rows of friction ask for it
    Once<double> condition{};                  ///< condition_estimate() asks for it
    struct {
        double all = 0, factorisation = 0, springs = 0, dilatation = 0;
    } seconds;  ///< of make_part_system, and of steps in it

    int n() const { return input.space.n_functions; }
};

/// Makes a part ready to be solved; what makes it unsolvable is told in `failure`. size: the length at which rotations are
/// measured (the part's diagonal); center: about which they turn. The free motions are held by pinning as many coefficients:
/// exact as long as the loads on the part balance, which the equilibrium rows of the contact problem see to. Springs hold a
/// motion that they resist, however soft they are (on_springs.hpp). applied: (2n) on the plain functions; weighted: the same
/// loads on the weighted ones, with a structure only.
PartSystem make_part_system(PartInput input, std::vector<SupportSet> supports, Eigen::VectorXd applied, const Vec2& center,
                            double size, std::vector<SpringSet> springs = {}, const Eigen::VectorXd& weighted = {});

/// A part under other external loads (as make_part_system takes them); it shares the factor, and its free strain stays.
PartSystem with_loads(const PartSystem& system, Eigen::VectorXd applied, const Eigen::VectorXd& weighted = {});

/// Shortens the part across its cuts, by pull, in place of what it was shortened by before.
void set_shortening(PartSystem& system, const Eigen::VectorXd& shortening);

/// The coefficients (2n) of a rigid motion: exact, since all our spaces hold linear functions.
Eigen::VectorXd coefficients_of(const SplineSpace& space, const RigidMotion& motion);

/// The coefficients of several rigid motions, by column (2n x motions).
Eigen::MatrixXd coefficients_of(const SplineSpace& space, const std::vector<RigidMotion>& motions);

/// The product K u of the whole space (2n), nothing dropped.
Eigen::VectorXd stiffness_times(const PartSystem& system, const Eigen::VectorXd& displacement);

/// A total load vector (2n) less what prescribed coefficients take of it.
Eigen::VectorXd load_beside_prescribed(const PartSystem& system, const Eigen::VectorXd& load);

/// Its entries in the rows of the factorised matrix (n_kept).
Eigen::VectorXd kept_entries(const PartSystem& system, const Eigen::VectorXd& load);

/// The displacement (2n) under the given total load vector (2n, in place of system.load), pinned coefficients zero, dropped
/// ones prescribed.
Eigen::VectorXd solve(const PartSystem& system, const Eigen::VectorXd& load);

/// The displacement (2n) that a load (2n) adds to any other: pinned and dropped coefficients zero; none of a rigid part.
Eigen::VectorXd response(const PartSystem& system, const Eigen::VectorXd& load);

/// The condition number of the factorised matrix, see Factorization::condition_estimate; 1 where nothing was factorised. Cost:
/// 10 solutions, and as many products with the stiffness; of all systems that share the factor once.
double condition_estimate(const PartSystem& system);

/// The forces of the supports on the part for a displacement and the load vector that goes with it (contact included), by
/// support. Those of structures follow from equilibrium: the residual of the plain functions, each function's to the support
/// nearest to it; plain: loads (2n) besides `applied` (contact, constraints) on the plain functions, read for these only.
std::vector<Resultant> support_reactions(const PartSystem& system, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& load, const Eigen::VectorXd& plain = {});

/// The resultant of the stresses of a displacement along a support's points, in the held direction: a second opinion on the
/// reaction of a structure, which converges more slowly.
Resultant traction_resultant(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement);

/// The resultant of a load vector (2n) on the plain functions.
Resultant resultant_of(const SplineSpace& space, const Eigen::VectorXd& load);

/// The sum of place about a centre times force of a load (2n): its moment changes by that times a small turn, taken off.
double virial_of(const SplineSpace& space, const Eigen::VectorXd& load, const Vec2& center);

/// The strain energy of the part alone, without its springs; with a free strain that of the elastic strains (elastic_energy).
double strain_energy(const PartSystem& system, const Eigen::VectorXd& displacement);

/// A length that no displacement of the part exceeds but by the overshoot of sampling: the largest coefficient, or with a
/// structure the largest value at its points.
double largest_displacement(const PartInput& input, const Eigen::VectorXd& displacement);

}  // namespace abut::solver
