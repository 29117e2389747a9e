// SPDX-License-Identifier: GPL-3.0-or-later
// E5: discs that spin, b = 1, rho w^2 = 1e4 [Timoshenko70, art. 32]; in plane strain with E / (1 - nu^2) and nu / (1 - nu).
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_spin {

constexpr double a = 0.25, q = 1e4;  // radius of the hole, rho w^2 b^2

struct Disc {
    double E = 1e5, nu = 0.3;  ///< those of plane stress that stand for the case
    double middle() const { return (3 + nu) / 8 * q; }
    double rim() const { return (1 - nu) / 4 * q; }
    double at_hole() const { return q / 4 * (3 + nu + (1 - nu) * a * a); }
};
Disc disc_in(Analysis analysis) {
    return analysis == Analysis::plane_stress ? Disc{} : Disc{1e5 / (1 - 0.09), 0.3 / 0.7};
}

VerifyProblem solid(const std::string& name, const std::string& about, Analysis analysis) {
    const Disc d = disc_in(analysis);
    const double zz = analysis == Analysis::plane_strain ? 0.3 * 2 * d.middle() : 0;
    return {name,
            about,
            {{"verification/spin_disc.json", {}, analysis}},
            {{"srr(0)", [](const Answers& r) { return r[0].probes.at(0).stress.xx; }, d.middle(), 1e-3},
             {"szz(0)", [](const Answers& r) { return r[0].probes.at(0).stress.zz; }, zz, 1e-3, d.middle()},
             {"stt(b)", [](const Answers& r) { return r[0].probes.at(1).stress.yy; }, d.rim(), 5e-3},
             {"u(b)", [](const Answers& r) { return r[0].probes.at(1).displacement.x(); }, d.rim() / d.E, 1e-3}}};
}

VerifyProblem with_hole(const std::string& name, const std::string& about, Analysis analysis) {
    const Disc d = disc_in(analysis);
    return {name,
            about,
            {{"verification/spin_ring.json", {}, analysis}},
            {{"stt(a)", [](const Answers& r) { return r[0].probes.at(0).stress.yy; }, d.at_hole(), 5e-3},
             {"u(a)", [](const Answers& r) { return r[0].probes.at(0).displacement.x(); }, a * d.at_hole() / d.E, 1e-3}}};
}

}  // namespace verify_spin

std::vector<VerifyProblem> spin_problems() {
    using namespace verify_spin;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    return {solid("E5-spin", "a disc that spins, away from the origin", ps),
            solid("E5-spin-strain", "the same in plane strain", pe), with_hole("E5-hole", "a disc with a hole that spins", ps),
            with_hole("E5-hole-strain", "the same in plane strain", pe)};
}

}  // namespace abut
