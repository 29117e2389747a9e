// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact_measures.hpp"

#include <algorithm>
#include <cmath>

namespace abut {

double energy_of(const SolvedAssembly& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.problem.parts.size(); ++i)
        sum += strain_energy(s.problem.parts[i], s.solution.displacement[i]);
    return sum;
}

double peak_of(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return 0;
    const solver::KnotVector& k = s.contacts[contact].face.pressure;
    double peak = 0;
    for (int i = 0; i < k.n_intervals(); ++i)
        for (int q = 0; q < 4; ++q) {
            const double a = k.breakpoints[static_cast<std::size_t>(i)], b = k.breakpoints[static_cast<std::size_t>(i) + 1];
            peak = std::max(peak, solver::pressure_at(k, pressure_of(s, contact), a + (b - a) * q / 3));
        }
    return peak;
}

bool any_run(const SolvedAssembly& s) {
    return std::any_of(s.runs.begin(), s.runs.end(), [](const auto& r) { return !r.empty(); });
}

namespace {

/// Is the largest pressure that at an end of the interface?
bool peak_at_end(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return false;
    const solver::KnotVector& k = s.contacts[contact].face.pressure;
    const double ends = std::max(solver::pressure_at(k, pressure_of(s, contact), k.breakpoints.front()),
                                 solver::pressure_at(k, pressure_of(s, contact), k.breakpoints.back()));
    return ends >= peak_of(s, contact);
}

/// Root of the mean square of a contact's pressure: steady where the peak at a corner has no limit.
double mean_of(const SolvedAssembly& s, std::size_t contact) {
    if (s.interface_of[contact] < 0) return 0;
    double sum = 0, length = 0;
    for (const solver::InterfacePoint& p : s.contacts[contact].face.points) {
        sum += p.weight * std::pow(solver::pressure_at(s.contacts[contact].face.pressure, pressure_of(s, contact), p.s), 2);
        length += p.weight;
    }
    return std::sqrt(sum / length);
}

bool is_settled(double now, double before) {
    return std::abs(now - before) <= settled_pressure * std::max(now, before);
}

bool is_settled(const ContactRun& now, const ContactRun& before) {
    const double limit = settled_fraction * std::max(now.end - now.begin, before.end - before.begin);
    return std::abs(now.begin - before.begin) <= limit && std::abs(now.end - before.end) <= limit;
}

bool is_settled(const SolvedAssembly& now, const SolvedAssembly& before, std::size_t contact) {
    if (!is_settled(mean_of(now, contact), mean_of(before, contact))) return false;
    if (!is_settled(peak_of(now, contact), peak_of(before, contact)) && !peak_at_end(now, contact)) return false;
    return std::equal(now.runs[contact].begin(), now.runs[contact].end(), before.runs[contact].begin(),
                      before.runs[contact].end(), [](const ContactRun& a, const ContactRun& b) { return is_settled(a, b); });
}

}  // namespace

bool same_contacts(const SolvedAssembly& now, const SolvedAssembly& before) {
    if (now.runs.size() != before.runs.size()) return false;
    for (std::size_t k = 0; k < now.runs.size(); ++k)
        if (!is_settled(now, before, k)) return false;
    return true;
}

}  // namespace abut
