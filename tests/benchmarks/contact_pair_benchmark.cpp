// SPDX-License-Identifier: GPL-3.0-or-later
// One pair of parts with hundreds of multipliers: the contact problem apart from the factorisations, and these beside it.
#include <benchmark/benchmark.h>

#include "tests/benchmarks/solve_again.hpp"
#include "tests/hard_cases/pin_sweep.hpp"

namespace abut::benchmarks {
namespace {

/// Argument: cells in the hole's radius; 25, 50 and 100 make 126, 251 and 503 multipliers.
test::PinSetup setup_of(const benchmark::State& state) {
    return {1.0 / static_cast<double>(state.range(0)), 0, 1, test::Drawn::concentric, 1.4};
}

void contact_of_a_pair(benchmark::State& state) {
    SolvedAssembly pass = solve_case(test::pin_case(setup_of(state)));
    test::scale_loads(pass, 1e-4);
    solve_again(state, pass);
}
BENCHMARK(contact_of_a_pair)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace abut::benchmarks
