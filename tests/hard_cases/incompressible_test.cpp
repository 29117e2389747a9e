// SPDX-License-Identifier: GPL-3.0-or-later
// Nearly incompressible plane strain: E4's ring and Cook's membrane (VALIDATION E10, E8).
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "src/analysis.hpp"
#include "tests/hard_cases/curve_plot.hpp"
#include "tests/hard_cases/part_problem.hpp"
#include "tests/hard_cases/shapes.hpp"

namespace abut::test {
namespace {

PartAnswer ring_answer(int degree, double nu, Hold hold, double cell = 0.21) {
    PartProblem p;
    p.part = ring_quarter(1, 2);
    p.material.nu = nu;
    p.analysis = Analysis::plane_strain;
    p.exact = lame(elasticity_of(p), {1, 2, 1});
    p.hold = hold;
    p.held = {{2, 0}, {0, 1}};
    p.degree = degree;
    return solve_part(p, even_grid(p, cell, {0.07, 0.04}));
}

}  // namespace

TEST(Explore, Incompressible) {
    for (bool fitted : {true, false})
        for (int degree : {2, 3, 4})
            for (double h : {0.2, 0.1})
                for (double nu : {0.3, 0.4999}) {
                    PartProblem p;
                    p.part = rectangle({0.8, 0.3}, {1.8, 1.3});
                    p.material.nu = nu;
                    p.analysis = Analysis::plane_strain;
                    p.exact = lame(elasticity_of(p), {1, 2, 1});
                    p.degree = degree;
                    const PartAnswer a = solve_part(p, even_grid(p, h, fitted ? Vec2(0.8, 0.3) : Vec2(0.87, 0.34)));
                    std::printf("box %d p=%d nu=%g h=%g L2 %.2e en %.2e maxu %.2e maxs %.2e raw %.2e cond %.1e %s\n", fitted, degree, nu, h,
                            a.displacement, a.energy, a.largest_displacement, a.largest_stress, a.largest_raw_stress, a.condition, a.failure.c_str());
                }
    for (int p : {1, 2, 3}) for (double n : {8., 16., 32.}) {
        Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/verification/cook.json", {{"nu", 0.4999}, {"n", n}, {"p", (double)p}});
        scene.analysis = Analysis::plane_strain;
        const Result r = analyze(scene, {});
        std::printf("cook p=%d n=%g: %.5f %.5f\n", p, n, r.probes[0].displacement.y(), r.probes[1].displacement.y());
    }
}

}  // namespace abut::test
