// SPDX-License-Identifier: GPL-3.0-or-later
// H2: a preloaded bolt under an outer force: F0 + Fe kb / (kb + kp) until the clamped bars part, then Fe.
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_preload {

constexpr double F0 = 1000, kb = 2e5 * 10 / 100, kp = 2 * 1e5 * 15 / 100;

double force_of_bolt(const Answers& answers) {
    return answers.at(0).preloads.at(0).force_under_load;
}

VerifyProblem bolt(const std::string& name, const std::string& about, double Fe) {
    const bool is_closed = Fe < F0 * (kb + kp) / kp;
    return {name,
            about,
            {{"verification/preloaded_bolt.json", {{"F0", F0}, {"Fe", Fe}}}},
            {{"force of the bolt", force_of_bolt, is_closed ? F0 + Fe * kb / (kb + kp) : Fe, 1e-6},
             {"its shortening", [](const Answers& a) { return a.at(0).preloads.at(0).shortening; }, F0 / kb + F0 / kp, 1e-6}}};
}

}  // namespace verify_preload

std::vector<VerifyProblem> preload_problems() {
    using namespace verify_preload;
    return {bolt("H2-tightened", "a bolt tightened between rigid plates that two bars hold apart", 0),
            bolt("H2-clamped", "the same with a force that pulls the plates apart", 500),
            bolt("H2-parted", "the same with a force that lifts them off the bars", 2000)};
}

}  // namespace abut
