// SPDX-License-Identifier: GPL-3.0-or-later
// Coulomb friction: sheared cylinders (F1, F2), any profile by its pressures under two loads (F3), a cylinder sheared on a
// block that is pulled (F4), blocks on slopes, ladders, wedges and cylinders at the limit of rest (F5 to F8), a shrink fit that
// carries a moment (F9), a band around a drum (F10), rough faces (F11), what holds in every answer (F12), a vise (F13), steps
// whose order does not count (H3).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "src/io/number_text.hpp"
#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_friction {

constexpr double two_percent = 0.02, statics = 1e-9;

/// Cattaneo and Mindlin; Mindlin and Deresiewicz [Johnson85, chapter 7]: a half width, p0 mu the bound in the middle; a
/// traction of one slip zone all over, less those of inner zones that do not slip again.
struct Sheared {
    double a, bound;

    double root(double half_width, double x) const {
        const double inside = half_width * half_width - x * x;
        return inside > 0 ? std::sqrt(inside) / a : 0;
    }
    /// share: Q over mu P.
    double stick(double share) const { return a * std::sqrt(1 - share); }
    double loaded(double share, double x) const { return bound * (root(a, x) - root(stick(share), x)); }
    /// From the share at which it turned to another; loaded from `turned` onwards backwards.
    double unloaded(double turned, double share, double x) const {
        return bound * (-root(a, x) + 2 * root(stick((turned - share) / 2), x) - root(stick(turned), x));
    }
};

constexpr Sheared cylinders{0.01, 0.3 * 500};

const ContactResult& contact_of_step(const Answers& answers, std::size_t step) {
    return answers.at(step).contacts.at(0);
}

/// Deviation of the traction over the profile in the mean square, of its bound's.
template <class Theory>
Quantity traction(const std::string& what, std::size_t step, std::optional<double> tolerance, Theory exact) {
    return {what + ": shear, L2 error over that of mu p",
            [=](const Answers& answers) {
                const ContactProfile& p = contact_of_step(answers, step).profile;
                double difference = 0, bound = 0;
                for (std::size_t k = 0; k + 1 < p.x.size(); ++k) {
                    const double x = 0.5 * (p.x[k] + p.x[k + 1]), length = std::abs(p.x[k + 1] - p.x[k]);
                    const double shear = 0.5 * (p.shear[k] + p.shear[k + 1]) - exact(x);
                    difference += length * shear * shear;
                    bound += length * std::pow(cylinders.bound * cylinders.root(cylinders.a, x), 2);
                }
                return std::sqrt(difference / bound);
            },
            0, tolerance, 1};
}

/// By how much the traction exceeds its bound anywhere, of the largest bound.
double excess(const Answers& answers) {
    double worst = 0;
    for (const Result& answer : answers)
        for (const ContactResult& c : answer.contacts)
            for (std::size_t k = 0; k < c.profile.shear.size(); ++k)
                worst = std::max(worst, std::abs(c.profile.shear[k]) - c.friction->coefficient * c.profile.pressure[k]);
    return worst / (answers.at(0).contacts.at(0).friction->coefficient * peak(answers));
}

double imbalance(const Answers& answers) {
    double worst = 0;
    for (const Result& answer : answers)
        worst = std::max({worst, answer.equilibrium.relative_residual, answer.equilibrium.relative_moment_residual});
    return worst;
}

double least_dissipated(const Answers& answers) {
    double least = 0;
    for (const Result& answer : answers) least = std::min(least, answer.contacts.at(0).friction->dissipated);
    return least;
}

/// Largest deviation of the traction, of the largest bound, but for two per cent of a beside places where its slope has no
/// limit: what is known to two per cent of a has no value there.
template <class Theory>
Quantity largest_deviation(const std::string& what, std::size_t step, std::vector<double> places, double tolerance,
                           Theory exact) {
    places.push_back(cylinders.a);
    return {what + ": largest error of the shear over mu p0",
            [=](const Answers& answers) {
                const ContactProfile& p = contact_of_step(answers, step).profile;
                double worst = 0;
                for (std::size_t k = 0; k < p.x.size(); ++k) {
                    const auto is_near = [&](double place) {
                        return std::abs(std::abs(p.x[k]) - place) < two_percent * cylinders.a;
                    };
                    if (std::none_of(places.begin(), places.end(), is_near))
                        worst = std::max(worst, std::abs(p.shear[k] - exact(p.x[k])));
                }
                return worst / cylinders.bound;
            },
            0, tolerance, 1};
}

double stick_of_step(const Answers& answers, std::size_t step) {
    return contact_of_step(answers, step).friction->stick_length / 2 / cylinders.a;
}

std::vector<Quantity> identities() {
    return {{"shear beyond its bound", excess, 0, 1e-12, 1},
            {"forces and moments without balance", imbalance, 0, statics, 1},
            {"least work of friction in a step", least_dissipated, 0, 1e-12, 1}};
}

/// Steps: pressed, sheared to `share` of the limit, released, sheared back, and there again.
VerifyProblem sheared_cylinders(double share) {
    // 1 % of the pressure is 1 % of the shear in the mean square, and 2.6 % beside the ends of slip
    constexpr double target = 0.003;
    const Sheared& theory = cylinders;
    const auto loaded = [=](double x) { return theory.loaded(share, x); };
    const auto unloaded = [=](double x) { return theory.unloaded(share, 0, x); };
    const double stick = theory.stick(share), stick_released = theory.stick(share / 2);
    VerifyProblem problem{"F1-" + number_text(100 * share, 3),
                          "equal cylinders sheared by " + number_text(share, 2) + " of what makes them slip, and back",
                          {{"verification/cattaneo.json", {{"share", share}, {"target", target}}}},
                          {}};
    problem.quantities = {
        {"stick zone over a", [](const Answers& a) { return stick_of_step(a, 1); }, stick / theory.a, two_percent, 1},
        {"released: stick zone over a", [](const Answers& a) { return stick_of_step(a, 2); }, stick_released / theory.a,
         two_percent, 1},
        traction("there", 1, two_percent, loaded),
        traction("released", 2, two_percent, unloaded),
        traction("back", 3, two_percent, [=](double x) { return -loaded(x); }),
        traction("there again", 4, two_percent, loaded),
        largest_deviation("there", 1, {stick}, two_percent, loaded),
        largest_deviation("released", 2, {stick, stick_released}, two_percent, unloaded),
        {"shear force over the load", [=](const Answers& a) { return contact_of_step(a, 1).friction->utilisation.value_or(0); },
         share, 1e-6},
        {"work of friction, there again over released and back",
         [](const Answers& a) {
             return contact_of_step(a, 4).friction->dissipated /
                    (contact_of_step(a, 2).friction->dissipated + contact_of_step(a, 3).friction->dissipated);
         },
         1, two_percent}};
    for (Quantity& q : identities()) problem.quantities.push_back(std::move(q));
    return problem;
}

/// Mindlin and Deresiewicz: half of the limit there, halfway back, two cycles.
VerifyProblem cycles() {
    constexpr double share = 0.5;
    const Sheared& theory = cylinders;
    const auto cycle = [](const Answers& answers, std::size_t begin) {
        double work = 0;
        for (std::size_t step = begin; step < begin + 4; ++step) work += contact_of_step(answers, step).friction->dissipated;
        return work;
    };
    const auto halfway = [=](double x) { return theory.unloaded(share, share / 2, x); };
    VerifyProblem problem{
        "F2-cycles",
        "equal cylinders sheared to and fro: halfway back, and two cycles",
        {{"verification/mindlin_cycle.json"}},
        {traction("halfway back", 2, two_percent, halfway),
         largest_deviation("halfway back", 2, {theory.stick(share), theory.stick(share / 4)}, two_percent, halfway),
         traction("released", 3, two_percent, [=](double x) { return theory.unloaded(share, 0, x); }),
         traction("after two cycles", 10, two_percent, [=](double x) { return theory.loaded(share, x); }),
         {"work of friction, second cycle over first", [=](const Answers& a) { return cycle(a, 7) / cycle(a, 3); }, 1, 0.01}}};
    for (Quantity& q : identities()) problem.quantities.push_back(std::move(q));
    return problem;
}

/// Units, and the direction of the shear: of the same answer the traction, over its bound.
VerifyProblem same_answers() {
    const auto difference = [](const Answers& a, std::size_t first, double length, double way) {
        double worst = 0;
        const ContactProfile &p = contact_of_step(a, 1).profile, &q = contact_of_step(a, first + 1).profile;
        if (p.x.size() != q.x.size()) return 1.0;
        for (std::size_t k = 0; k < p.x.size(); ++k) {
            worst = std::max(worst, std::abs(p.x[k] - q.x[k] / length) / cylinders.a);
            worst = std::max(worst, std::abs(p.shear[k] - way * q.shear[k] / (way > 0 ? 1e6 : 1)) / cylinders.bound);
        }
        return worst;
    };
    VerifyProblem problem{
        "F12-same",
        "sheared cylinders in other units, and sheared the other way",
        {{"verification/cattaneo.json"},
         {"verification/cattaneo.json", {{"R", 1e-3}, {"E", 1e11}, {"P", 7853.98163397448}}},
         {"verification/cattaneo.json", {{"share", -0.5}}}},
        {{"other units: difference of the shear", [=](const Answers& a) { return difference(a, 5, 1e-3, 1); }, 0, 1e-8, 1}}};
    problem.quantities.push_back(
        {"the other way: difference of the shear", [=](const Answers& a) { return difference(a, 10, 1, -1); }, 0, 1e-8, 1});
    return problem;
}

/// Without friction what was pressed and pulled in any order is the same; what comes back too.
VerifyProblem order_of_steps() {
    const auto difference = [](const Answers& a, std::size_t first, std::size_t second) {
        const ContactProfile &p = contact_of_step(a, first).profile, &q = contact_of_step(a, second).profile;
        return p.pressure.size() == q.pressure.size() ? relative_error_norm(p.pressure, q.pressure) : 1.0;
    };
    return {"H3-order",
            "a cylinder pressed on a block that is pulled, in any order, without friction",
            {{"verification/order_of_steps.json"}},
            {{"pull released: difference of the pressure", [=](const Answers& a) { return difference(a, 2, 0); }, 0, 1e-8, 1},
             {"pulled before pressed: difference", [=](const Answers& a) { return difference(a, 4, 1); }, 0, 1e-8, 1}}};
}

double says(const Answers& answers, const std::string& words) {
    return answers.at(0).message.find(words) != std::string::npos ? 1.0 : 0.0;
}

/// What rests, with the quantities asked of it, and what does not, whose motion is named.
VerifyProblem rests(const std::string& name, const std::string& about, VerifyRun run, std::vector<Quantity> quantities) {
    quantities.push_back({"forces and moments without balance", imbalance, 0, 1e-6, 1});
    return {name, about, {std::move(run)}, std::move(quantities)};
}
VerifyProblem slides(const std::string& name, const std::string& about, VerifyRun run, const std::vector<std::string>& words) {
    VerifyProblem problem{name, about, {std::move(run)}, {}};
    problem.expects_failure = true;
    problem.quantities.push_back(
        {"has no answer", [](const Answers& a) { return a[0].status == "failed" ? 1.0 : 0.0; }, 1, 0.0});
    for (const std::string& w : words)
        problem.quantities.push_back({"says '" + w + "'", [=](const Answers& a) { return says(a, w); }, 1, 0.0});
    return problem;
}

/// Beside the limit by a thousandth; a block of weight 0.8 on a slope of 1 : 2.
std::vector<VerifyProblem> slopes() {
    const std::string scene = "verification/friction_slope.json";
    const auto shear = [](const Answers& a) { return std::abs(contact_of(a).friction->shear_force); };
    return {rests("F5-rests", "a block on a slope, friction a thousandth more than it needs", {scene, {{"mu", 0.5005}}},
                  {{"shear force", shear, 0.8 / std::sqrt(5.0), 1e-6}}),
            slides("F5-slides", "the same with a thousandth less: no answer, the motion named", {scene, {{"mu", 0.4995}}},
                   {"b slides along (-0.8944, -0.4472)", "friction of 0.5 would hold it"})};
}

/// Round ends of radius r roll on their faces: the lever of the wall's force is L sin t + r.
std::vector<VerifyProblem> ladders() {
    constexpr double L = 10, r = 0.5;
    const double sine = 2 / std::sqrt(5.0), cosine = 1 / std::sqrt(5.0), needed = 0.5 * L * cosine / (L * sine + r);
    const std::string scene = "verification/friction_ladder.json";
    return {rests("F6-rests", "a ladder against a smooth wall, friction one hundredth more than it needs",
                  {scene, {{"mu", 1.01 * needed}}},
                  {{"utilisation of friction", [](const Answers& a) { return contact_of(a).friction->utilisation.value_or(0); },
                    1 / 1.01, 0.01}}),
            slides("F6-slides", "the same with one hundredth less", {scene, {{"mu", 0.99 * needed}}}, {})};
}

std::vector<VerifyProblem> limits() {
    const std::string wedge = "verification/friction_wedge.json", groove = "verification/friction_groove.json";
    const auto moment = [](const Answers& a) {
        return std::abs(a[0].contacts.at(0).friction->shear_force) + std::abs(a[0].contacts.at(1).friction->shear_force);
    };
    constexpr double mu = 0.3, W = 0.1;
    return {rests("F7-rests", "a wedge under a block, pushed by a thousandth less than lifts it", {wedge}, {}),
            slides("F7-slides", "the same pushed by a thousandth more", {wedge, {{"share", 1.001}}}, {"wedge"}),
            rests("F8-rests", "a cylinder in a groove, turned by a thousandth less than it bears", {groove},
                  {{"shear forces", moment, 0.999 * std::numbers::sqrt2 * mu * W / (1 + mu * mu), 1e-3}}),
            slides("F8-slides", "the same turned by a tenth more", {groove, {{"share", 1.1}}},
                   {"cylinder rotates about", "would hold it, 0.3 does not"}),
            slides("F9-slides", "a shrink fit under a tenth more moment than it bears",
                   {"verification/friction_shrink_fit.json", {{"share", 1.1}}},
                   {"in rotates about (0, 0)", "friction of 0.22 would hold it"})};
}

/// A workpiece between two faces, each pressed by the thrust, lifted by a hundredth less and more than 2 mu thrust.
std::vector<VerifyProblem> vises() {
    constexpr double thrust = 8000, mu = 0.15;
    const std::string scene = "scenes/vise_friction.json";
    const auto sum = [](const Answers& a, double FrictionResult::*of) {
        double forces = 0;
        for (const ContactResult& c : a[0].contacts) forces += c.friction ? std::abs((*c.friction).*of) : 0;
        return forces;
    };
    return {
        rests("F13-rests", "a workpiece in a vise, lifted by a hundredth less than friction bears", {scene, {{"share", 0.99}}},
              {{"shear forces on both of its faces", [=](const Answers& a) { return sum(a, &FrictionResult::shear_force); },
                0.99 * 2 * mu * thrust, 1e-6},
               {"normal forces", [=](const Answers& a) { return sum(a, &FrictionResult::normal_force); }, 2 * thrust, 1e-6}}),
        slides("F13-slides", "the same, lifted by a hundredth more", {scene, {{"share", 1.01}}},
               {"workpiece slides along (0, 1)", "friction of 0.1515 would hold it"})};
}

/// Euler [1769]: slipping all over, tensions are as exp(mu beta); the band's thickness is a hundredth of the radius.
VerifyProblem band() {
    const auto ratio = [](const Answers& a) { return 1000 / std::abs(a[0].reactions.at(1).force.x()); };
    return {"F10-band",
            "a thin band over a quarter of a drum: the pull at one end over that at the other",
            {{"verification/friction_band.json"}},
            {{"ratio of tensions", ratio, std::exp(0.3 * std::numbers::pi / 2), 0.01},
             {"forces and moments without balance", imbalance, 0, 1e-6, 1}}};
}

VerifyProblem shrink_fit() {
    constexpr double limit = 0.2 * 23.4375;
    const auto shear_error = [](const Answers& a) {
        std::vector<double> size;
        for (double t : contact_of(a).profile.shear) size.push_back(std::abs(t));
        return relative_error_norm(size, std::vector<double>(size.size(), 0.9 * limit));
    };
    return {"F9-moment",
            "a shrink fit under nine tenths of the moment that it bears: it slips nowhere",
            {{"verification/friction_shrink_fit.json"}},
            {{"shear, L2 error", shear_error, 0, 0.01, 1},
             {"length that slips", [](const Answers& a) { return contact_of(a).friction->slip_length; }, 0, 1e-9, 1}}};
}

VerifyProblem rough() {
    const auto difference = [](const Answers& a) {
        const Vec2 rough = a[0].probes.at(0).displacement, bonded = a[0].probes.at(1).displacement;
        return (rough - bonded).norm() / bonded.norm();
    };
    return {"F11-rough",
            "rough faces that press on each other all over, against bonded ones",
            {{"verification/friction_rough.json"}},
            {{"difference of displacements", difference, 0, 1e-9, 1}}};
}

/// Ciavarella and Jaeger: shear is mu times what the pressure grew by in the step before, when it was pressed by Q / mu more.
/// Deviation in the mean square, of the bound's.
double shear_error(const Answers& answers) {
    constexpr double mu = 0.4;
    const ContactProfile& p = answers.at(2).contacts.at(0).profile;
    const ContactResult &less = answers.at(0).contacts.at(0), &pressed = answers.at(1).contacts.at(0);
    const auto pressure = [](const ContactResult& c, double x) {
        const double value = pressure_at_x(c, x);
        return std::isfinite(value) ? value : 0.0;
    };
    double difference = 0, bound = 0;
    for (std::size_t k = 0; k + 1 < p.x.size(); ++k) {
        const double x = 0.5 * (p.x[k] + p.x[k + 1]), length = std::abs(p.x[k + 1] - p.x[k]);
        const double shear = 0.5 * (p.shear[k] + p.shear[k + 1]), all = mu * pressure(pressed, x);
        difference += length * std::pow(shear - (all - mu * pressure(less, x)), 2);
        bound += length * all * all;
    }
    return std::sqrt(difference / bound);
}

VerifyProblem any_profile() {
    return {"F3-profile",
            "a flat punch with fillets, pressed in two steps, then sheared by half of what makes it slip",
            {{"verification/friction_profile.json"}},
            {{"shear, L2 error over that of mu p", shear_error, 0, 0.02, 1}}};
}

/// Where a contact sticks, along x.
struct Stretch {
    double begin = 0, end = 0;
    double middle() const { return 0.5 * (begin + end); }
    double half_width() const { return 0.5 * std::abs(end - begin); }
};
Stretch sticking(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    Stretch stretch;
    bool sticks = false;
    for (std::size_t k = 0; k + 1 < p.x.size(); ++k) {
        const double between = 0.5 * (p.x[k] + p.x[k + 1]);
        if (p.state[k] != "stick" && p.state[k + 1] == "stick" && !sticks) stretch.begin = between;
        if (p.state[k] == "stick" && p.state[k + 1] != "stick") stretch.end = between;
        sticks = sticks || p.state[k + 1] == "stick";
    }
    return stretch;
}

/// Nowell and Hills: a = 0.01, p0 = 250, mu = 0.3, half of the limit, a pull of 45.
VerifyProblem pulled_block() {
    constexpr double a = 0.01, moved = 45 / (4 * 0.3 * 250), three_percent = 0.03;
    const auto zone = [](const Answers& answers) { return sticking(answers.at(1).contacts.at(0)); };
    return {
        "F4-pull",
        "a cylinder sheared on a block that is pulled: the stick zone moves and keeps its width",
        {{"verification/fretting.json"}},
        {{"half width of the stick zone over a", [=](const Answers& answers) { return zone(answers).half_width() / a; },
          std::sqrt(0.5), three_percent, 1},
         {"its middle over a", [=](const Answers& answers) { return zone(answers).middle() / a; }, -moved, three_percent, 1}}};
}

}  // namespace verify_friction

std::vector<VerifyProblem> friction_problems() {
    using namespace verify_friction;
    std::vector<VerifyProblem> problems{sheared_cylinders(0.2), sheared_cylinders(0.5), sheared_cylinders(0.9), cycles()};
    for (const auto& group : {slopes(), ladders(), limits(), vises()})
        problems.insert(problems.end(), group.begin(), group.end());
    problems.push_back(band());
    problems.push_back(shrink_fit());
    problems.push_back(rough());
    problems.push_back(any_profile());
    problems.push_back(pulled_block());
    problems.push_back(same_answers());
    problems.push_back(order_of_steps());
    return problems;
}

}  // namespace abut
