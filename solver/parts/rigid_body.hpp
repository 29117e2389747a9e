// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid part as a part system: it lends the contact problem its motions, and no compliance.
//
// What supports hold of it spans a wrench space [Grishin10, section 2.2]; the motions of that space are prescribed, those that
// no support resists are free and become amplitudes with their equilibrium, as those of elastic parts do.
#pragma once
#include <vector>

#include "solver/parts/part_system.hpp"

namespace abut::solver {

/// A condition on the motion about the body's centre: row . (u_x, u_y, rotation) = value; weight: that of the place among the
/// supports.
struct MotionCondition {
    int tag = 0;
    Eigen::Vector3d row{0, 0, 0};
    double value = 0, weight = 1;
};

/// The condition direction . u(x) = value.
MotionCondition held_point(int tag, const Vec2& x, const Vec2& center, const Vec2& direction, double value, double weight);

/// A rigid part's motion as far as supports prescribe it.
struct RigidBody {
    Vec2 center{0, 0};
    double size = 1;  ///< the length at which rotations are measured
    std::vector<MotionCondition> conditions;
    Eigen::Matrix3d held_inverse = Eigen::Matrix3d::Zero();  ///< of the conditions' Gram matrix, on what they hold
    double contradiction = 0;  ///< largest violation of the conditions by the motion that fits them best
    double largest_value = 0;  ///< of the conditions' values
};

/// Can one motion meet all conditions, but for rounding?
bool is_consistent(const RigidBody& body);

/// Makes a rigid part's system. input: a space that holds linear functions; of the rest its axis alone is read: a body around
/// one moves along y only. applied: loads (2n). Springs give way in motions that no condition holds. failure stays empty.
PartSystem make_rigid_system(PartInput input, std::vector<MotionCondition> conditions, Eigen::VectorXd applied,
                             const Vec2& center, double size, std::vector<SpringSet> springs = {});

/// The forces (2n) that act on a rigid part beside those of its conditions, for its displacement under a total load (2n,
/// contact included): that load, and springs.
Eigen::VectorXd forces_on(const PartSystem& system, const Eigen::VectorXd& displacement, const Eigen::VectorXd& load);

/// The force and moment under a support's tag.
struct TaggedResultant {
    int tag;
    Resultant force;
};
/// What each condition's support exerts, by tag, against such forces. More conditions than motions share as equally stiff
/// points would: rigid bodies leave that open.
std::vector<TaggedResultant> rigid_reactions(const PartSystem& system, const Eigen::VectorXd& forces);

}  // namespace abut::solver
