// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "solver/contact/assembly_solve.hpp"
#include "src/plan/effect_meter.hpp"
#include "src/solution/contact_interface.hpp"
#include "src/solution/pressed_stretches.hpp"

namespace abut {

/// A cut across which a part is tightened.
struct PreloadState {
    int grid, pull;  ///< the part among the solved ones, and the cut among its own
    std::array<Vec2, 2> across;
    std::string where;            ///< the load's place in the scene
    double force = 0;             ///< that it is tightened to
    double shortening = 0;        ///< how far its sides were drawn together for that
    double force_under_load = 0;  ///< across the cut, once all loads act
};

/// A solved pass.
struct SolvedAssembly {
    std::vector<PartOnGrid> grids;           ///< of the parts that are solved
    std::vector<int> solver_part;            ///< by scene part: index into grids, or -1
    std::vector<ContactInterface> contacts;  ///< parallel to the candidates; those without pieces have no points
    std::vector<int> interface_of;           ///< by contact: index among the solver's interfaces, or -1
    std::vector<int> shear_of;  ///< by contact: index of the interface of its tangential traction (bonds, friction), or -1
    std::shared_ptr<KnownInterfaces> known{};  ///< of all cases on these grids; null: there is one only
    solver::AssemblyProblem problem;
    solver::AssemblySolution solution;
    std::vector<double> part_energy{};  ///< strain energies by solved part, once they are known
    PressedStretches stretches;
    std::vector<PreloadState> preloads;
    std::string failure;        ///< not empty: not solvable, and why
    bool is_lost = false;       ///< that is no matter of grids or numbers: something moves that nothing holds
    int refined_for_walls = 0;  ///< parts whose grid had to be refined to hold the basis
    EffectUses uses;            ///< of the effects' code in this pass
    int limited_grids = 0;      ///< parts whose grid is coarser than wanted, to bound the number of cells
};

/// Is a solved part's factor that of another solved part, which it is a copy of?
inline bool has_factor_of_model(const SolvedAssembly& solved, std::size_t part) {
    const int model = solved.grids[part].model;
    return model >= 0 && solved.solver_part[static_cast<std::size_t>(model)] >= 0;
}

/// Are any faces bonded?
inline bool has_bonds(const SolvedAssembly& solved) {
    return std::any_of(solved.contacts.begin(), solved.contacts.end(),
                       [](const ContactInterface& c) { return c.face.bilateral; });
}

/// The stretches under pressure of a contact that has an interface, if these were its coefficients. Bonded edges hold wherever
/// they face each other. load_scale: the largest single load; contact forces that are its rounding press nothing.
std::vector<PressedStretch> stretches_of(const SolvedAssembly& solved, std::size_t contact, const Eigen::VectorXd& pressure,
                                         double load_scale);

/// Is what a contact that has an interface carries no more than rounding, bonded or not?
bool carries_nothing(const SolvedAssembly& solved, std::size_t contact);

/// The coefficients of a contact's pressure spline.
const Eigen::VectorXd& pressure_of(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut
