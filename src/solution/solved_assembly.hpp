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
    std::vector<int> shear_of;  ///< by contact: index of the interface of its tangential traction (bonds, friction), or -1
    solver::AssemblyProblem problem;
    solver::AssemblySolution solution;
    ContactRuns runs;
    std::string failure;               ///< not empty: not solvable, and why
    int refined_for_walls = 0;         ///< parts whose grid had to be refined to hold the basis
    EffectUses uses;                   ///< of the effects' code in this pass
    int increments = 1;                ///< of the step that this is the end of
    std::vector<double> dissipated{};  ///< by contact: work of friction in the step's increments before the last
    int limited_grids = 0;             ///< parts whose grid is coarser than wanted, to bound the number of cells
};

/// The coefficients of a contact's pressure spline.
const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut
