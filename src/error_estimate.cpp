// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace abut {

namespace {

/// Order of the errors away from the ends in the cell size, and the least refinement that a change tells anything of.
constexpr double order = 3, largest_rate = 0.6;
constexpr double same_cells = 0.95;  // ratio of knot spacings above which they are no finer
/// Bounds on rates that two changes of the energy show.
constexpr double least_observed = 0.05, most_observed = 0.8;

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

bool peak_at_corner(const ContactRecord& c, double peak) {
    const auto stands = [&](const RunEnd& end, double s) {
        return end.kind == RunEnd::Kind::corner && solver::pressure_at(c.pressure, c.coefficients, s) >= peak;
    };
    return std::any_of(c.runs.begin(), c.runs.end(),
                       [&](const ContactRun& run) { return stands(run.at_begin, run.begin) || stands(run.at_end, run.end); });
}

ContactError estimate(const ContactRecord& now, const PressureChange& c, const std::optional<ContactError>& before) {
    ContactError e;
    e.at_corner = peak_at_corner(now, c.peak);
    const double rate = rate_of(c.refinement);
    e.ends = end_errors(now) / c.norm;
    e.inside = remainder(c.inside, rate) / c.norm;
    e.peak = remainder(c.peak - c.peak_before, rate) / c.peak;
    if (before && c.refinement > same_cells) {
        e.inside = std::max(e.inside, before->inside);
        e.peak = std::max(e.peak, before->peak);
    }
    e.pressure = std::hypot(e.ends, e.inside);
    e.force = remainder(c.force - c.force_before, rate) / c.force;
    return e;
}

/// Grids that follow the contacts change in many ways at once: two changes of the energy show a rate only where there are none.
double energy_rate(std::span<const PassRecord> passes, bool has_contact) {
    const std::size_t n = passes.size();
    const double change = passes[n - 1].energy - passes[n - 2].energy;
    if (n > 2 && !has_contact && passes[n - 2].energy != passes[n - 3].energy)
        return std::clamp(std::abs(change / (passes[n - 2].energy - passes[n - 3].energy)), least_observed, most_observed);
    return rate_of(std::sqrt(static_cast<double>(passes[n - 2].unknowns) / passes[n - 1].unknowns));
}

}  // namespace

ErrorEstimate estimate_errors(std::span<const PassRecord> passes, const ErrorEstimate& estimate_before) {
    ErrorEstimate e;
    const PassRecord& now = passes.back();
    e.contacts.resize(now.contacts.size());
    if (passes.size() < 2) return e;
    const PassRecord& before = passes[passes.size() - 2];
    double worst = 0, strongest = 0, worst_peak = 0, largest_peak = 0;
    for (std::size_t k = 0; k < now.contacts.size(); ++k) {
        const PressureChange c = change_of(now.contacts[k], before.contacts[k]);
        if (!(c.norm > 0)) continue;
        const bool known = k < estimate_before.contacts.size();
        const ContactError error =
            estimate(now.contacts[k], c, known ? estimate_before.contacts[k] : std::optional<ContactError>());
        e.contacts[k] = error;
        e.contacts[k]->share = c.norm;
        worst = std::max(worst, error.pressure * c.norm);
        strongest = std::max(strongest, c.norm);
        if (!error.at_corner) worst_peak = std::max(worst_peak, error.peak * c.peak);
        largest_peak = std::max(largest_peak, c.peak);
    }
    for (auto& c : e.contacts)
        if (c) c->share /= strongest;
    if (strongest > 0) e.contact_pressure = worst / strongest;
    if (strongest > 0) e.peak = worst_peak / largest_peak;
    if (!(now.energy > 0)) return e;
    e.energy = remainder(now.energy - before.energy, energy_rate(passes, strongest > 0)) / now.energy;
    e.stress = std::sqrt(*e.energy);
    return e;
}

}  // namespace abut
