// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/one_grid.hpp"

#include <algorithm>
#include <cmath>

#include "src/discretization/load_vector.hpp"
#include "src/discretization/support_sets.hpp"
#include "tests/benchmarks/benchmark_scenes.hpp"
#include "tests/benchmarks/one_thread.hpp"

namespace abut::benchmarks {
namespace {

/// Half contact width over the radius, which is 1, and how far from the middle pairs of points are sought.
struct Width {
    double contact, zone;
};
Width width_of(GridKind kind) {
    if (kind == GridKind::even) return {0.1, 0.2};
    return {0.01, 0.025};
}

/// Boxes half as large as the one before, of a part above (1) or below (-1) the contact.
std::string halved_grid(double cell, int side) {
    constexpr int levels = 5;
    const std::string n = std::to_string(std::max(4L, std::lround(1 / cell)));
    std::string boxes;
    for (int level = 1; level <= levels; ++level) {
        const std::string w = std::to_string(std::ldexp(1.0, -level));
        boxes += (level > 1 ? ", " : "") +
                 (side > 0 ? R"({"from": [0, 0], "to": [)" + w + ", " + w + "]"
                           : R"({"from": [0, -)" + w + R"(], "to": [)" + w + ", 0]") +
                 R"(, "levels": )" + std::to_string(level) + "}";
    }
    return R"({"cells": [)" + n + ", " + n + R"(], "refine": [)" + boxes + "]}";
}

std::string accuracy_of(GridKind kind, double cell) {
    if (kind == GridKind::halved)
        return R"({"grids": {"upper": )" + halved_grid(cell, 1) + R"(, "lower": )" + halved_grid(cell, -1) + "}}";
    constexpr double finest = 0.05;  // of the half contact width: 40 multipliers in the zone
    const Width width = width_of(kind);
    const double at_contact = std::max(finest * width.contact, 0.02 * cell);
    const std::string even = R"({"cell_size": )" + std::to_string(cell);
    if (kind == GridKind::even) return even + "}";
    return even + R"(, "refine": [{"near": [0, 0], "radius": )" + std::to_string(width.zone) + R"(, "cell_size": )" +
           std::to_string(at_contact) + "}]}";
}

Scene two_discs(GridKind kind, double cell) {
    const Width width = width_of(kind);
    const double load = 39269.9 * width.contact * width.contact;  // pi E a^2 / (8 R)
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [
        {"name": "upper", "material": "m", "geometry": {"intersection": [
            {"circle": {"center": [0, 1], "radius": 1}}, {"rectangle": {"min": [0, 0], "max": [1, 1]}}]}},
        {"name": "lower", "material": "m", "geometry": {"intersection": [
            {"circle": {"center": [0, -1], "radius": 1}}, {"rectangle": {"min": [0, -1], "max": [1, 0]}}]}}],
        "supports": [{"on": ["upper/left", "lower/left", "lower/bottom"], "symmetry": true}],
        "loads": [{"on": "upper/top", "pressure": )" +
                      std::to_string(load) + R"(}], "contacts": {"search_distance": )" +
                      std::to_string(width.zone * width.zone) + R"(}, "accuracy": )" + accuracy_of(kind, cell) + "}");
}

OneGrid with_cells(GridKind kind, double cell) {
    OneGrid one{two_discs(kind, cell), {}, {}};
    one.conditions = resolve_conditions(one.scene);
    one.candidates = find_candidates(one.scene, 1);
    return one;
}

solver::SpaceInput space_input(const PartOnGrid& g) {
    const solver::SplineSpace& space = g.input.space;
    return {space.x,     space.y, g.elements.fraction, {g.elements.cell_of_extra, g.elements.neighbours},
            space.basis, {},      g.cells.grid.tree};
}

double system_seconds(const OneGrid& problem, const PartOnGrid& g, Eigen::VectorXd load) {
    return thread_seconds_of([&] {
        make_part_system(g.input, support_sets(problem.scene, problem.conditions, g), std::move(load), g.center, g.size);
    });
}

double interface_seconds(const OneGrid& problem, const SolvedAssembly& solved) {
    return thread_seconds_of([&] {
        for (const Candidate& c : problem.candidates)
            make_interface(problem.scene, c, solved.grids[0], solved.grids[1], {0, 1}, std::vector<FacesByCell>(2));
    });
}

}  // namespace

OneGrid grid_of_size(GridKind kind, int thousands) {
    constexpr int steps = 8;
    constexpr double close_enough = 0.05;
    double cell = 1 / (std::sqrt(1e3 * thousands / 3) - 2);  // the even grid's: each part fills pi / 4 of its box
    for (int step = 0;; ++step) {
        OneGrid one = with_cells(kind, cell);
        const double ratio = 1e3 * thousands / n_unknowns(solve(one));
        if (std::abs(ratio - 1) < close_enough || step == steps) return one;
        cell /= std::sqrt(ratio);
    }
}

SolvedAssembly solve(const OneGrid& problem) {
    Stopwatches seconds;
    return solve_pass(problem.scene, problem.conditions, problem.candidates, {true, true}, WantedSizes(2), 1, seconds);
}

int n_unknowns(const SolvedAssembly& solved) {
    int n = 0;
    for (const solver::PartSystem& part : solved.problem.parts) n += part.n_kept;
    return n;
}

std::vector<solver::SparseSymmetric> stiffness_matrices(const SolvedAssembly& solved) {
    std::vector<solver::SparseSymmetric> all;
    for (const solver::PartSystem& part : solved.problem.parts)
        all.push_back(restricted(part.stiffness, part.number, part.n_kept));
    return all;
}

std::map<std::string, double> stage_seconds(const OneGrid& problem, const SolvedAssembly& solved) {
    std::map<std::string, double> seconds;
    for (const PartOnGrid& g : solved.grids) {
        const int degree = g.input.space.x.degree;
        seconds["cells"] += thread_seconds_of([&] { find_elements(g.local, cut_cells(g.local, g.cells.grid)); });
        seconds["space"] += thread_seconds_of([&] { make_space(space_input(g)); });
        seconds["quadrature"] += thread_seconds_of([&] { cell_rules(g.local, g.cells, g.elements, degree); });
        PartLoad load;
        seconds["loads"] += thread_seconds_of([&] { load = load_vector(problem.scene, problem.conditions, g); });
        seconds["supports"] += system_seconds(problem, g, load.vector);
        seconds["assembly"] += thread_seconds_of([&] { assemble_stiffness(g.input); });
    }
    for (solver::SparseSymmetric& matrix : stiffness_matrices(solved))
        seconds["factor"] += thread_seconds_of([&] { solver::Factorization(std::move(matrix)); });
    seconds["supports"] -= seconds["assembly"] + seconds["factor"];
    seconds["interface"] = interface_seconds(problem, solved);
    seconds["contact"] = thread_seconds_of([&] { solve_assembly(solved.problem); });
    return seconds;
}

}  // namespace abut::benchmarks
