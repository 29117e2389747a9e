// SPDX-License-Identifier: GPL-3.0-or-later
// E7: free, held and uneven expansion (Timoshenko and Goodier, chapter 13); a warm pin in a ring (Lame). E = 2e5,
// alpha = 1.2e-5, 100 degrees: strain 1.2e-3.
#include <cmath>
#include <numbers>

#include "src/verification/verify_contact_answers.hpp"
#include "src/verification/verify_errors.hpp"

namespace abut {

namespace verify_thermal {

constexpr double E = 2e5, strain = 1.2e-3, exact = 1e-9;

/// What plane strain multiplies restrained stresses of the plane by, over those of plane stress.
double stiffening(double nu, Analysis analysis) {
    return analysis == Analysis::plane_strain ? 1 / (1 - nu) : 1;
}

/// Temperatures linear in x leave a free square without stress in plane stress.
VerifyProblem free_square(const std::string& name, const std::string& about, Analysis analysis, double nu,
                          std::map<std::string, double> parameters) {
    parameters["nu"] = nu;
    const double slope = parameters.contains("slope") ? parameters["slope"] / 100 : 0;
    const double e = analysis == Analysis::plane_strain ? (1 + nu) * strain : strain;
    const auto u = [=](const Vec2& p) {
        return Vec2(e * (p.x() + slope / 2 * (p.x() * p.x() - p.y() * p.y())), e * p.y() * (1 + slope * p.x()));
    };
    const double zz = analysis == Analysis::plane_strain ? -E * strain * (1 + slope) : 0;
    // stresses of a projected volume strain amplify rounding by lambda / mu = 5e3 and by the condition of its mass matrix
    const double stress_exact = nu > 0.49 ? 1e-6 : exact;
    return {
        name,
        about,
        {{"verification/warm_square.json", std::move(parameters), analysis}},
        {{"displacement, worst anywhere", [u](const Answers& r) { return largest_displacement_error(r[0], u); }, 0, exact, 1},
         {"largest stress in the plane",
          [](const Answers& r) {
              double worst = 0;
              for (const FieldSample& s : r[0].fields[0].samples)
                  worst = std::max({worst, std::abs(s.stress.xx), std::abs(s.stress.yy), std::abs(s.stress.xy)});
              return worst;
          },
          0, stress_exact, E * strain},
         {"szz(1, 1)", [](const Answers& r) { return r[0].probes.at(0).stress.zz; }, zz, stress_exact, E * strain},
         {"strain energy", [](const Answers& r) { return r[0].strain_energy; }, zz * zz / (2 * E), exact,
          E * strain * strain}}};
}

VerifyProblem held_square(const std::string& name, const std::string& about, Analysis analysis, double nu, double turn) {
    const double s = -E * strain / (analysis == Analysis::plane_strain ? 1 - 2 * nu : 1 - nu);
    const bool strained = analysis == Analysis::plane_strain;
    return {
        name,
        about,
        {{"verification/warm_square_held.json", {{"nu", nu}, {"grid_turn", turn}}, analysis}},
        {{"sxx", [](const Answers& r) { return r[0].probes.at(0).stress.xx; }, s, exact},
         {"szz", [](const Answers& r) { return r[0].probes.at(0).stress.zz; }, strained ? s : 0, exact, -s},
         {"stress, worst anywhere",
          [s](const Answers& r) { return largest_stress_error(r[0], [s](const Vec2&) {
                                      return Stress{s, s, 0, 0};
                                  }); }, 0,
          exact, 1},
         {"strain energy", [](const Answers& r) { return r[0].strain_energy; }, -s * strain * (strained ? 1.5 : 1), exact}}};
}

/// s(r) at the edges, with log(b / a) and b / a = 2.
VerifyProblem ring(const std::string& name, const std::string& about, Analysis analysis, double nu, int degree) {
    const double log2 = std::numbers::ln2, k = E * strain / (2 * log2) * stiffening(nu, analysis);
    const double inner = k * (1 - 8.0 / 3 * log2), outer = k * (1 - 2.0 / 3 * log2);
    const double zz = analysis == Analysis::plane_strain ? nu * inner - E * strain : 0;
    return {name,
            about,
            {{"verification/warm_ring.json", {{"nu", nu}, {"p", static_cast<double>(degree)}}, analysis}},
            {{"stt(a)", [](const Answers& r) { return r[0].probes.at(0).stress.yy; }, inner, 0.01},
             {"stt(b)", [](const Answers& r) { return r[0].probes.at(1).stress.yy; }, outer, 0.01},
             {"szz(a)", [](const Answers& r) { return r[0].probes.at(0).stress.zz; }, zz, 0.01, -inner}}};
}

/// Of equal materials, radius ratio 2: the interference over the closing per pressure.
VerifyProblem heated_pin(const std::string& name, const std::string& about, Analysis analysis) {
    const double p = 3.0 / 8 * E * strain * stiffening(0.3, analysis);
    return {name,
            about,
            {{"verification/heated_pin.json", {}, analysis}},
            {{"mean pressure", [](const Answers& r) { return mean_pressure(contact_of(r)); }, p, 0.005},
             {"largest pressure", peak, p, 0.01},
             {"least pressure", [](const Answers& r) { return least_pressure(contact_of(r)); }, p, 0.01}}};
}

}  // namespace verify_thermal

std::vector<VerifyProblem> thermal_problems() {
    using namespace verify_thermal;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    return {free_square("E7-free", "a square that is free to expand", ps, 0.3, {}),
            free_square("E7-free-strain", "the same in plane strain", pe, 0.3, {}),
            free_square("E7-free-slope", "the same, warmer on one side", ps, 0.3, {{"slope", 50}}),
            free_square("E7-free-incompressible", "plane strain, nu = 0.4999", pe, 0.4999, {}),
            held_square("E7-held", "a warm square held all round", ps, 0.3, 0),
            held_square("E7-held-strain", "the same in plane strain", pe, 0.3, 0),
            held_square("E7-held-turned", "the same on a turned grid", pe, 0.3, 17),
            held_square("E7-held-incompressible", "the same, nu = 0.4999", pe, 0.4999, 17),
            ring("E7-ring", "quarter of a ring with heat flowing outward", ps, 0.3, 2),
            ring("E7-ring-strain", "the same in plane strain", pe, 0.3, 2),
            ring("E7-ring-incompressible", "plane strain, nu = 0.4999, degree 3", pe, 0.4999, 3),
            heated_pin("E7-pin", "a pin that is warmer than its ring", ps),
            heated_pin("E7-pin-strain", "the same in plane strain", pe)};
}

}  // namespace abut
