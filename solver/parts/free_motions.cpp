// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/free_motions.hpp"

#include <Eigen/Eigenvalues>

#include "solver/assembly/assembly.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

/// Motions that neither supports nor springs resist: the null space of sum w (d.r_k)(d.r_l) over the three unit motions r. A
/// spring's stiffness does not count: what it resists at all it holds.
std::vector<RigidMotion> free_motions_in_plane(const PartSystem& s, const Vec2& center, double size) {
    const RigidMotion unit[3] = {{{1, 0}, 0, center}, {{0, 1}, 0, center}, {{0, 0}, 1 / size, center}};
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    const auto resist = [&](const Vec2& x, const Vec2& direction, double weight) {
        Eigen::Vector3d along;
        for (int k = 0; k < 3; ++k) along[k] = direction.dot(unit[k].at(x));
        gram += weight * along * along.transpose();
    };
    for (const SupportRecord& record : s.supports)
        for (const SupportPoint& p : record.set.points) resist(p.x, p.direction, p.weight);
    for (const SpringSet& set : s.springs)
        for (const SpringPoint& p : set.points) {
            if (set.normal > 0) resist(p.x, p.normal, p.weight);
            if (set.tangential > 0) resist(p.x, {-p.normal.y(), p.normal.x()}, p.weight);
        }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(gram);
    std::vector<RigidMotion> motions;
    for (int k = 0; k < 3; ++k) {
        if (gram.isZero(0))
            motions.push_back(unit[k]);
        else if (eigen.eigenvalues()[k] <= rigid_mode_fraction * eigen.eigenvalues()[2]) {
            const Eigen::Vector3d v = eigen.eigenvectors().col(k);
            motions.push_back({v.head<2>(), v[2] / size, center});
        }
    }
    return motions;
}

/// Around an axis: along it, unless something resists that.
std::vector<RigidMotion> free_motions_along_axis(const PartSystem& s, const Vec2& center) {
    double held = 0, all = 0;
    const auto resist = [&](double along, double weight) {
        held += weight * along * along;
        all += weight;
    };
    for (const SupportRecord& record : s.supports)
        for (const SupportPoint& p : record.set.points) resist(p.direction.y(), p.weight);
    for (const SpringSet& set : s.springs)
        for (const SpringPoint& p : set.points) {
            if (set.normal > 0) resist(p.normal.y(), p.weight);
            if (set.tangential > 0) resist(p.normal.x(), p.weight);
        }
    if (held > rigid_mode_fraction * all) return {};
    return {{{0, 1}, 0, center}};
}

}  // namespace

std::vector<RigidMotion> free_motions(const PartSystem& s, const Vec2& center, double size) {
    return s.input.axis ? free_motions_along_axis(s, center) : free_motions_in_plane(s, center, size);
}

namespace {

Eigen::MatrixXd make_integrals(const PartSystem& system) {
    if (system.body || system.modes.cols() == 0) return system.modes;
    const Vec2 center = system.free_motions.front().center;
    const std::vector<RigidMotion> rigid{{{1, 0}, 0, center}, {{0, 1}, 0, center}, {{0, 0}, 1, center}};
    const Eigen::MatrixXd coefficients = coefficients_of(system.input.space, rigid);
    Eigen::MatrixXd integrals = Eigen::MatrixXd::Zero(coefficients.rows(), 3);
    const Eigen::VectorXd of_one = body_load(system.input, [](const Vec2&) { return Vec2(1, 0); });
    for (Eigen::Index i = 0; i < of_one.size(); i += 2) integrals(i, 0) = integrals(i + 1, 1) = of_one[i];
    integrals.col(2) = body_load(system.input, [&](const Vec2& x) { return rigid[2].at(x); });
    const PivotedCholesky gram(coefficients.transpose() * coefficients);
    return integrals * gram.solve_columns(coefficients.transpose() * system.modes);
}

}  // namespace

RigidMotion sum_of_motions(const std::vector<RigidMotion>& motions, const Eigen::VectorXd& shares) {
    ENSURE(!motions.empty() && static_cast<Eigen::Index>(motions.size()) == shares.size(), "every motion has a share");
    RigidMotion sum{{0, 0}, 0, motions.front().center};
    for (std::size_t k = 0; k < motions.size(); ++k) {
        const double share = shares[static_cast<Eigen::Index>(k)];
        sum.translation += share * motions[k].at(sum.center);
        sum.rotation += share * motions[k].rotation;
    }
    return sum;
}

const Eigen::MatrixXd& motion_integrals(const PartSystem& system) {
    return system.motion_integrals([&] { return make_integrals(system); });
}

}  // namespace abut::solver
