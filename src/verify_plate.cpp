// SPDX-License-Identifier: GPL-3.0-or-later
// E3: Kirsch's plate with a hole [Timoshenko70, art. 35], R = 1, tension 1 along x.
#include <cmath>

#include "src/verify_errors.hpp"
#include "src/verify_problem.hpp"

namespace abut {

namespace {

constexpr double E = 1e5, nu = 0.3;

/// G and Kolosov's constant.
struct Elastic {
    double G, kappa;
};
Elastic elastic(Analysis analysis) {
    return {E / (2 * (1 + nu)), analysis == Analysis::plane_strain ? 3 - 4 * nu : (3 - nu) / (1 + nu)};
}

Vec2 displacement(const Vec2& p, const Elastic& m) {
    const double r = p.norm(), t = std::atan2(p.y(), p.x()), r3 = r * r * r;
    return Vec2(r * (m.kappa + 1) * std::cos(t) + 2 / r * ((1 + m.kappa) * std::cos(t) + std::cos(3 * t)) -
                    2 / r3 * std::cos(3 * t),
                r * (m.kappa - 3) * std::sin(t) + 2 / r * ((1 - m.kappa) * std::sin(t) + std::sin(3 * t)) -
                    2 / r3 * std::sin(3 * t)) /
           (8 * m.G);
}

Stress stress(const Vec2& p) {
    const double t = std::atan2(p.y(), p.x()), q = 1 / p.squaredNorm();
    const double c2 = std::cos(2 * t), s2 = std::sin(2 * t), c4 = std::cos(4 * t), s4 = std::sin(4 * t);
    return {1 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4, -q * (0.5 * c2 - c4) - 1.5 * q * q * c4,
            -q * (0.5 * s2 + s4) + 1.5 * q * q * s4, 0};
}

struct Tolerances {
    double peak, displacement;
};

std::vector<Quantity> quantities(Analysis analysis, const Tolerances& tolerance) {
    const Elastic m = elastic(analysis);
    return {
        {"sxx(0, 1)", [](const Answers& a) { return a[0].probes.at(0).stress.xx; }, 3, tolerance.peak},
        {"syy(1, 0)", [](const Answers& a) { return a[0].probes.at(1).stress.yy; }, -1, tolerance.peak},
        {"ux(1, 0)", [](const Answers& a) { return a[0].probes.at(1).displacement.x(); }, displacement({1, 0}, m).x(),
         tolerance.displacement},
        {"uy(0, 1)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, displacement({0, 1}, m).y(),
         tolerance.displacement},
        {"stress, worst anywhere", [](const Answers& a) { return largest_stress_error(a[0], stress); }, 0, tolerance.peak, 1}};
}

VerifyRun even(double h, double p) {
    return {"verification/plate_with_hole.json", {{"h", h}, {"p", p}}};
}

/// The rate of the displacement's L2 norm from the runs k and k + 1, whose cells differ by a factor 2.
double rate(const Answers& answers, std::size_t k) {
    const auto u = [](const Vec2& p) { return displacement(p, elastic(Analysis::plane_stress)); };
    return std::log2(mean_displacement_error(answers.at(k), u) / mean_displacement_error(answers.at(k + 1), u));
}

VerifyProblem rates(int degree, double coarse) {
    constexpr double rate_tolerance = 0.2;
    const std::string p = std::to_string(degree);
    return {"E3-rate-" + p,
            "its rate of convergence, degree " + p,
            {even(coarse, degree), even(coarse / 2, degree)},
            {{"rate of the displacement's L2 error", [](const Answers& a) { return rate(a, 0); }, degree + 1.0, rate_tolerance,
              1}}};
}

}  // namespace

std::vector<VerifyProblem> plate_problems() {
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    const Tolerances coarse{0.01, 0.01}, fine{0.001, 0.001};
    VerifyRun strain = even(0.125, 2);
    strain.analysis = pe;
    return {{"E3-standard",
             "plate with a hole on the grid that abut chooses",
             {{"verification/kirsch.json"}},
             quantities(ps, coarse)},
            {"E3-coarse", "plate with a hole, 8 cells of degree 2 a radius", {even(0.125, 2)}, quantities(ps, coarse)},
            {"E3-coarse-strain", "the same in plane strain", {strain}, quantities(pe, coarse)},
            {"E3-fine", "plate with a hole, 20 cells of degree 3 a radius", {even(0.05, 3)}, quantities(ps, fine)},
            rates(2, 0.125),
            rates(3, 0.25)};
}

}  // namespace abut
