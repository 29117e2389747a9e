// SPDX-License-Identifier: GPL-3.0-or-later
// One part of degree 2 from 1e3 to 1e6 unknowns: a square plate, and one with 8 x 8 holes whose edges meet no grid line.
// Arguments: thousands of unknowns. Complexity is fitted to the unknowns; counters are bytes per unknown.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <map>

#include "solver/parts/part_system.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"

namespace abut::benchmarks {
namespace {

constexpr int degree = 2;

Scene plate_with_holes(int each_way) {
    std::string holes;
    for (int r = 0; r < each_way; ++r)
        for (int c = 0; c < each_way; ++c) {
            const auto place = [&](int k) { return std::to_string(-1 + 2 * (k + 0.5) / each_way); };
            holes += R"(, {"circle": {"center": [)" + place(c) + ", " + place(r) + R"(], "radius": )" +
                     std::to_string(0.5 / each_way) + "}}";
        }
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [{"name": "plate", "material": "m",
        "geometry": {"difference": [{"rectangle": {"min": [-1, -1], "max": [1, 1]}})" +
                      holes + R"(]}}], "supports": [{"part": "plate", "rigid": {"translation": [0, 0], "rotation": 0}}]})");
}

/// The plate with as many unknowns, nearly: made once for each size.
const solver::PartInput& plate(const benchmark::State& state, int holes) {
    static std::map<std::pair<int, int>, solver::PartInput> made;
    static std::map<int, Scene> scenes;
    const int thousands = static_cast<int>(state.range(0));
    if (const auto old = made.find({thousands, holes}); old != made.end()) return old->second;
    const double filled = holes > 0 ? 1 - 3.14159265 / 16 : 1;
    const int n = static_cast<int>(std::lround(std::sqrt(500.0 * thousands / filled))) - degree;
    if (!scenes.contains(holes)) scenes.emplace(holes, plate_with_holes(holes));
    made.clear();  // one at a time: the largest takes more than a gigabyte
    return made.emplace(std::pair(thousands, holes), plate_on_grid(scenes.at(holes), n, degree).input).first->second;
}

/// The first few coefficients held: no rigid motion left.
solver::SparseSymmetric held(const solver::BlockMatrix& k) {
    constexpr int n_held = 6;
    std::vector<int> number(static_cast<std::size_t>(2 * k.n), -1);
    for (int i = n_held; i < 2 * k.n; ++i) number[static_cast<std::size_t>(i)] = i - n_held;
    return restricted(k, number, 2 * k.n - n_held);
}

template <class T>
double bytes(const std::vector<T>& v) {
    return static_cast<double>(v.size() * sizeof(T));
}

void set_unknowns(benchmark::State& state, int unknowns) {
    state.SetComplexityN(unknowns);
    state.counters["unknowns"] = unknowns;
}

void Assemble(benchmark::State& state, int holes) {
    const solver::PartInput& part = plate(state, holes);
    double memory = 0;
    for (auto _ : state) {
        const solver::BlockMatrix k = assemble_stiffness(part);
        memory = bytes(k.first) + bytes(k.column) + bytes(k.block);
    }
    set_unknowns(state, 2 * part.space.n_functions);
    state.counters["cut"] = static_cast<double>(part.cut_rules.size());
    state.counters["bytes"] = memory / (2 * part.space.n_functions);
}

/// Ordering, symbolic and numeric factorisation: a new grid needs all three.
void Factorise(benchmark::State& state, int holes) {
    const solver::SparseSymmetric matrix = held(assemble_stiffness(plate(state, holes)));
    double factor_bytes = 0;
    for (auto _ : state) {
        const solver::Factorization factor(matrix);
        if (!factor.ok()) state.SkipWithError("not positive definite");
        factor_bytes = factor.bytes();
    }
    set_unknowns(state, matrix.n);
    state.counters["bytes"] = (bytes(matrix.first) + bytes(matrix.row) + bytes(matrix.value)) / matrix.n;
    state.counters["factor_bytes"] = factor_bytes / matrix.n;
}

void SolveLower50(benchmark::State& state, int holes) {
    const solver::SparseSymmetric matrix = held(assemble_stiffness(plate(state, holes)));
    const solver::Factorization factor(matrix);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(matrix.n, 50);
    for (Eigen::Index k = 0; k < rows.cols(); ++k) rows((k * matrix.n) / rows.cols(), k) = 1;
    for (auto _ : state) benchmark::DoNotOptimize(factor.solve_lower(rows));
    set_unknowns(state, matrix.n);
}

void EstimateCondition(benchmark::State& state, int holes) {
    const solver::SparseSymmetric matrix = held(assemble_stiffness(plate(state, holes)));
    const solver::Factorization factor(matrix);
    for (auto _ : state) benchmark::DoNotOptimize(factor.condition_estimate());
    set_unknowns(state, matrix.n);
}

void sizes(benchmark::internal::Benchmark* b) {
    for (int thousands : {1, 3, 10, 30, 100, 300, 1000}) b->Arg(thousands);
    b->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Complexity([](benchmark::IterationCount n) {
        return std::pow(static_cast<double>(n), 1.25);  // between n of the assembly and n^1.5 of nested dissection
    });
}

BENCHMARK_CAPTURE(Assemble, square, 0)->Apply(sizes)->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(Assemble, holes, 8)->Apply(sizes)->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(Factorise, square, 0)->Apply(sizes);
BENCHMARK_CAPTURE(Factorise, holes, 8)->Apply(sizes);
BENCHMARK_CAPTURE(SolveLower50, square, 0)->Apply(sizes);
BENCHMARK_CAPTURE(SolveLower50, holes, 8)->Apply(sizes);
BENCHMARK_CAPTURE(EstimateCondition, square, 0)->Apply(sizes);

}  // namespace
}  // namespace abut::benchmarks
