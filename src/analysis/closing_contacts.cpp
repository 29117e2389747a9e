// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/closing_contacts.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

/// Of the parts' displacement: a gap that is smaller is of no account, however little error is aimed at.
constexpr double least_share = 1e-3;

bool was_closed(const SolvedAssembly& solved, std::size_t contact) {
    return contact < solved.pressure_before.size() && !solved.pressure_before[contact].s.empty();
}

}  // namespace

void tell_closing_contacts(const SolvedAssembly& solved, double target, Result& result) {
    std::vector<Finding> closing;
    for (std::size_t k = 0; k < result.contacts.size(); ++k) {
        const ContactResult& c = result.contacts[k];
        if (!c.friction || !c.friction->utilisation || was_closed(solved, k)) continue;
        const double moved =
            std::max(result.parts[at(c.part[0])].max_displacement.value, result.parts[at(c.part[1])].max_displacement.value);
        if (c.gap_min <= std::max(target, least_share) * moved) continue;
        const std::string which = "contact " + contact_number(k), gap = number_text(c.gap_min, 3);
        closing.push_back(
            {c.gap_min / moved, which,
             "the loads close " + which + ", which has friction, from a gap of " + gap +
                 ": what its parts move along each other before they touch is taken for slip, and its shear force "
                 "may be far off; draw them where they touch, or close them in a step before what pulls along them",
             "the shear force of " + which + " may be far off, since the loads close it from a gap of " + gap});
    }
    tell(std::move(closing), "closing_contact", result);
}

}  // namespace abut
