// SPDX-License-Identifier: GPL-3.0-or-later
// One pass of the analysis: grids, discretisation, contact interfaces, solution.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "solver/contact/assembly_solve.hpp"
#include "src/contact/candidates.hpp"
#include "src/discretization/grid_design.hpp"
#include "src/plan/boundary_conditions.hpp"
#include "src/plan/effect_meter.hpp"
#include "src/solution/contact_interface.hpp"
#include "src/solution/contact_runs.hpp"

namespace abut {

/// Seconds by stage; stages of several passes add up. "factorisation" is a part of "assembly";
/// "rows", "condensation", "contact iterations" and "displacements" are parts of "solve".
using Stopwatches = std::map<std::string, double>;

/// A solved pass.
struct SolvedAssembly {
    std::vector<PartOnGrid> grids;           ///< of the parts that are solved
    std::vector<int> solver_part;            ///< by scene part: index into grids, or -1
    std::vector<ContactInterface> contacts;  ///< parallel to the candidates; those without pieces have no points
    std::vector<int> interface_of;           ///< by contact: index among the solver's interfaces, or -1
    std::vector<int> shear_of;               ///< the same of the tangential traction of bonded ones
    solver::AssemblyProblem problem;
    solver::AssemblySolution solution;
    ContactRuns runs;
    std::string failure;        ///< not empty: not solvable, and why
    int refined_for_walls = 0;  ///< parts whose grid had to be refined to hold the basis
    EffectUses uses;            ///< of the effects' code in this pass
    bool is_folded = false;     ///< half of it was solved (solver/parts/fold.hpp)
    std::string not_folded;     ///< not empty: a mirror symmetric scene that was solved as drawn, and why
    int limited_grids = 0;      ///< parts whose grid is coarser than wanted, to bound the number of cells
};

/// What is asked of the grids of a pass: features by scene part, in assembly coordinates.
struct WantedSize {
    std::vector<Vec2> points;  ///< the cells around all of them
    double size;
    double growth;  ///< of cells per distance from there
};
using WantedSizes = std::vector<std::vector<WantedSize>>;

/// threads: at most so many, see solver::usable_threads.
SolvedAssembly solve_pass(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          const std::vector<bool>& solve_part, const WantedSizes& wanted, double coarseness,
                          Stopwatches& seconds, int threads = 1);

/// The same grids and factorisations with interfaces made anew, where the candidates expect other ends of contact. Costs the
/// contact solution alone.
void solve_contacts_again(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Candidate>& candidates,
                          SolvedAssembly& solved, Stopwatches& seconds, int threads);

/// Largest condition number of the parts' scaled matrices; costs about ten solves each.
double largest_condition(const SolvedAssembly& solved, int threads);

/// Sizes wanted before anything is known: cells along the closest portions of the candidates.
WantedSizes first_sizes(const Scene& scene, const std::vector<Candidate>& candidates, double coarseness);

/// How finely the next grids resolve a contact.
struct ContactResolution {
    double cells;            ///< along each stretch of contact, at least
    double end_fraction;     ///< cells at its free ends, of its length
    double corner_fraction;  ///< the same at corners, and where a straight edge meets an arc
};

/// Sizes wanted from a solution: cells within every contact, finer towards its ends. runs: as they were found, or where they
/// are expected; resolution: by contact.
WantedSizes sizes_from(const Scene& scene, const SolvedAssembly& solved, const ContactRuns& runs,
                       const std::vector<ContactResolution>& resolution);

/// Pressure spline's coefficients of a contact.
const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut
