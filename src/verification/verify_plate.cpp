// SPDX-License-Identifier: GPL-3.0-or-later
// E3: Kirsch's plate with a hole [Timoshenko70, art. 35], R = 1, tension 1 along x.
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "src/verification/verify_errors.hpp"
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_plate {

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

std::vector<Quantity> quantities(Analysis analysis, double tolerance) {
    const Elastic m = elastic(analysis);
    return {{"sxx(0, 1)", [](const Answers& a) { return a[0].probes.at(0).stress.xx; }, 3, tolerance},
            {"syy(1, 0)", [](const Answers& a) { return a[0].probes.at(1).stress.yy; }, -1, tolerance},
            {"ux(1, 0)", [](const Answers& a) { return a[0].probes.at(1).displacement.x(); }, displacement({1, 0}, m).x(),
             tolerance},
            {"uy(0, 1)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, displacement({0, 1}, m).y(),
             tolerance},
            {"stress, worst anywhere", [](const Answers& a) { return largest_stress_error(a[0], stress); }, 0, tolerance, 1}};
}

/// The grid that abut chooses has 6 cells a radius, where the references' tolerances are for 8: the peak alone is judged.
std::vector<Quantity> standard_quantities(double tolerance) {
    std::vector<Quantity> list = quantities(Analysis::plane_stress, tolerance);
    for (std::size_t k = 1; k < list.size(); ++k) list[k].tolerance.reset();
    return list;
}

VerifyRun even(double h, double p) {
    return {"verification/plate_with_hole.json", {{"h", h}, {"p", p}}};
}

/// Half the work of the tractions on the sides x = 4 and y = 4; the others do none.
double energy() {
    constexpr double side = 4;
    constexpr int n = 40;  // far more points than the smooth integrand needs
    const Elastic m = elastic(Analysis::plane_stress);
    const geometry::GaussRule& rule = geometry::gauss_rule(n);
    double twice = 0;
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const double s = side * rule.points[k], w = side * rule.weights[k];
        const Vec2 right(side, s), top(s, side);
        const Stress r = stress(right), t = stress(top);
        twice += w * (Vec2(r.xx, r.xy).dot(displacement(right, m)) + Vec2(t.xy, t.yy).dot(displacement(top, m)));
    }
    return 0.5 * twice;
}

/// Of the energy norm, from two runs whose cells differ by a factor 2.
double rate(const Answers& answers) {
    const double exact = energy();
    return 0.5 * std::log2((exact - answers.at(0).strain_energy) / (exact - answers.at(1).strain_energy));
}

VerifyProblem rates(int degree, double coarse) {
    constexpr double rate_tolerance = 0.2;
    const std::string p = std::to_string(degree);
    return {"E3-rate-" + p,
            "its rate of convergence, degree " + p,
            {even(coarse, degree), even(coarse / 2, degree)},
            {{"rate of the energy norm", rate, static_cast<double>(degree), rate_tolerance, 1}}};
}

}  // namespace verify_plate

std::vector<VerifyProblem> plate_problems() {
    using namespace verify_plate;
    const auto ps = Analysis::plane_stress, pe = Analysis::plane_strain;
    constexpr double coarse = 0.01, fine = 0.001;
    VerifyRun strain = even(0.125, 2);
    strain.analysis = pe;
    return {{"E3-standard",
             "plate with a hole on the grid that abut chooses",
             {{"verification/kirsch.json"}},
             standard_quantities(coarse)},
            {"E3-coarse", "plate with a hole, 8 cells of degree 2 a radius", {even(0.125, 2)}, quantities(ps, coarse)},
            {"E3-coarse-strain", "the same in plane strain", {strain}, quantities(pe, coarse)},
            {"E3-fine", "plate with a hole, 20 cells of degree 3 a radius", {even(0.05, 3)}, quantities(ps, fine)},
            rates(2, 0.25),
            rates(3, 0.25)};
}

}  // namespace abut
