// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: q = (u_x, u_y, rotation * size) of the body's centre; a row times 1/size in its last entry acts on q.
#include "solver/parts/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "solver/parts/free_motions.hpp"
#include "solver/parts/on_springs.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

/// Of the largest prescribed value: what fits worse is a contradiction, not rounding.
constexpr double consistency = 1e-9;

Eigen::Vector3d scaled_row(const MotionCondition& c, double size) {
    return {c.row[0], c.row[1], c.row[2] / size};
}

RigidMotion motion_of(const Eigen::Vector3d& q, const RigidBody& body) {
    return {q.head<2>(), q[2] / body.size, body.center};
}

/// A rigid ring has one motion, along the axis: it does not stretch.
std::vector<RigidMotion> split_motion_along_axis(RigidBody& body) {
    double held = 0;
    for (const MotionCondition& c : body.conditions) held += c.weight * c.row[1] * c.row[1];
    if (held == 0) return {motion_of({0, 1, 0}, body)};
    body.held_inverse(1, 1) = 1 / held;
    return {};
}

/// Free motions; held_inverse of the rest.
std::vector<RigidMotion> split_motions(RigidBody& body) {
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    for (const MotionCondition& c : body.conditions) {
        const Eigen::Vector3d row = scaled_row(c, body.size);
        gram += c.weight * row * row.transpose();
    }
    if (gram.isZero(0)) return {motion_of({1, 0, 0}, body), motion_of({0, 1, 0}, body), motion_of({0, 0, 1}, body)};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(gram);
    std::vector<RigidMotion> free;
    for (Index k = 0; k < 3; ++k) {
        const Eigen::Vector3d v = eigen.eigenvectors().col(k);
        if (eigen.eigenvalues()[k] <= rigid_mode_fraction * eigen.eigenvalues()[2])
            free.push_back(motion_of(v, body));
        else
            body.held_inverse += v * v.transpose() / eigen.eigenvalues()[k];
    }
    return free;
}

/// The motion that fits the prescribed values best.
RigidMotion prescribed_motion(RigidBody& body) {
    Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
    for (const MotionCondition& c : body.conditions) rhs += c.weight * c.value * scaled_row(c, body.size);
    const Eigen::Vector3d q = body.held_inverse * rhs;
    for (const MotionCondition& c : body.conditions) {
        body.contradiction = std::max(body.contradiction, std::abs(scaled_row(c, body.size).dot(q) - c.value));
        body.largest_value = std::max(body.largest_value, std::abs(c.value));
    }
    return motion_of(q, body);
}

}  // namespace

MotionCondition held_point(int tag, const Vec2& x, const Vec2& center, const Vec2& direction, double value, double weight) {
    const Vec2 arm = x - center;
    return {tag, {direction.x(), direction.y(), arm.x() * direction.y() - arm.y() * direction.x()}, value, weight};
}

bool is_consistent(const RigidBody& body) {
    return body.contradiction <= consistency * body.largest_value;
}

PartSystem make_rigid_system(PartInput input, std::vector<MotionCondition> conditions, Eigen::VectorXd applied,
                             const Vec2& center, double size, std::vector<SpringSet> springs) {
    PartSystem s;
    s.input = std::move(input);
    s.springs = std::move(springs);
    RigidBody body{center, size, std::move(conditions)};
    UnheldMotions unheld = split_by_springs(s.input.axis ? split_motion_along_axis(body) : split_motions(body), s.springs);
    s.free_motions = std::move(unheld.free);
    s.prescribed = coefficients_of(s.input.space, prescribed_motion(body));
    s.held_load = -springs_times(s, s.prescribed);
    s.applied = std::move(applied);
    s.load = s.applied + s.held_load;
    s.dropped.assign(static_cast<std::size_t>(2 * s.n()), 0);
    s.number.assign(s.dropped.size(), -1);
    s.modes = coefficients_of(s.input.space, s.free_motions);
    s.body = std::make_shared<const RigidBody>(std::move(body));
    s.sprung = sprung_motions(s, coefficients_of(s.input.space, unheld.on_springs));
    return s;
}

Eigen::VectorXd forces_on(const PartSystem& system, const Eigen::VectorXd& displacement, const Eigen::VectorXd& load) {
    return load - system.held_load - springs_times(system, displacement);
}

std::vector<TaggedResultant> rigid_reactions(const PartSystem& system, const Eigen::VectorXd& forces) {
    const RigidBody& body = *system.body;
    const Resultant total = resultant_of(system.input.space, forces);
    const double moment = total.moment - (body.center.x() * total.force.y() - body.center.y() * total.force.x());
    const Eigen::Vector3d wrench(-total.force.x(), -total.force.y(), -moment / body.size);
    const Eigen::Vector3d share = body.held_inverse * wrench;
    std::map<int, Resultant> sum;
    for (const MotionCondition& c : body.conditions) {
        const double force = c.weight * scaled_row(c, body.size).dot(share);
        Resultant& r = sum[c.tag];
        const Vec2 f = force * c.row.head<2>();
        r.force += f;
        r.moment += force * c.row[2] + body.center.x() * f.y() - body.center.y() * f.x();
    }
    std::vector<TaggedResultant> reactions;
    for (const auto& [tag, force] : sum) reactions.push_back({tag, force});
    return reactions;
}

}  // namespace abut::solver
