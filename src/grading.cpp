// SPDX-License-Identifier: GPL-3.0-or-later
// Cell sizes that contacts ask for: before a solution from the drawn gaps, after one from the contacts found.
#include <algorithm>
#include <cmath>

#include "src/assembly_model.hpp"

namespace abut {

namespace {

constexpr int samples = 33;
constexpr double near_gap_fraction = 0.25;  // of a zone's range of gaps: what is closer counts as where contact will be
constexpr double cells_in_first_contact = 16;
/// Cells at the ends from which on the growth towards the middle follows them, by the fourth root: the ends' errors fall with
/// the cell size, those of the rest with its third power and more.
constexpr double fast_end = 0.02;
constexpr double slowest_growth = 0.4, fastest_growth = 0.69;  // neighbours by a factor of 2

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

void want(WantedSizes& wanted, int part, const std::vector<Vec2>& points, double size, double growth) {
    if (!points.empty() && size > 0) wanted[at(part)].push_back({points, size, growth});
}

double growth_for(const ContactResolution& r) {
    return std::clamp(fastest_growth * std::pow(r.end_fraction / fast_end, 0.25), slowest_growth, fastest_growth);
}

double end_size(const RunEnd& end, const ContactResolution& r) {
    return end.kind == RunEnd::Kind::free ? r.end_fraction : r.corner_fraction;
}

/// Where a straight edge meets an arc within a contact the pressure has a steep peak: fine cells at the joints of either chain.
void want_at_joints(const Scene& scene, const ContactInterface& contact, const ContactRun& run,
                    const ContactResolution& resolution, WantedSizes& wanted) {
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
            for (int p : contact.part)
                want(wanted, p, {x}, (run.end - run.begin) * resolution.corner_fraction, growth_for(resolution));
        }
    }
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
        want(wanted, c.first, on1, coarseness * length / cells_in_first_contact, size_growth);
        want(wanted, c.second, on2, coarseness * length / cells_in_first_contact, size_growth);
    }
    return wanted;
}

WantedSizes sizes_from(const Scene& scene, const SolvedAssembly& solved, const std::vector<ContactResolution>& resolution) {
    WantedSizes wanted(scene.parts.size());
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        for (const ContactRun& run : solved.runs[k]) {
            const ContactInterface& contact = solved.contacts[k];
            const double length = run.end - run.begin, growth = growth_for(resolution[k]);
            std::array<std::vector<Vec2>, 2> points;
            for (int i = 0; i < samples; ++i) {
                const geometry::FacingPair pair = pair_at(scene, contact, run.begin + length * i / (samples - 1));
                if (!pair.found) continue;
                points[0].push_back(pair.on1.x);
                points[1].push_back(pair.on2.x);
            }
            want_at_joints(scene, contact, run, resolution[k], wanted);
            for (std::size_t side = 0; side < 2; ++side) {
                if (points[side].empty()) continue;
                const int part = contact.part[side];
                want(wanted, part, points[side], length / resolution[k].cells, growth);
                if (run.at_begin.kind != RunEnd::Kind::plain)
                    want(wanted, part, {points[side].front()}, length * end_size(run.at_begin, resolution[k]), growth);
                if (run.at_end.kind != RunEnd::Kind::plain)
                    want(wanted, part, {points[side].back()}, length * end_size(run.at_end, resolution[k]), growth);
            }
        }
    return wanted;
}

}  // namespace abut
