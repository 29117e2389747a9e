// SPDX-License-Identifier: GPL-3.0-or-later
// What is solved on the same grids, until contact ends where its pressure's knots expect it.
#pragma once
#include <string>
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut {

/// Is there a solution, converged or not?
bool is_solved(const SolvedAssembly& solved);

/// Why it is no answer: its failure, or that the contact iterations have come to no end; empty: it is one, or slides.
std::string failure_of(const SolvedAssembly& solved);

struct EndsFollowed {
    int moves = 0;       ///< of the knots
    int iterations = 0;  ///< of the contact solutions
};

/// Knots move to where contact was found to end, and the contact alone is solved again, until they are there or have moved so
/// many times. With friction the loads are put on at once until then, and followed along their way at last, from which the
/// ends are looked at once more; what slides at once slides.
EndsFollowed follow_ends(const Scene& scene, SolvedAssembly& now, std::vector<Candidate>& candidates, int most_moves,
                         Stopwatches& seconds, int threads);

}  // namespace abut
