// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/closing_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"

namespace abut {

namespace {

bool was_closed(const SolvedAssembly& solved, std::size_t contact) {
    return contact < solved.pressure_before.size() && !solved.pressure_before[contact].s.empty();
}

}  // namespace

void warn_of_closing_contacts(const Scene& scene, const SolvedAssembly& solved, double target, Result& result) {
    std::vector<std::string> closing;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (!c.friction || !c.friction->utilisation || was_closed(solved, k)) continue;
        double moved = 0;
        for (int i : c.part) moved = std::max(moved, std::abs(result.parts[at(i)].max_displacement.value));
        const double negligible = std::max(target, 1e-3) * moved;
        if (c.gap_min > negligible)
            closing.push_back("contact " + std::to_string(k + 1) + " (gap " + number_text(c.gap_min, 3) + ")");
    }
    if (closing.empty()) return;
    result.warnings.push_back("with friction the loads close " + first_few(closing) +
                              ": what the parts move along each other before they touch is taken for slip, so that shear "
                              "forces and all that hangs on "
                              "them may be far off; " +
                              (scene.in_steps ? "close them in a step of its own, before what pulls along them"
                                              : "draw the parts where they touch, or close them in a step of its own"));
}

}  // namespace abut
