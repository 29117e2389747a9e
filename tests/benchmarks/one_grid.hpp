// SPDX-License-Identifier: GPL-3.0-or-later
// Two half discs pressed together (Hertz), on grids of about as many unknowns as wanted: one pass of the analysis, its stages
// apart, and the stiffness matrices that it factorised.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut::benchmarks {

/// even: cells of one size, the contact a tenth of the radius. graded: small cells in a contact of a hundredth of the radius,
/// growing away from it to the size that the unknowns leave. halved: the same contact, equal cells that are halved five times
/// towards it, as many of each size.
enum class GridKind { even, graded, halved };

/// The scene with what a pass needs of it.
struct OneGrid {
    Scene scene;
    ResolvedConditions conditions;
    std::vector<Candidate> candidates;
};

/// thousands: of unknowns, of both parts together; met to a few per cent. At most 50 multipliers up to 200 thousand.
OneGrid grid_of_size(GridKind kind, int thousands);

SolvedAssembly solve(const OneGrid& problem);

int n_unknowns(const SolvedAssembly& solved);

/// As they were factorised, supports and pins applied.
std::vector<solver::SparseSymmetric> stiffness_matrices(const SolvedAssembly& solved);

/// Seconds of the calling thread that each stage of the pass takes, done anew: cells, space, quadrature, loads, assembly,
/// factor, supports (with free motions and what else makes a system of a part), interface, contact (condensation, multipliers,
/// displacements).
std::map<std::string, double> stage_seconds(const OneGrid& problem, const SolvedAssembly& solved);

}  // namespace abut::benchmarks
