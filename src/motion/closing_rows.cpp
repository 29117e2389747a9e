// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/closing_rows.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

constexpr int samples = 8;    // intervals along a zone
constexpr int halvings = 26;  // of an interval, towards the least gap on either side
constexpr int search_steps = 40;
/// Of what is searched: gaps tell no better where the least is, since they hardly change there.
constexpr double known_by_gap = 1e-6;

/// The gaps of one zone.
class ZoneRows {
public:
    ZoneRows(const Scene& scene, const Candidate& zone, double far, std::vector<ClosingRow>& rows)
        : scene_(scene), c_(zone), far_(far), rows_(rows) {}

    void append() {
        std::vector<geometry::FacingPair> pairs;
        bool curved = false;
        for (int k = 0; k <= samples; ++k) {
            pairs.push_back(pair_at(place(k)));
            curved = curved || pairs.back().on1.curvature != 0 || pairs.back().on2.curvature != 0;
        }
        for (int k = 0; k <= samples; ++k)
            if (curved || k == 0 || k == samples) take(pairs[at(k)]);
        if (!curved) return;
        for (int k = 0; k <= samples; ++k) {
            const auto gap = [&](int i) { return pairs[at(std::clamp(i, 0, samples))].gap; };
            if (gap(k) <= gap(k - 1) && gap(k) <= gap(k + 1)) append_around(place(k - 1), place(k + 1));
        }
    }

private:
    double place(int k) const {
        const double share = static_cast<double>(std::clamp(k, 0, samples)) / samples;
        return (1 - share) * c_.zone.begin1 + share * c_.zone.end1;
    }

    geometry::FacingPair pair_at(double s) const {
        const double share = (s - c_.zone.begin1) / (c_.zone.end1 - c_.zone.begin1);
        return pair_from_first(part_of(scene_, c_.first), part_of(scene_, c_.second), c_.zone, s,
                               (1 - share) * c_.zone.begin2 + share * c_.zone.end2);
    }

    void take(const geometry::FacingPair& p, bool is_beside = false) {
        if (!p.found || p.gap > far_) return;
        rows_.push_back({c_.first, c_.second, p.on1.x, p.on2.x, normal_of(p), p.gap, pivot(p.on1, p.on2), pivot(p.on2, p.on1),
                         c_.friction, is_beside});
    }

    /// Does a gap grow from another one as between round faces, one of which may be flat?
    static bool grows_by_curvature(const geometry::FacingPair& p, const geometry::FacingPair& from) {
        constexpr double much = 0.5;  // of what curvatures say
        const double curvature = from.on1.curvature + from.on2.curvature;
        return from.on1.curvature >= 0 && from.on2.curvature >= 0 && curvature > 0 &&
               p.gap - from.gap >= much * 0.5 * curvature * (p.on1.x - from.on1.x).squaredNorm();
    }

    static Vec2 pivot(const geometry::ChainPoint& own, const geometry::ChainPoint& other) {
        if (own.curvature * other.curvature >= 0) return own.x;
        return own.x - own.normal / own.curvature;
    }

    /// A round part in a hollow is pressed towards its own centre, however wide the hollow.
    static Vec2 normal_of(const geometry::FacingPair& p) {
        if (p.on1.curvature * p.on2.curvature >= 0) return p.normal;
        return std::abs(p.on1.curvature) > std::abs(p.on2.curvature) ? p.on1.normal : Vec2(-p.on2.normal);
    }

    /// About the least gap between two places.
    void append_around(double begin, double end) {
        constexpr double golden = 0.381966011250105;
        double low = begin, high = end;
        for (int i = 0; i < search_steps; ++i) {
            const double a = low + golden * (high - low), b = high - golden * (high - low);
            const bool is_below = pair_at(a).gap < pair_at(b).gap;
            (is_below ? high : low) = is_below ? b : a;
        }
        const double least = where_normals_oppose(0.5 * (low + high), known_by_gap * (end - begin));
        const geometry::FacingPair closest = pair_at(least);
        take(closest);
        double offset = 0.5 * (end - begin);
        for (int i = 0; i < halvings; ++i) {
            offset *= 0.5;
            for (const double s : {least - offset, least + offset})
                if (s > c_.zone.begin1 && s < c_.zone.end1) {
                    const geometry::FacingPair pair = pair_at(s);
                    take(pair, grows_by_curvature(pair, closest));
                }
        }
    }

    /// The place no farther than that from another one where the outward normals are opposite, if there is any: what lies at a
    /// least gap of smooth faces.
    double where_normals_oppose(double near, double within) const {
        const auto turn = [&](double s) {
            const geometry::FacingPair p = pair_at(s);
            return geometry::cross(p.on1.normal, p.on2.normal);
        };
        double low = near - within, high = near + within;
        const bool rises = turn(high) > 0;
        if (rises == (turn(low) > 0)) return near;
        for (int i = 0; i < search_steps; ++i) ((turn(0.5 * (low + high)) > 0) == rises ? high : low) = 0.5 * (low + high);
        return 0.5 * (low + high);
    }

    const Scene& scene_;
    const Candidate& c_;
    double far_;
    std::vector<ClosingRow>& rows_;
};

/// A corner that points at a face has no zone: the closest points are its row.
void append_corner(const Encounter& m, double touching, std::vector<ClosingRow>& rows) {
    if (!m.unpaired || m.closest->distance <= touching) return;
    const Vec2 across = m.closest->x2 - m.closest->x1;
    rows.push_back({m.first, m.second, m.closest->x1, m.closest->x2, across / across.norm(), m.closest->distance, m.closest->x1,
                    m.closest->x2});
}

}  // namespace

Closing closing_rows(const Scene& scene, const PairRules& rules, const std::vector<int>& bodies,
                     const std::vector<double>& may_move) {
    ENSURE(may_move.size() == scene.parts.size() && bodies.size() == scene.parts.size(),
           "of every part it is known how far it may move, and with which");
    Closing closing;
    const SearchDistances distances(scene);
    const int n = static_cast<int>(scene.parts.size());
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) {
            const double far = may_move[at(i)] + may_move[at(j)];
            if (far == 0 || bodies[at(i)] == bodies[at(j)] || !distances.within(i, j, far)) continue;
            const Encounter m = encounter_of(scene, rules, distances, i, j, {far, far, far});
            for (const Candidate& c : m.candidates) ZoneRows(scene, c, far, closing.rows).append();
            append_corner(m, distances.touching(i, j), closing.rows);
            if (!m.overlap) continue;
            closing.deepest = std::max(closing.deepest, m.overlap->depth / distances.size(i, j));
            closing.overlaps = closing.overlaps || m.overlap->depth > distances.precision(i, j);
        }
    return closing;
}

}  // namespace abut
