// SPDX-License-Identifier: GPL-3.0-or-later
// The way over grids of one problem: after each solution it says what the next grids are to be, or that this was the last.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/analysis/outcome.hpp"
#include "src/analysis/part_groups.hpp"
#include "src/discretization/grid_design.hpp"
#include "src/solution/assembly_model.hpp"

namespace abut {

/// What a walk wants of its next pass.
struct PassAsk {
    std::vector<bool> parts;  ///< by scene part: solved
    WantedSizes wanted;
    double coarseness;               ///< of the cells that the shapes want
    std::optional<PassCost> cost{};  ///< where the user gives a budget
};

/// The candidates of a search, `factor` times as far as the first one goes; none where there is nothing to search.
std::vector<Candidate> search_scene(const Scene& scene, double factor, Stopwatches& seconds, EffectUses& uses);

/// The walk of one group of parts under one set of loads. Refers to scene, conditions and seconds.
class GridWalk {
public:
    /// candidates: of the first search, those of other groups, too.
    GridWalk(const Scene& scene, const ResolvedConditions& conditions, Stopwatches& seconds, PartGroup group,
             const std::vector<Candidate>& candidates, int threads);
    GridWalk(GridWalk&&) noexcept;
    GridWalk& operator=(GridWalk&&) noexcept;
    ~GridWalk();

    PassAsk ask() const;
    const std::vector<Candidate>& candidates() const;  ///< that the next pass is to be solved with
    /// Takes a solution on grids that are as fine as asked for, or finer. True: it may be the last one, and is if no other
    /// follows.
    bool take(SolvedAssembly solved);
    /// Where the walk is over, since pressures are known well enough: asks for another grid for the largest stress, if that is
    /// doubtful. False: it is as well known, or no grid is worth it.
    bool sharpen();
    bool is_over() const;  ///< as take or sharpen said last
    /// Has the last solution taken an answer, with an error that somebody could aim at?
    bool has_answer() const;
    int n_widenings() const;  ///< of the search: answers before have other candidates
    /// What failed where the walk is over: the grids or numbers of the last solution. Empty: nothing, or mechanics.
    const std::string& failed() const;
    /// The walk as it stands, without what it has solved.
    GridWalk unsolved();
    /// A walk that has taken nothing begins with the sizes that another of the same candidates has come to.
    void begin_like(const GridWalk& other);
    /// Whatever the next pass gives is the last, since no finer one can be: why. is_again: it is on the grids of the last one,
    /// whose place it takes.
    void end_with_next(const std::string& why, bool is_again = false);
    /// Has a wider search met parts of other groups? They are one problem with these, then: the walk is void.
    bool meets_others() const;
    std::size_t n_passes() const;
    /// The last solution taken, as what follows it needs it: displacements, contacts with their pressures. Steps only.
    const SolvedAssembly& last() const;
    /// What the walk ended with, after a last solution; once.
    Outcome take_outcome();

private:
    class Path;
    explicit GridWalk(std::unique_ptr<Path> path);
    std::unique_ptr<Path> path_;
};

}  // namespace abut
