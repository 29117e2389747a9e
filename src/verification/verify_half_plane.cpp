// SPDX-License-Identifier: GPL-3.0-or-later
// E13: a half-plane under a strip load and under a line load [Johnson85, 2.2 and 2.5], at the point (0.6, 0.5).
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_half_plane {

constexpr double tolerance = 0.005;

std::vector<Quantity> stresses(const Stress& s) {
    return {{"sxx(0.6, 0.5)", [](const Answers& a) { return a[0].probes.at(0).stress.xx; }, s.xx, tolerance},
            {"szz(0.6, 0.5)", [](const Answers& a) { return a[0].probes.at(0).stress.yy; }, s.yy, tolerance},
            {"sxz(0.6, 0.5)", [](const Answers& a) { return a[0].probes.at(0).stress.xy; }, s.xy, tolerance}};
}

}  // namespace verify_half_plane

std::vector<VerifyProblem> half_plane_problems() {
    using namespace verify_half_plane;
    return {{"E13-strip",
             "half-plane under a strip load",
             {{"verification/strip_load.json"}},
             stresses({-0.372470318, -0.864260611, -0.165772009, 0})},
            {"E13-line",
             "half-plane under a line load, without its neighbourhood",
             {{"verification/line_load.json"}},
             stresses({-0.307959041, -0.213860445, -0.256632534, 0})}};
}

}  // namespace abut
