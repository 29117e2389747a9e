// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "solver/contact/assembly_solve.hpp"
#include "src/plan/effect_meter.hpp"
#include "src/solution/contact_interface.hpp"
#include "src/solution/contact_runs.hpp"

namespace abut {

/// A solved pass.
struct SolvedAssembly {
    std::vector<PartOnGrid> grids;           ///< of the parts that are solved
    std::vector<int> solver_part;            ///< by scene part: index into grids, or -1
    std::vector<ContactInterface> contacts;  ///< parallel to the candidates; those without pieces have no points
    std::vector<int> interface_of;           ///< by contact: index among the solver's interfaces, or -1
    std::vector<int> shear_of;  ///< by contact: index of the interface of a bonded one's tangential traction, or -1
    solver::AssemblyProblem problem;
    solver::AssemblySolution solution;
    ContactRuns runs;
    std::string failure;        ///< not empty: not solvable, and why
    int refined_for_walls = 0;  ///< parts whose grid had to be refined to hold the basis
    EffectUses uses;            ///< of the effects' code in this pass
    int limited_grids = 0;      ///< parts whose grid is coarser than wanted, to bound the number of cells
};

/// The stretches under pressure of a contact that has an interface, if these were its coefficients. Bonded edges hold wherever
/// they face each other. load_scale: the largest single load; contact forces that are its rounding press nothing.
std::vector<ContactRun> runs_of(const SolvedAssembly& solved, std::size_t contact, const Eigen::VectorXd& pressure,
                                double load_scale);

/// The coefficients of a contact's pressure spline.
const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut
