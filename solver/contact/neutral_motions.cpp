// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/neutral_motions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "solver/contact/assembly_rows.hpp"
#include "solver/contact/condensation.hpp"
#include "solver/contact/traction_arm.hpp"
#include "solver/linear_algebra/dense.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/parts/free_motions.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Bases of motions that make a larger angle (its sine) than this are different motions.
constexpr double same_motion = 1e-3;
/// Of unit motion at the part's size: what normals do less in a motion than this, or than so many times what the motion is
/// neutral by, is rounding.
constexpr double least_lever = 1e-6, clear_lever = 30;

/// What a hollow resists of a motion that it leaves free at first: less than counts as resisted, and the part of the loads that
/// is expected to find its balance by a motion that is small beside the hollow.
constexpr double hollow_resistance = 0.5 * neutral_motion_fraction;

/// Force along the normal at a point, and its moment about a center: times (translation, rotation) about it, the motion that it
/// resists.
using Wrench = std::array<double, 3>;

/// Where a side's motions turn about.
Vec2 center_of(const PartSystem& part) {
    return part.free_motions.empty() ? Vec2(0, 0) : part.free_motions.front().center;
}

/// A part's free motions by column: (translation, rotation) about the center.
Eigen::Matrix3Xd free_twists(const PartSystem& part) {
    Eigen::Matrix3Xd twists(3, static_cast<Index>(part.free_motions.size()));
    for (Index k = 0; k < twists.cols(); ++k) {
        const RigidMotion& motion = part.free_motions[static_cast<std::size_t>(k)];
        twists.col(k) << motion.at(center_of(part)), motion.rotation;
    }
    return twists;
}

/// Sums of weight times products of the wrenches of two sides, over the points of an interface.
struct WrenchProducts {
    Eigen::Matrix3d first = Eigen::Matrix3d::Zero(), both = first, second = first;
    double weight = 0;
};

void add_product(double weight, const Wrench& a, const Wrench& b, Eigen::Matrix3d& sum) {
    for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 3; ++i) sum(i, j) += weight * a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
}

/// normals: of a point, outward of each body.
template <class Normals>
WrenchProducts wrench_products(const AssemblyProblem& problem, std::size_t face, Normals normals) {
    const Interface& f = problem.interfaces[face];
    const PartSystem &first = problem.parts[static_cast<std::size_t>(f.part[0])],
                     &second = problem.parts[static_cast<std::size_t>(f.part[1])];
    const std::array<Vec2, 2> center{center_of(first), center_of(second)};
    const bool is_first_free = !first.free_motions.empty(), is_second_free = !second.free_motions.empty();
    WrenchProducts sum;
    for (std::size_t q = 0; q < f.points.size(); ++q) {
        const std::array<Vec2, 2> outward = normals(q);
        const auto wrench = [&](std::size_t side) {
            const Vec2 &n = outward[side], &c = center[side], x = f.points[q].x[side] + traction_arm(f, f.points[q], side);
            return Wrench{n.x(), n.y(), (x.x() - c.x()) * n.y() - (x.y() - c.y()) * n.x()};
        };
        const double weight = f.points[q].weight;
        sum.weight += weight;
        const Wrench a = is_first_free ? wrench(0) : Wrench{}, b = is_second_free ? wrench(1) : Wrench{};
        if (is_first_free) add_product(weight, a, a, sum.first);
        if (is_first_free && is_second_free) add_product(weight, a, b, sum.both);
        if (is_second_free) add_product(weight, b, b, sum.second);
    }
    return sum;
}

/// Mean square of the closing along these normals: the first body's motions, then the second's.
MatrixXd mean_square(const AssemblyProblem& problem, const Interface& f, const WrenchProducts& sum) {
    const Eigen::Matrix3Xd a = free_twists(problem.parts[static_cast<std::size_t>(f.part[0])]),
                           b = free_twists(problem.parts[static_cast<std::size_t>(f.part[1])]);
    MatrixXd squared(a.cols() + b.cols(), a.cols() + b.cols());
    squared.topLeftCorner(a.cols(), a.cols()) = a.transpose() * sum.first * a;
    squared.topRightCorner(a.cols(), b.cols()) = a.transpose() * sum.both * b;
    squared.bottomLeftCorner(b.cols(), a.cols()) = squared.topRightCorner(a.cols(), b.cols()).transpose();
    squared.bottomRightCorner(b.cols(), b.cols()) = b.transpose() * sum.second * b;
    return squared / sum.weight;
}

/// Orthonormal basis of the motions with so small a mean square that they are neutral.
MatrixXd neutral_to(const MatrixXd& squared) {
    const SymmetricEigen eigen = symmetric_eigen(squared);
    const Index n = (eigen.values.array() < neutral_motion_fraction * neutral_motion_fraction).count();
    return eigen.vectors.leftCols(n);
}

/// A basis, and what another spans besides; both orthonormal.
MatrixXd joined(const MatrixXd& basis, const MatrixXd& other) {
    if (basis.cols() == 0 || other.cols() == 0) return basis.cols() == 0 ? other : basis;
    const MatrixXd more = motions_beside(basis, other);
    MatrixXd both(basis.rows(), basis.cols() + more.cols());
    both << basis, more;
    return both;
}

/// The motion of a basis that turns the bodies against each other, but for what another basis has of it; zero where none does.
/// Lines that meet in a point leave a turn about it free at first, but a body that turns in a hollow rises: it is held as soon
/// as it moves.
VectorXd turn_in_hollow(const AssemblyProblem& problem, const Interface& f, const MatrixXd& basis, const MatrixXd& own) {
    const Eigen::Matrix3Xd a = free_twists(problem.parts[static_cast<std::size_t>(f.part[0])]),
                           b = free_twists(problem.parts[static_cast<std::size_t>(f.part[1])]);
    VectorXd turn(a.cols() + b.cols());
    if (a.cols() > 0) turn.head(a.cols()) = a.row(2).transpose();
    if (b.cols() > 0) turn.tail(b.cols()) = -b.row(2).transpose();
    VectorXd motion = basis * (basis.transpose() * turn);
    if (motion.norm() <= same_motion * turn.norm()) return VectorXd::Zero(turn.size());
    motion.normalize();
    motion -= own * (own.transpose() * motion);
    return motion.norm() > same_motion ? motion.normalized() : VectorXd::Zero(turn.size());
}

/// What an interface resists of a motion: its closing along the lines that forces act on, but for the motions that leave these
/// as they are, and those in which a body's own outline slides in itself.
Resistance pair_resistance(const AssemblyProblem& problem, std::size_t face) {
    const Interface& f = problem.interfaces[face];
    const MatrixXd acting = mean_square(problem, f, wrench_products(problem, face, [&](std::size_t q) {
                                            return std::array<Vec2, 2>{f.points[q].normal[0], Vec2(-f.points[q].normal[1])};
                                        }));
    if (f.bilateral) return {acting, acting};
    const MatrixXd own =
        mean_square(problem, f, wrench_products(problem, face, [&](std::size_t q) { return problem.own_normals[face][q]; }));
    const MatrixXd across = neutral_to(acting), in_outline = neutral_to(own), neutral = joined(in_outline, across);
    if (neutral.cols() == 0) return {acting, acting};
    const MatrixXd resisted = MatrixXd::Identity(acting.rows(), acting.cols()) - neutral * neutral.transpose();
    const VectorXd held = hollow_resistance * turn_in_hollow(problem, f, across, in_outline);
    return {resisted * acting * resisted + held * held.transpose(), acting};
}

/// Amplitudes of an interface's motions.
std::vector<Index> amplitudes_of(const Interface& face, const std::vector<Index>& offset) {
    std::vector<Index> list;
    for (int part : face.part)
        for (Index k = offset[static_cast<std::size_t>(part)]; k < offset[static_cast<std::size_t>(part) + 1]; ++k)
            list.push_back(k);
    return list;
}

/// Of the neutral motions those in which contact forces have levers, scaled to levers of one.
MatrixXd balanced_motions(const Resistance& resistance, const MatrixXd& neutral) {
    if (neutral.cols() == 0) return neutral;
    const MatrixXd levers = neutral.transpose() * resistance.acting * neutral;
    const SymmetricEigen eigen = symmetric_eigen(levers);
    MatrixXd balanced(neutral.rows(), 0);
    for (Index k = 0; k < neutral.cols(); ++k) {
        const VectorXd motion = neutral * eigen.vectors.col(k);
        const double lever = std::sqrt(std::max(0.0, eigen.values[k])),
                     left = std::sqrt(std::max(0.0, motion.dot(resistance.contact * motion)));
        if (lever <= std::max(least_lever, clear_lever * left)) continue;
        balanced.conservativeResize(Eigen::NoChange, balanced.cols() + 1);
        balanced.rightCols(1) = motion / lever;
    }
    return balanced;
}

/// Of the largest resistance: couplings between amplitudes below are rounding.
constexpr double coupling_rounding = 1e-14;

/// Amplitudes that hang together by what resists their motions, ascending.
std::vector<std::vector<Index>> coupled_amplitudes(const MatrixXd& squared) {
    const Index n = squared.cols();
    if (n == 0) return {};
    const double least = coupling_rounding * squared.diagonal().maxCoeff();
    std::vector<std::vector<Index>> sets;
    std::vector<char> found(static_cast<std::size_t>(n), 0);
    for (Index first = 0; first < n; ++first) {
        if (std::exchange(found[static_cast<std::size_t>(first)], 1)) continue;
        std::vector<Index> set{first};
        for (std::size_t next = 0; next < set.size(); ++next)
            for (Index i = 0; i < n; ++i)
                if (std::abs(squared(i, set[next])) > least && !std::exchange(found[static_cast<std::size_t>(i)], 1))
                    set.push_back(i);
        std::sort(set.begin(), set.end());
        sets.push_back(std::move(set));
    }
    return sets;
}

/// Columns of motions that come one after the other, of n amplitudes at most.
class Motions {
public:
    explicit Motions(Index n) : motions_(n, n) {}
    void add(const MatrixXd& more) {
        motions_.middleCols(count_, more.cols()) = more;
        count_ += more.cols();
    }
    MatrixXd all() const { return motions_.leftCols(count_); }

private:
    MatrixXd motions_;
    Index count_ = 0;
};

/// What is resisted of each part's own motions, alone, which stay its own: rows of contact are then of two parts' motions. What
/// is not is neutral whatever the others do.
MatrixXd resisted_by_part(const std::vector<Index>& offset, const MatrixXd& squared, double limit, Motions& neutral) {
    Motions resisted(squared.cols());
    for (std::size_t i = 0; i + 1 < offset.size(); ++i) {
        const Index first = offset[i], size = offset[i + 1] - first;
        if (size == 0) continue;
        const MatrixXd block = squared.block(first, first, size, size);
        MatrixXd own = MatrixXd::Zero(squared.rows(), size);
        own.middleRows(first, size).setIdentity();
        if (Cholesky(block - limit * MatrixXd::Identity(size, size)).succeeded()) {
            resisted.add(own);
            continue;
        }
        const SingularVectors motions = right_singular_vectors(block);
        own.middleRows(first, size) = motions.vectors;
        const Index kept = (motions.values.array() >= limit).count();
        resisted.add(own.leftCols(kept));
        neutral.add(own.rightCols(size - kept));
    }
    return resisted.all();
}

/// The motions in which any of the rows moves.
std::vector<Index> moving_rows(const MatrixXd& modes, const MatrixXd& motions) {
    const MatrixXd moved = times_few(modes, motions);
    std::vector<Index> moving;
    for (Index k = 0; k < motions.cols(); ++k)
        if (!moved.col(k).isZero(0)) moving.push_back(k);
    return moving;
}

}  // namespace

MatrixXd motions_beside(const MatrixXd& others, const MatrixXd& motions) {
    if (others.cols() == 0 || motions.cols() == 0) return motions;
    const SingularVectors rest = left_singular_vectors(motions - others * (others.transpose() * motions));
    return rest.vectors.leftCols((rest.values.array() > same_motion).count());
}

Resistance candidate_resistance(const AssemblyProblem& problem) {
    return resistance_of(problem, std::vector<char>(problem.interfaces.size(), 1));
}

Resistance resistance_of(const AssemblyProblem& problem, const std::vector<char>& interfaces) {
    ENSURE(interfaces.size() == problem.interfaces.size(), "an interface counts or not");
    const std::vector<Index> offset = mode_offsets(problem.parts);
    Resistance sum{MatrixXd::Zero(offset.back(), offset.back()), MatrixXd::Zero(offset.back(), offset.back())};
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        const std::vector<Index> amplitude = amplitudes_of(problem.interfaces[f], offset);
        const std::array<int, 2>& between = problem.interfaces[f].part;
        if (!interfaces[f] || problem.interfaces[f].points.empty() || amplitude.empty() || between[0] == between[1]) continue;
        const Resistance pair = pair_resistance(problem, f);
        sum.contact(amplitude, amplitude) += pair.contact;
        sum.acting(amplitude, amplitude) += pair.acting;
    }
    return sum;
}

MotionSplit split_motions(const AssemblyProblem& problem, const Resistance& resistance, const MatrixXd& modes) {
    const Index n = modes.cols();
    if (n == 0) return {MatrixXd(0, 0), MatrixXd(0, 0), MatrixXd(0, 0)};
    const auto held = modes.bottomRows(static_cast<Index>(problem.constraints.size()));
    const MatrixXd squared = resistance.contact + held.transpose() * held;
    const double limit = neutral_motion_fraction * neutral_motion_fraction;
    Motions resisted(n), neutral(n);
    const MatrixXd left = resisted_by_part(mode_offsets(problem.parts), squared, limit, neutral);
    const MatrixXd of_left = left.transpose() * squared * left;
    for (const std::vector<Index>& own : coupled_amplitudes(of_left)) {
        const auto size = static_cast<Index>(own.size());
        const MatrixXd block = of_left(own, own), motions = left(Eigen::all, own);
        if (Cholesky(block - limit * MatrixXd::Identity(size, size)).succeeded()) {
            resisted.add(motions);
            continue;
        }
        // Jacobi's rotations leave motions that hardly anything couples apart: one part's stays one part's among equal values
        const SingularVectors combined = right_singular_vectors(block);
        const Index kept = (combined.values.array() >= limit).count();
        resisted.add(motions * combined.vectors.leftCols(kept));
        neutral.add(motions * combined.vectors.rightCols(size - kept));
    }
    const MatrixXd neutral_ones = neutral.all(), with_rows = neutral_ones(Eigen::all, moving_rows(modes, neutral_ones));
    const MatrixXd resisted_ones = neutral_ones.cols() == 0 ? MatrixXd::Identity(n, n) : resisted.all();
    return {resisted_ones(Eigen::all, moving_rows(modes, resisted_ones)), neutral_ones,
            balanced_motions(resistance, with_rows)};
}

std::vector<PartMotion> part_motions(const std::vector<PartSystem>& parts, const VectorXd& amplitudes) {
    const std::vector<Index> offset = mode_offsets(parts);
    constexpr double notable = 1e-3;
    std::vector<PartMotion> result;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = amplitudes.segment(offset[i], offset[i + 1] - offset[i]);
        if (share.size() == 0 || share.norm() < notable * amplitudes.norm()) continue;
        result.push_back({static_cast<int>(i), sum_of_motions(parts[i].free_motions, share)});
    }
    return result;
}

void find_driven_neutral_motion(const AssemblyProblem& problem, const Resistance& resistance, const MatrixXd& neutral,
                                const VectorXd& mode_load, double load_scale, AssemblySolution& solution) {
    VectorXd work = neutral.transpose() * mode_load;
    for (Index k = 0; k < neutral.cols(); ++k) {
        const double left = std::sqrt(std::max(0.0, neutral.col(k).dot(resistance.contact * neutral.col(k))));
        if (std::abs(work[k]) <= (neutral_work_fraction + left) * load_scale) work[k] = 0;
    }
    if (!work.isZero(0)) {
        solution.mechanism = part_motions(problem.parts, neutral * work);
        return;
    }
    for (Index k = 0; k < neutral.cols(); ++k)
        for (const PartMotion& m : part_motions(problem.parts, neutral.col(k))) solution.neutral.push_back(m);
}

NeutralMeasure neutral_measure(const AssemblyProblem& problem, const MatrixXd& neutral, int threads) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    const auto motions_of = [&](std::size_t i) { return neutral.middleRows(offset[i], offset[i + 1] - offset[i]); };
    NeutralMeasure measure{{}, MatrixXd::Zero(neutral.cols(), neutral.cols())};
    measure.integrals.resize(problem.parts.size());
    parallel_for(static_cast<int>(problem.parts.size()), threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        if (!motions_of(i).isZero(0)) measure.integrals[i] = motion_integrals(problem.parts[i]);
    });
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const auto own = motions_of(i);
        if (measure.integrals[i].size() == 0) continue;
        const MatrixXd of_part = measure.integrals[i].transpose() * problem.parts[i].modes;
        // motions are those of few parts
        std::vector<Index> moving;
        for (Index k = 0; k < own.cols(); ++k)
            if (!own.col(k).isZero(0)) moving.push_back(k);
        const MatrixXd shares = own(Eigen::all, moving);
        measure.gram(moving, moving) += shares.transpose() * of_part * shares;
    }
    return measure;
}

namespace {

/// The motions of parts that are displaced, and of those that hang together with them by a motion: the others stay.
std::vector<Index> of_displaced_parts(const std::vector<Index>& offset, const MatrixXd& motions,
                                      const std::vector<VectorXd>& displacement) {
    std::vector<char> is_displaced;
    for (const VectorXd& u : displacement) is_displaced.push_back(!u.isZero(0));
    std::vector<char> taken(static_cast<std::size_t>(motions.cols()), 0);
    const auto moves = [&](Index motion, std::size_t part) {
        return !motions.col(motion).segment(offset[part], offset[part + 1] - offset[part]).isZero(0);
    };
    for (bool grows = true; grows;) {
        grows = false;
        for (Index k = 0; k < motions.cols(); ++k) {
            if (taken[static_cast<std::size_t>(k)]) continue;
            std::vector<std::size_t> parts;
            for (std::size_t i = 0; i < is_displaced.size(); ++i)
                if (moves(k, i)) parts.push_back(i);
            if (std::none_of(parts.begin(), parts.end(), [&](std::size_t i) { return is_displaced[i] != 0; })) continue;
            taken[static_cast<std::size_t>(k)] = grows = true;
            for (const std::size_t i : parts) is_displaced[i] = 1;
        }
    }
    std::vector<Index> list;
    for (Index k = 0; k < motions.cols(); ++k)
        if (taken[static_cast<std::size_t>(k)]) list.push_back(k);
    return list;
}

}  // namespace

VectorXd pull_of(const AssemblyProblem& problem, const NeutralMeasure& measure, const MatrixXd& neutral,
                 const std::vector<VectorXd>& displacement) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    VectorXd pull = VectorXd::Zero(neutral.cols());
    for (std::size_t i = 0; i < problem.parts.size(); ++i)
        if (measure.integrals[i].size() > 0)
            pull -= neutral.middleRows(offset[i], offset[i + 1] - offset[i]).transpose() *
                    (measure.integrals[i].transpose() * displacement[i]);
    return pull;
}

VectorXd least_amplitudes(const std::vector<PartSystem>& parts, const std::vector<VectorXd>& displacement) {
    const std::vector<Index> offset = mode_offsets(parts);
    VectorXd amplitudes = VectorXd::Zero(offset.back());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].modes.cols() == 0 || displacement[i].isZero(0)) continue;
        const MatrixXd& integrals = motion_integrals(parts[i]);
        amplitudes.segment(offset[i], parts[i].modes.cols()) =
            -PivotedCholesky(integrals.transpose() * parts[i].modes).solve(integrals.transpose() * displacement[i]);
    }
    return amplitudes;
}

void add_rigid_motions(const AssemblyProblem& problem, const VectorXd& amplitudes, AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartSystem& part = problem.parts[i];
        if (part.modes.cols() > 0) solution.displacement[i] += part.modes * amplitudes.segment(offset[i], part.modes.cols());
    }
}

void take_least_motion(const AssemblyProblem& problem, const MatrixXd& all, int threads, AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    const MatrixXd neutral = all(Eigen::all, of_displaced_parts(offset, all, solution.displacement));
    if (neutral.cols() == 0) return;
    const NeutralMeasure measure = neutral_measure(problem, neutral, threads);
    const VectorXd pull = pull_of(problem, measure, neutral, solution.displacement);
    add_rigid_motions(problem, neutral * PivotedCholesky(measure.gram).solve(pull), solution);
}

}  // namespace abut::solver
