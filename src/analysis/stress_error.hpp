// SPDX-License-Identifier: GPL-3.0-or-later
// Error of the stresses in the energy norm, from one solution alone: the smoothed stresses are the more accurate ones, and what
// they differ by is the error of the others (Zienkiewicz and Zhu, Int. J. Numer. Meth. Engng. 24, 1987). Estimate over true
// error, measured by tests/verification/estimate_test.cpp: 0.5 to 1.6 where the stress is smooth, down to 0.31 with
// contact on draft's grids. Where the stress has no limit it sees 0.07 to 0.3 of the energy's error: singular_errors says what
// is missed there.
#pragma once
#include <optional>
#include <vector>

#include "solver/recovery/recovery.hpp"
#include "solver/terms/stress.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The smoothed stresses of every solved part, side by side on `threads` threads.
std::vector<solver::StressField> stress_fields(const SolvedAssembly& solved, int threads = 1);

/// The strain energy of the stresses of a displacement in one cell of a part's space.
double strain_energy(const solver::PartInput& input, const solver::StressOf& stress, const solver::CellRule& cell);

/// The strain energy of the difference between a part's smoothed stresses and those of its displacement, by element of its
/// space. smoothed: of a fit that has not failed.
std::vector<double> element_errors(const solver::PartInput& input, const Eigen::VectorXd& displacement,
                                   const solver::StressField& smoothed);

/// The strain of the same difference in one element, in the root of its mean square.
double strain_error(const solver::PartInput& input, const Eigen::VectorXd& displacement, const solver::StressField& smoothed,
                    int element);

/// Is anything strained by more than temperatures in parts that expand freely, and places, are rounded by?
bool is_strained(const SolvedAssembly& solved);

/// The estimated error of the strain energy of each of solved.grids; the root of its share of the energy is that of the
/// stresses in the energy norm. None where a smoothing failed, or where nothing is strained. Cost: an evaluation of both
/// stresses at every quadrature point.
std::optional<std::vector<double>> energy_errors(const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                                                 int threads = 1);

/// Energies of each of solved.grids, as shares of what it stores.
std::vector<double> of_own_energy(const SolvedAssembly& solved, std::vector<double> energy);

}  // namespace abut
