// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks stacked on each other, for the tests of interfaces and assemblies: one frame for all, contact along horizontal lines.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "solver/contact/assembly_solve.hpp"
#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::test {

/// A block [x0, x1] x [y0, y1] whose grid overhangs it by `overhang` cells, so that its sides cut cells.
struct Block {
    Box box;
    int nx = 4, ny = 3;
    double overhang = 0;
    Elasticity elasticity = plane_stress(1000, 0.3);
    double thickness = 1;
};

inline PartInput part_of(const Block& b, int degree) {
    const double hx = (b.box.x1 - b.box.x0) / b.nx * b.overhang, hy = (b.box.y1 - b.box.y0) / b.ny * b.overhang;
    return part_of({b.box}, grid_lines(b.box.x0 - hx, b.box.x1 + 0.7 * hx, b.nx, false),
                   grid_lines(b.box.y0 - 0.8 * hy, b.box.y1 + 0.6 * hy, b.ny, false), degree, Basis::web, b.elasticity,
                   b.thickness);
}

/// Load of a traction on the upper side of a block, from x0 to x1.
inline VectorXd top_load(const PartInput& part, const Block& b, double x0, double x1, const Vec2& traction) {
    return boundary_load(
        part, traction_on(part.space, {x0, b.box.y1}, {x1, b.box.y1}, {0, 1}, [&](const Vec2&) { return traction; }));
}

/// Pairs along y = height between body `lower` (below) and `upper`, from x0 to x1, with the given drawn gap.
inline Interface horizontal_interface(const std::vector<PartSystem>& parts, int lower, int upper, double x0, double x1,
                                      double height, int n_intervals, const std::function<double(double)>& gap,
                                      double thickness = 1) {
    Interface face{
        {lower, upper}, thickness, clamped_knots(grid_lines(x0, x1, n_intervals, true), multiplier_degree), false, {}};
    const SplineSpace &below = parts[static_cast<std::size_t>(lower)].input.space,
                      &above = parts[static_cast<std::size_t>(upper)].input.space;
    std::vector<double> cuts = face.pressure.breakpoints;
    for (const SplineSpace* s : {&below, &above})
        for (double line : s->x.breakpoints)
            if (line > x0 && line < x1) cuts.push_back(line);
    std::sort(cuts.begin(), cuts.end());
    const LineRule rule = gauss(4);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const double x = cuts[k] + rule.points[i] * (cuts[k + 1] - cuts[k]), g = gap(x);
            const Vec2 lower_point(x, height), upper_point(x, height + g);
            face.points.push_back({x,
                                   rule.weights[i] * (cuts[k + 1] - cuts[k]),
                                   g,
                                   {below.cell_at(lower_point - Vec2(0, 1e-9)), above.cell_at(upper_point + Vec2(0, 1e-9))},
                                   {lower_point, upper_point},
                                   {Vec2(0, 1), Vec2(0, 1)}});
        }
    return face;
}

inline void add_interface(AssemblyProblem& problem, Interface face) {
    problem.own_normals.emplace_back(face.points.size(), std::array<Vec2, 2>{Vec2(0, 1), Vec2(0, -1)});
    problem.interfaces.push_back(std::move(face));
    problem.foundation.push_back(1000);
}

inline PartSystem system_of(const Block& b, const PartInput& part, const std::vector<SupportSet>& supports,
                            const VectorXd& load) {
    return make_part_system(part, supports, load, {0.5 * (b.box.x0 + b.box.x1), 0.5 * (b.box.y0 + b.box.y1)},
                            std::hypot(b.box.x1 - b.box.x0, b.box.y1 - b.box.y0));
}

/// Rollers under and at the left of a block: no rigid motion, and a uniform vertical pressure leaves its stress uniform.
inline std::vector<SupportSet> corner_rollers(const PartInput& part, const Block& b) {
    return {support_on(part.space, {b.box.x0, b.box.y0}, {b.box.x1, b.box.y0}, {0, -1}, {0, 1}),
            support_on(part.space, {b.box.x0, b.box.y0}, {b.box.x0, b.box.y1}, {-1, 0}, {1, 0})};
}

/// A block on rollers under a floating one that nothing but contact holds, loaded on its upper side.
struct TwoBlocks {
    Block lower{{0, 0, 1, 1}, 4, 3, 0, plane_stress(1000, 0.3), 1}, upper{{0, 1, 1, 2}, 3, 4, 0, plane_stress(2500, 0.25), 1};
    int degree = 2, n_intervals = 4;
    double gap = 0, load_from = 0, load_to = 1;
    Vec2 traction{0, -1};
    std::vector<SupportSet> upper_supports;

    AssemblyProblem problem() const {
        AssemblyProblem p;
        const PartInput below = part_of(lower, degree), above = part_of(upper, degree);
        p.parts.push_back(system_of(lower, below, corner_rollers(below, lower), VectorXd::Zero(2 * below.space.n_functions)));
        const VectorXd load = top_load(above, upper, load_from, load_to, traction);
        p.load_scale = resultant_of(above.space, load).force.norm();
        p.parts.push_back(system_of(upper, above, upper_supports, load));
        const double x0 = std::max(lower.box.x0, upper.box.x0), x1 = std::min(lower.box.x1, upper.box.x1);
        add_interface(p, horizontal_interface(
                             p.parts, 0, 1, x0, x1, lower.box.y1, n_intervals, [&](double) { return gap; }, lower.thickness));
        return p;
    }
};

}  // namespace abut::solver::test
