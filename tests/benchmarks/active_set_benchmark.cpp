// SPDX-License-Identifier: GPL-3.0-or-later
// The condensed contact problem alone: a smooth indenter on a half plane, its compliance Flamant's logarithm of the distance,
// free to move against the surface. Between a tenth and nine tenths of the rows close.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/contact/contact_qp.hpp"

namespace abut::benchmarks {
namespace {

/// m strips over [-1, 1], E* = 1, radius 1; the load that Hertz' closed form gives for the half width.
solver::ContactQp indenter(int m, double half_width) {
    const double own = std::exp(-1.5);  // the mean logarithm of the distance within a strip is ln h - 3/2
    const double h = 2.0 / m, load = std::numbers::pi / 4 * half_width * half_width;
    solver::ContactQp qp;
    Eigen::MatrixXd compliance(m, m);
    qp.gap.resize(m);
    for (int i = 0; i < m; ++i) {
        const double x = -1 + (i + 0.5) * h;
        qp.gap[i] = 0.5 * x * x;
        for (int j = 0; j < m; ++j) {
            const double distance = i == j ? own * h : std::abs(i - j) * h;
            compliance(i, j) = 2 / std::numbers::pi * std::log(20 / distance);
        }
    }
    qp.compliance = std::move(compliance);
    qp.modes = Eigen::MatrixXd::Ones(m, 1);
    qp.mode_load = Eigen::VectorXd::Constant(1, -load);
    qp.unilateral.assign(static_cast<std::size_t>(m), 1);
    qp.foundation = Eigen::VectorXd::Constant(m, h / half_width);
    qp.drawn_gap = qp.gap;
    qp.load_scale = load;
    return qp;
}

/// Arguments: multipliers, per cent of them that close.
void ActiveSet(benchmark::State& state) {
    const int m = static_cast<int>(state.range(0));
    const solver::ContactQp qp = indenter(m, 0.01 * static_cast<double>(state.range(1)));
    const solver::ContactQpResult result = solve_contact_qp(qp);
    if (!result.converged) return state.SkipWithError("no convergence");
    for (auto _ : state) benchmark::DoNotOptimize(solve_contact_qp(qp));
    state.counters["iterations"] = result.iterations;
    state.counters["closed"] = static_cast<double>(std::ranges::count(result.active, 1));
    state.counters["fallback"] = result.used_fallback;
    state.SetComplexityN(m);
}
void sizes(benchmark::internal::Benchmark* b, int per_cent) {
    b->ArgNames({"multipliers", "closed"})->ArgsProduct({{25, 50, 100, 200, 400}, {per_cent}});
    b->Unit(benchmark::kMicrosecond)->Complexity(benchmark::oNCubed);
}
void few(benchmark::internal::Benchmark* b) {
    sizes(b, 10);
}
void half(benchmark::internal::Benchmark* b) {
    sizes(b, 50);
}
void nearly_all(benchmark::internal::Benchmark* b) {
    sizes(b, 90);
}
BENCHMARK(ActiveSet)->Apply(few);
BENCHMARK(ActiveSet)->Apply(half);
BENCHMARK(ActiveSet)->Apply(nearly_all);

}  // namespace
}  // namespace abut::benchmarks
