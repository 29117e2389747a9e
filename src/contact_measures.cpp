// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact_measures.hpp"

#include <algorithm>

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

}  // namespace abut
