// SPDX-License-Identifier: GPL-3.0-or-later
// E8: Cook's membrane. References are converged numbers of a spectral finite element solver, six to seven digits.
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_membrane {

struct Reference {
    double middle;  ///< v(48, 52)
    double work;    ///< of the load: twice the strain energy
};
constexpr Reference stress_third{23.96774, 24.041606}, strain_third{21.52457, 21.590232}, strain_4999{18.51192, 18.56733};

std::vector<Quantity> quantities(const Reference& reference, double tolerance) {
    return {{"v(48, 52)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, reference.middle, tolerance},
            {"work of the load", [](const Answers& a) { return 2 * a[0].strain_energy; }, reference.work, tolerance}};
}

VerifyProblem membrane(const std::string& name, const std::string& about, double n, double p, double nu, Analysis analysis,
                       const Reference& reference, double tolerance) {
    return {name,
            about,
            {{"verification/cook.json", {{"n", n}, {"p", p}, {"nu", nu}}, analysis}},
            quantities(reference, tolerance)};
}

}  // namespace verify_membrane

std::vector<VerifyProblem> membrane_problems() {
    using namespace verify_membrane;
    // nearly incompressible the stress at the corner (0, 44) is more singular: errors fall like h^1.2, and with 16 cells the
    // work is 0.52 % off: recorded
    VerifyProblem coarse_4999 = membrane("E10-membrane", "Cook's membrane nearly incompressible, 16 cells of degree 3 across",
                                         16, 3, 0.4999, Analysis::plane_strain, strain_4999, 0.005);
    coarse_4999.quantities.at(1).tolerance.reset();
    constexpr double coarse = 0.005, fine = 0.001, third = 1.0 / 3;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    return {{"E8-standard",
             "Cook's membrane on the grid that abut chooses",
             {{"verification/cook_standard.json"}},
             quantities(stress_third, coarse)},
            membrane("E8-coarse", "Cook's membrane, 16 cells of degree 2 across", 16, 2, third, ps, stress_third, coarse),
            membrane("E8-coarse-strain", "the same in plane strain", 16, 2, third, pe, strain_third, coarse),
            membrane("E8-fine", "Cook's membrane, 64 cells of degree 3 across", 64, 3, third, ps, stress_third, fine),
            membrane("E8-fine-strain", "the same in plane strain", 64, 3, third, pe, strain_third, fine),
            coarse_4999,
            membrane("E10-membrane-fine", "the same, 32 cells across", 32, 3, 0.4999, pe, strain_4999, coarse)};
}

}  // namespace abut
