// SPDX-License-Identifier: GPL-3.0-or-later
// Contact between flat faces: patch tests (C3), punches (C4), gaps and blocks (C9), the dissertation's punch and vise (S-A,
// S-E).
#include <cmath>
#include <numbers>

#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_blocks {

constexpr double exact = 1e-8, statics = 1e-6;

double first_probe_y(const Answers& answers) {
    return answers.at(0).probes.at(0).displacement.y();
}

double deepest(const Answers& answers) {
    return contact_of(answers).max_penetration;
}

Quantity uniform_pressure(double p, double tolerance) {
    return {"pressure, largest error", [=](const Answers& a) { return pressure_error(contact_of(a), p); }, 0, tolerance, 1};
}

/// Uniform pressure q = 100.
std::vector<VerifyProblem> patches() {
    constexpr double q = 100;
    const auto straight = [](double v) { return Quantity{"v of the top", first_probe_y, v, exact}; };
    std::vector<VerifyProblem> problems{{"C3-straight",
                                         "two blocks on grids turned against each other",
                                         {{"verification/contact_patch.json"}},
                                         {straight(-2e-3)}},
                                        {"C3-stiffer",
                                         "the same, one ten times as stiff",
                                         {{"verification/contact_patch.json", {{"E2", 1e6}}}},
                                         {straight(-1.1e-3)}},
                                        {"C3-narrow",
                                         "a narrow block, the pressure goes on beside it",
                                         {{"verification/contact_patch_narrow.json"}},
                                         {straight(-2e-3)}},
                                        {"C3-inclined",
                                         "an interface at 30 degrees under all-round pressure",
                                         {{"verification/contact_patch_inclined.json"}},
                                         {}},
                                        {"C3-inclined-stiffer",
                                         "the same, one ten times as stiff",
                                         {{"verification/contact_patch_inclined.json", {{"E2", 1e6}}}},
                                         {}}};
    for (VerifyProblem& problem : problems) problem.quantities.push_back(uniform_pressure(q, exact));
    return problems;
}

/// q over eps = 500 E / 1 = 5e7.
VerifyProblem penalty_patch() {
    constexpr double q = 100, eps = 5e7, as_asked = 1e-6;
    const PenaltyOptions penalty{500, 1};
    return {"C3-penalty",
            "the patch of blocks by penalty: exact but for its penetration",
            {{"verification/contact_patch.json", {}, {}, penalty}},
            {uniform_pressure(q, as_asked),
             {"penetration", deepest, q / eps, as_asked},
             {"v of the top", first_probe_y, -2e-3 - q / eps, exact}}};
}

Quantity pressure_of_mean(double x, double mean, double reference, double tolerance) {
    return {"p / mean at " + std::to_string(x).substr(0, 3) + " a",
            [=](const Answers& a) { return pressure_at_x(contact_of(a), x) / mean; }, reference, tolerance};
}

/// Sadowsky's rigid punch; and converged numbers, four digits, of an elastic one six half widths high. a = 1, q = 100. Towards
/// the corner the pressure has no limit: the tolerance follows, and at 0.9 a it is recorded.
std::vector<VerifyProblem> punches() {
    constexpr double q = 100, inner = 0.02, near_corner = 0.05, taken_as_rigid = 1e12;
    VerifyProblem rigid{
        "C4-rigid", "a punch 1e4 times as stiff as the half-plane", {{"verification/punch.json", {{"E1", 1e9}}}}, {}};
    for (double x : {0.0, 0.2, 0.4, 0.6, 0.8})
        rigid.quantities.push_back(
            pressure_of_mean(x, q, 2 / (std::numbers::pi * std::sqrt(1 - x * x)), x > 0.7 ? near_corner : inner));
    VerifyProblem body = rigid;
    body.name = "C4-body";
    body.about = "a rigid punch";
    body.runs = {{"verification/punch.json", {{"E1", taken_as_rigid}}}};
    VerifyProblem elastic{"C4-elastic", "a punch of the half-plane's material", {{"verification/punch.json"}}, {}};
    const std::vector<std::pair<double, double>> converged{
        {0, 0.84824}, {0.2, 0.85604}, {0.4, 0.88235}, {0.6, 0.93973}, {0.8, 1.0757}};
    for (const auto& [x, p] : converged) elastic.quantities.push_back(pressure_of_mean(x, q, p, x > 0.7 ? near_corner : inner));
    elastic.quantities.push_back(pressure_of_mean(0.9, q, 1.2523, 0));
    elastic.quantities.back().tolerance.reset();
    return {std::move(rigid), std::move(body), std::move(elastic)};
}

/// Converged numbers, three to four digits.
VerifyProblem case_a() {
    constexpr double q = 250, a = 0.5, three_percent = 0.03;
    VerifyProblem problem{"S-A", "the dissertation's punch on a die", {{"scenes/case_a.json"}}, {}};
    const std::vector<std::pair<double, double>> converged{
        {0, 0.9024}, {0.2, 0.9040}, {0.4, 0.9121}, {0.6, 0.9400}, {0.8, 1.0332}};
    for (const auto& [x, p] : converged)
        problem.quantities.push_back({"p / q at " + std::to_string(x).substr(0, 3) + " a",
                                      [at = x * a](const Answers& r) { return pressure_at_x(contact_of(r), at) / q; }, p,
                                      three_percent});
    problem.quantities.push_back({"contact force along y", vertical_force, q * a, statics});
    return problem;
}

/// The same beside Okubo's series, which the dissertation compares with. Tolerance: its criterion (section 4.6.1), the series
/// being an approximation itself.
VerifyProblem okubo() {
    constexpr double q = 250, a = 0.5, five_percent = 0.05;
    VerifyProblem problem{"S-A-okubo", "the dissertation's punch beside Okubo's series", {{"scenes/case_a.json"}}, {}};
    for (const double x : {0.0, 0.2, 0.4, 0.6, 0.8})
        problem.quantities.push_back({"p / q at " + std::to_string(x).substr(0, 3) + " a",
                                      [at = x * a](const Answers& r) { return pressure_at_x(contact_of(r), at) / q; },
                                      okubo_pressure(x), five_percent});
    return problem;
}

VerifyProblem closed_gap() {
    return {"C9-gap",
            "a bar closes a gap of 0.3 and presses on another",
            {{"verification/gap_closed_by_load.json"}},
            {{"contact force", force, 140, exact},
             {"u(1, 0.5)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, 0.86, exact}}};
}

/// (F - N) / 1000 - 0.002 = N (2 / 500 + 1 / eps).
VerifyProblem bars(const std::string& name, const std::string& about, std::optional<PenaltyOptions> penalty,
                   double compliance) {
    constexpr double F = 10;
    const double N = (F / 1000 - 0.002) / (0.001 + 0.004 + compliance);
    return {name,
            about,
            {{"verification/bars_with_gap.json", {}, {}, penalty}},
            {{"contact force", force, N, exact},
             {"u(1, 0.5)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, (F - N) / 1000, exact}}};
}

/// Too small a load leaves the gap open.
VerifyProblem open_gap() {
    constexpr double F = 1.9;
    return {"C9-open",
            "a load that does not close the gap",
            {{"verification/bars_with_gap.json", {{"F", F}}}},
            {{"contact force", force, 0, exact, F},
             {"u(1, 0.5)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, F / 1000, exact}}};
}

/// nu = 0: the field is exact; else the roller below disturbs it.
VerifyProblem gravity() {
    return {"C9-gravity",
            "a block on a block under their own weight",
            {{"verification/blocks_under_gravity.json"}},
            {uniform_pressure(1, exact),
             {"v(0.5, 2) - v(0.5, 1)",
              [](const Answers& a) { return a[0].probes.at(1).displacement.y() - a[0].probes.at(0).displacement.y(); }, -0.5e-3,
              exact},
             {"reaction of the base", [](const Answers& a) { return a[0].equilibrium.reaction.y(); }, 2, exact}}};
}

Quantity gap_at_the_top(double tolerance) {
    return {"gap at the top", [](const Answers& a) { return gap_at_top(contact_of(a)); }, 3.0749e-3, tolerance};
}

/// Converged numbers, four digits.
VerifyProblem vise() {
    return {"S-E",
            "the dissertation's vise",
            {{"scenes/vise.json"}},
            {{"contact force", force, 429.60, 0.01},
             gap_at_the_top(0.02),
             {"u(1, 1.1)", [](const Answers& a) { return a[0].probes.at(0).displacement.x(); }, 3.6168e-3, std::nullopt},
             {"strain energy", [](const Answers& a) { return a[0].strain_energy; }, 2.148032, std::nullopt}}};
}

/// The converged pressure over the dissertation's penalty, 50 x 1e6 over a length of 1.
VerifyProblem vise_by_penalty() {
    constexpr double eps = 5e7;
    VerifyProblem problem{"S-E-penalty",
                          "the vise with the dissertation's penalty 5e7",
                          {{"scenes/vise.json", {}, {}, PenaltyOptions{50, 1}}},
                          {{"contact force", force, 429.60, 0.01}, gap_at_the_top(0.02)}};
    const std::vector<std::pair<double, double>> converged{{0.05, 1291.5}, {0.1, 1086.6}, {0.2, 844.7}, {0.4, 489.6}};
    for (const auto& [y, p] : converged)
        problem.quantities.push_back({"penetration at y = " + std::to_string(y).substr(0, 4),
                                      [y = y](const Answers& a) { return -gap_at_y(contact_of(a), y); }, p / eps, 0.05});
    return problem;
}

}  // namespace verify_blocks

std::vector<VerifyProblem> block_problems() {
    using namespace verify_blocks;
    constexpr double eps = 50 * 1000.0;  // of the stiffer bar, over a length of 1
    std::vector<VerifyProblem> problems = patches();
    problems.push_back(penalty_patch());
    for (VerifyProblem& problem : punches()) problems.push_back(std::move(problem));
    problems.push_back(closed_gap());
    problems.push_back(bars("C9-bars", "two bars and a gap", {}, 0));
    problems.push_back(bars("C9-penalty", "the same by penalty: softer by its compliance", PenaltyOptions{50, 1}, 1 / eps));
    problems.push_back(open_gap());
    problems.push_back(gravity());
    problems.push_back(case_a());
    problems.push_back(okubo());
    problems.push_back(vise());
    problems.push_back(vise_by_penalty());
    return problems;
}

}  // namespace abut
