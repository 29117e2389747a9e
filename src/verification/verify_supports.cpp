// SPDX-License-Identifier: GPL-3.0-or-later
// What supports hold, and what they must not hold.
#include "src/verification/verify_problem.hpp"

namespace abut {

namespace verify_supports {

/// Of a converged solution on a fine grid, three digits. Held along the recess, too, the block would give an eleventh of it.
VerifyProblem recess() {
    return {"hold-recess",
            "a block on two feet, with a recess between them on the same grid line",
            {{"verification/recessed_feet.json"}},
            {{"v(5, 0.05)", [](const Answers& a) { return a[0].probes.at(0).displacement.y(); }, -0.02276, 0.02}}};
}

VerifyProblem slope() {
    const auto says_so = [](const Answers& a) {
        return a[0].message.find("b slides along (-0.8944, -0.4472)") != std::string::npos ? 1.0 : 0.0;
    };
    VerifyProblem problem{"hold-slope",
                          "a block on a slope without friction: no answer, and the motion named",
                          {{"verification/slope.json"}},
                          {{"motion is named", says_so, 1, 0.0}}};
    problem.expects_failure = true;
    return problem;
}

}  // namespace verify_supports

std::vector<VerifyProblem> support_problems() {
    using namespace verify_supports;
    return {recess(), slope()};
}

}  // namespace abut
