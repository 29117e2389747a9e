// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/missed_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "solver/linear_algebra/parallel_for.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

/// Of the scene's largest force: a part on which less acts is of no interest to anybody.
constexpr double negligible_force = 1e-3;

/// Of how far parts move, and of their size: shallower overlaps are rounding of displacements, and of coordinates.
constexpr double rounding_of_moves = 1e-9, rounding_of_places = 1e-15;

/// Of the distance between two points: nearer than this the place of the least gap is known well enough.
constexpr double place_tolerance = 1e-3;

/// A zone under the displacements.
class DeformedZone {
public:
    DeformedZone(const Scene& scene, const SolvedAssembly& solved, std::size_t contact)
        : scene_(scene), solved_(solved), contact_(solved.contacts[contact]), runs_(solved.stretches[contact]) {}

    double gap(const solver::InterfacePoint& p) const {
        double gap = p.gap;
        for (std::size_t side = 0; side < 2; ++side) gap += opening(side, p.element[side], p.x[side], p.normal[side]);
        return gap;
    }

    /// The same anywhere along the middle curve; nothing where it has no pair.
    std::optional<double> gap(double s) const {
        const geometry::FacingPair pair = pair_at(scene_, contact_, s);
        if (!pair.found) return std::nullopt;
        double gap = contact_.drawn.of(pair.gap);
        for (std::size_t side = 0; side < 2; ++side) {
            const PartOnGrid& g = grid_of(side);
            const geometry::ChainPoint& on = side == 0 ? pair.on1 : pair.on2;
            gap += opening(side, element_of(g, on), g.frame.to_local(on.x), g.frame.vector_to_local(pair.normal));
        }
        return gap;
    }

    /// Is a place under pressure, or so near to where it ends that the pressure's knots do not tell?
    bool is_pressed(double s) const {
        return std::any_of(runs_.begin(), runs_.end(), [&](const PressedStretch& stretch) {
            return s >= stretch.begin - stretch.at_begin.reach && s <= stretch.end + stretch.at_end.reach;
        });
    }

private:
    const PartOnGrid& grid_of(std::size_t side) const { return solved_.grids[at(contact_.face.part[side])]; }
    double opening(std::size_t side, int element, const Vec2& x, const Vec2& normal) const {
        const std::size_t i = at(contact_.face.part[side]);
        const auto u = solver::displacement_at(solved_.grids[i].input, solved_.solution.displacement[i], element, x);
        return (side == 0 ? -1 : 1) * normal.dot(u.value);
    }

    const Scene& scene_;
    const SolvedAssembly& solved_;
    const ContactInterface& contact_;
    const std::vector<PressedStretch>& runs_;
};

struct GapAt {
    double s, gap;
};

/// The least gap between two places (golden sections: it has one minimum there).
GapAt least_between(const DeformedZone& zone, double low, double high) {
    constexpr double golden = 0.6180339887498949;
    const double tolerance = place_tolerance * (high - low);
    const auto look = [&](double s) { return GapAt{s, zone.gap(s).value_or(std::numeric_limits<double>::infinity())}; };
    GapAt a = look(high - golden * (high - low)), b = look(low + golden * (high - low));
    while (high - low > tolerance) {
        if (a.gap < b.gap) {
            high = b.s;
            b = a;
            a = look(high - golden * (high - low));
        } else {
            low = a.s;
            a = b;
            b = look(low + golden * (high - low));
        }
    }
    return a.gap < b.gap ? a : b;
}

/// Where the gap closes between an open place and an overlap.
double edge_between(const DeformedZone& zone, double open, double closed) {
    const double tolerance = place_tolerance * std::abs(closed - open);
    while (std::abs(closed - open) > tolerance) {
        const double middle = 0.5 * (open + closed);
        (zone.gap(middle).value_or(1) < 0 ? closed : open) = middle;
    }
    return open;
}

MissedContact missed_between(double begin, double end, double depth) {
    MissedContact m{{begin, end, false, false}, depth, 0};
    m.stretch.at_begin.kind = m.stretch.at_end.kind = StretchEnd::Kind::free;
    return m;
}

/// By two parts the places, on the first of them, where pressures begin and end.
using PressedPlaces = std::map<std::array<int, 2>, std::vector<Vec2>>;

/// The gaps at a zone's ends and points; 0 under pressure. An end up to which the same parts press on each other in another
/// zone, round a corner, is part of that contact's end.
std::vector<GapAt> gaps_along(const Scene& scene, const DeformedZone& zone, const ContactInterface& c,
                              const std::vector<Vec2>& pressed) {
    std::vector<GapAt> gaps;
    const auto append = [&](double s, std::optional<double> gap) {
        if (gap) gaps.push_back({s, zone.is_pressed(s) ? 0 : *gap});
    };
    const double merge = std::max(merge_length(part_of(scene, c.part[0])), merge_length(part_of(scene, c.part[1])));
    const auto append_end = [&](double s) {
        const Vec2 place = pair_at(scene, c, s).on1.x;
        const auto is_here = [&](const Vec2& end) { return (end - place).norm() <= merge; };
        if (std::none_of(pressed.begin(), pressed.end(), is_here)) append(s, zone.gap(s));
    };
    append_end(c.s.front());
    for (const solver::InterfacePoint& p : c.face.points) append(p.s, zone.gap(p));
    append_end(c.s.back());
    return gaps;
}

/// The least gap along a zone, about that of its points.
double least_of(const DeformedZone& zone, const std::vector<GapAt>& gaps) {
    if (gaps.empty()) return std::numeric_limits<double>::infinity();
    const auto least = std::min_element(gaps.begin(), gaps.end(), [](const GapAt& a, const GapAt& b) { return a.gap < b.gap; });
    if (least->gap == 0) return 0;
    const double before = least == gaps.begin() ? least->s : (least - 1)->s,
                 after = least + 1 == gaps.end() ? least->s : (least + 1)->s;
    return std::min(least->gap, least_between(zone, before, after).gap);
}

/// Overlapping stretches of one contact: points where the gap is negative, and places between points where it is. What goes on
/// from a stretch under pressure is no contact of its own: bodies overlap there by what the pressure's end lacks, which has an
/// estimate, and by motions that nothing holds, which tilt the gap.
SeenContact look_at(const Scene& scene, const DeformedZone& zone, const ContactInterface& c, const std::vector<Vec2>& pressed) {
    SeenContact seen;
    const std::vector<GapAt> gaps = gaps_along(scene, zone, c, pressed);
    seen.least_gap = least_of(zone, gaps);
    const std::size_t n = gaps.size();
    std::vector<MissedContact>& found = seen.overlaps;
    for (std::size_t i = 0; i < n; ++i) {
        const double before = i == 0 ? gaps[i].s : gaps[i - 1].s;
        const auto after = [&] { return i + 1 == n ? gaps[i].s : gaps[i + 1].s; };
        if (gaps[i].gap < 0) {
            const std::size_t first = i;
            double depth = -gaps[i].gap;
            for (; i + 1 < n && gaps[i + 1].gap < 0; ++i) depth = std::max(depth, -gaps[i + 1].gap);
            const bool goes_on = (first > 0 && gaps[first - 1].gap == 0) || (i + 1 < n && gaps[i + 1].gap == 0);
            if (!goes_on) found.push_back(missed_between(before, after(), depth));
            continue;
        }
        const bool is_least =
            gaps[i].gap > 0 && i > 0 && i + 1 < n && gaps[i].gap <= gaps[i - 1].gap && gaps[i].gap <= gaps[i + 1].gap;
        if (!is_least) continue;
        const GapAt least = least_between(zone, before, after());
        if (least.gap < 0)
            found.push_back(
                missed_between(edge_between(zone, before, least.s), edge_between(zone, after(), least.s), -least.gap));
    }
    return seen;
}

/// By solver's part: the largest load on it, or force of its contacts.
std::vector<double> largest_forces(const SolvedAssembly& solved) {
    std::vector<double> force = solved.problem.part_load;
    force.resize(solved.grids.size(), 0);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        if (solved.stretches[k].empty()) continue;
        const double f = contact_force(solved, k).force.norm();
        for (int part : solved.contacts[k].face.part) force[at(part)] = std::max(force[at(part)], f);
    }
    return force;
}

bool is_searched(const SolvedAssembly& solved, std::size_t contact) {
    const ContactInterface& c = solved.contacts[contact];
    return solved.interface_of[contact] >= 0 && !c.face.bilateral && c.pairing == Pairing::middle;
}

/// Contacts that were looked at under the displacements, and the forces on their parts.
class LookedAt {
public:
    LookedAt(const SolvedAssembly& solved, const std::vector<SeenContact>& seen)
        : solved_(solved), forces_(largest_forces(solved)), seen_(seen) {
        ENSURE(seen.size() == solved.contacts.size(), "every contact was looked at");
    }

    MissedContacts missed(double least_share) const {
        MissedContacts missed(seen_.size());
        const double least_force = negligible_force * largest_force();
        for (std::size_t k = 0; k < seen_.size(); ++k)
            for (MissedContact m : seen_[k].overlaps) {
                if (!is_overlap(k, m.depth)) continue;
                const auto& part = solved_.contacts[k].face.part;
                m.share =
                    force_against(k, m.depth) / std::max(std::min(forces_[at(part[0])], forces_[at(part[1])]), least_force);
                if (m.share > least_share) missed[k].push_back(m);
            }
        return missed;
    }

private:
    /// Where nothing but motions drives there may be none yet: then it is the largest against an overlap.
    double largest_force() const {
        double largest = forces_.empty() ? 0 : *std::max_element(forces_.begin(), forces_.end());
        if (largest > 0) return largest;
        for (std::size_t k = 0; k < seen_.size(); ++k)
            for (const MissedContact& m : seen_[k].overlaps)
                if (is_overlap(k, m.depth)) largest = std::max(largest, force_against(k, m.depth));
        return largest;
    }

    /// Is it more than rounding, and can neither part evade?
    bool is_overlap(std::size_t contact, double depth) const {
        const auto& part = solved_.contacts[contact].face.part;
        return std::all_of(part.begin(), part.end(),
                           [&](int i) { return depth > rounding_of(at(i)) && !may_evade(at(i), contact); });
    }

    /// About what would press an overlap back.
    double force_against(std::size_t contact, double depth) const {
        return solved_.contacts[contact].face.thickness * depth / compliance_of(solved_, contact);
    }

    /// Of a part's places under the displacements.
    double rounding_of(std::size_t part) const {
        const double farthest = solved_.solution.displacement[part].lpNorm<Eigen::Infinity>();
        return rounding_of_moves * farthest + rounding_of_places * solved_.grids[part].size;
    }

    /// A part on which nothing acts and that nothing holds gets out of the way of one overlap, as long as that closes no other
    /// gap: a move by the depth closes none by more.
    bool may_evade(std::size_t part, std::size_t contact) const {
        const double depth = -seen_[contact].least_gap;
        if (forces_[part] > 0 || solved_.problem.parts[part].free_motions.size() < 3) return false;
        if (has_held_means(solved_, part) || seen_[contact].overlaps.size() > 1) return false;
        for (std::size_t k = 0; k < seen_.size(); ++k) {
            const std::array<int, 2>& between = solved_.contacts[k].face.part;
            if (k == contact || solved_.interface_of[k] < 0 || (at(between[0]) != part && at(between[1]) != part)) continue;
            if (!is_searched(solved_, k) || seen_[k].least_gap <= depth) return false;
        }
        return true;
    }

    const SolvedAssembly& solved_;
    std::vector<double> forces_;  // by solver's part
    const std::vector<SeenContact>& seen_;
};

}  // namespace

std::vector<SeenContact> look_at_contacts(const Scene& scene, const SolvedAssembly& solved, int threads) {
    std::vector<SeenContact> seen(solved.contacts.size());
    PressedPlaces pressed;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        std::vector<Vec2>& places = pressed[solved.contacts[k].part];
        for (const PressedEnd& end : pressed_ends(scene, solved, k)) places.push_back(end.pair.on1.x);
    }
    solver::parallel_for(static_cast<int>(seen.size()), threads, [&](int k) {
        if (is_searched(solved, at(k)))
            seen[at(k)] = look_at(scene, DeformedZone(scene, solved, at(k)), solved.contacts[at(k)],
                                  pressed.at(solved.contacts[at(k)].part));
    });
    return seen;
}

MissedContacts missed_contacts(const SolvedAssembly& solved, const std::vector<SeenContact>& seen, double least_share) {
    return LookedAt(solved, seen).missed(least_share);
}

bool any_missed(const MissedContacts& missed) {
    return std::any_of(missed.begin(), missed.end(), [](const auto& m) { return !m.empty(); });
}

PressedStretches with_missed(PressedStretches stretches, const MissedContacts& missed) {
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        for (const MissedContact& m : missed[k]) stretches[k].push_back(m.stretch);
        std::sort(stretches[k].begin(), stretches[k].end(),
                  [](const PressedStretch& a, const PressedStretch& b) { return a.begin < b.begin; });
    }
    return stretches;
}

}  // namespace abut
