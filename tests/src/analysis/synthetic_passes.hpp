// SPDX-License-Identifier: GPL-3.0-or-later
// Records of solutions made up from pressures, to test what is made of them without solving anything.
#pragma once
#include <functional>

#include "src/analysis/pass_record.hpp"

namespace abut::synthetic {

/// A pressure over the unit length, on equal cells: the spline whose coefficients are its values at the Greville points.
inline ContactRecord record(int cells, const std::function<double(double)>& pressure) {
    std::vector<double> lines;
    for (int i = 0; i <= cells; ++i) lines.push_back(static_cast<double>(i) / cells);
    ContactRecord r{{0, 1}, {0, 1}, solver::clamped_knots(lines, 2), {}, {}, 1};
    r.coefficients.resize(r.pressure.n_functions());
    for (int i = 0; i < r.pressure.n_functions(); ++i) r.coefficients[i] = pressure(solver::greville(r.pressure, i));
    r.stretches = {{0, 1, true, true, {}, {}}};
    return r;
}

inline PassRecord pass(std::vector<ContactRecord> contacts, int unknowns = 1000) {
    PassRecord p;
    p.contacts = std::move(contacts);
    p.energy = 1;
    p.unknowns = unknowns;
    return p;
}

}  // namespace abut::synthetic
