// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing_carry.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/proximity/facing_search.hpp"
#include "geometry/proximity/facing_stretch.hpp"

namespace abut::geometry {

namespace {

/// A gap that varies by less than this per length is uniform: its extrema would be those of rounding.
constexpr double uniform_slope = 1e-10;

struct Sample {
    FacingPair pair;
    bool valid = false;
    double tilt = 0;                    ///< n1 x n2: zero where the gap is extreme
    double opposition = 0, spread = 0;  ///< see least_opposition, least_spread
};

class ZoneCarrier {
public:
    ZoneCarrier(const Part& part1, const Part& part2, const CarriedZone& found, const CarryLimits& limits)
        : part1_(part1), part2_(part2), found_(found), limits_(limits), same_(FacingModel::same_fraction * limits.size) {
        chains_.chain1 = found.chain1;
        chains_.chain2 = found.chain2;
    }

    std::vector<FacingZone> run() {
        take_samples();
        if (samples_.size() < 2) return {};
        add_extrema();
        const bool all = std::all_of(samples_.begin(), samples_.end(), [](const Sample& s) { return s.valid; });
        if (found_.closed && all) return {closed_zone()};
        if (found_.closed) begin_at_invalid();
        return zones_between();
    }

private:
    Sample sample(const FacingPair& pair) const {
        const double r = pair.gap / (pair.on1.normal - pair.on2.normal).norm();
        Sample s{pair};
        s.tilt = cross(pair.on1.normal, pair.on2.normal);
        s.opposition = -pair.on1.normal.dot(pair.on2.normal);
        s.spread = 1 + std::min(r * pair.on1.curvature, r * pair.on2.curvature);
        s.valid = pair.found && std::abs(pair.gap) <= limits_.distance && s.opposition >= least_opposition &&
                  s.spread >= least_spread;
        return s;
    }
    Sample at_first(double s1, double guess2) const { return sample(pair_from_first(part1_, part2_, chains_, s1, guess2)); }
    Sample at_second(double s2, double guess1) const { return sample(pair_from_second(part1_, part2_, chains_, s2, guess1)); }

    void take_samples() {
        const std::vector<ZoneGuess>& b = found_.breaks;
        const Sample first = end_sample(b.front(), true), last = end_sample(b.back(), false);
        samples_.push_back(first);
        for (const ZoneGuess& guess : b) {
            if (guess.s1 - samples_.back().pair.s1 <= same_ || last.pair.s1 - guess.s1 <= same_) continue;
            samples_.push_back(at_first(guess.s1, guess.s2));
        }
        if (last.pair.s1 - samples_.back().pair.s1 > same_) samples_.push_back(last);
    }

    /// The end of the zone: at a corner of chain 1, at the image of a corner of chain 2, or where the arcs' zone ends.
    Sample end_sample(const ZoneGuess& guess, bool is_begin) const {
        if (found_.closed) return at_first(guess.s1, guess.s2);
        const double corner1 = is_begin ? 0 : found_.chain1.length, corner2 = is_begin ? found_.chain2.length : 0;
        const Sample plain = at_first(guess.s1, guess.s2);
        const double reach = 100 * same_ + limits_.error + arc_joint_angle * std::abs(plain.pair.gap);
        const bool near1 = !found_.chain1.closed && std::abs(guess.s1 - corner1) <= reach;
        const bool near2 = !found_.chain2.closed && std::abs(guess.s2 - corner2) <= reach;
        if (near1) {
            const Sample s = at_first(corner1, guess.s2);
            if (s.pair.found) return snapped(s);
        }
        if (near2) {
            const Sample s = at_second(corner2, guess.s1);
            if (s.pair.found) return snapped(s);
        }
        return near1 || near2 ? plain : beyond_angle(plain, is_begin);
    }

    /// Ends of the chains exactly, where only rounding is missing.
    Sample snapped(Sample s) const {
        const auto snap = [&](const Chain& chain, double& length) {
            if (chain.closed) return;
            if (std::abs(length) <= 4 * same_) length = 0;
            if (std::abs(length - chain.length) <= 4 * same_) length = chain.length;
        };
        snap(found_.chain1, s.pair.s1);
        snap(found_.chain2, s.pair.s2);
        return s;
    }

    /// Where the arcs' zone ends by its angle, the true one may go on a little, for tangents of arcs err more than their
    /// points: a sample outside it, if one is found nearby.
    Sample beyond_angle(const Sample& end, bool is_begin) const {
        if (!end.valid || end.opposition - least_opposition > arc_joint_angle) return end;
        const double bend = std::max({std::abs(end.pair.on1.curvature), std::abs(end.pair.on2.curvature), 1 / limits_.size});
        double step = arc_joint_angle / bend / 16;
        constexpr int doublings = 6;
        for (int k = 0; k < doublings; ++k, step *= 2) {
            double s1 = end.pair.s1 + (is_begin ? -step : step);
            if (!found_.chain1.closed) s1 = std::clamp(s1, 0.0, found_.chain1.length);
            const Sample out = at_first(s1, end.pair.s2);
            if (!out.valid) return out.pair.found && out.opposition < least_opposition ? out : end;
        }
        return end;
    }

    /// The place between a and b where the normals are parallel, by secants kept inside the bracket (Illinois).
    Sample extremum(const Sample& a, const Sample& b) const {
        double low = a.pair.s1, high = b.pair.s1, tilt_low = a.tilt, tilt_high = b.tilt;
        double guess = 0.5 * (a.pair.s2 + b.pair.s2);
        Sample best = std::abs(a.tilt) < std::abs(b.tilt) ? a : b;
        int side = 0;
        for (int k = 0; k < 60 && high - low > same_ * 1e-3; ++k) {
            const double s1 = (low * tilt_high - high * tilt_low) / (tilt_high - tilt_low);
            if (!(s1 > low && s1 < high)) break;
            const Sample s = at_first(s1, guess);
            if (!s.pair.found) break;
            guess = s.pair.s2;
            best = s;
            if (s.tilt == 0) break;
            if ((s.tilt < 0) == (tilt_low < 0)) {
                low = s1;
                tilt_low = s.tilt;
                if (side == -1) tilt_high *= 0.5;
                side = -1;
            } else {
                high = s1;
                tilt_high = s.tilt;
                if (side == 1) tilt_low *= 0.5;
                side = 1;
            }
        }
        return best;
    }

    void add_extrema() {
        std::vector<Sample> all;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            all.push_back(samples_[i]);
            if (i + 1 == samples_.size()) break;
            const Sample &a = samples_[i], &b = samples_[i + 1];
            const bool steep = std::max(std::abs(a.tilt), std::abs(b.tilt)) > uniform_slope;
            if (!a.pair.found || !b.pair.found || a.tilt * b.tilt >= 0 || !steep) continue;
            const Sample s = extremum(a, b);
            if (s.pair.s1 > a.pair.s1 && s.pair.s1 < b.pair.s1) all.push_back(s);
        }
        samples_ = all;
    }

    /// The end of validity between a valid and an invalid sample.
    Sample limit_between(Sample inside, const Sample& outside) const {
        double a = inside.pair.s1, b = outside.pair.s1;
        for (int k = 0; k < 100; ++k) {
            const double m = 0.5 * (a + b);
            if (m == a || m == b) break;
            const Sample s = at_first(m, inside.pair.s2);
            (s.valid ? a : b) = m;
            if (s.valid) inside = s;
        }
        return inside;
    }

    void extend(FacingZone& zone, const Sample& s) const {
        zone.gap_min = std::min(zone.gap_min, s.pair.gap);
        zone.gap_max = std::max(zone.gap_max, s.pair.gap);
    }

    /// Of a full turn: at the beginning of chain 1.
    Sample at_seam() const {
        const double length1 = found_.chain1.length, seam = length1 * std::ceil(samples_.front().pair.s1 / length1);
        const auto after = std::find_if(samples_.begin(), samples_.end(), [&](const Sample& s) { return s.pair.s1 >= seam; });
        return at_first(seam, (after == samples_.end() ? samples_.back() : *after).pair.s2);
    }

    FacingZone closed_zone() const {
        FacingZone zone = chains_;
        zone.closed = true;
        zone.gap_min = zone.gap_max = samples_.front().pair.gap;
        const Sample* largest = &samples_.front();
        for (const Sample& s : samples_) {
            extend(zone, s);
            if (s.pair.gap > largest->pair.gap) largest = &s;
        }
        const Sample start = at_seam();
        const bool uniform = start.pair.found && zone.gap_max <= start.pair.gap + 100 * same_;
        const FacingPair& begin = uniform ? start.pair : largest->pair;
        zone.begin1 = begin.s1;
        zone.begin2 = begin.s2;
        zone.end1 = zone.begin1 + found_.chain1.length;
        zone.end2 = zone.begin2 - found_.chain2.length;
        return on_first_turn(zone);
    }

    /// begin1 in [0, length) of a closed chain 1, end2 in [0, length) of a closed chain 2.
    FacingZone on_first_turn(FacingZone zone) const {
        if (found_.chain1.closed) {
            const double turns = found_.chain1.length * std::floor(zone.begin1 / found_.chain1.length);
            zone.begin1 -= turns;
            zone.end1 -= turns;
        }
        if (found_.chain2.closed) {
            const double turns = found_.chain2.length * std::floor(zone.end2 / found_.chain2.length);
            zone.begin2 -= turns;
            zone.end2 -= turns;
        }
        return zone;
    }

    /// A full turn with places that are too far: begin at one of them.
    void begin_at_invalid() {
        samples_.pop_back();  // the first once more
        const auto first = std::find_if(samples_.begin(), samples_.end(), [](const Sample& s) { return !s.valid; });
        for (auto s = samples_.begin(); s != first; ++s) {
            s->pair.s1 += found_.chain1.length;
            s->pair.s2 -= found_.chain2.length;
        }
        std::rotate(samples_.begin(), first, samples_.end());
        Sample last = samples_.front();
        last.pair.s1 += found_.chain1.length;
        last.pair.s2 -= found_.chain2.length;
        samples_.push_back(last);
    }

    std::vector<FacingZone> zones_between() const {
        std::vector<FacingZone> zones;
        for (std::size_t i = 0; i < samples_.size();) {
            std::size_t k = i;
            while (k < samples_.size() && samples_[k].valid) ++k;
            if (k > i) add_zone(i, k - 1, zones);
            i = k + 1;
        }
        return zones;
    }

    /// The zone of the valid samples first .. last.
    void add_zone(std::size_t first, std::size_t last, std::vector<FacingZone>& zones) const {
        const bool cut_begin = first > 0, cut_end = last + 1 < samples_.size();
        const Sample begin = cut_begin ? limit_between(samples_[first], samples_[first - 1]) : samples_[first];
        const Sample end = cut_end ? limit_between(samples_[last], samples_[last + 1]) : samples_[last];
        if (!(end.pair.s1 - begin.pair.s1 > shortest_zone_fraction * limits_.size)) return;
        FacingZone zone = chains_;
        zone.begin1 = begin.pair.s1;
        zone.begin2 = begin.pair.s2;
        zone.end1 = end.pair.s1;
        zone.end2 = end.pair.s2;
        zone.gap_min = zone.gap_max = begin.pair.gap;
        extend(zone, end);
        for (std::size_t i = first; i <= last; ++i) extend(zone, samples_[i]);
        const auto is_limit = [&](const Sample& s) {
            const bool corner1 = !zone.chain1.closed && (s.pair.s1 <= 0 || s.pair.s1 >= zone.chain1.length);
            const bool corner2 = !zone.chain2.closed && (s.pair.s2 <= 0 || s.pair.s2 >= zone.chain2.length);
            return std::abs(std::abs(s.pair.gap) - limits_.distance) <= 1e-9 * limits_.distance && !corner1 && !corner2;
        };
        zone.begin_is_limit = is_limit(begin);
        zone.end_is_limit = is_limit(end);
        zones.push_back(on_first_turn(zone));
    }

    const Part &part1_, &part2_;
    const CarriedZone& found_;
    const CarryLimits& limits_;
    double same_;
    FacingZone chains_;  ///< only its chains: what pairing needs
    std::vector<Sample> samples_;
};

}  // namespace

std::vector<FacingZone> carried_over(const Part& part1, const Part& part2, const CarriedZone& found,
                                     const CarryLimits& limits) {
    return ZoneCarrier(part1, part2, found, limits).run();
}

}  // namespace abut::geometry
