// SPDX-License-Identifier: GPL-3.0-or-later
// One part ready to be solved: stiffness with supports, its free rigid motions, its factor.
#pragma once
#include <string>
#include <vector>

#include "solver/factorization.hpp"
#include "solver/supports.hpp"

namespace abut::solver {

/// A small rigid motion in the plane: u(x) = translation + rotation * (-(y - center.y), x - center.x).
struct RigidMotion {
    Vec2 translation{0, 0};
    double rotation = 0;
    Vec2 center{0, 0};
    Vec2 at(const Vec2& x) const { return translation + rotation * Vec2(-(x.y() - center.y()), x.x() - center.x()); }
};

/// How a support set was imposed.
enum class SupportMethod { aligned, nitsche };

struct SupportRecord {
    SupportSet set;
    SupportMethod method;
    std::vector<int> dropped;  ///< functions whose `component` the set holds (aligned); each belongs to one set only
};

/// Whether two rigid motions of a part count as held or free: the smallest eigenvalue of the supports' Gram matrix, with
/// rotations measured at the part's size, below this fraction of the largest is free.
inline constexpr double rigid_mode_fraction = 1e-10;

struct PartSystem {
    PartInput input;
    BlockMatrix stiffness;    ///< with Nitsche's terms, nothing dropped
    Eigen::VectorXd load;     ///< (2n) with Nitsche's data
    Eigen::VectorXd applied;  ///< (2n) external loads only
    std::vector<SupportRecord> supports;
    Eigen::VectorXd prescribed;  ///< (2n) values of dropped coefficients, 0 elsewhere
    std::vector<int> number;     ///< (2n) row in the factorised matrix; negative: dropped or pinned
    std::vector<char> dropped;   ///< (2n)
    int n_kept = 0;
    std::vector<RigidMotion> free_motions;  ///< 0 to 3, unit displacement at the part's size
    Eigen::MatrixXd modes;                  ///< (2n x free motions) their coefficients
    Factorization factor;
    std::string failure;  ///< not empty: not solvable, and why

    int n() const { return input.space.n_functions; }
};

/// size: the length at which rotations are measured (the part's diagonal); center: about which they turn.
/// The free motions are held by pinning as many coefficients: exact as long as the loads on the part balance, which the
/// equilibrium rows of the contact problem see to.
PartSystem make_part_system(PartInput input, std::vector<SupportSet> supports, Eigen::VectorXd applied, const Vec2& center,
                            double size);

/// Coefficients (2n) of a rigid motion: exact, since all our spaces hold linear functions.
Eigen::VectorXd coefficients_of(const SplineSpace& space, const RigidMotion& motion);

/// Displacement under the given total load vector (2n, in place of system.load), pinned coefficients zero, dropped ones
/// prescribed.
Eigen::VectorXd solve(const PartSystem& system, const Eigen::VectorXd& load);

/// Forces of the supports on the part for a displacement and the load vector that goes with it (contact included), by support.
std::vector<Resultant> support_reactions(const PartSystem& system, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& load);

/// Resultant of a load vector (2n).
Resultant resultant_of(const SplineSpace& space, const Eigen::VectorXd& load);

double strain_energy(const PartSystem& system, const Eigen::VectorXd& displacement);

/// Displacement and its gradient (rows: components) at a point.
struct DisplacementAt {
    Vec2 value;
    Eigen::Matrix2d gradient;
};
DisplacementAt displacement_at(const SplineSpace& space, const Eigen::VectorXd& displacement, int cell, const Vec2& x);

}  // namespace abut::solver
