// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of round faces in round holes: a pin (C6), shrink fits (C7), the dissertation's beam on four pins (S-D).
#include <cmath>
#include <numbers>

#include "src/io/number_text.hpp"
#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_pins {

/// Half angle of contact about the direction of the load, degrees.
double half_angle(const Answers& answers) {
    double angle = 0;
    for (const Vec2& end : contact_of(answers).ends)
        angle = std::max(angle, std::acos(end.dot(Vec2(1, 1).normalized()) / end.norm()) * 180 / std::numbers::pi);
    return angle;
}

/// R = 1, E = 1e5. The plate held at the radius Ro; p0 = R p0 / Q times Q.
VerifyProblem pin(const std::string& name, const std::string& about, double Ro, double dR, double Q, double p0, double angle) {
    constexpr double two_percent = 0.02, two_degrees = 2;
    return {name,
            about,
            {{"verification/pin_in_hole.json", {{"Ro", Ro}, {"dR", dR}, {"Q", Q}}}},
            {{"largest pressure over Q / R", [=](const Answers& a) { return peak(a) / Q; }, p0, two_percent},
             {"half angle of contact, degrees (error absolute)", half_angle, angle, two_degrees, 1}}};
}

/// Converged numbers for E' dR / Q = 1, the half angle to 0.06 and 0.02 degrees; else Persson's closed form (Ciavarella and
/// Decuzzi 2001) for the infinite plate, which a plate of thirty radii meets to 0.05 %.
std::vector<VerifyProblem> pins() {
    constexpr double dR = 0.001;
    return {pin("C6-pin", "a pin with clearance in a plate of ten radii, E dR / Q = 1", 10, dR, 100, 0.707662, 60.735),
            pin("C6-large", "the same in a plate of thirty", 30, dR, 100, 0.704956, 60.91),
            pin("C6-neat", "a neat pin, whatever its load", 30, 0, 100, 0.599629, 84.827946),
            pin("C6-neat-more", "the same pushed ten times as hard", 30, 0, 1000, 0.599629, 84.827946),
            pin("C6-half", "E dR / Q = 0.5", 30, dR, 200, 0.650841, 69.735445),
            pin("C6-ten", "E dR / Q = 10", 30, dR, 10, 1.383835, 27.137879)};
}

/// Lame: one pressure all round.
VerifyProblem shrink_fit(const std::string& name, const std::string& about, VerifyRun run, double p) {
    return {name,
            about,
            {std::move(run)},
            {{"mean pressure", [](const Answers& a) { return mean_pressure(contact_of(a)); }, p, 0.005},
             {"largest pressure", peak, p, 0.01},
             {"least pressure", [](const Answers& a) { return least_pressure(contact_of(a)); }, p, 0.01}}};
}

/// A ring of this wall on a shaft of radius 2 and the same material, interference 0.002.
VerifyProblem thin_ring(const std::string& name, double wall) {
    constexpr double delta = 0.002, E = 1e5, b = 2;
    const double c = b + wall;
    return shrink_fit(name, "a ring with a wall of " + number_text(wall, 2) + " on a solid shaft of radius 2",
                      {"verification/shrink_fit_solid.json", {{"t", wall}}}, delta * E / b * (c * c - b * b) / (2 * c * c));
}

/// Radii 1, 2, 3; interference 0.002.
std::vector<VerifyProblem> shrink_fits() {
    constexpr double p = 23.4375, delta = 0.002, eps = 5 * 1e5;
    const std::string rings = "verification/shrink_fit.json";
    return {shrink_fit("C7-shrink-fit", "two rings with an interference of 0.002", {rings}, p),
            shrink_fit("C7-strain", "the same in plane strain", {rings, {}, Analysis::plane_strain}, 25.755495),
            shrink_fit("C7-shaft", "a ring on a solid shaft", {"verification/shrink_fit_solid.json"}, 27.777778),
            thin_ring("C7-thin", 0.1),
            thin_ring("C7-thinner", 0.02),
            shrink_fit("C7-stiffer", "the inner ring ten times as stiff", {rings, {{"E1", 1e6}}}, 32.930845),
            shrink_fit("C7-penalty", "by penalty, which takes p / eps off the interference",
                       {rings, {}, {}, PenaltyOptions{5, 1}}, p / (1 + p / delta / eps))};
}

double tip(const Result& answer) {
    return answer.probes.at(0).displacement.y();
}

/// Forces of the pins on the beam over its load F, by contact.
void add_pin_forces(const std::vector<Vec2>& forces, double load, double tolerance, VerifyProblem& problem) {
    for (std::size_t k = 0; k < forces.size(); ++k)
        for (int c : {0, 1})
            problem.quantities.push_back({"pin " + std::to_string(k + 1) + " / F, " + "xy"[c],
                                          [=](const Answers& a) { return -a[0].contacts.at(k).force[c] / load; }, forces[k][c],
                                          tolerance, 1});
}

/// Converged numbers; tolerances of pin forces are on F.
std::vector<VerifyProblem> beams() {
    constexpr double F = 1000, two_percent = 0.02;
    const std::string scene = "scenes/four_pin_beam.json", coarse = "verification/dissertation_beam.json";
    VerifyProblem elastic{"S-D", "the dissertation's beam on four pins", {{scene}}, {}};
    elastic.quantities = {{"deflection of the tip", [](const Answers& a) { return tip(a[0]); }, -0.0981829, 0.002}};
    add_pin_forces({{0.3355, -0.2773}, {0.8802, 0.8819}, {-0.3386, -0.1736}, {-0.8771, 0.5691}}, F, 0.005, elastic);
    VerifyProblem rigid{"S-D-rigid", "the same on pins 1e4 times as stiff", {{scene, {{"E_pin", 1e9}}}}, {}};
    rigid.quantities = {{"deflection of the tip", [](const Answers& a) { return tip(a[0]); }, -0.0826608, two_percent}};
    add_pin_forces({{0.3110, -0.2520}, {0.9479, 0.9574}, {-0.2593, -0.1558}, {-0.9996, 0.4505}}, F, two_percent, rigid);
    VerifyProblem bodies = rigid;
    bodies.name = "S-D-bodies";
    bodies.about = "the same on pins that are stiff enough to be taken as rigid bodies";
    bodies.runs = {{scene, {{"E_pin", 1e12}}}};
    VerifyProblem linear{
        "S-D-linear", "neat holes: the answer is proportional to the load", {{coarse}, {coarse, {{"F", 2 * F}}}}, {}};
    linear.quantities = {{"tip at 2 F over tip at F", [](const Answers& a) { return tip(a[1]) / tip(a[0]); }, 2, 1e-9}};
    return {std::move(elastic), std::move(rigid), std::move(bodies), std::move(linear)};
}

}  // namespace verify_pins

std::vector<VerifyProblem> pin_problems() {
    using namespace verify_pins;
    std::vector<VerifyProblem> problems;
    for (const auto& group : {pins(), shrink_fits(), beams()}) problems.insert(problems.end(), group.begin(), group.end());
    return problems;
}

}  // namespace abut
