// SPDX-License-Identifier: GPL-3.0-or-later
// R: around an axis. Lame's cylinder and sphere, cylinders that spin, are warm or are shrunk together (long ones: plane
// strain), Hertz' contact of spheres (Johnson 1985, chapter 4; Timoshenko and Goodier, arts. 136 and 140), uniform strain.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/verification/verify_contact_answers.hpp"
#include "src/verification/verify_errors.hpp"

namespace abut {

namespace verify_axisymmetric {

constexpr double E = 1e5, pi = std::numbers::pi;

Quantity probe(const std::string& what, std::size_t k, double (*value)(const ProbeResult&), double reference, double tolerance,
               double scale = 0) {
    return {what, [=](const Answers& r) { return value(r[0].probes.at(k)); }, reference, tolerance, scale};
}
double ux(const ProbeResult& p) {
    return p.displacement.x();
}
double rr(const ProbeResult& p) {
    return p.stress.xx;
}
double yy(const ProbeResult& p) {
    return p.stress.yy;
}
double hoop(const ProbeResult& p) {
    return p.stress.zz;
}

/// Worst stress of all four components over the samples, against one uniform stress.
double uniform_stress_error(const Result& r, const Stress& s) {
    double worst = 0;
    for (const FieldSample& f : r.fields.at(0).samples)
        worst = std::max({worst, std::abs(f.stress.xx - s.xx), std::abs(f.stress.yy - s.yy), std::abs(f.stress.xy - s.xy),
                          std::abs(f.stress.zz - s.zz)});
    return worst / std::abs(s.yy);
}

VerifyProblem uniform(const std::string& name, const std::string& about, const std::string& scene, double nu, double p,
                      const Stress& s) {
    const double err = (s.xx - nu * (s.yy + s.zz)) / E, eyy = (s.yy - nu * (s.xx + s.zz)) / E;
    const auto u = [=](const Vec2& x) { return Vec2(err * x.x(), eyy * x.y()); };
    constexpr double exact = 1e-9;
    return {
        name,
        about,
        {{"verification/" + scene + ".json", {{"nu", nu}, {"p", p}}}},
        {{"displacement, worst anywhere", [u](const Answers& r) { return largest_displacement_error(r[0], u); }, 0, exact, 1},
         {"stress, worst anywhere", [s](const Answers& r) { return uniform_stress_error(r[0], s); }, 0, exact, 1},
         probe("hoop stress on the axis", 0, hoop, s.zz, exact)}};
}

/// The stress of strains -2e-3 along the axis, 1e-3 in the section and around: no volume strain.
Stress stress_of_cone(double nu) {
    const double twice_mu = E / (1 + nu);
    return {twice_mu * 1e-3, twice_mu * -2e-3, 0, twice_mu * 1e-3};
}

std::vector<VerifyProblem> patches() {
    const Stress bar{-30, -100, 0, -30};
    return {uniform("R-bar", "a round bar under uniform stress, axis included", "round_bar", 0.3, 2, bar),
            uniform("R-bar-cubic", "the same, degree 3", "round_bar", 0.3, 3, bar),
            uniform("R-bar-incompressible", "the same, nu = 0.4999", "round_bar", 0.4999, 2, bar),
            uniform("R-cone", "uniform strain in a cone with a bite, cut cells all over", "cone", 0.3, 2, stress_of_cone(0.3)),
            uniform("R-cone-cubic", "the same, degree 3", "cone", 0.3, 3, stress_of_cone(0.3))};
}

/// a = 1, b = 2, p = 100 inside; the hoop is zz.
VerifyProblem cylinder(const std::string& name, const std::string& about, double nu, double tolerance) {
    const double k = 100.0 / 3, u = k * (1 + nu) / E * (1 - 2 * nu + 4);
    return {name,
            about,
            {{"verification/cylinder_rz.json", {{"nu", nu}}}},
            {probe("u(a)", 0, ux, u, tolerance), probe("srr(a)", 0, rr, -100, 10 * tolerance),
             probe("stt(a)", 0, hoop, 5 * k, 10 * tolerance), probe("stt(b)", 1, hoop, 2 * k, 10 * tolerance),
             probe("syy(a)", 0, yy, nu * 2 * k, 10 * tolerance, 100)}};
}

VerifyProblem sphere(const std::string& name, const std::string& about, double nu, double p, double n) {
    const double k = 100.0 / 7;  // srr, stt = k (1 - b^3 / r^3), k (1 + b^3 / 2 r^3)
    const auto u = [=](double r) { return k / E * ((1 - 2 * nu) * r + (1 + nu) * 4 / (r * r)); };
    return {name,
            about,
            {{"verification/hollow_sphere.json", {{"nu", nu}, {"p", p}, {"n", n}}}},
            {probe("u(a) at the equator", 0, ux, u(1), 1e-3),
             probe("u(b) at the equator", 1, ux, u(2), 1e-3),
             {"u(a) at the pole", [](const Answers& r) { return r[0].probes.at(2).displacement.y(); }, u(1), 1e-3},
             probe("stt(a), around", 0, hoop, 5 * k, 0.01),
             probe("stt(a), along", 0, yy, 5 * k, 0.01),
             probe("srr(a)", 0, rr, -100, 0.01),
             probe("stt(b)", 1, hoop, 1.5 * k, 0.01),
             probe("hoop stress at the pole", 2, hoop, 5 * k, 0.01)}};
}

/// rho w^2 b^2 = 1e4, plane strain's E and nu.
VerifyProblem spinning(const std::string& name, const std::string& about, double hole) {
    const double nu = 0.3 / 0.7, e = E / (1 - 0.09), q = 1e4;
    const double inner = hole > 0 ? q / 4 * (3 + nu + (1 - nu) * hole * hole) : (3 + nu) / 8 * q;
    const double outer = q / 4 * (1 - nu + (3 + nu) * hole * hole);
    return {
        name,
        about,
        {{"verification/spin_cylinder.json", {{"a", hole}}}},
        {probe("stt(a)", 0, hoop, inner, 5e-3), probe("stt(b)", 1, hoop, outer, 5e-3), probe("u(b)", 1, ux, outer / e, 1e-3)}};
}

VerifyProblem warm(const std::string& name, const std::string& about, double nu, double p) {
    const double log2 = std::numbers::ln2, k = 240 / (2 * log2) / (1 - nu), inner = k * (1 - 8.0 / 3 * log2);
    return {name,
            about,
            {{"verification/warm_cylinder.json", {{"nu", nu}, {"p", p}}}},
            {probe("stt(a)", 0, hoop, inner, 5e-3), probe("stt(b)", 1, hoop, k * (1 - 2.0 / 3 * log2), 5e-3),
             probe("syy(a)", 0, yy, nu * inner - 240, 5e-3)}};
}

/// Interference 0.002 at radius 2; force: of the pressure over the whole seat, a length of 1.
VerifyProblem press_fit(const std::string& name, const std::string& about, VerifyRun run, double p) {
    return {name,
            about,
            {std::move(run)},
            {{"mean pressure", [](const Answers& a) { return mean_pressure(contact_of(a)); }, p, 1e-3},
             {"largest pressure", peak, p, 1e-3},
             {"least pressure", [](const Answers& a) { return least_pressure(contact_of(a)); }, p, 1e-3},
             {"radial force on the seat", [](const Answers& a) { return -contact_of(a).force.x(); }, p * 4 * pi, 1e-3}}};
}

struct PointContact {
    double a, p0;
};
/// Bodies that yield: two of equal materials with nu = 0.3, or one; radius: 1 / (1/R1 + 1/R2).
PointContact point_contact(double radius, double load, int yielding) {
    const double modulus = E / (yielding * (1 - 0.09)), a = std::cbrt(0.75 * load * radius / modulus);
    return {a, 1.5 * load / (pi * a * a)};
}

/// Relative L2 error of the pressure along the radius, at points all over the contact.
double profile_error(const ContactResult& contact, const PointContact& hertz) {
    std::vector<double> value, exact;
    constexpr int points = 200;
    for (int k = 0; k < points; ++k) {
        const double x = hertz.a * (k + 0.5) / points;
        value.push_back(pressure_at_x(contact, x));
        exact.push_back(hertz.p0 * std::sqrt(1 - x * x / (hertz.a * hertz.a)));
    }
    return relative_error_norm(value, exact);
}

/// a / R = 0.03: the closed form leaves out terms of its square.
VerifyProblem spheres(const std::string& name, const std::string& about, const std::string& scene, double radius, double load,
                      int yielding = 2) {
    const PointContact h = point_contact(radius, load, yielding);
    constexpr double one_percent = 0.01;
    return {name,
            about,
            {{"verification/" + scene + ".json", {{"F", load}}}},
            {{"largest pressure", peak, h.p0, one_percent},
             {"radius of contact", [](const Answers& a) { return half_width(contact_of(a)); }, h.a, one_percent},
             {"pressure, L2", [h](const Answers& a) { return profile_error(contact_of(a), h); }, 0, 2 * one_percent, 1},
             {"force", vertical_force, load, 1e-6}}};
}

}  // namespace verify_axisymmetric

std::vector<VerifyProblem> axisymmetric_problems() {
    using namespace verify_axisymmetric;
    std::vector<VerifyProblem> problems = patches();
    const std::vector<VerifyProblem> others{
        cylinder("R-cylinder", "Lame's cylinder, ends held", 0.3, 1e-3),
        cylinder("R-cylinder-incompressible", "the same, nu = 0.4999", 0.4999, 1e-3),
        sphere("R-sphere", "Lame's hollow sphere, 28 cells of degree 2 over b", 0.3, 2, 28),
        sphere("R-sphere-cubic", "20 cells of degree 3", 0.3, 3, 20),
        sphere("R-sphere-incompressible", "28 cells of degree 2, nu = 0.4999", 0.4999, 2, 28),
        spinning("R-spin", "a solid cylinder that spins", 0),
        spinning("R-spin-bore", "the same with a bore", 0.25),
        warm("R-warm", "heat flows outward through a cylinder", 0.3, 2),
        warm("R-warm-incompressible", "the same, nu = 0.4999, degree 3", 0.4999, 3),
        press_fit("R-press-fit", "two tubes shrunk together", {"verification/shrink_fit_rz.json", {{"bore", 1}}}, 25.755495),
        press_fit("R-press-fit-shaft", "a tube on a solid shaft", {"verification/shrink_fit_rz.json", {{"bore", 0}}},
                  30.525031),
        press_fit("R-press-fit-rigid", "a tube on a rigid shaft", {"verification/rigid_shaft_rz.json", {}}, 36.284470),
        spheres("R-hertz-flat", "a sphere on a flat block", "hertz_sphere_on_flat", 10, 197.802),
        spheres("R-hertz-spheres", "two spheres, radii 10 and 5", "hertz_spheres", 10.0 / 3, 21.978),
        spheres("R-hertz-rigid", "a rigid sphere on a flat block", "rigid_sphere_rz", 10, 395.604, 1)};
    problems.insert(problems.end(), others.begin(), others.end());
    return problems;
}

}  // namespace abut
