// SPDX-License-Identifier: GPL-3.0-or-later
// A sleeve between a pin and a plate: its two pressures share splines where it is thinner than its cells.
#include "src/solution/shared_cells.hpp"

#include <gtest/gtest.h>

#include "src/analysis/adaptive.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::shared_cells_test {
namespace {

constexpr double cell = 0.4;

SolvedAssembly sleeve(double wall) {
    const Scene scene = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 2e5, "nu": 0.3}},
        "parameters": {"wall": )" + std::to_string(wall) +
                                            R"(}, "parts": [
        {"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [-20, -20], "max": [20, 20]}, "name": "p"},
                                                                       {"circle": {"center": [0, 0], "radius": 10}}]}},
        {"name": "sleeve", "material": "m", "geometry": {"difference": [{"circle": {"center": [0, 0], "radius": 10}},
                                                                        {"circle": {"center": [0, 0], "radius": "10 - wall"}}]}},
        {"name": "pin", "material": "m", "geometry": {"circle": {"center": [0, 0], "radius": "10 - wall"}}}],
        "supports": [{"on": "plate/p/bottom", "fix": ["x", "y"]}], "loads": [{"part": "pin", "force": [0, -1000]}],
        "accuracy": {"cell_size": )" + std::to_string(cell) +
                                            "}}",
                                        "s.json");
    Stopwatches seconds;
    return solve_adaptively(scene, resolve_conditions(scene), {}, seconds).solved;
}

/// Coefficients of the pressures that a part meets, but for those of parts that it only faces through another.
int coefficients_on(const SolvedAssembly& solved, int part) {
    int n = 0;
    for (const ContactInterface& c : solved.contacts)
        if (c.part[0] == part || c.part[1] == part) n += solver::n_rows(c.face);
    return n;
}

}  // namespace

TEST(SharedCells, PressuresOnBothFacesOfAThinWallAreNoMoreThanItsSplines) {
    const SolvedAssembly solved = sleeve(0.1);
    ASSERT_TRUE(solved.failure.empty()) << solved.failure;
    EXPECT_LE(coefficients_on(solved, 1), solved.grids[1].input.space.n_functions);
    EXPECT_TRUE(solved.solution.converged);
    // where the coefficients are not determined it is 1
    EXPECT_LE(solved.solution.residual, 1e-9);
}

TEST(SharedCells, AWallOfManyCellsHasAllOfThem) {
    const SolvedAssembly solved = sleeve(4);
    const double round = 2 * 3.141592653589793 * (10 + 6);
    // spacing along a slanted boundary: cells are between one and the root of two long
    EXPECT_GE(coefficients_on(solved, 1), round / (std::sqrt(2.0) * multiplier_spacing * cell));
}

}  // namespace abut::shared_cells_test
