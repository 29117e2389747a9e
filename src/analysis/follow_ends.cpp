// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/follow_ends.hpp"

#include "src/analysis/next_candidates.hpp"

namespace abut {

bool is_solved(const SolvedAssembly& solved) {
    return solved.failure.empty() && solved.solution.mechanism.empty();
}

std::string failure_of(const SolvedAssembly& solved) {
    if (!solved.failure.empty()) return solved.failure;
    const bool is_stuck = !solved.solution.converged && solved.solution.sliding.empty();
    return is_stuck ? "the contact iterations did not converge" : "";
}

EndsFollowed follow_ends(const Scene& scene, SolvedAssembly& now, std::vector<Candidate>& candidates, int most_moves,
                         Stopwatches& seconds, int threads) {
    EndsFollowed followed;
    if (scene.contacts.penalty) return followed;
    const auto follow_way = [&] {
        const bool may_rest = is_solved(now) && now.solution.sliding.empty();
        if (!may_rest || now.problem.path_tolerance || !follow_loads(scene, now, seconds, threads)) return false;
        followed.iterations += now.solution.iterations;
        return true;
    };
    for (bool is_along_way = false; is_solved(now);) {
        if (is_along_way || !now.solution.converged) follow_way();
        const std::vector<std::size_t> elsewhere =
            followed.moves < most_moves ? moved_ends(scene, now, candidates) : std::vector<std::size_t>();
        if (elsewhere.empty()) {
            if (is_along_way || !follow_way()) break;
            is_along_way = true;
            continue;
        }
        if (now.known)  // what stays is not computed again
            expect_ends(scene, now, elsewhere, candidates);
        else
            expect_ends(scene, now, now.stretches, candidates);
        expect_pressures(now, candidates);
        solve_contacts_again(scene, candidates, now, seconds, threads);
        followed.iterations += now.solution.iterations;
        ++followed.moves;
    }
    return followed;
}

}  // namespace abut
