// SPDX-License-Identifier: GPL-3.0-or-later
// E1: constant stress wherever the grid cuts. E6: a bar under its own weight, whose field is quadratic. Both are in the spline
// space, so that nothing but rounding is left, or what Nitsche's method leaves at supports.
#include <algorithm>
#include <cmath>

#include "src/verification/verify_errors.hpp"
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_patch {

constexpr double exact = 1e-9, exact_with_curves = 1e-7, exact_with_nitsche = 1e-6;

Vec2 patch_displacement(const Vec2& p, double gxy) {
    return {1e-3 * p.x() + gxy / 2 * p.y(), gxy / 2 * p.x() - 2e-3 * p.y()};
}

/// By the strains 1e-3, -2e-3, gxy with E = 1e5 and nu = 0.3.
Stress patch_stress(Analysis analysis, double gxy) {
    const double sxy = 1e5 / 2.6 * gxy;
    if (analysis == Analysis::plane_strain) {
        const double factor = 1e5 / (1.3 * 0.4);
        return {factor * (0.7e-3 - 0.6e-3), factor * (0.3e-3 - 1.4e-3), sxy, 0};
    }
    return {1e5 / 0.91 * (1e-3 - 0.6e-3), 1e5 / 0.91 * (0.3e-3 - 2e-3), sxy, 0};
}

/// The largest over the runs.
template <class ErrorOf>
std::function<double(const Answers&)> worst(ErrorOf error_of) {
    return [error_of](const Answers& answers) {
        double error = 0;
        for (const Result& answer : answers) error = std::max(error, error_of(answer));
        return error;
    };
}

std::vector<Quantity> errors(const ExactDisplacement& u, const ExactStress& s, double tolerance) {
    return {{"stress, worst anywhere", worst([s](const Result& r) { return largest_stress_error(r, s); }), 0, tolerance, 1},
            {"displacement, worst anywhere", worst([u](const Result& r) { return largest_displacement_error(r, u); }), 0,
             tolerance, 1}};
}

std::vector<Quantity> patch_errors(double tolerance, Analysis analysis, double gxy) {
    return errors([gxy](const Vec2& p) { return patch_displacement(p, gxy); },
                  [analysis, gxy](const Vec2&) { return patch_stress(analysis, gxy); }, tolerance);
}

/// Grids that cut off slivers of a tenth to 1e-8 of a cell, along the axes and turned.
std::vector<VerifyRun> sliver_runs(const std::string& scene, double turn, std::optional<Analysis> analysis) {
    std::vector<VerifyRun> runs;
    for (int k = 1; k <= 8; ++k)
        for (double grid_turn : {0.0, turn}) {
            std::map<std::string, double> parameters{{"sliver", std::pow(10.0, -k)}, {"grid_turn", grid_turn}};
            if (analysis == Analysis::plane_strain) parameters["plane_strain"] = 1;
            runs.push_back({"verification/" + scene + ".json", parameters, analysis});
        }
    return runs;
}

constexpr double gxy = 1.5e-3;

void append_shape(std::vector<VerifyProblem>& problems, const std::string& shape, double turn, double tolerance) {
    const std::string where = "constant stress, " + shape + " on 16 grids with slivers down to 1e-8 of a cell, ";
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    problems.push_back({"E1-a-" + shape, where + "displacements prescribed all round",
                        sliver_runs("patch_" + shape + "_held", turn, {}), patch_errors(exact_with_nitsche, ps, gxy)});
    problems.push_back({"E1-b-" + shape, where + "exact tractions", sliver_runs("patch_" + shape, turn, {}),
                        patch_errors(tolerance, ps, gxy)});
    problems.push_back({"E1-b-" + shape + "-strain", where + "exact tractions, plane strain",
                        sliver_runs("patch_" + shape, turn, pe), patch_errors(tolerance, pe, gxy)});
}

void append_symmetry(std::vector<VerifyProblem>& problems) {
    const auto run = [](double sliver, double turn) {
        return VerifyRun{"verification/patch_symmetry.json", {{"sliver", sliver}, {"grid_turn", turn}}};
    };
    const auto stress = Analysis::plane_stress;
    problems.push_back({"E1-c-aligned",
                        "constant stress in a square on symmetry supports along grid lines",
                        {run(1, 0)},
                        patch_errors(exact, stress, 0)});
    problems.push_back({"E1-c-turned",
                        "the same on grids with slivers and turned ones",
                        {run(1e-3, 0), run(1e-6, 0), run(1, 20), run(1e-6, 20)},
                        patch_errors(exact_with_nitsche, stress, 0)});
}

std::vector<Quantity> bar_errors(double tolerance) {
    const auto u = [](const Vec2& p) {
        return Vec2(-0.3 * p.x() * p.y() / 1e3, (p.y() * p.y() + 0.3 * p.x() * p.x() - 100) / 2e3);
    };
    std::vector<Quantity> list = errors(
        u,
        [](const Vec2& p) {
            return Stress{0, p.y(), 0, 0};
        },
        tolerance);
    list.push_back({"v(0, 0)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, -0.05, tolerance});
    return list;
}

void append_bars(std::vector<VerifyProblem>& problems) {
    const auto run = [](const char* scene, double turn, double p) {
        return VerifyRun{std::string("verification/") + scene, {{"grid_turn", turn}, {"p", p}}};
    };
    problems.push_back({"E6-traction",
                        "a bar under its own weight, carried by a traction, on shifted and turned grids",
                        {run("bar.json", 0, 2), run("bar.json", 10, 2), run("bar.json", 10, 3)},
                        bar_errors(exact)});
    problems.push_back({"E6-held",
                        "the same, with the exact displacement at its top, along grid lines",
                        {run("bar_held.json", 0, 2), run("bar_held.json", 0, 3)},
                        bar_errors(exact)});
    problems.push_back({"E6-held-turned",
                        "the same on turned grids (Nitsche)",
                        {run("bar_held.json", 10, 2), run("bar_held.json", 33, 3)},
                        bar_errors(exact_with_nitsche)});
}

}  // namespace verify_patch

std::vector<VerifyProblem> patch_problems() {
    using namespace verify_patch;
    std::vector<VerifyProblem> problems;
    append_shape(problems, "square", 17, exact);
    append_shape(problems, "disc", 10, exact_with_curves);
    append_shape(problems, "l", 10, exact);
    append_symmetry(problems);
    append_bars(problems);
    return problems;
}

}  // namespace abut
