// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/part_system.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace abut::solver {

namespace {

using Eigen::Index;

/// Drops the functions of an aligned set; false where the basis or an earlier set with another value does not allow it.
bool drop_aligned(PartSystem& s, SupportRecord& record) {
    if (!record.set.side) return false;
    const auto functions = functions_on_side(s.input.space, *record.set.side, record.set.stretches);
    if (!functions) return false;
    const auto dof = [&](int f) { return static_cast<std::size_t>(2 * f + record.set.component); };
    for (int f : *functions)
        if (s.dropped[dof(f)] && s.prescribed[static_cast<Index>(dof(f))] != record.set.value) return false;
    for (int f : *functions) {
        if (s.dropped[dof(f)]) continue;
        s.dropped[dof(f)] = 1;
        s.prescribed[static_cast<Index>(dof(f))] = record.set.value;
        record.dropped.push_back(f);
    }
    return true;
}

void apply_supports(PartSystem& s, std::vector<SupportSet> sets) {
    for (SupportSet& set : sets) {
        SupportRecord record{std::move(set), SupportMethod::aligned, {}};
        if (!drop_aligned(s, record)) {
            record.method = SupportMethod::nitsche;
            add_nitsche(s.input, record.set, s.stiffness, s.load);
        }
        s.supports.push_back(std::move(record));
    }
}

/// Motions that no support resists: the null space of sum w (d.r_k)(d.r_l) over the three unit motions r.
std::vector<RigidMotion> free_motions(const PartSystem& s, const Vec2& center, double size) {
    const RigidMotion unit[3] = {{{1, 0}, 0, center}, {{0, 1}, 0, center}, {{0, 0}, 1 / size, center}};
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    for (const SupportRecord& record : s.supports)
        for (const SupportPoint& p : record.set.points) {
            Eigen::Vector3d along;
            for (int k = 0; k < 3; ++k) along[k] = p.direction.dot(unit[k].at(p.x));
            gram += p.weight * along * along.transpose();
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

/// A coefficient can be pinned if its stiffness is at least this fraction of the median: one whose function barely touches the
/// part would hold it by a weak spring, and rounding of the loads would move the part (1e-8 of its displacement at degree 3).
constexpr double pin_stiffness_fraction = 0.5;

/// As many coefficients as there are modes, chosen so that holding them holds the modes: pivoted elimination on the modes'
/// rows.
std::vector<Index> pins(const PartSystem& s) {
    Eigen::MatrixXd rest = s.modes;
    Eigen::VectorXd diagonal(2 * s.n());
    for (int f = 0; f < s.n(); ++f)
        diagonal.segment<2>(2 * f) =
            s.stiffness.block[static_cast<std::size_t>(s.stiffness.first[static_cast<std::size_t>(f) + 1] - 1)].diagonal();
    std::vector<double> sorted(diagonal.begin(), diagonal.end());
    std::nth_element(sorted.begin(), sorted.begin() + diagonal.size() / 2, sorted.end());
    const double least = pin_stiffness_fraction * sorted[sorted.size() / 2];
    std::vector<Index> chosen;
    for (Index k = 0; k < rest.cols(); ++k) {
        Index best = 0;
        double largest = -1;
        for (Index i = 0; i < rest.rows(); ++i)
            if (!s.dropped[static_cast<std::size_t>(i)] && diagonal[i] >= least && rest.row(i).squaredNorm() > largest) {
                largest = rest.row(i).squaredNorm();
                best = i;
            }
        chosen.push_back(best);
        const Eigen::RowVectorXd pivot = rest.row(best) / rest.row(best).norm();
        rest -= (rest * pivot.transpose()) * pivot;
    }
    return chosen;
}

void number_unknowns(PartSystem& s) {
    const std::vector<Index> pinned = pins(s);
    s.number.assign(s.dropped.size(), -1);
    for (std::size_t i = 0; i < s.dropped.size(); ++i) {
        const bool is_pin = std::find(pinned.begin(), pinned.end(), static_cast<Index>(i)) != pinned.end();
        if (!s.dropped[i] && !is_pin) s.number[i] = s.n_kept++;
    }
}

}  // namespace

Eigen::VectorXd coefficients_of(const SplineSpace& space, const RigidMotion& motion) {
    Eigen::VectorXd c(2 * space.n_functions);
    for (int f = 0; f < space.n_functions; ++f) c.segment<2>(2 * f) = motion.at(greville_point(space, f));
    return c;
}

PartSystem make_part_system(PartInput input, std::vector<SupportSet> supports, Eigen::VectorXd applied, const Vec2& center,
                            double size) {
    PartSystem s;
    s.input = std::move(input);
    s.stiffness = assemble_stiffness(s.input);
    s.applied = std::move(applied);
    s.load = s.applied;
    s.dropped.assign(static_cast<std::size_t>(2 * s.n()), 0);
    s.prescribed = Eigen::VectorXd::Zero(2 * s.n());
    apply_supports(s, std::move(supports));
    s.free_motions = free_motions(s, center, size);
    s.modes.resize(2 * s.n(), static_cast<Index>(s.free_motions.size()));
    for (std::size_t k = 0; k < s.free_motions.size(); ++k) {
        s.modes.col(static_cast<Index>(k)) = coefficients_of(s.input.space, s.free_motions[k]);
        for (std::size_t i = 0; i < s.dropped.size(); ++i)
            if (s.dropped[i]) s.modes(static_cast<Index>(i), static_cast<Index>(k)) = 0;
    }
    number_unknowns(s);
    s.factor = Factorization(restricted(s.stiffness, s.number, s.n_kept));
    if (!s.factor.ok()) s.failure = "the stiffness matrix is not positive definite";
    return s;
}

Eigen::VectorXd solve(const PartSystem& system, const Eigen::VectorXd& load) {
    const Eigen::VectorXd rest = load - multiply(system.stiffness, system.prescribed);
    Eigen::VectorXd b(system.n_kept);
    for (std::size_t i = 0; i < system.number.size(); ++i)
        if (system.number[i] >= 0) b[system.number[i]] = rest[static_cast<Index>(i)];
    const Eigen::VectorXd x = system.factor.solve(b);
    Eigen::VectorXd u = system.prescribed;
    for (std::size_t i = 0; i < system.number.size(); ++i)
        if (system.number[i] >= 0) u[static_cast<Index>(i)] = x[system.number[i]];
    return u;
}

std::vector<Resultant> support_reactions(const PartSystem& system, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& load) {
    const Eigen::VectorXd residual = multiply(system.stiffness, displacement) - load;
    std::vector<Resultant> reactions;
    for (const SupportRecord& record : system.supports) {
        Resultant sum;
        if (record.method == SupportMethod::nitsche) sum = nitsche_reaction(system.input, record.set, displacement);
        for (int f : record.dropped) {
            Vec2 force = Vec2::Zero();
            force[record.set.component] = residual[2 * f + record.set.component];
            sum.add(greville_point(system.input.space, f), force);
        }
        reactions.push_back(sum);
    }
    return reactions;
}

Resultant resultant_of(const SplineSpace& space, const Eigen::VectorXd& load) {
    Resultant sum;
    for (int f = 0; f < space.n_functions; ++f) sum.add(greville_point(space, f), load.segment<2>(2 * f));
    return sum;
}

double strain_energy(const PartSystem& system, const Eigen::VectorXd& displacement) {
    double twice = displacement.dot(multiply(system.stiffness, displacement));
    for (const SupportRecord& record : system.supports)
        if (record.method == SupportMethod::nitsche) twice -= nitsche_energy(system.input, record.set, displacement);
    return 0.5 * twice;
}

DisplacementAt displacement_at(const SplineSpace& space, const Eigen::VectorXd& displacement, int cell, const Vec2& x) {
    const PointBasis b = evaluate(space, cell, x);
    DisplacementAt d{Vec2::Zero(), Eigen::Matrix2d::Zero()};
    for (std::size_t i = 0; i < b.functions.size(); ++i) {
        const auto k = static_cast<Index>(i);
        const Vec2 c = displacement.segment<2>(2 * b.functions[i]);
        d.value += b.value[k] * c;
        d.gradient.col(0) += b.dx[k] * c;
        d.gradient.col(1) += b.dy[k] * c;
    }
    return d;
}

}  // namespace abut::solver
