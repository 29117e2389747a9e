// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <benchmark/benchmark.h>

#include "src/solution/assembly_model.hpp"

namespace abut::benchmarks {

/// Times the contact problem of a solved pass, factorisations left out; counts what it was made of.
inline void solve_again(benchmark::State& state, const SolvedAssembly& pass) {
    if (!pass.failure.empty() || !pass.solution.converged) return state.SkipWithError("the pass has no solution");
    for (auto _ : state) benchmark::DoNotOptimize(solve_assembly(pass.problem));
    double unknowns = 0;
    for (const solver::PartSystem& part : pass.problem.parts) unknowns += part.n_kept;
    state.counters["unknowns"] = unknowns;
    state.counters["multipliers"] = pass.solution.n_multipliers;
    state.counters["iterations"] = pass.solution.iterations;
    state.counters["fallback"] = pass.solution.used_fallback;
}

}  // namespace abut::benchmarks
