// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that go far before they rest (L1 to L7), each from three drawn places and more: the answer is that of the place of
// rest.
#include <cmath>
#include <numbers>

#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_motion {

constexpr double statics = 1e-6, stated = 0.01;  // the error aimed at
constexpr double degree = std::numbers::pi / 180;

double force_of(const Answers& answers, std::size_t run, std::size_t contact) {
    return answers.at(run).contacts.at(contact).force.norm();
}

double peak_of(const Answers& answers, std::size_t run, std::size_t contact) {
    return answers.at(run).contacts.at(contact).max_pressure.value;
}

std::string from(std::size_t run) {
    return ", place " + std::to_string(run);
}

/// The first run is drawn at rest, the others elsewhere; the load is pushed at any angle in the last.
VerifyProblem loose_pin() {
    constexpr double F = 1000;
    VerifyProblem problem{"L1",
                          "a pin with a tenth of the radius as clearance, drawn anywhere in its hole",
                          {{"verification/loose_pin.json", {{"py", -1}}},
                           {"verification/loose_pin.json"},
                           {"verification/loose_pin.json", {{"py", 1}}},
                           {"verification/loose_pin.json", {{"px", 1}}},
                           {"verification/loose_pin.json", {{"px", 0.3}, {"py", -0.6}, {"angle", 37}}}},
                          {}};
    for (std::size_t run = 1; run < problem.runs.size(); ++run) {
        problem.quantities.push_back(
            {"contact force" + from(run), [=](const Answers& a) { return force_of(a, run, 0); }, F, statics});
        problem.quantities.push_back({"peak over that at rest" + from(run),
                                      [=](const Answers& a) { return peak_of(a, run, 0) / peak_of(a, 0, 0); }, 1,
                                      run == 2 ? statics : stated});
        problem.quantities.push_back(
            {"length over that at rest" + from(run),
             [=](const Answers& a) { return a.at(run).contacts.at(0).contact_length / a.at(0).contacts.at(0).contact_length; },
             1, stated});
    }
    return problem;
}

/// Area and first moment about the hinge of the lever: an eye with a hole, the arm beyond it, and half a disc at its end.
double middle_of_lever(double L, double rho, double R) {
    const double eye = 2 * R, pi = std::numbers::pi;
    const double chord = std::sqrt(eye * eye - rho * rho), segment = rho * chord + eye * eye * std::asin(rho / eye);
    const double arm = 2 * rho * L - segment, tip = pi * rho * rho / 2;
    const double moment = rho * L * L - (eye * eye * rho - rho * rho * rho / 3) + tip * (L + 4 * rho / (3 * pi));
    return moment / (pi * (eye * eye - R * R) + arm + tip);
}

/// Moments about the hinge, in the turned position: the stop's force is upright, W and -H act in the middle.
VerifyProblem lever() {
    constexpr double L = 100, rho = 2, d = 12, R = 5, W = 100, H = 50, one_in_a_thousand = 1e-3;
    const double t = std::asin((d - rho) / L), share = middle_of_lever(L, rho, R) / L;
    const double stop = share * (W + H * std::tan(t)), hinge = std::hypot(H, W - stop);
    VerifyProblem problem{"L2", "a lever on a hinge pin falls on a stop, from three angles", {}, {}};
    for (const double t0 : {-10.0, 0.0, 4.0}) problem.runs.push_back({"verification/lever_on_stop.json", {{"t0", t0}}});
    for (std::size_t run = 0; run < problem.runs.size(); ++run) {
        problem.quantities.push_back({"force of the hinge" + from(run), [=](const Answers& a) { return force_of(a, run, 0); },
                                      hinge, one_in_a_thousand});
        problem.quantities.push_back(
            {"force of the stop" + from(run), [=](const Answers& a) { return force_of(a, run, 1); }, stop, one_in_a_thousand});
    }
    return problem;
}

VerifyProblem groove() {
    constexpr double W = 100, R = 10, E = 2e5;
    const double force = W / (2 * std::sin(45 * degree)), peak = hertz(R, E / 2, force).p0;
    VerifyProblem problem{"L3",
                          "a disc drawn above a V groove and beside its middle",
                          {{"verification/disc_in_groove.json"},
                           {"verification/disc_in_groove.json", {{"h", 4}, {"s", 1}}},
                           {"verification/disc_in_groove.json", {{"h", 9}, {"s", -6}}}},
                          {}};
    for (std::size_t run = 0; run < problem.runs.size(); ++run)
        for (std::size_t side = 0; side < 2; ++side) {
            const std::string where = (side == 0 ? ", right" : ", left") + from(run);
            problem.quantities.push_back(
                {"force" + where, [=](const Answers& a) { return force_of(a, run, side); }, force, statics});
            problem.quantities.push_back(
                {"peak" + where, [=](const Answers& a) { return peak_of(a, run, side); }, peak, stated});
        }
    return problem;
}

VerifyProblem tilted_block() {
    constexpr double W = 1000;
    VerifyProblem problem{"L4",
                          "a block drawn tilted above a flat comes to rest flush",
                          {{"verification/tilted_block.json"},
                           {"verification/tilted_block.json", {{"tilt", 0.1}, {"h", 0.1}}},
                           {"verification/tilted_block.json", {{"tilt", 1}, {"h", 0.5}}},
                           {"verification/tilted_block.json", {{"tilt", -4}, {"h", 2}}}},
                          {}};
    const auto middle = [](const Answers& a, std::size_t run) {  // its middle lands where the lower corner turned it to
        const ContactProfile& p = a.at(run).contacts.at(0).profile;
        return pressure_at_x(a.at(run).contacts.at(0), 0.5 * (p.x.front() + p.x.back()));
    };
    for (std::size_t run = 1; run < problem.runs.size(); ++run) {
        problem.quantities.push_back({"force" + from(run), [=](const Answers& a) { return force_of(a, run, 0); }, W, statics});
        problem.quantities.push_back({"pressure in the middle over that drawn flush" + from(run),
                                      [=](const Answers& a) { return middle(a, run) / middle(a, 0); }, 1, stated});
    }
    return problem;
}

/// Two discs against the walls, the third on both: rigid statics, which the discs' flattening changes by less than a hundredth.
VerifyProblem pile() {
    constexpr double r = 9.5, w = 40, W = 100;
    const double lean = std::asin((w - 2 * r) / (4 * r)), wall = W / 2 * std::tan(lean), top = W / 2 / std::cos(lean);
    VerifyProblem problem{"L5",
                          "three discs drawn loose in a box fall into a pile",
                          {{"verification/discs_in_box.json", {{"lift", 0.3}}},
                           {"verification/discs_in_box.json", {{"lift", 2}}},
                           {"verification/discs_in_box.json", {{"lift", 4}, {"aside", 0.4}}}},
                          {}};
    const auto between = [](const Answers& a, std::size_t run, const std::string& one, const std::string& other) {
        double largest = 0;  // the floor's and the walls' are told apart by their size
        for (const ContactResult& c : a.at(run).contacts)
            if ((c.parts[0] == one && c.parts[1] == other) || (c.parts[0] == other && c.parts[1] == one))
                largest = std::max(largest, c.force.norm());
        return largest;
    };
    for (std::size_t run = 0; run < problem.runs.size(); ++run) {
        for (const char* side : {"left", "right"}) {
            problem.quantities.push_back({std::string("floor, ") + side + from(run),
                                          [=](const Answers& a) { return between(a, run, "box", side); }, 1.5 * W, stated});
            problem.quantities.push_back({std::string("top on ") + side + from(run),
                                          [=](const Answers& a) { return between(a, run, side, "top"); }, top, stated});
        }
        problem.quantities.push_back({"wall" + from(run),
                                      [=](const Answers& a) {
                                          double sideways = 0;
                                          for (const ContactResult& c : a.at(run).contacts)
                                              if (c.parts[0] == "box" || c.parts[1] == "box")
                                                  sideways += 0.5 * std::abs(c.force.x());
                                          return sideways;
                                      },
                                      wall, stated});
    }
    return problem;
}

VerifyProblem turned() {
    VerifyProblem problem{"L7",
                          "a wedge in a groove, turned by a right angle by the groove's support",
                          {{"verification/turned_wedge.json", {{"drawn", 90}}},
                           {"verification/turned_wedge.json", {{"turn", 90}}},
                           {"verification/turned_wedge.json", {{"drawn", 180}, {"turn", -90}}}},
                          {}};
    const auto pressed = [](const Answers& a, std::size_t run) {  // of the candidates, some stay open
        std::vector<const ContactResult*> contacts;
        for (const ContactResult& c : a.at(run).contacts)
            if (c.status != "open") contacts.push_back(&c);
        return contacts;
    };
    for (std::size_t run = 1; run < problem.runs.size(); ++run)
        for (std::size_t side = 0; side < 2; ++side) {
            const std::string where = (side == 0 ? ", one side" : ", other side") + from(run);
            problem.quantities.push_back({"force over that drawn turned" + where,
                                          [=](const Answers& a) {
                                              return pressed(a, run).at(side)->force.norm() /
                                                     pressed(a, 0).at(side)->force.norm();
                                          },
                                          1, statics});
            problem.quantities.push_back({"mean pressure over that drawn turned" + where,
                                          [=](const Answers& a) {
                                              return mean_pressure(*pressed(a, run).at(side)) /
                                                     mean_pressure(*pressed(a, 0).at(side));
                                          },
                                          1, statics});
        }
    return problem;
}

/// Led by edges as far as the bolt, and a hundredth on: what the bodies give in by is all that presses.
VerifyProblem led() {
    constexpr double there = 3.05;
    VerifyProblem problem{"L7-edge",
                          "a slotted strap led by its end against a bolt, drawn where they touch and elsewhere",
                          {{"verification/led_strap.json", {{"s", there}}},
                           {"verification/led_strap.json"},
                           {"verification/led_strap.json", {{"s", 1.7}}},
                           {"verification/led_strap.json", {{"s", -2}}}},
                          {}};
    for (std::size_t run = 1; run < problem.runs.size(); ++run) {
        problem.quantities.push_back({"force over that drawn there" + from(run),
                                      [=](const Answers& a) { return force_of(a, run, 0) / force_of(a, 0, 0); }, 1, statics});
        problem.quantities.push_back({"peak over that drawn there" + from(run),
                                      [=](const Answers& a) { return peak_of(a, run, 0) / peak_of(a, 0, 0); }, 1, stated});
    }
    return problem;
}

/// Each from three drawn places.
std::vector<VerifyProblem> no_rest() {
    const auto named = [](const std::string& part) {
        return [part](const Answers& a) { return a.at(0).message.find(part) != std::string::npos ? 1.0 : 0.0; };
    };
    std::vector<VerifyProblem> problems;
    const auto add = [&](const std::string& name, const std::string& about, const std::string& scene, const std::string& part,
                         const std::map<std::string, double>& parameters) {
        problems.push_back({name, about, {{"verification/" + scene, parameters}}, {}});
        problems.back().quantities.push_back({"the part is named", named(part), 1, 0.0});
        problems.back().expects_failure = true;
    };
    add("L6-tip", "a bar balanced on its tip: no answer", "balanced_bar.json", "bar", {});
    add("L6-slope", "the same upright on a slope of 1e-3 degrees", "balanced_bar.json", "bar", {{"slope", 1e-3}});
    add("L6-above", "the same drawn above the flat", "balanced_bar.json", "bar", {{"above", 2}});
    add("L6-disc", "a disc on a slope of 10 degrees: no answer", "slope_disc.json", "disc", {});
    add("L6-disc-slight", "the same on a slope of 1e-3 degrees, drawn above it", "slope_disc.json", "disc",
        {{"slope", 1e-3}, {"h", 3}, {"s", 20}});
    add("L6-disc-end", "the same drawn near the end of its slope", "slope_disc.json", "disc", {{"h", 10}, {"s", -50}});
    return problems;
}

}  // namespace verify_motion

std::vector<VerifyProblem> motion_problems() {
    using namespace verify_motion;
    std::vector<VerifyProblem> problems{loose_pin(), lever(), groove(), tilted_block(), pile(), turned(), led()};
    for (VerifyProblem& problem : no_rest()) problems.push_back(std::move(problem));
    return problems;
}

}  // namespace abut
