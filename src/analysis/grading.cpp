// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/grading.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"
#include "src/solution/contact_joints.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

constexpr int samples = 33;
constexpr double near_gap_fraction = 0.25;  // of a zone's range of gaps: what is closer counts as where contact will be
constexpr double cells_in_first_contact = 16;
/// Cells at the ends from which on the growth towards the middle follows them, by the fourth root: the ends' errors fall with
/// the cell size, those of the rest with its third power and more.
constexpr double fast_end = 0.02;
/// Distance of a joint from the end of contact, times this: the length that the end's cells are a fraction of.
/// At least this of the stretch: a joint at the very end tells nothing.
constexpr double lengths_beside_joint = 4, least_steep_end = 1e-3;
constexpr double slowest_growth = 0.4, fastest_growth = 0.69;  // neighbours by a factor of 2

void want(WantedSizes& wanted, int part, const std::vector<Vec2>& points, double size, double growth) {
    if (!points.empty() && size > 0) wanted[at(part)].push_back({points, size, growth});
}

double growth_for(const ContactResolution& r) {
    return std::clamp(fastest_growth * std::pow(r.end_fraction / fast_end, 0.25), slowest_growth, fastest_growth);
}

/// length: of the pressure's steep end.
double end_size(const StretchEnd& end, double length, const ContactResolution& r) {
    return length * (end.kind == StretchEnd::Kind::free ? r.end_fraction : r.corner_fraction);
}

/// Joints within a stretch from which on the gap opens; and the lengths of the pressure's steep ends, beyond the nearest ones.
struct RunJoints {
    std::vector<ContactJoint> inside;
    std::vector<double> length;  // of the steep end that each belongs to
    double at_begin, at_end;
};

RunJoints joints_in(const std::vector<ContactJoint>& joints, const PressedStretch& stretch) {
    const double whole = stretch.end - stretch.begin;
    RunJoints in{{}, {}, whole, whole};
    for (const ContactJoint& joint : joints) {
        if (joint.s <= stretch.begin || joint.s >= stretch.end) continue;
        const bool to_end = joint.opening > 0;
        const double distance = to_end ? stretch.end - joint.s : joint.s - stretch.begin;
        const StretchEnd& end = to_end ? stretch.at_end : stretch.at_begin;
        const double length = end.kind == StretchEnd::Kind::free
                                  ? std::clamp(lengths_beside_joint * distance, least_steep_end * whole, whole)
                                  : whole;
        double& shortest = to_end ? in.at_end : in.at_begin;
        shortest = std::min(shortest, length);
        in.inside.push_back(joint);
        in.length.push_back(length);
    }
    return in;
}

/// On both bodies, where sticking and slipping meet within a stretch.
std::array<std::vector<Vec2>, 2> borders_in(const Scene& scene, const SolvedAssembly& solved, std::size_t contact,
                                            const PressedStretch& stretch) {
    std::array<std::vector<Vec2>, 2> places;
    for (const StickBorder& border : stick_borders(solved, contact)) {
        const geometry::FacingPair pair = pair_at(scene, solved.contacts[contact], border.s);
        if (!pair.found || border.s <= stretch.begin || border.s >= stretch.end) continue;
        places[0].push_back(pair.on1.x);
        places[1].push_back(pair.on2.x);
    }
    return places;
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

WantedSizes sizes_from(const Scene& scene, const SolvedAssembly& solved, const PressedStretches& stretches,
                       const std::vector<ContactResolution>& resolution) {
    WantedSizes wanted(scene.parts.size());
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const std::vector<ContactJoint> all_joints =
            stretches[k].empty() ? std::vector<ContactJoint>() : contact_joints(scene, solved.contacts[k]);
        for (const PressedStretch& stretch : stretches[k]) {
            const ContactInterface& contact = solved.contacts[k];
            const double length = stretch.end - stretch.begin, growth = growth_for(resolution[k]);
            std::array<std::vector<Vec2>, 2> points;
            for (int i = 0; i < samples; ++i) {
                const geometry::FacingPair pair = pair_at(scene, contact, stretch.begin + length * i / (samples - 1));
                if (!pair.found) continue;
                points[0].push_back(pair.on1.x);
                points[1].push_back(pair.on2.x);
            }
            const RunJoints joints = joints_in(all_joints, stretch);
            const std::array<std::vector<Vec2>, 2> borders = borders_in(scene, solved, k, stretch);
            for (std::size_t side = 0; side < 2; ++side) {
                if (points[side].empty()) continue;
                const int part = contact.part[side];
                want(wanted, part, points[side], length / resolution[k].cells, growth);
                if (stretch.at_begin.kind != StretchEnd::Kind::plain)
                    want(wanted, part, {points[side].front()}, end_size(stretch.at_begin, joints.at_begin, resolution[k]),
                         growth);
                if (stretch.at_end.kind != StretchEnd::Kind::plain)
                    want(wanted, part, {points[side].back()}, end_size(stretch.at_end, joints.at_end, resolution[k]), growth);
                for (const Vec2& border : borders[side])
                    want(wanted, part, {border}, length * resolution[k].end_fraction, growth);
                for (std::size_t i = 0; i < joints.inside.size(); ++i)
                    want(wanted, part, {joints.inside[i].x[side]}, joints.length[i] * resolution[k].corner_fraction, growth);
            }
        }
    }
    return wanted;
}

}  // namespace abut
