// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/mirrored_solution.hpp"

#include <Eigen/Cholesky>
#include <chrono>
#include <cmath>
#include <tuple>
#include <utility>

#include "solver/contact/condensation.hpp"
#include "solver/contact/mirrored_rows.hpp"
#include "solver/contact/neutral_motions.hpp"
#include "solver/linear_algebra/index.hpp"
#include "solver/parts/fold.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const PartMirror& mirror_of(const PartSystem& part) {
    return *part.input.mirror;
}

/// The leaders stand for two parts, their unknowns for sqrt(2) times their displacements, a unit of their motions for half a
/// unit of either part's: forces do the work in it that they do in one part's own. The constraints that are left.
class Folded {
public:
    Folded(AssemblyProblem& problem, const FoldedRows& rows) : problem_(problem), constraints_(problem.constraints) {
        const std::size_t first = rows.kept.size() - constraints_.size();
        problem.constraints.clear();
        for (std::size_t k = 0; k < constraints_.size(); ++k)
            if (rows.kept[first + k]) problem.constraints.push_back(constraints_[k]);
        for (PartSystem& part : problem.parts) {
            saved_.push_back({part.load, part.prescribed, part.modes});
            if (mirror_of(part).role != MirrorRole::leader) continue;
            part.modes *= std::sqrt(0.5);
            part.load *= std::sqrt(2.0);
            part.prescribed *= std::sqrt(2.0);
        }
    }
    Folded(const Folded&) = delete;
    Folded& operator=(const Folded&) = delete;
    ~Folded() {
        problem_.constraints = std::move(constraints_);
        for (std::size_t i = 0; i < saved_.size(); ++i)
            std::tie(problem_.parts[i].load, problem_.parts[i].prescribed, problem_.parts[i].modes) = std::move(saved_[i]);
    }

private:
    AssemblyProblem& problem_;
    std::vector<MeanConstraint> constraints_;
    std::vector<std::tuple<VectorXd, VectorXd, MatrixXd>> saved_;
};

VectorXd unfolded(const VectorXd& multipliers, const FoldedRows& rows) {
    VectorXd whole = VectorXd::Zero(static_cast<Index>(rows.folded.size()));
    for (std::size_t r = 0; r < rows.folded.size(); ++r)
        if (rows.folded[r] >= 0) whole[static_cast<Index>(r)] = rows.sign[r] * multipliers[rows.folded[r]];
    return whole;
}

void unfold_displacements(const AssemblyProblem& problem, AssemblySolution& solution) {
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartMirror& mirror = mirror_of(problem.parts[i]);
        if (mirror.role != MirrorRole::leader) continue;
        solution.displacement[i] *= std::sqrt(0.5);
        solution.displacement[at(mirror.image)] = mirrored(mirror, solution.displacement[i]);
    }
}

/// The same motions of the leaders' images.
void append_images(const AssemblyProblem& problem, std::vector<PartMotion>& motions) {
    const std::size_t n = motions.size();
    for (std::size_t k = 0; k < n; ++k) {
        const PartMirror& mirror = mirror_of(problem.parts[at(motions[k].part)]);
        if (mirror.role != MirrorRole::leader) continue;
        PartMotion image{mirror.image, motions[k].motion};
        image.motion.translation[mirror.place.axis] *= -1;
        image.motion.rotation *= -1;
        image.motion.center = mirror.place(motions[k].motion.center);
        motions.push_back(image);
    }
}

/// The systems' free motions are all of them meanwhile, not the symmetric ones alone.
class AllMotions {
public:
    explicit AllMotions(AssemblyProblem& problem) : problem_(problem) {
        for (PartSystem& part : problem.parts) {
            std::swap(part.free_motions, part.all_free_motions);
            MatrixXd modes = coefficients_of(part.input.space, part.free_motions);
            std::swap(part.modes, modes);
            symmetric_.push_back(std::move(modes));
        }
    }
    AllMotions(const AllMotions&) = delete;
    AllMotions& operator=(const AllMotions&) = delete;
    ~AllMotions() {
        for (std::size_t i = 0; i < symmetric_.size(); ++i) {
            std::swap(problem_.parts[i].free_motions, problem_.parts[i].all_free_motions);
            problem_.parts[i].modes = std::move(symmetric_[i]);
        }
    }

    /// What constraints make of the motions; zero in the interfaces' rows, which are not read.
    MatrixXd constraint_modes(const Rows& rows) const {
        const std::vector<Index> offset = mode_offsets(problem_.parts);
        MatrixXd modes = MatrixXd::Zero(rows.n, offset.back());
        const int first = rows.n - static_cast<int>(problem_.constraints.size());
        for (std::size_t i = 0; i < problem_.parts.size(); ++i)
            for (const RowEntry& e : rows.by_part[i])
                if (e.row >= first)
                    modes.row(e.row).segment(offset[i], offset[i + 1] - offset[i]) +=
                        e.value / rows.weight[e.row] * problem_.parts[i].modes.row(e.coefficient);
        return modes;
    }

    /// Amplitudes of all motions that one of each symmetric motion is (all x symmetric): a leader's moves its follower, too.
    MatrixXd of_symmetric() const {
        const std::vector<Index> offset = mode_offsets(problem_.parts);
        std::vector<Index> column{0};
        for (const MatrixXd& modes : symmetric_) column.push_back(column.back() + modes.cols());
        MatrixXd all = MatrixXd::Zero(offset.back(), column.back());
        for (std::size_t i = 0; i < problem_.parts.size(); ++i) {
            const PartMirror& mirror = mirror_of(problem_.parts[i]);
            const auto image = at(mirror.image);
            for (Index k = 0; k < symmetric_[i].cols(); ++k) {
                const bool is_pair = mirror.role == MirrorRole::leader;
                const VectorXd field = (is_pair ? 0.5 : 1.0) * symmetric_[i].col(k);
                all.col(column[i] + k).segment(offset[i], offset[i + 1] - offset[i]) = amplitudes(i, field);
                if (!is_pair) continue;
                all.col(column[i] + k).segment(offset[image], offset[image + 1] - offset[image]) =
                    amplitudes(image, mirrored(mirror, field));
            }
        }
        return all;
    }

private:
    /// A rigid motion's share of the part's own.
    VectorXd amplitudes(std::size_t part, const VectorXd& field) const {
        const MatrixXd& modes = problem_.parts[part].modes;
        return (modes.transpose() * modes).ldlt().solve(modes.transpose() * field);
    }

    AssemblyProblem& problem_;
    std::vector<MatrixXd> symmetric_;  // modes
};

/// What resists the symmetric motions, and all the motions that nothing resists.
struct WholeMotions {
    Resistance resistance;
    std::vector<PartMotion> neutral;
};
WholeMotions motions_of(AssemblyProblem& problem, const Rows& rows) {
    const AllMotions motions(problem);
    const Resistance resistance = candidate_resistance(problem);
    const MatrixXd to_all = motions.of_symmetric();
    WholeMotions whole{{to_all.transpose() * resistance.contact * to_all, to_all.transpose() * resistance.acting * to_all}, {}};
    const MotionSplit split = split_motions(problem, resistance, motions.constraint_modes(rows));
    for (Index k = 0; k < split.neutral.cols(); ++k)
        for (const PartMotion& m : part_motions(problem.parts, split.neutral.col(k))) whole.neutral.push_back(m);
    return whole;
}

}  // namespace

MirrorFailure asymmetry_of_parts(const AssemblyProblem& problem) {
    for (std::size_t i = 0; i < problem.parts.size(); ++i) {
        const PartMirror& mirror = mirror_of(problem.parts[i]);
        if (mirror.role == MirrorRole::follower) continue;
        const std::string what = asymmetry_of(problem.parts[i], problem.parts[at(mirror.image)]);
        if (!what.empty()) return {what, static_cast<int>(i), -1};
    }
    return {};
}

MirroredSolution solve_mirrored(AssemblyProblem& problem, int threads) {
    MirroredSolution result;
    const auto begin = std::chrono::steady_clock::now();
    const AssemblyRows whole = assembly_rows(problem);
    const RowImages images = row_images(problem, whole.rows);
    if (images.lonely_parts[0] >= 0) {
        result.failure = {"has no mirror image", images.lonely_parts[0], images.lonely_parts[1]};
        return result;
    }
    const FoldedRows rows = fold_rows(problem, whole, images.image);
    const WholeMotions motions = motions_of(problem, whole.rows);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    RowsSolution answer;
    {
        const Folded folded(problem, rows);
        answer = solve_rows(problem, rows.all, motions.resistance, threads);
    }
    AssemblySolution& solution = result.solution = std::move(answer.solution);
    solution.seconds.rows = result.seconds;
    solution.n_multipliers = whole.rows.n;
    append_images(problem, solution.mechanism);
    if (!solution.mechanism.empty()) return result;
    solution.neutral = motions.neutral;
    const VectorXd multipliers = unfolded(answer.multipliers, rows);
    unfold_displacements(problem, solution);
    for (std::size_t i = 0; i < problem.parts.size(); ++i) set_loads(problem, whole.rows, multipliers, i, solution);
    split_multipliers(problem, whole, multipliers, solution);
    return result;
}

}  // namespace abut::solver
