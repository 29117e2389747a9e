// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <utility>

#include "solver/assembly/assembly.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What resists motions at all, however stiff it is: sum w (d.r_k)(d.r_l).
class Resistance {
public:
    explicit Resistance(std::vector<RigidMotion> motions)
        : motions_(std::move(motions)), gram_(MatrixXd::Zero(std::ssize(motions_), std::ssize(motions_))) {}

    void add(const Vec2& x, const Vec2& direction, double weight) {
        VectorXd along(gram_.rows());
        for (std::size_t k = 0; k < motions_.size(); ++k) along[static_cast<Index>(k)] = direction.dot(motions_[k].at(x));
        gram_ += weight * along * along.transpose();
        all_ += weight;
    }

    /// Those that nothing resists, the null space, and the others.
    std::pair<std::vector<RigidMotion>, std::vector<RigidMotion>> split() const {
        if (gram_.isZero(0)) return {motions_, {}};
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram_);
        std::pair<std::vector<RigidMotion>, std::vector<RigidMotion>> split;
        for (Index k = 0; k < gram_.rows(); ++k)
            (eigen.eigenvalues()[k] <= rigid_mode_fraction * all_ ? split.first : split.second)
                .push_back(sum_of_motions(motions_, eigen.eigenvectors().col(k)));
        return split;
    }

private:
    std::vector<RigidMotion> motions_;
    MatrixXd gram_;
    double all_ = 0;
};

}  // namespace

UnheldMotions split_by_springs(std::vector<RigidMotion> unheld, const std::vector<SpringSet>& springs) {
    if (unheld.empty() || springs.empty()) return {std::move(unheld), {}};
    Resistance resistance(std::move(unheld));
    for (const SpringSet& set : springs)
        for (const SpringPoint& p : set.points) {
            if (set.normal > 0) resistance.add(p.x, p.normal, p.weight);
            if (set.tangential > 0) resistance.add(p.x, {-p.normal.y(), p.normal.x()}, p.weight);
        }
    auto [free, on_springs] = resistance.split();
    return {std::move(free), std::move(on_springs)};
}

UnheldMotions unheld_motions(const PartSystem& s, const Vec2& center, double size) {
    std::vector<RigidMotion> all{{{0, 1}, 0, center}};
    if (!s.input.axis) all = {{{1, 0}, 0, center}, {{0, 1}, 0, center}, {{0, 0}, 1 / size, center}};
    Resistance resistance(std::move(all));
    for (const SupportRecord& record : s.supports)
        for (const SupportPoint& p : record.set.points) resistance.add(p.x, p.direction, p.weight);
    return split_by_springs(resistance.split().first, s.springs);
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
