// SPDX-License-Identifier: GPL-3.0-or-later
// One pass of the analysis: grids, discretisation, contact interfaces, solution.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/contact/candidates.hpp"
#include "src/discretization/grid_design.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Seconds by stage; stages of several passes add up. "factorisation" is a part of "assembly";
/// "rows", "condensation", "contact iterations" and "displacements" are parts of "solve".
using Stopwatches = std::map<std::string, double>;

/// Solves one pass, with friction as under loads that are put on at once. What cannot be solved is told in `failure`. threads:
/// at most so many, see solver::usable_threads.
SolvedAssembly solve_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                          Stopwatches& seconds, int threads = 1);

/// The parts of a pass ready to be solved, for several cases: grids and systems, no interfaces. candidates: of one case; where
/// they lie the factors are quick. scene: its loads are not those of any case, none are best. What cannot be put on a grid is
/// told in `failure`; systems that cannot be made tell so themselves.
SolvedAssembly prepare_parts(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                             const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                             Stopwatches& seconds, int threads);

/// Solves those of the prepared parts that `solve_part` names, under the loads of one case. The scenes of the cases differ by
/// their loads alone. Parts that temperatures act on, and rigid ones, are made anew. Loads that cannot be computed are told in
/// `failure`. before: the state on the same grids that slips count from; null: as drawn.
SolvedAssembly solve_case(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const SolvedAssembly& prepared, const SolvedAssembly* before,
                          Stopwatches& seconds, int threads);

/// Solves again on the same grids and factorisations, with interfaces made anew, where the candidates expect other ends of
/// contact. Costs the contact solution alone. Loads are put on at once.
void solve_contacts_again(const Scene& scene, const std::vector<Candidate>& candidates, SolvedAssembly& solved,
                          Stopwatches& seconds, int threads);

/// Solves again where there is friction, which depends on the way: the loads grow evenly from the state before. False: there
/// is none.
bool follow_loads(const Scene& scene, SolvedAssembly& solved, Stopwatches& seconds, int threads);

/// The largest condition number of the parts' scaled matrices; costs about ten solves each.
double largest_condition(const SolvedAssembly& solved, int threads);

}  // namespace abut
