// SPDX-License-Identifier: GPL-3.0-or-later
// E9: the singular field at the corner of an L [Szabo91, 4.2]. On even grids its energy converges like h^(2 l), l = 0.5445.
#include <cmath>

#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_corner {

constexpr double energy_stress = 4.884754673, energy_strain = 4.154544227, singular_exponent = 0.544483736782464;

VerifyRun even(double n, double p, Analysis analysis) {
    return {"verification/corner.json", {{"n", n}, {"p", p}}, analysis};
}

/// Rate of the energy norm, from runs with n and 2 n cells a side.
double rate(const Answers& answers, double exact) {
    return 0.5 * std::log2((exact - answers.at(0).strain_energy) / (exact - answers.at(1).strain_energy));
}

VerifyProblem corner(const std::string& name, const std::string& about, double n, double p, Analysis analysis, double exact) {
    constexpr double rate_tolerance = 0.1;
    return {name,
            about,
            {even(n, p, analysis), even(2 * n, p, analysis)},
            {{"strain energy", [](const Answers& a) { return a.at(1).strain_energy; }, exact, std::nullopt},
             {"rate of the energy norm", [exact](const Answers& a) { return rate(a, exact); }, singular_exponent,
              rate_tolerance, 1}}};
}

}  // namespace verify_corner

std::vector<VerifyProblem> corner_problems() {
    using namespace verify_corner;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    return {
        corner("E9-quadratic", "singular field of an L's corner, 32 and 64 cells of degree 2 a side", 32, 2, ps, energy_stress),
        corner("E9-quadratic-strain", "the same in plane strain", 32, 2, pe, energy_strain),
        corner("E9-cut", "the same with grid lines beside the corner, 31 and 62 cells", 31, 2, ps, energy_stress),
        corner("E9-cubic", "the same, degree 3", 32, 3, ps, energy_stress)};
}

}  // namespace abut
