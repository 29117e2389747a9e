// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// Order of the errors away from the ends in the cell size, and the least refinement that a change tells anything of.
constexpr double order = 3, largest_rate = 0.6;

/// Factor on errors from one grid to the next.
double rate_of(double refinement) {
    return std::min(std::pow(refinement, order), largest_rate);
}

/// What is still missing after a change, the last of a geometric series.
double remainder(double change, double rate) {
    return std::abs(change) * rate / (1 - rate);
}

double end_errors(const ContactRecord& c) {
    double square = 0;
    for (const ContactRun& run : c.runs)
        square += run.at_begin.error * run.at_begin.error + run.at_end.error * run.at_end.error;
    return std::sqrt(square);
}

ContactError estimate(const ContactRecord& now, const PressureChange& c) {
    ContactError e;
    const double rate = rate_of(c.refinement);
    e.ends = end_errors(now) / c.norm;
    e.inside = remainder(c.inside, rate) / c.norm;
    e.pressure = std::hypot(e.ends, e.inside);
    e.peak = remainder(c.peak - c.peak_before, rate) / c.peak;
    e.force = remainder(c.force - c.force_before, rate) / c.force;
    return e;
}

}  // namespace

ErrorEstimate estimate_errors(const PassRecord& now, const PassRecord* before) {
    ErrorEstimate e;
    e.contacts.resize(now.contacts.size());
    if (!before) return e;
    double worst = 0, strongest = 0;
    for (std::size_t k = 0; k < now.contacts.size(); ++k) {
        const PressureChange c = change_of(now.contacts[k], before->contacts[k]);
        if (!(c.norm > 0)) continue;
        e.contacts[k] = estimate(now.contacts[k], c);
        worst = std::max(worst, e.contacts[k]->pressure * c.norm);
        strongest = std::max(strongest, c.norm);
    }
    if (strongest > 0) e.contact_pressure = worst / strongest;
    if (now.energy > 0)
        e.energy =
            remainder(now.energy - before->energy, rate_of(std::sqrt(static_cast<double>(before->unknowns) / now.unknowns))) /
            now.energy;
    return e;
}

}  // namespace abut
