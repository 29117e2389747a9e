// SPDX-License-Identifier: GPL-3.0-or-later
// CHOLMOD as its manual calls it, without anything of ours: what the solver's own times are held against.
#pragma once
#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::benchmarks {

/// defaults: as cholmod_start leaves it (AMD, then METIS where AMD's factor is costly; simplicial or supernodal as it finds
/// best). supernodal: AMD alone, always supernodal.
enum class CholmodSettings { defaults, supernodal };

/// Seconds of the calling thread for cholmod_analyze and cholmod_factorize. Throws std::runtime_error where the matrix is not
/// positive definite.
double seconds_of_cholmod(const solver::SparseSymmetric& matrix, CholmodSettings settings);

}  // namespace abut::benchmarks
