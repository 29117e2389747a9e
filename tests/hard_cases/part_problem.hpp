// SPDX-License-Identifier: GPL-3.0-or-later
// One part with a known field, on a grid that need not fit it, solved by the program's own stages, and how far off the answer
// is everywhere.
#pragma once
#include <string>
#include <vector>

#include "solver/parts/part_system.hpp"
#include "src/discretization/discretize.hpp"
#include "tests/hard_cases/exact_fields.hpp"

namespace abut::test {

/// rigid: no support, the exact tractions all round, errors up to a rigid motion. The others hold the components named in
/// PartProblem::held at the exact values: by dropped functions or weights, which need zeros there, or by Nitsche's method.
/// dissertation: all of its method (src/scene/dissertation_method.hpp), by weights at zero whatever the exact field has there:
/// such an answer has no errors, only a matrix.
enum class Hold { rigid, nitsche, aligned, structure, dissertation };
std::string name_of(Hold hold);
std::string name_of(solver::Basis basis);

struct HeldEdge {
    int edge, component;  ///< of the assembly's axes
};

struct PartProblem {
    geometry::Part part;
    Material material{"m", 1, 0.3, 0, false, {}, false};
    Analysis analysis = Analysis::plane_stress;
    ExactField exact;
    Hold hold = Hold::rigid;
    std::vector<HeldEdge> held;
    solver::Basis basis = solver::Basis::web;
    int degree = 2;
    Frame frame{};               ///< of the grid
    bool standard_form = false;  ///< without the projection of the volume strain, whatever nu is
};
Elasticity elasticity_of(const PartProblem& problem);

/// Lines at offset + k h over the part, in the frame of the grid. With offset on the part's lower left corner the grid begins
/// there.
geometry::Grid even_grid(const PartProblem& problem, double h, const Vec2& offset);

/// Errors relative to the largest exact value (largest) or to the exact field's norm; at points all over the part and its
/// boundary, those of the smallest slivers included.
struct PartAnswer {
    std::string failure;  ///< not empty: nothing below `smallest_fraction` is filled in
    int unknowns = 0;
    double smallest_fraction = 1;   ///< filled fraction of the element that holds least
    double condition = 0;           ///< estimate, scaled matrix
    double unscaled_condition = 0;  ///< the same of the matrix as it is assembled; not of the web basis
    double displacement = 0;        ///< L2 norm
    double energy = 0;              ///< energy norm of the displacement's stresses
    double largest_displacement = 0;
    double largest_stress = 0;      ///< of the smoothed stresses
    double largest_raw_stress = 0;  ///< of the displacement's own
    double strain_energy = 0;
    double exact_energy = 0;                       ///< by quadrature
    std::vector<solver::SupportMethod> methods{};  ///< of the supports
};

PartAnswer solve_part(const PartProblem& problem, const geometry::Grid& grid);

/// The part's system as solve_part makes it, for those who want to look inside. The structure's, too.
struct PreparedPart {
    PartOnGrid on_grid;
    solver::PartSystem system;
};
PreparedPart prepare_part(const PartProblem& problem, const geometry::Grid& grid);

/// Largest over smallest eigenvalue of the scaled matrix, by a dense eigenvalue solver.
double dense_condition(const solver::PartSystem& system);

}  // namespace abut::test
