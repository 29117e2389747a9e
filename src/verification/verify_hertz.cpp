// SPDX-License-Identifier: GPL-3.0-or-later
// Line contact of curved bodies: Hertz (C1), the roller on a block of NAFEMS (C2), flats with fillets (C4), a wedge (C5), the
// dissertation's cases B and C with sizes of our own (S-B, S-C).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/io/number_text.hpp"
#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_hertz {

constexpr double statics = 1e-6, one_cell = 1.0 / 12;  // of a contact's length: there are 12 in each
constexpr double ten_cells = 0.01, fine = 0.015;       // of the largest pressure

double half_width_of(const Answers& answers) {
    return half_width(contact_of(answers));
}

/// Of the pressure, in the mean square over the profile; of models cut at x = 0.
template <class Theory>
double pressure_deviation(const ContactProfile& profile, const Theory& exact) {
    std::vector<double> pressure, theory;
    for (std::size_t i = 0; i + 1 < profile.x.size(); ++i) {
        const double weight = std::sqrt(std::abs(profile.x[i + 1] - profile.x[i]));
        pressure.push_back(weight * 0.5 * (profile.pressure[i] + profile.pressure[i + 1]));
        theory.push_back(weight * exact.pressure(0.5 * (profile.x[i] + profile.x[i + 1])));
    }
    return relative_error_norm(pressure, theory);
}

/// Scenes that model half of the contact carry half of the load.
VerifyProblem hertz_problem(const std::string& name, const std::string& about, VerifyRun run, const Hertz& exact,
                            double force_of_model, double peak_tolerance) {
    return {
        name,
        about,
        {std::move(run)},
        {{"pressure, L2 error", [=](const Answers& a) { return pressure_deviation(contact_of(a).profile, exact); }, 0, {}, 1},
         {"largest pressure", peak, exact.p0, peak_tolerance},
         {"half width", half_width_of, exact.a, one_cell},
         {"contact force along y", vertical_force, force_of_model, statics}}};
}

/// C1's table: E = 1e5, nu = 0.3, Q = 500; of the cylinders 1/E* = compliance / E'.
std::vector<VerifyProblem> c1_variants() {
    struct Variant {
        std::string name, about, scene;
        std::map<std::string, double> parameters;
        double radius, compliance;
    };
    constexpr double rigid = 1e4, E = 1e5, nu = 0.3, Q = 500;
    const std::vector<Variant> variants{
        {"C1-convex", "cylinders of radius 1 and 2", "scenes/case_b.json", {}, 1 / 1.5, 2},
        {"C1-groove", "a cylinder of radius 1 in a groove of 2", "scenes/case_c.json", {}, 1 / 0.5, 2},
        {"C1-plane", "a cylinder on a plane", "verification/cylinder_on_plane.json", {}, 1, 2},
        {"C1-rigid",
         "a cylinder 1e4 times as stiff as the plane",
         "verification/cylinder_on_plane.json",
         {{"E1", rigid * E}},
         1,
         1 + 1 / rigid},
        {"C1-body", "a rigid cylinder on a plane", "verification/rigid_cylinder.json", {}, 1, 1}};
    std::vector<VerifyProblem> problems;
    for (const Variant& v : variants)
        for (const bool strain : {false, true}) {
            const double modulus = (strain ? E / (1 - nu * nu) : E) / v.compliance;
            const VerifyRun run{v.scene, v.parameters, strain ? Analysis::plane_strain : Analysis::plane_stress};
            problems.push_back(hertz_problem(v.name + (strain ? "-strain" : ""), v.about + (strain ? ", plane strain" : ""),
                                             run, hertz(v.radius, modulus, Q), Q / 2, ten_cells));
        }
    return problems;
}

/// Konter 2006, benchmark 1; the block's displacement by our own converged model of the same half roller.
VerifyProblem roller() {
    VerifyProblem problem = hertz_problem("C2-roller", "NAFEMS: a steel roller on an aluminium block",
                                          {"verification/roller_on_block.json"}, {6.214627867, 3585.362231}, 17500, 0.02);
    problem.quantities.push_back(
        {"u_y on top of the block", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, -1.29707, 0.015});
    return problem;
}

/// Johnson 1985, 5.2.
VerifyProblem wedge() {
    constexpr double a = 0.02, E = 1e5 / (1 + 1e-4), slope = 0.05, two_percent = 0.02;
    VerifyProblem problem{
        "C5-wedge", "a blunt wedge; the pressure has no limit under its edge", {{"verification/wedge.json"}}, {}};
    for (double x : {0.1, 0.3, 0.5, 0.7, 0.9})
        problem.quantities.push_back({"p at " + std::to_string(x).substr(0, 3) + " a",
                                      [=](const Answers& r) { return pressure_at_x(contact_of(r), x * a); },
                                      E * slope / std::numbers::pi * std::acosh(1 / x), two_percent});
    problem.quantities.push_back({"half width", half_width_of, a, one_cell});
    problem.quantities.push_back({"contact force along y", vertical_force, 50, statics});
    return problem;
}

/// A flat of half width b with fillets of radius R, pressed until it touches to a half width a [Ciavarella1998].
struct FilletedPunch {
    double b, radius, modulus, a;

    double angle() const { return std::asin(b / a); }
    double load() const {
        const double t = angle(), sine = std::sin(t);
        return modulus * b * b / (2 * radius) * ((std::numbers::pi - 2 * t) / (2 * sine * sine) - 1 / std::tan(t));
    }
    double pressure(double x) const {
        if (std::abs(x) >= a) return 0;
        const double t0 = angle(), t = std::asin(std::abs(x) / a), open = std::numbers::pi - 2 * t0;
        const double roots = open * std::cos(t) + std::sin(t) * std::log(std::abs(std::sin(t + t0) / std::sin(t - t0))) +
                             std::sin(t0) * std::log(std::abs(std::tan((t + t0) / 2) * std::tan((t - t0) / 2)));
        return 2 / std::numbers::pi * load() / a * roots / (open - std::sin(2 * t0));
    }
    double peak() const {
        constexpr int steps = 10000;  // between the fillet's joint, beyond which it stands, and the end
        double largest = 0;
        for (int i = 0; i < steps; ++i) largest = std::max(largest, pressure(b + (i + 0.5) / steps * (a - b)));
        return largest;
    }
};

/// beyond: how far the contact reaches into the fillet, of the flat's half width. Pressures are 1e-4 E: at 1e-2 the theory
/// itself is off by per cents.
VerifyProblem filleted_punch(const std::string& name, double radius, double beyond) {
    constexpr double b = 0.02, E = 1e5 / (1 + 1e-4), beyond_the_flat = 0.015;
    const FilletedPunch exact{b, radius, E, (1 + beyond) * b};
    return {
        name,
        "a flat with fillets, pressed on over " + number_text(beyond, 3) + " of its half width beyond them",
        {{"verification/filleted_punch.json", {{"R", radius}, {"P", exact.load()}}}},
        {{"pressure, L2 error", [=](const Answers& r) { return pressure_deviation(contact_of(r).profile, exact); }, 0, fine, 1},
         {"largest pressure", peak, exact.peak(), fine},
         {"contact beyond the flat", [](const Answers& r) { return half_width_of(r) - b; }, exact.a - b, beyond_the_flat},
         {"contact force along y", vertical_force, 0.5 * exact.load(), statics}}};
}

}  // namespace verify_hertz

std::vector<VerifyProblem> hertz_problems() {
    using namespace verify_hertz;
    constexpr double load_per_thickness = 200, force = 3.92699081698724;
    std::vector<VerifyProblem> problems{
        hertz_problem("C1-equal", "two equal cylinders, contact of a hundredth of the radius", {"verification/hertz_001.json"},
                      hertz(0.5, 0.5e5, 2 * force), force, ten_cells),
        hertz_problem("C1-cam", "a cam as a NURBS under an elliptic crown", {"scenes/cam_follower.json"},
                      hertz(1 / (12 / 49.0 + 1 / 37.5), 105000, load_per_thickness), 2000, ten_cells)};
    for (VerifyProblem& problem : c1_variants()) problems.push_back(std::move(problem));
    problems.push_back(roller());
    problems.push_back(filleted_punch("C4-fillet", 10, 0.1));
    problems.push_back(filleted_punch("C4-fillet-small", 1, 0.005));
    problems.push_back(wedge());
    problems.push_back(hertz_problem("S-B", "the dissertation's convex cylinders", {"scenes/case_b.json"}, {0.0921318, 3452.24},
                                     250, ten_cells));
    problems.push_back(hertz_problem("S-C", "the dissertation's cylinder in a groove", {"scenes/case_c.json"},
                                     {0.159577, 1995.355}, 250, fine));
    return problems;
}

}  // namespace abut
