// SPDX-License-Identifier: GPL-3.0-or-later
// Cell sizes that contacts ask for: before a solution from the drawn gaps, after one from the contacts found.
#include <algorithm>

#include "src/assembly_model.hpp"

namespace abut {

namespace {

constexpr int samples = 33;
constexpr double near_gap_fraction = 0.25;  // of a zone's range of gaps: what is closer counts as where contact will be
constexpr double cells_in_first_contact = 16;
constexpr double cells_in_contact = 12;
constexpr double end_fraction = 1.0 / 120;    // of the contact's length: cells at its ends
constexpr double corner_fraction = 1.0 / 40;  // the same where it ends at a corner that concentrates the pressure:
constexpr double corner_rise = 1.05;          //   there it is so much larger than
constexpr double corner_reach = 0.1;          //   this fraction of the length away (a symmetry plane is no such corner)

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

void want(WantedSizes& wanted, int part, const std::vector<Vec2>& points, double size) {
    if (!points.empty() && size > 0) wanted[at(part)].push_back({points, size});
}

/// Where a straight edge meets an arc within a contact the pressure has a steep peak: fine cells at the joints of either chain.
void want_at_joints(const Scene& scene, const ContactInterface& contact, const ContactRun& run, double size,
                    WantedSizes& wanted) {
    const geometry::FacingPair begin = pair_at(scene, contact, run.begin), end = pair_at(scene, contact, run.end);
    if (!begin.found || !end.found) return;
    const std::array<const geometry::Chain*, 2> chain{&contact.zone.chain1, &contact.zone.chain2};
    const std::array<double, 2> low{begin.s1, std::min(begin.s2, end.s2)}, high{end.s1, std::max(begin.s2, end.s2)};
    for (std::size_t side = 0; side < 2; ++side) {
        const geometry::Part& part = scene.parts[at(contact.part[side])].part;
        const std::size_t n = chain[side]->edges.size();
        for (std::size_t k = chain[side]->closed ? 0 : 1; k < n && n > 1; ++k) {
            double s = chain[side]->begin[k];
            if (chain[side]->closed)
                while (s < low[side]) s += chain[side]->length;
            if (s <= low[side] || s >= high[side]) continue;
            const Vec2 x = geometry::at(part, *chain[side], s).x;
            for (int p : contact.part) want(wanted, p, {x}, size);
        }
    }
}

bool rises_towards(const Eigen::VectorXd& pressure, const ContactInterface& contact, double end, double inside) {
    return solver::pressure_at(contact.face.pressure, pressure, end) >
           corner_rise * solver::pressure_at(contact.face.pressure, pressure, inside);
}

}  // namespace

WantedSizes first_sizes(const Scene& scene, const std::vector<Candidate>& candidates, double coarseness) {
    WantedSizes wanted(scene.parts.size());
    for (const Candidate& c : candidates) {
        const geometry::Part &p1 = scene.parts[at(c.first)].part, &p2 = scene.parts[at(c.second)].part;
        const double limit = c.zone.gap_min + near_gap_fraction * (c.zone.gap_max - c.zone.gap_min);
        std::vector<Vec2> on1, on2;
        double partner = c.zone.begin2;
        for (int k = 0; k < samples; ++k) {
            const double s1 = c.zone.begin1 + (k + 0.5) / samples * (c.zone.end1 - c.zone.begin1);
            const geometry::FacingPair pair = pair_from_first(p1, p2, c.zone, s1, partner);
            if (!pair.found) continue;
            partner = pair.s2;
            if (pair.gap > limit) continue;
            on1.push_back(pair.on1.x);
            on2.push_back(pair.on2.x);
        }
        const double length = (c.zone.end1 - c.zone.begin1) * static_cast<double>(on1.size()) / samples;
        want(wanted, c.first, on1, coarseness * length / cells_in_first_contact);
        want(wanted, c.second, on2, coarseness * length / cells_in_first_contact);
    }
    return wanted;
}

WantedSizes sizes_from(const Scene& scene, const SolvedAssembly& solved, double coarseness) {
    WantedSizes wanted(scene.parts.size());
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        for (const ContactRun& run : solved.runs[k]) {
            const ContactInterface& contact = solved.contacts[k];
            const Eigen::VectorXd& pressure = pressure_of(solved, k);
            const double length = run.end - run.begin;
            std::array<std::vector<Vec2>, 2> points;
            for (int i = 0; i < samples; ++i) {
                const geometry::FacingPair pair = pair_at(scene, contact, run.begin + length * i / (samples - 1));
                if (!pair.found) continue;
                points[0].push_back(pair.on1.x);
                points[1].push_back(pair.on2.x);
            }
            want_at_joints(scene, contact, run, coarseness * length * corner_fraction, wanted);
            for (std::size_t side = 0; side < 2; ++side) {
                if (points[side].empty()) continue;
                want(wanted, contact.part[side], points[side], coarseness * length / cells_in_contact);
                if (!run.from_start)
                    want(wanted, contact.part[side], {points[side].front()}, coarseness * length * end_fraction);
                else if (rises_towards(pressure, contact, run.begin, run.begin + corner_reach * length))
                    want(wanted, contact.part[side], {points[side].front()}, coarseness * length * corner_fraction);
                if (!run.to_end)
                    want(wanted, contact.part[side], {points[side].back()}, coarseness * length * end_fraction);
                else if (rises_towards(pressure, contact, run.end, run.end - corner_reach * length))
                    want(wanted, contact.part[side], {points[side].back()}, coarseness * length * corner_fraction);
            }
        }
    return wanted;
}

}  // namespace abut
