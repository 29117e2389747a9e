// SPDX-License-Identifier: GPL-3.0-or-later
// Contact problems, at the accuracy that abut chooses: Hertz (C1), a pin with clearance (C6), a shrink fit (C7), a gap closed
// by its load (C9), and the dissertation's scenes with sizes of our own (S-B, S-C, S-E).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/verify_problem.hpp"

namespace abut {

namespace {

constexpr double statics = 1e-6, one_cell = 1.0 / 12;  // of a contact's length: there are 12 in each

const ContactResult& contact_of(const Answers& answers) {
    return answers.at(0).contacts.at(0);
}

double peak(const Answers& answers) {
    return contact_of(answers).max_pressure.value;
}

double force(const Answers& answers) {
    return contact_of(answers).force.norm();
}

/// Of models with a symmetry about x = 0, where forces along x are no matter of statics.
double vertical_force(const Answers& answers) {
    return std::abs(contact_of(answers).force.y());
}

/// Of models cut at x = 0.
double half_width(const Answers& answers) {
    double width = 0;
    for (const Vec2& end : contact_of(answers).ends) width = std::max(width, std::abs(end.x()));
    return width;
}

/// Line contact in plane stress: radii of the bodies (negative where concave), their common E, the full load per thickness.
struct Hertz {
    double a, p0;
};
Hertz hertz(double radius1, double radius2, double E, double load) {
    const double radius = 1 / (1 / radius1 + 1 / radius2), modulus = E / 2;
    const double a = std::sqrt(4 * load * radius / (std::numbers::pi * modulus));
    return {a, 2 * load / (std::numbers::pi * a)};
}

/// Scenes that model half of the contact carry half of the load.
VerifyProblem hertz_problem(const std::string& name, const std::string& about, const std::string& scene, const Hertz& exact,
                            double force_of_model, double peak_tolerance) {
    return {name,
            about,
            {{scene}},
            {{"largest pressure", peak, exact.p0, peak_tolerance},
             {"half width", half_width, exact.a, one_cell},
             {"contact force along y", vertical_force, force_of_model, statics}}};
}

double mean_pressure(const Answers& answers) {
    const std::vector<double>& p = contact_of(answers).profile.pressure;
    double sum = 0;
    for (double value : p) sum += value;
    return sum / static_cast<double>(p.size());
}

double least_pressure(const Answers& answers) {
    const std::vector<double>& p = contact_of(answers).profile.pressure;
    return *std::min_element(p.begin(), p.end());
}

VerifyProblem shrink_fit() {
    return {"C7-shrink-fit",
            "two rings with an interference of 0.002",
            {{"verification/shrink_fit.json"}},
            {{"mean pressure", mean_pressure, 23.4375, 0.005},
             {"largest pressure", peak, 23.4375, 0.01},
             {"least pressure", least_pressure, 23.4375, 0.01}}};
}

/// Half angle of contact about the direction of the load, degrees.
double half_angle(const Answers& answers) {
    double angle = 0;
    for (const Vec2& end : contact_of(answers).ends)
        angle = std::max(angle, std::acos(end.dot(Vec2(1, 1).normalized()) / end.norm()) * 180 / std::numbers::pi);
    return angle;
}

/// A ring held at ten radii; converged numbers, the half angle to 0.06 degrees.
VerifyProblem pin_in_hole() {
    constexpr double two_degrees = 2;
    return {"C6-pin",
            "a pin with clearance in a ring",
            {{"verification/pin_in_hole.json"}},
            {{"largest pressure", peak, 70.7662, 0.02},
             {"half angle of contact, degrees (error absolute)", half_angle, 60.735, two_degrees, 1}}};
}

VerifyProblem closed_gap() {
    constexpr double exact = 1e-8;
    return {"C9-gap",
            "a bar closes a gap of 0.3 and presses on another",
            {{"verification/gap_closed_by_load.json"}},
            {{"contact force", force, 140, exact},
             {"u(1, 0.5)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, 0.86, exact}}};
}

double gap_at_top(const Answers& answers) {
    const ContactProfile& p = contact_of(answers).profile;
    return p.gap.at(static_cast<std::size_t>(std::max_element(p.y.begin(), p.y.end()) - p.y.begin()));
}

/// Converged numbers, four digits.
VerifyProblem vise() {
    return {"S-E",
            "the dissertation's vise",
            {{"scenes/vise.json"}},
            {{"contact force", force, 429.60, 0.01},
             {"gap at the top", gap_at_top, 3.0749e-3, 0.02},
             {"u(1, 1.1)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, 3.6168e-3, std::nullopt},
             {"strain energy", [](const Answers& a) { return a[0].strain_energy; }, 2.148032, std::nullopt}}};
}

}  // namespace

std::vector<VerifyProblem> contact_problems() {
    constexpr double ten_cells = 0.01, fine = 0.015;
    const double load_per_thickness = 200;
    return {
        hertz_problem("C1-equal", "two equal cylinders, contact of a hundredth of the radius", "verification/hertz_001.json",
                      hertz(1, 1, 1e5, 2 * 3.92699081698724), 3.92699081698724, ten_cells),
        hertz_problem("C1-cam", "a cam as a NURBS under an elliptic crown", "scenes/cam_follower.json",
                      hertz(49.0 / 12, 37.5, 210000, load_per_thickness), 2000, ten_cells),
        pin_in_hole(),
        shrink_fit(),
        closed_gap(),
        hertz_problem("S-B", "the dissertation's convex cylinders", "scenes/case_b.json", {0.0921318, 3452.24}, 250, ten_cells),
        hertz_problem("S-C", "the dissertation's cylinder in a groove", "scenes/case_c.json", {0.159577, 1995.355}, 250, fine),
        vise()};
}

}  // namespace abut
