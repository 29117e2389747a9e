// SPDX-License-Identifier: GPL-3.0-or-later
// Steps: rows of interfaces and constraints -> per part, forward solves of its rows -> C, g, G, h -> neutral motions left out
// -> the contact QP -> displacements.
#include "solver/assembly_solve.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Pressures may change by this fraction in making up for the neutral motions' balance.
constexpr double largest_rebalancing = 0.02;

/// Where each part's free motions stand among the amplitudes.
std::vector<Index> mode_offsets(const std::vector<PartSystem>& parts) {
    std::vector<Index> offset{0};
    for (const PartSystem& p : parts) offset.push_back(offset.back() + p.modes.cols());
    return offset;
}

/// The rows of one part, numbered among themselves.
struct LocalRows {
    std::vector<int> global;
    Eigen::SparseMatrix<double> columns;  // (kept unknowns x rows): D' of the part
};

LocalRows local_rows(const PartSystem& part, const std::vector<RowEntry>& entries) {
    LocalRows local;
    for (const RowEntry& e : entries) local.global.push_back(e.row);
    std::sort(local.global.begin(), local.global.end());
    local.global.erase(std::unique(local.global.begin(), local.global.end()), local.global.end());
    std::vector<Eigen::Triplet<double>> kept;
    for (const RowEntry& e : entries) {
        const int unknown = part.number[static_cast<std::size_t>(e.coefficient)];
        const auto column = std::lower_bound(local.global.begin(), local.global.end(), e.row) - local.global.begin();
        if (unknown >= 0) kept.emplace_back(unknown, static_cast<int>(column), e.value);
    }
    local.columns.resize(part.n_kept, static_cast<Index>(local.global.size()));
    local.columns.setFromTriplets(kept.begin(), kept.end());
    return local;
}

VectorXd rows_times(const std::vector<RowEntry>& entries, const VectorXd& u, int n_rows) {
    VectorXd v = VectorXd::Zero(n_rows);
    for (const RowEntry& e : entries) v[e.row] += e.value * u[e.coefficient];
    return v;
}

VectorXd transposed_times(const std::vector<RowEntry>& entries, const VectorXd& multipliers, int n) {
    VectorXd f = VectorXd::Zero(2 * n);
    for (const RowEntry& e : entries) f[e.coefficient] += e.value * multipliers[e.row];
    return f;
}

/// C, g, G, h before scaling, with the rows that they belong to.
ContactQp condense(const AssemblyProblem& problem, const Rows& rows) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    const Index m = rows.n, n = offset.back();
    ContactQp qp{MatrixXd::Zero(m, m), rows.gap0, MatrixXd::Zero(m, n), VectorXd::Zero(n), rows.unilateral,
                 VectorXd::Zero(m),    rows.gap0, problem.load_scale};
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartSystem& part = problem.parts[i];
        const Index n_modes = part.modes.cols();
        if (n_modes > 0) {
            qp.mode_load.segment(offset[i], n_modes) = part.modes.transpose() * part.load;
            // prescribed displacements load a part, too: what their entries add up from is the scale of their rounding
            qp.load_scale = std::max(qp.load_scale, (part.modes.cwiseAbs().transpose() * part.load.cwiseAbs()).maxCoeff());
        }
        if (rows.by_part[i].empty()) continue;
        qp.gap += rows_times(rows.by_part[i], solve(part, part.load), rows.n);
        for (Index k = 0; k < n_modes; ++k)
            qp.modes.col(offset[i] + k) = rows_times(rows.by_part[i], part.modes.col(k), rows.n);
        const LocalRows local = local_rows(part, rows.by_part[i]);
        const MatrixXd c = part.factor.inverse_form(local.columns);
        for (std::size_t a = 0; a < local.global.size(); ++a)
            for (std::size_t b = 0; b < local.global.size(); ++b)
                qp.compliance(local.global[a], local.global[b]) += c(static_cast<Index>(a), static_cast<Index>(b));
    }
    qp.compliance.diagonal().head(rows.softness.size()) += rows.softness;
    return qp;
}

/// Rows as mean gaps, multipliers as forces: C and G of comparable entries whatever the spacing of the multipliers.
void scale_rows(ContactQp& qp, const VectorXd& weight) {
    const VectorXd s = weight.cwiseInverse();
    qp.compliance = s.asDiagonal() * qp.compliance * s.asDiagonal();
    qp.gap = s.cwiseProduct(qp.gap);
    qp.drawn_gap = s.cwiseProduct(qp.drawn_gap);
    qp.modes = s.asDiagonal() * qp.modes;
}

void add_foundation(ContactQp& qp, const AssemblyProblem& problem, const std::vector<int>& first_row, const VectorXd& weight) {
    double stiffest = 0;
    for (std::size_t i = 0; i < problem.interfaces.size(); ++i)
        for (int k = 0; k < n_rows(problem.interfaces[i]); ++k) {
            const Index row = first_row[i] + k;
            qp.foundation[row] = problem.foundation[i] * weight[row];
            stiffest = std::max(stiffest, qp.foundation[row]);
        }
    for (Index row = 0; row < qp.foundation.size(); ++row)
        if (!qp.unilateral[static_cast<std::size_t>(row)]) qp.foundation[row] = stiffest > 0 ? stiffest : 1.0;
}

/// How the candidates resist the free motions along the bodies' own normals: root-mean-square over each interface; constraints
/// as they are. (rows x amplitudes)
MatrixXd resistance(const AssemblyProblem& problem, const ContactQp& qp, Index n_modes) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    Index n_rows = 0;
    for (const Interface& face : problem.interfaces) n_rows += static_cast<Index>(face.points.size());
    MatrixXd r = MatrixXd::Zero(n_rows + static_cast<Index>(problem.constraints.size()), n_modes);
    Index row = 0;
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f) {
        const Interface& face = problem.interfaces[f];
        double total = 0;
        for (const InterfacePoint& p : face.points) total += p.weight;
        for (std::size_t q = 0; q < face.points.size(); ++q, ++row)
            for (std::size_t side = 0; side < 2; ++side) {
                const auto part = static_cast<std::size_t>(face.part[side]);
                const auto& motions = problem.parts[part].free_motions;
                for (std::size_t k = 0; k < motions.size(); ++k)
                    r(row, offset[part] + static_cast<Index>(k)) +=
                        std::sqrt(face.points[q].weight / total) *
                        -problem.own_normals[f][q][side].dot(motions[k].at(face.points[q].x[side]));
            }
    }
    r.bottomRows(static_cast<Index>(problem.constraints.size())) =
        qp.modes.bottomRows(static_cast<Index>(problem.constraints.size()));
    return r;
}

/// Orthonormal bases of the motions that something resists, and of the neutral ones.
struct MotionSplit {
    MatrixXd resisted, neutral;
};

MotionSplit split_motions(const MatrixXd& resistance) {
    const Index n = resistance.cols();
    if (n == 0) return {MatrixXd(0, 0), MatrixXd(0, 0)};
    if (resistance.rows() == 0 || resistance.isZero(0)) return {MatrixXd(n, 0), MatrixXd::Identity(n, n)};
    const Eigen::JacobiSVD<MatrixXd> svd(resistance.transpose() * resistance, Eigen::ComputeFullV);
    // eigenvalues of R'R: squares of the singular values of R
    const double limit = neutral_motion_fraction * neutral_motion_fraction * svd.singularValues()[0];
    Index kept = 0;
    while (kept < n && svd.singularValues()[kept] >= limit) ++kept;
    return {svd.matrixV().leftCols(kept), svd.matrixV().rightCols(n - kept)};
}

/// Motion of every part that takes a notable share in a combination of the free motions.
std::vector<PartMotion> part_motions(const std::vector<PartSystem>& parts, const VectorXd& amplitudes) {
    const std::vector<Index> offset = mode_offsets(parts);
    constexpr double notable = 1e-3;
    std::vector<PartMotion> result;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = amplitudes.segment(offset[i], offset[i + 1] - offset[i]);
        if (share.size() == 0 || share.norm() < notable * amplitudes.norm()) continue;
        PartMotion m{static_cast<int>(i), {{0, 0}, 0, parts[i].free_motions[0].center}};
        for (Index k = 0; k < share.size(); ++k) {
            const RigidMotion& unit = parts[i].free_motions[static_cast<std::size_t>(k)];
            m.motion.translation += share[k] * unit.translation;
            m.motion.rotation += share[k] * unit.rotation;
        }
        result.push_back(m);
    }
    return result;
}

void find_driven_neutral_motion(const AssemblyProblem& problem, const MatrixXd& neutral, const VectorXd& mode_load,
                                AssemblySolution& solution) {
    const VectorXd work = neutral.transpose() * mode_load;
    if (work.size() > 0 && work.cwiseAbs().maxCoeff() > neutral_work_fraction * problem.load_scale)
        solution.mechanism = part_motions(problem.parts, neutral * work);
    else
        for (Index k = 0; k < neutral.cols(); ++k)
            for (const PartMotion& m : part_motions(problem.parts, neutral.col(k))) solution.neutral.push_back(m);
}

/// Pairs act along the normal of the middle curve, not along a round part's own: with the neutral motions left out, their
/// balance is off by what that difference does (1e-8 to 1e-5 of the load). Where the pressures can make up for it, they do so
/// with the neutral motions as unknowns; their amplitudes, which mean nothing, are taken out again by take_least_motion.
bool balance_neutral_motions(const ContactQp& whole, const MotionSplit& split, ContactQp& qp, ContactQpResult& result,
                             MatrixXd& held) {
    const MatrixXd lever = whole.modes * split.neutral;
    constexpr double least_lever = 1e-6;  // of unit motion at the part's size: below, contact cannot turn the part at all
    std::vector<Index> some;
    for (Index k = 0; k < lever.cols(); ++k)
        if (lever.rows() > 0 && lever.col(k).cwiseAbs().maxCoeff() > least_lever) some.push_back(k);
    if (some.empty()) return false;
    MatrixXd all(held.rows(), held.cols() + static_cast<Index>(some.size()));
    all << held, split.neutral(Eigen::all, some);
    ContactQp full = whole;
    full.modes = whole.modes * all;
    full.mode_load = all.transpose() * whole.mode_load;
    ContactQpResult balanced = solve_contact_qp(full);
    balanced.iterations += result.iterations;
    if (!balanced.feasible || !balanced.converged) return false;
    const double change = (balanced.multipliers - result.multipliers).cwiseAbs().sum();
    if (change > largest_rebalancing * result.multipliers.cwiseAbs().sum()) return false;
    result = std::move(balanced);
    qp = std::move(full);
    held = std::move(all);
    return true;
}

/// The neutral motions' amplitudes that make the displacement least (in the coefficients).
void take_least_motion(const AssemblyProblem& problem, const MatrixXd& neutral, AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    if (neutral.cols() == 0) return;
    MatrixXd gram = MatrixXd::Zero(neutral.cols(), neutral.cols());
    VectorXd rhs = VectorXd::Zero(neutral.cols());
    std::vector<MatrixXd> motion;
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        motion.push_back(problem.parts[i].modes * neutral.middleRows(offset[i], offset[i + 1] - offset[i]));
        gram += motion.back().transpose() * motion.back();
        rhs -= motion.back().transpose() * solution.displacement[i];
    }
    const VectorXd amplitude = gram.ldlt().solve(rhs);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) solution.displacement[i] += motion[i] * amplitude;
}

/// Loads, and displacements without the rigid motions.
void recover_displacements(const AssemblyProblem& problem, const Rows& rows, const VectorXd& multipliers,
                           AssemblySolution& solution) {
    solution.contact_load.clear();
    solution.load.clear();
    solution.displacement.clear();
    VectorXd contact_only = multipliers;
    contact_only.tail(static_cast<Index>(problem.constraints.size())).setZero();
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartSystem& part = problem.parts[i];
        solution.contact_load.push_back(transposed_times(rows.by_part[i], contact_only, part.n()));
        solution.load.push_back(part.load + transposed_times(rows.by_part[i], multipliers, part.n()));
        solution.displacement.push_back(solve(part, solution.load.back()));
    }
}

void add_rigid_motions(const AssemblyProblem& problem, const VectorXd& amplitudes, AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartSystem& part = problem.parts[i];
        if (part.modes.cols() > 0) solution.displacement[i] += part.modes * amplitudes.segment(offset[i], part.modes.cols());
    }
}

/// What the refinement changes. The settled amplitudes stay: all else is small against them where there is clearance.
struct ContactAnswer {
    VectorXd forces;  // multipliers of the scaled rows
    VectorXd settled, motion;
};

/// What displacements (without rigid motions) and forces leave of the gaps and of the balance.
struct Remainder {
    VectorXd gap, load;
};
Remainder remainder_of(const AssemblyProblem& problem, const Rows& rows, const ContactQp& qp, const MatrixXd& held,
                       const ContactAnswer& answer, const AssemblySolution& solution) {
    const std::vector<Index> offset = mode_offsets(problem.parts);
    VectorXd opening = VectorXd::Zero(rows.n), load = VectorXd::Zero(offset.back());
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        opening += rows_times(rows.by_part[i], solution.displacement[i], rows.n);
        load.segment(offset[i], offset[i + 1] - offset[i]) = problem.parts[i].modes.transpose() * solution.load[i];
    }
    const Index soft = rows.softness.size();
    opening.head(soft) += rows.softness.cwiseProduct(answer.forces.cwiseQuotient(rows.weight).head(soft));
    const VectorXd settled_gap = qp.drawn_gap + qp.modes * answer.settled;
    return {settled_gap + opening.cwiseQuotient(rows.weight) + qp.modes * answer.motion, held.transpose() * load};
}

/// Displacements under the contact forces, with one step of iterative refinement: what they leave of closed gaps and of
/// equilibrium is the right-hand side of a correction. It takes out the rounding of C and of the pinned solutions, where the
/// active set holds every motion.
void recover_refined(const AssemblyProblem& problem, const Rows& rows, const MatrixXd& held, const ContactQp& qp,
                     const ContactQpResult& result, ContactAnswer& answer, AssemblySolution& solution) {
    recover_displacements(problem, rows, answer.forces.cwiseQuotient(rows.weight), solution);
    Remainder left = remainder_of(problem, rows, qp, held, answer, solution);
    ContactQp correction = qp;
    correction.gap = left.gap;
    correction.mode_load = left.load;
    VectorXd forces, motion;
    if (solve_on_set(correction, result.active, forces, motion)) {
        answer.forces += forces;
        answer.motion += motion;
        recover_displacements(problem, rows, answer.forces.cwiseQuotient(rows.weight), solution);
        left = remainder_of(problem, rows, qp, held, answer, solution);
    }
    solution.residual = contact_residual(qp, {answer.forces, left.gap, left.load});
}

}  // namespace

AssemblySolution solve_assembly(const AssemblyProblem& problem) {
    AssemblySolution solution;
    std::vector<int> first_row;
    Rows rows = interface_rows(problem.parts, problem.interfaces, first_row);
    for (const MeanConstraint& c : problem.constraints)
        append_mean_constraint(rows, problem.parts[static_cast<std::size_t>(c.part)], c.part, c.integrals, c.area,
                               c.coefficient, c.size, c.value);
    solution.n_multipliers = rows.n;

    ContactQp qp = condense(problem, rows);
    scale_rows(qp, rows.weight);
    add_foundation(qp, problem, first_row, rows.weight);
    const MotionSplit split = split_motions(resistance(problem, qp, qp.modes.cols()));
    find_driven_neutral_motion(problem, split.neutral, qp.mode_load, solution);
    if (!solution.mechanism.empty()) return solution;
    const ContactQp whole = qp;
    qp.modes = qp.modes * split.resisted;
    qp.mode_load = split.resisted.transpose() * qp.mode_load;

    ContactQpResult result = solve_contact_qp(qp);
    MatrixXd held = split.resisted;
    if (result.feasible && result.converged && split.neutral.cols() > 0 &&
        !balance_neutral_motions(whole, split, qp, result, held)) {
        const VectorXd work = split.neutral.transpose() * (whole.mode_load + whole.modes.transpose() * result.multipliers);
        const double scale = std::max(problem.load_scale, result.multipliers.cwiseAbs().sum());
        solution.driven_work = work.cwiseAbs().maxCoeff() / scale;
        if (solution.driven_work > driven_work_fraction) {
            solution.neutral.clear();
            solution.driven = part_motions(problem.parts, split.neutral * work);
        }
    }
    solution.iterations = result.iterations;
    solution.converged = result.converged;
    solution.used_fallback = result.used_fallback;
    if (!result.feasible) {
        solution.mechanism = part_motions(problem.parts, split.resisted * result.mechanism);
        return solution;
    }
    ContactAnswer answer{result.multipliers, result.settled, result.motion};
    recover_refined(problem, rows, held, qp, result, answer, solution);
    add_rigid_motions(problem, held * (answer.settled + answer.motion), solution);
    const VectorXd multipliers = answer.forces.cwiseQuotient(rows.weight);
    take_least_motion(problem, split.neutral, solution);
    for (std::size_t f = 0; f < problem.interfaces.size(); ++f)
        solution.pressure.push_back(
            all_coefficients(problem.interfaces[f], multipliers.segment(first_row[f], n_rows(problem.interfaces[f]))));
    for (std::size_t c = 0; c < problem.constraints.size(); ++c)
        solution.constraint_force.push_back(multipliers[rows.n - static_cast<Index>(problem.constraints.size() - c)]);
    return solution;
}

}  // namespace abut::solver
