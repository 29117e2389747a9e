// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/missed_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "solver/solution_structure.hpp"
#include "src/contact_measures.hpp"

namespace abut {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Gap of an interface's point under the displacements.
double gap_at(const SolvedAssembly& solved, const solver::Interface& face, const solver::InterfacePoint& p) {
    double gap = p.gap;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t i = at(face.part[side]);
        const auto u =
            solver::displacement_at(solved.grids[i].input, solved.solution.displacement[i], p.element[side], p.x[side]);
        gap += (side == 0 ? -1 : 1) * p.normal[side].dot(u.value);
    }
    return gap;
}

/// Is a place under pressure, or so near to where it ends that the pressure's knots do not tell?
bool is_pressed(const std::vector<ContactRun>& runs, double s) {
    return std::any_of(runs.begin(), runs.end(), [&](const ContactRun& run) {
        return s >= run.begin - run.at_begin.reach && s <= run.end + run.at_end.reach;
    });
}

/// Overlapping stretches of one contact, from the open point before to the open point after.
std::vector<MissedContact> overlaps(const SolvedAssembly& solved, std::size_t contact) {
    const ContactInterface& c = solved.contacts[contact];
    std::vector<MissedContact> found;
    bool inside = false;
    double before = c.s.front();
    for (const solver::InterfacePoint& p : c.face.points) {
        const double gap = is_pressed(solved.runs[contact], p.s) ? 0 : gap_at(solved, c.face, p);
        if (gap < 0) {
            if (!inside) {
                found.emplace_back();
                found.back().run.begin = before;
                found.back().run.at_begin.kind = found.back().run.at_end.kind = RunEnd::Kind::free;
            }
            found.back().run.end = c.s.back();
            found.back().depth = std::max(found.back().depth, -gap);
        } else if (inside) {
            found.back().run.end = p.s;
        }
        inside = gap < 0;
        before = p.s;
    }
    return found;
}

/// What contacts and loads are measured against.
double largest_force(const SolvedAssembly& solved) {
    double force = solved.problem.load_scale;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        if (!solved.runs[k].empty()) force = std::max(force, contact_force(solved, k).force.norm());
    return force;
}

}  // namespace

MissedContacts missed_contacts(const SolvedAssembly& solved, double least_share) {
    MissedContacts missed(solved.contacts.size());
    const double force = largest_force(solved);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (solved.interface_of[k] < 0 || c.face.bilateral || c.pairing != Pairing::middle) continue;
        for (MissedContact& m : overlaps(solved, k)) {
            m.share = c.face.thickness * m.depth / compliance_of(solved, k) / force;
            if (m.share > least_share) missed[k].push_back(m);
        }
    }
    return missed;
}

bool any_missed(const MissedContacts& missed) {
    return std::any_of(missed.begin(), missed.end(), [](const auto& m) { return !m.empty(); });
}

ContactRuns with_missed(ContactRuns runs, const MissedContacts& missed) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
        for (const MissedContact& m : missed[k]) runs[k].push_back(m.run);
        std::sort(runs[k].begin(), runs[k].end(), [](const ContactRun& a, const ContactRun& b) { return a.begin < b.begin; });
    }
    return runs;
}

}  // namespace abut
