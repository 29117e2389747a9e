// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a scene that may move as rigid bodies, and one step of their motion.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "solver/contact/contact_qp.hpp"
#include "src/motion/closing_rows.hpp"
#include "src/motion/leads.hpp"
#include "src/motion/rigid_loads.hpp"

namespace abut {

/// Measures each part of a scene: twice the distance of its farthest point from its middle, which does not depend on how it is
/// turned, and nor do steps that are fractions of it.
std::vector<double> sizes_of(const Scene& scene);

/// Parts that move as one, being bonded to each other.
struct Bodies {
    std::vector<int> of_part;  ///< the first part of each part's body
    std::vector<double> size;  ///< by part: its body's, as of sizes_of
};
/// Finds them.
Bodies bodies_of(const Scene& drawn);

/// A part that may move: what supports leave its body to do, about the body's middle.
struct MovingPart {
    int part;
    Vec2 center;               ///< of the body
    double size, arm;          ///< the body's, and half of it: turns times arm count like translations
    Eigen::Matrix3Xd motions;  ///< orthonormal; rows: translation of the middle, turn times arm
    Eigen::Index first = 0;    ///< among all amplitudes, which parts of one body share
    RigidLoad load{};          ///< of the part, about the body's middle
    double pull = 0;           ///< the size of the body's loads

    Eigen::Index n() const { return motions.cols(); }
    Eigen::VectorXd own(const Eigen::VectorXd& amplitudes) const { return amplitudes.segment(first, n()); }
    /// Is the middle held on a line, while the part may turn about it?
    bool turns_on_a_line() const { return n() == 2 && motions.row(2).squaredNorm() > 1 - 1e-9; }
    /// Translation of the middle, and turn.
    Eigen::Vector3d motion(const Eigen::VectorXd& amplitudes) const;
};

/// All of them.
struct MovingParts {
    std::vector<MovingPart> list{};
    std::vector<int> of_part{};  ///< by part of the scene: index into list, or -1
    Eigen::Index n = 0;          ///< amplitudes
    double pull = 0;             ///< of the strongest loads
};

/// Finds what may move in a scene.
MovingParts moving_parts(const Scene& scene, const ResolvedConditions& conditions, const Bodies& bodies);

/// How far a part may go in a step, as a fraction of its size.
inline constexpr double step_fraction = 0.1;
/// A part is there when what is left of its way is less than this fraction of its size.
inline constexpr double arrived_fraction = 1e-4;
/// How far the loads press the springs along the gaps together, of the smallest part's size. What they tilt a part by must
/// drive it less than the least drag holds.
inline constexpr double spring_closing = 1e-9;
/// The drag is that of the loads over a step's length times a factor between this and one. What drives a part by less of its
/// loads is the rounding of drawings, and holds as balanced.
inline constexpr double least_drag = 1e-6, drag_step = 1e-2;
/// The longest motion, in steps' lengths.
double farthest_in_steps(const MovingParts& moving, const Eigen::VectorXd& amplitudes);

/// How a step is resisted: closing: of the smallest part's size, how far the loads press the springs along the gaps together;
/// drag: of the parts' loads over a step's length, on every motion.
struct Resisted {
    double closing, drag;
    std::vector<double> turns{};  ///< by part: as of `Step`; empty: not known, and loads do not turn back either
    Eigen::VectorXd towards{};    ///< amplitudes that the drag pulls to instead of the loads; empty: the loads act
    double leading = 1;           ///< what takes a part its way is as stiff as gaps, times this
    std::vector<char> sticks{};   ///< by gap: nothing slides there; empty: all do
    bool curved = false;          ///< by forces in gaps between round parts and hollows, which turn as these roll in each other
    double across_loads = 1;      ///< of the drag, what is left of it on motions in which a part's loads do not work
};

/// The step of parts on stiff springs along the gaps, which come first among its rows, under the loads. leads: by part, as far
/// as this step is to take them. across: by gap, the stiffness between its pivots across its normal; empty: none.
solver::ContactQp step_problem(const MovingParts& moving, const std::vector<ClosingRow>& gaps, const std::vector<Lead>& leads,
                               const Resisted& by, const std::vector<double>& across = {});

/// The number of the group of each moving part. Parts that no gap joins do not know of each other.
std::vector<int> groups_of(const MovingParts& moving, const std::vector<ClosingRow>& gaps);
/// Such a group that loads or leads drive, as a problem of its own, with the gaps that it has.
struct DrivenGroup {
    MovingParts moving;
    std::vector<ClosingRow> gaps;
};
/// Finds all of them: what nothing drives stays.
std::vector<DrivenGroup> driven_groups(const MovingParts& moving, const std::vector<ClosingRow>& gaps,
                                       const std::vector<Lead>& leads);
/// A group's amplitudes among those of all parts.
void put(const DrivenGroup& group, const Eigen::VectorXd& amplitudes, const MovingParts& moving, Eigen::VectorXd& all);

/// The stiffness across each gap: a round part and the hollow about it hold each other by the line through their middles,
/// which turns as one rolls in the other. Force over the distance of these. Between round parts it drives them apart, which the
/// next step sees.
std::vector<double> stiffness_across(const std::vector<ClosingRow>& gaps, const Eigen::VectorXd& force);

/// A step, and the moment over a turn that the forces in its gaps resist a turn of each part by: those that stretch it turn it
/// back, as a link between its pins, which its gaps alone would let go. Below 0 where they press it.
struct Step {
    Eigen::VectorXd amplitudes;
    std::vector<double> turns;  ///< by part of the scene
};
/// The step of all parts, each driven group's by itself: its digits are those of its own loads.
Step step_of(const MovingParts& moving, const std::vector<ClosingRow>& gaps, const std::vector<Lead>& leads,
             const Resisted& by);

}  // namespace abut
