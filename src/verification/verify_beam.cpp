// SPDX-License-Identifier: GPL-3.0-or-later
// E2: Timoshenko's cantilever [Timoshenko70, art. 21], in the form of Augarde and Deeks. A cubic field.
#include <cmath>

#include "src/verification/verify_errors.hpp"
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_beam {

constexpr double P = 1000, L = 48, D = 12, E = 3e7, nu = 0.3, inertia = D * D * D / 12;

struct Elastic {
    double E, nu;  ///< those of plane stress that stand for the case
};
Elastic elastic(Analysis analysis) {
    return analysis == Analysis::plane_strain ? Elastic{E / (1 - nu * nu), nu / (1 - nu)} : Elastic{E, nu};
}

Vec2 displacement(const Vec2& p, const Elastic& m) {
    const double x = p.x(), y = p.y(), factor = P / (6 * m.E * inertia);
    return {factor * y * ((6 * L - 3 * x) * x + (2 + m.nu) * (y * y - D * D / 4)),
            -factor * (3 * m.nu * y * y * (L - x) + (4 + 5 * m.nu) * D * D * x / 4 + (3 * L - x) * x * x)};
}

Stress stress(const Vec2& p) {
    return {P * (L - p.x()) * p.y() / inertia, 0, -P / (2 * inertia) * (D * D / 4 - p.y() * p.y()), 0};
}

/// The integral of stress times strain, P^2 L^3 / 6EI of bending and the rest of shear.
double energy(const Elastic& m) {
    return P * P * L * L * L / (6 * m.E * inertia) + P * P * L * (1 + m.nu) * D * D / (10 * m.E * inertia);
}

VerifyProblem beam(const std::string& name, const std::string& about, Analysis analysis,
                   std::map<std::string, double> parameters, double tolerance) {
    const Elastic m = elastic(analysis);
    if (analysis == Analysis::plane_strain) parameters["plane_strain"] = 1;
    const auto u = [m](const Vec2& p) { return displacement(p, m); };
    // only degree 3 holds the stresses everywhere
    const std::optional<double> everywhere = parameters.contains("p") ? std::optional(tolerance) : std::nullopt;
    return {
        name,
        about,
        {{"verification/cantilever.json", std::move(parameters), analysis}},
        {{"v(48, 0)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, u({L, 0}).y(), tolerance},
         {"sxx(0, 6)", [](const Answers& a) { return a[0].probes.at(1).stress.xx; }, stress({0, D / 2}).xx, tolerance},
         {"strain energy", [](const Answers& a) { return a[0].strain_energy; }, energy(m), tolerance},
         {"displacement, worst anywhere", [u](const Answers& a) { return largest_displacement_error(a[0], u); }, 0, tolerance,
          1},
         {"stress, worst anywhere", [](const Answers& a) { return largest_stress_error(a[0], stress); }, 0, everywhere, 1}}};
}

}  // namespace verify_beam

std::vector<VerifyProblem> beam_problems() {
    using namespace verify_beam;
    constexpr double quadratic = 1e-3, cubic = 1e-8;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    return {beam("E2-quadratic", "cantilever, 4 cells of degree 2 over its height", ps, {}, quadratic),
            beam("E2-quadratic-strain", "the same in plane strain", pe, {}, quadratic),
            beam("E2-quadratic-turned", "the same with cells a sixth as large, turned by 11 degrees", ps,
                 {{"grid_turn", 11}, {"nx", 96}, {"ny", 32}}, quadratic),
            beam("E2-cubic", "cantilever, degree 3", ps, {{"p", 3}}, cubic),
            beam("E2-cubic-strain", "the same in plane strain", pe, {{"p", 3}}, cubic),
            beam("E2-cubic-turned", "the same on a grid turned by 11 degrees", ps, {{"p", 3}, {"grid_turn", 11}}, cubic)};
}

}  // namespace abut
