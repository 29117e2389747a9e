// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/preload.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "solver/contact/independent_groups.hpp"
#include "solver/terms/free_strain.hpp"
#include "src/base/index.hpp"
#include "src/discretization/preload_cut.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int most_solutions = 60;
/// Of the force asked for: forces are a piecewise linear function of shortenings, so that the last step is exact.
constexpr double force_rounding = 1e-9;
/// A force is none below this share of what the part would have if nothing gave way: gaps are still to be closed.
constexpr double open_force = 1e-12;
constexpr double growth = 10;

/// Every cut of the assembly, in the parts' order.
std::vector<PreloadState> cuts_of(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<PreloadState> cuts;
    for (const PartOnGrid& g : solved.grids) {
        int pull = 0;
        for (const Load* load : preloads_on(scene, g.part)) {
            const auto acts = [&](const Load& l) { return l.where == load->where; };
            const auto own = std::find_if(scene.loads.begin(), scene.loads.end(), acts);
            cuts.push_back({solved.solver_part[at(g.part)], pull++, load->across, load->where,
                            own == scene.loads.end() ? 0 : own->value[0].constant()});
        }
    }
    return cuts;
}

/// Takes away all loads but those of the pulls, and what was before, for as long as it lives.
class Unloaded {
public:
    explicit Unloaded(solver::AssemblyProblem& problem) : problem_(problem), constraints_(problem.constraints) {
        for (solver::PartSystem& part : problem.parts) {
            loads_.push_back(part.load);
            prescribed_.push_back(part.prescribed);
            part.load.setZero();
            part.prescribed.setZero();
            for (const solver::Pull& pull : part.pulls) part.load += pull.shortening * pull.load;
        }
        for (solver::MeanConstraint& c : problem.constraints) c.value = 0;
        std::swap(problem.part_load, part_load_);
        std::swap(problem.before, before_);
    }
    Unloaded(const Unloaded&) = delete;
    Unloaded& operator=(const Unloaded&) = delete;
    ~Unloaded() {
        for (std::size_t k = 0; k < loads_.size(); ++k) {
            problem_.parts[k].load = std::move(loads_[k]);
            problem_.parts[k].prescribed = std::move(prescribed_[k]);
        }
        problem_.constraints = std::move(constraints_);
        std::swap(problem_.part_load, part_load_);
        std::swap(problem_.before, before_);
    }

private:
    solver::AssemblyProblem& problem_;
    std::vector<solver::MeanConstraint> constraints_;
    std::vector<VectorXd> loads_, prescribed_;
    std::vector<solver::StateBefore> before_;
    std::vector<double> part_load_;
};

class Tightening {
public:
    Tightening(const Scene& scene, SolvedAssembly& solved, int threads) : scene_(scene), solved_(solved), threads_(threads) {}

    /// Shortenings by cut, by Broyden's method from each cut's own secant; empty: solved.failure says why not. A cut that is to
    /// have no force is not tightened: its part is as drawn, whatever the others do to it.
    VectorXd run() {
        const auto n = static_cast<Index>(solved_.preloads.size());
        VectorXd wanted(n), shortening(n);
        for (Index k = 0; k < n; ++k) {
            wanted[k] = cut(k).force;
            shortening[k] = wanted[k] / pull(k).stiffness;
        }
        VectorXd force = forces(shortening);
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(n, n);
        bool has_slope = false;
        for (int count = 1; solved_.failure.empty(); ++count) {
            const VectorXd missing = (wanted.array() > 0).select(wanted - force, 0);
            if (missing.cwiseAbs().maxCoeff() <= force_rounding * wanted.maxCoeff()) return shortening;
            if (count == most_solutions) {
                solved_.failure = not_settled(missing);
                break;
            }
            VectorXd step = close_gaps(shortening, force, wanted);
            const bool is_closing = step.cwiseAbs().maxCoeff() > 0;
            if (!is_closing && !has_slope) {
                slope = force.cwiseQuotient(shortening.cwiseMax(1e-300)).asDiagonal();
                for (Index k = 0; k < n; ++k)
                    if (wanted[k] == 0) slope(k, k) = pull(k).stiffness;  // any: it takes no step
                has_slope = true;
            }
            if (!is_closing) step = slope.partialPivLu().solve(missing);
            for (Index k = 0; k < n; ++k) step[k] = std::clamp(step[k], -0.9 * shortening[k], growth * shortening[k]);
            const VectorXd before = force;
            shortening += step;
            force = forces(shortening);
            if (has_slope) slope += (force - before - slope * step) * step.transpose() / step.squaredNorm();
        }
        return {};
    }

private:
    PreloadState& cut(Index k) { return solved_.preloads[at(static_cast<int>(k))]; }
    solver::PartSystem& part(Index k) { return solved_.problem.parts[at(cut(k).grid)]; }
    solver::Pull& pull(Index k) { return part(k).pulls[at(cut(k).pull)]; }
    const std::string& name(Index k) { return scene_.parts[at(solved_.grids[at(cut(k).grid)].part)].name; }

    std::string not_settled(const VectorXd& missing) {
        Index worst = 0;
        missing.cwiseAbs().maxCoeff(&worst);
        const PreloadState& c = cut(worst);
        const auto is_other = [&](const PreloadState& other) { return other.grid == c.grid && other.where != c.where; };
        const bool is_cut_again = std::any_of(solved_.preloads.begin(), solved_.preloads.end(), is_other);
        return "part " + name(worst) + " cannot be tightened to " + number_text(c.force, 4) + " (" + c.where +
               "): the force across its cut ends at " + number_text(c.force - missing[worst], 4) +
               (is_cut_again ? "; cuts one behind the other through a shank bear one force: give one of them"
                             : "; see what else bears the force between its ends");
    }

    /// Longer steps where a cut carries nothing yet; none anywhere: all that are wanted carry something.
    VectorXd close_gaps(const VectorXd& shortening, const VectorXd& force, const VectorXd& wanted) {
        VectorXd step = VectorXd::Zero(shortening.size());
        for (Index k = 0; k < step.size(); ++k) {
            if (wanted[k] == 0 || force[k] > open_force * pull(k).stiffness * shortening[k]) continue;
            step[k] = growth * shortening[k];
            if (shortening[k] > solved_.grids[at(cut(k).grid)].size)
                solved_.failure = "part " + name(k) +
                                  " cannot be tightened: nothing presses back on it however far it is shortened; see that both "
                                  "its ends meet other parts or supports";
            solved_.is_lost = !solved_.failure.empty();
        }
        return step;
    }

    /// The forces across the cuts under these shortenings alone.
    VectorXd forces(const VectorXd& shortening) {
        VectorXd force = VectorXd::Zero(shortening.size());
        for (Index k = 0; k < shortening.size(); ++k) pull(k).shortening = shortening[k];
        const double scale = std::exchange(solved_.problem.load_scale, largest_force());
        solver::AssemblySolution solution;
        {
            const Unloaded unloaded(solved_.problem);
            solution = solve_groups(solved_.problem, threads_);
        }
        solved_.problem.load_scale = scale;
        for (Index k = 0; k < shortening.size(); ++k) {
            if (solution.mechanism.empty() && solution.converged)
                force[k] = solver::force_across(pull(k), solution.displacement[at(cut(k).grid)]);
            pull(k).shortening = 0;
        }
        if (solution.mechanism.empty() && solution.converged)  // shortenings that differ by little press what these did
            expect_pressures_of(solution, solved_.problem.interfaces);
        solved_.is_lost = !solution.mechanism.empty();
        if (solved_.is_lost)
            solved_.failure = "tightening moves part " +
                              scene_.parts[at(solved_.grids[at(solution.mechanism.front().part)].part)].name +
                              ", which nothing holds; see that all that a preload clamps lies between parts or supports";
        else if (!solution.converged)
            solved_.failure = "the contact iterations did not converge while parts were tightened";
        return force;
    }

    double largest_force() {
        double largest = 0;
        for (const PreloadState& c : solved_.preloads) largest = std::max(largest, c.force);
        return largest;
    }

    const Scene& scene_;
    SolvedAssembly& solved_;
    int threads_;
};

}  // namespace

void tighten(const Scene& scene, SolvedAssembly& solved, int threads) {
    solved.preloads = cuts_of(scene, solved);
    if (solved.preloads.empty()) return;
    for (solver::PartSystem& part : solved.problem.parts)
        set_shortening(part, VectorXd::Zero(static_cast<Index>(part.pulls.size())));
    const VectorXd shortening = Tightening(scene, solved, threads).run();
    if (!solved.failure.empty()) return;
    std::vector<VectorXd> by_part;
    for (const solver::PartSystem& part : solved.problem.parts)
        by_part.emplace_back(VectorXd::Zero(static_cast<Index>(part.pulls.size())));
    for (std::size_t k = 0; k < solved.preloads.size(); ++k) {
        PreloadState& cut = solved.preloads[k];
        cut.shortening = by_part[at(cut.grid)][cut.pull] = shortening[static_cast<Index>(k)];
        solved.problem.load_scale = std::max(solved.problem.load_scale, cut.force);
        solved.problem.part_load[at(cut.grid)] = std::max(solved.problem.part_load[at(cut.grid)], cut.force);
    }
    for (std::size_t i = 0; i < by_part.size(); ++i) {
        set_shortening(solved.problem.parts[i], by_part[i]);
        solved.grids[i].input.stress_free = solved.problem.parts[i].input.stress_free;
    }
}

void fill_preload_forces(SolvedAssembly& solved) {
    for (PreloadState& cut : solved.preloads) {
        const solver::PartSystem& part = solved.problem.parts[at(cut.grid)];
        const VectorXd free_strain = part.input.free_strain ? solver::free_strain_load(part.input) : VectorXd();
        cut.force_under_load =
            solver::force_across(part.pulls[at(cut.pull)], solved.solution.displacement[at(cut.grid)], free_strain);
    }
}

}  // namespace abut
