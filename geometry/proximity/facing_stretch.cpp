// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/proximity/facing_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/curves/curve_meetings.hpp"
#include "geometry/curves/tangent_ball.hpp"

namespace abut::geometry {

namespace {

/// A sheet thinner than this fraction of the model cannot hide one surface from another.
constexpr double thin_fraction = 1e-6;
/// Places looked at between two events. Between events the gap is monotone and the angle has at most one maximum, so that the
/// only thing that can fall through is material in the line of sight narrower than a sample's share.
constexpr int samples_per_interval = 8;
/// The first and last sample lie this close to the event, to see what holds right beside it: a fraction of the interval, but
/// well clear of rounding (in units of FacingModel::same), and never beyond the next sample.
constexpr double beside = 1e-9, beside_rounding = 100, beside_at_most = 0.05;

/// Bisects for the place in (a, b) where the predicate stops having the value it has at a.
template <class Predicate>
double change_of(Predicate holds, double a, double b) {
    const bool at_a = holds(a);
    for (int k = 0; k < 100; ++k) {
        const double m = 0.5 * (a + b);
        if (m <= a || m >= b) break;
        (holds(m) == at_a ? a : b) = m;
    }
    return 0.5 * (a + b);
}

/// Values ascending, with those within `same` of each other reduced to one.
void sort_and_merge(std::vector<double>& values, double same) {
    std::sort(values.begin(), values.end());
    std::vector<double> kept;
    for (const double v : values)
        if (kept.empty() || v - kept.back() > same) kept.push_back(v);
    values = kept;
}

/// The normals of an edge: within an angle of that at its middle.
struct NormalCone {
    Vec2 middle;
    double half;
};
std::optional<NormalCone> normal_cone(const Curve& curve) {
    if (std::holds_alternative<Segment>(curve)) return NormalCone{outward_normal(curve, 0.5), 0};
    if (const auto* arc = std::get_if<Arc>(&curve)) return NormalCone{outward_normal(curve, 0.5), 0.5 * std::abs(arc->sweep)};
    return std::nullopt;
}

/// The stretches of one pair of edges, found step by step: events, then breaks, then intervals whose middle is valid.
class StretchSearch {
public:
    StretchSearch(const FacingModel& model, int edge1, int edge2)
        : model_(model),
          edge1_(edge1),
          edge2_(edge2),
          curve1_(curve_of(model.part1, edge1)),
          curve2_(curve_of(model.part2, edge2)),
          length1_(length(curve1_)),
          length2_(length(curve2_)) {}

    std::vector<FacingStretch> run() const {
        std::vector<FacingStretch> found;
        if (never_opposed()) return found;
        const std::vector<double> all = breaks();
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            if (!valid(0.5 * (all[i] + all[i + 1]))) continue;
            add_visible(all[i], all[i + 1], found);
        }
        return found;
    }

private:
    std::optional<EdgePair> pair(double s1) const { return pair_on_edges(model_, edge1_, edge2_, s1); }

    /// Most pairs of a large part end here.
    bool never_opposed() const {
        constexpr double rounding = 1e-6;  // radians
        const auto cone1 = normal_cone(curve1_), cone2 = normal_cone(curve2_);
        if (!cone1 || !cone2) return false;
        const double off = std::acos(std::clamp(-cone1->middle.dot(cone2->middle), -1.0, 1.0));
        return off - cone1->half - cone2->half > std::acos(least_opposition) + rounding;
    }

    bool opposed(double s1) const {
        const auto p = pair(s1);
        return p && p->opposition >= least_opposition;
    }
    bool valid(double s1) const {
        const auto p = pair(s1);
        return p && p->opposition >= least_opposition && std::abs(p->gap) <= model_.distance && p->s2 >= -model_.same &&
               p->s2 <= length2_ + model_.same;
    }
    bool above(double s1, double level) const {
        const auto p = pair(s1);
        return p && p->gap > level;
    }

    /// Ends of edge 1, images of the ends of edge 2, extrema of the gap.
    std::vector<double> events() const {
        std::vector<double> all{0, length1_};
        const auto add = [&](double t) {
            const double s = t * length1_;
            if (s > model_.same && s < length1_ - model_.same) all.push_back(s);
        };
        for (const double end : {0.0, 1.0}) {
            const auto ball = tangent_ball(curve1_, point(curve2_, end), outward_normal(curve2_, end));
            if (ball) add(ball->t);
        }
        for (const double t : parallel_points(curve1_, curve2_)) add(t);
        sort_and_merge(all, model_.same);
        all.back() = length1_;
        return all;
    }

    /// Events, and where the angle or the distance reaches its limit.
    std::vector<double> breaks() const {
        std::vector<double> all = events();
        const std::size_t n = all.size();
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const double a = all[i], b = all[i + 1];
            for (int j = 0; j < samples_per_interval; ++j) add_limits(sample(a, b, j), sample(a, b, j + 1), all);
        }
        sort_and_merge(all, model_.same);
        all.back() = length1_;
        return all;
    }

    double inset(double width) const {
        return std::min(std::max(beside * width, beside_rounding * model_.same), beside_at_most * width);
    }
    double sample(double a, double b, int j) const {
        if (j == 0) return a + inset(b - a);
        if (j == samples_per_interval) return b - inset(b - a);
        return a + (b - a) * j / samples_per_interval;
    }

    void add_limits(double a, double b, std::vector<double>& all) const {
        const bool opposed_a = opposed(a), opposed_b = opposed(b);
        if (opposed_a != opposed_b) {
            const double s = change_of([&](double m) { return opposed(m); }, a, b);
            all.push_back(s);
            (opposed_a ? b : a) = s + (opposed_a ? -beside : beside) * (b - a);
        } else if (!opposed_a) {
            return;
        }
        for (const double level : {model_.distance, -model_.distance})
            if (above(a, level) != above(b, level)) all.push_back(change_of([&](double m) { return above(m, level); }, a, b));
    }

    /// Does no edge of either part cross the open line between the points? Together with the opposed normals this means that
    /// the line runs outside both bodies (gap positive) or inside both (negative).
    bool in_sight(double s1) const {
        const auto p = pair(s1);
        if (!p) return false;
        if (std::abs(p->gap) <= model_.thin) return true;
        constexpr double off_the_ends = 1e-3;  // far above rounding even for the thinnest gap that is looked into
        const Vec2 inset = off_the_ends * (p->x2 - p->x1);
        const Segment line{p->x1 + inset, p->x2 - inset};
        return !crosses(model_.part1, model_.tree1, line) && !crosses(model_.part2, model_.tree2, line);
    }
    bool crosses(const Part& part, const EdgeTree& tree, const Segment& line) const {
        for (const int e : tree.near(bounding_box(Curve(line)), 0))
            if (!meeting_points(Curve(line), curve_of(part, e), model_.same).empty()) return true;
        return false;
    }

    void add_visible(double a, double b, std::vector<FacingStretch>& found) const {
        std::vector<double> cuts{a};
        double before = sample(a, b, 0);
        bool seen = in_sight(before);
        for (int j = 1; j <= samples_per_interval; ++j) {
            const double next = sample(a, b, j);
            const bool now = in_sight(next);
            if (now != seen) cuts.push_back(change_of([&](double s) { return in_sight(s); }, before, next));
            before = next;
            seen = now;
        }
        cuts.push_back(b);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (in_sight(0.5 * (cuts[i] + cuts[i + 1]))) add_stretch(cuts[i], cuts[i + 1], found);
    }

    void add_stretch(double a, double b, std::vector<FacingStretch>& found) const {
        const auto begin = pair(a), middle = pair(0.5 * (a + b)), end = pair(b);
        if (!begin || !middle || !end) return;
        FacingStretch stretch{edge1_, edge2_, *begin, *end};
        put_on_the_right_turn(stretch, middle->s2);
        stretch.begin.s2 = snapped(stretch.begin.s2);
        stretch.end.s2 = snapped(stretch.end.s2);
        found.push_back(stretch);
    }

    /// The seam of a full circle may come out as either of its ends; s2 falls along the stretch.
    void put_on_the_right_turn(FacingStretch& stretch, double middle) const {
        const auto* arc = std::get_if<Arc>(&curve2_);
        if (!arc) return;
        const double turn = 2 * std::numbers::pi * arc->radius;
        if (stretch.begin.s2 < middle) stretch.begin.s2 += turn;
        if (stretch.end.s2 > middle) stretch.end.s2 -= turn;
    }

    /// Ends of edge 2 exactly, where only rounding is missing.
    double snapped(double s2) const {
        if (std::abs(s2) <= 4 * model_.same) return 0;
        return std::abs(s2 - length2_) <= 4 * model_.same ? length2_ : s2;
    }

    const FacingModel& model_;
    int edge1_, edge2_;
    const Curve &curve1_, &curve2_;
    double length1_, length2_;
};

}  // namespace

FacingModel::FacingModel(const Part& first, const Part& second, double search_distance)
    : part1(first),
      part2(second),
      tree1(first),
      tree2(second),
      distance(search_distance),
      size(bounding_box(first).diagonal() + bounding_box(second).diagonal()),
      same(same_fraction * size),
      thin(thin_fraction * size) {}

std::optional<EdgePair> pair_on_edges(const FacingModel& model, int edge1, int edge2, double s1) {
    const Curve &curve1 = curve_of(model.part1, edge1), &curve2 = curve_of(model.part2, edge2);
    const double t1 = s1 / length(curve1);
    const Vec2 x1 = point(curve1, t1), n1 = outward_normal(curve1, t1);
    const auto ball = tangent_ball(curve2, x1, n1);
    if (!ball || n1.dot(ball->n) >= 0) return std::nullopt;
    if (1 + ball->radius * curvature(curve1, t1) < least_spread) return std::nullopt;
    if (1 + ball->radius * curvature(curve2, ball->t) < least_spread) return std::nullopt;
    const double gap = ball->radius * (n1 - ball->n).norm() + 0.0;  // + 0: no negative zero in what users see
    return EdgePair{s1, ball->t * length(curve2), x1, ball->x, gap, -n1.dot(ball->n)};
}

std::vector<FacingStretch> facing_stretches(const FacingModel& model, int edge1, int edge2) {
    return StretchSearch(model, edge1, edge2).run();
}

}  // namespace abut::geometry
