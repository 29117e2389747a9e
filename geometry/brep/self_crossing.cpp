// SPDX-License-Identifier: GPL-3.0-or-later
// A piece monotone in x and in y cannot meet itself, nor can two successive ones meet again as long as the curve does not turn
// back in both coordinates at once (a cusp): along both together one coordinate is monotone. All other pairs of pieces are
// tried as two curves.
#include "geometry/brep/self_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/curves/curve_meetings.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

/// Meetings nearer than this many tolerances along the curve are one point of it.
constexpr double same_place = 8;
/// Points of a crossing found by Newton iterations differ by less than this fraction of the curve's size.
constexpr double polished_fraction = 1e-13;
/// Curves whose tangents differ by a smaller sine touch.
constexpr double crossing_sine = 1e-6;

struct MonotonePortion {
    Curve curve;
    double t0 = 0, t1 = 0;
    Vec2 chord() const { return point(curve, 1) - point(curve, 0); }
    double parameter(const Vec2& p) const { return t0 + closest_parameter(curve, p) * (t1 - t0); }
};

/// Portions shorter than the tolerance go with the next one: at a cusp, where both coordinates turn back, rounding makes such.
std::vector<MonotonePortion> portions(const Curve& curve, double tolerance) {
    std::vector<double> cuts = axis_extrema(curve);
    std::erase_if(cuts, [&](double t) { return length(curve, t, 1) <= tolerance; });
    cuts.push_back(1);
    std::vector<MonotonePortion> found;
    double t = 0;
    for (const double next : cuts) {
        if (length(curve, t, next) <= tolerance) continue;
        found.push_back({trimmed(curve, t, next), t, next});
        t = next;
    }
    return found;
}

bool turns_back(const MonotonePortion& first, const MonotonePortion& second) {
    const Vec2 u = first.chord(), v = second.chord();
    return u.x() * v.x() <= 0 && u.y() * v.y() <= 0;
}

/// Tells meetings from what is one place of the curve.
class Meetings {
public:
    Meetings(const Curve& curve, double tolerance)
        : curve_(curve),
          tolerance_(tolerance),
          size_(bounding_box(curve).diagonal()),
          length_(length(curve)),
          is_closed_((point(curve, 1) - point(curve, 0)).norm() <= tolerance) {}

    /// The first along `first`.
    std::optional<SelfMeeting> of(const MonotonePortion& first, const MonotonePortion& second) const {
        std::optional<SelfMeeting> best;
        for (const Vec2& p : meeting_points(first.curve, second.curve, tolerance_)) {
            const double t0 = first.parameter(p), t1 = second.parameter(p);
            if (!is_meeting(t0, t1) || (best && best->t0 <= t0)) continue;
            const double sine = cross(unit_tangent(curve_, t0), unit_tangent(curve_, t1));
            best = SelfMeeting{t0, t1, p, std::abs(sine) > crossing_sine};
        }
        return best;
    }

private:
    /// Next to a cusp both branches stay within the tolerance for a while, as tangent curves do; a small loop has one point
    /// where they come together exactly.
    bool is_meeting(double t0, double t1) const {
        const double way = way_between(t0, t1), tangent_reach = std::sqrt(8 * tolerance_ * size_);
        if (way > tangent_reach) return true;
        return way > same_place * tolerance_ && (point(curve_, t0) - point(curve_, t1)).norm() <= polished_fraction * size_;
    }
    /// Arc length between two points of the curve, the shorter way round where it is closed.
    double way_between(double t0, double t1) const {
        const double inside = length(curve_, t0, t1);
        return is_closed_ ? std::min(inside, length_ - inside) : inside;
    }

    const Curve& curve_;
    double tolerance_, size_, length_;
    bool is_closed_;
};

}  // namespace

std::optional<SelfMeeting> self_meeting(const Curve& curve, double tolerance) {
    ENSURE(tolerance >= 0, "points of a curve are one up to a distance");
    std::optional<SelfMeeting> best;
    if (!std::holds_alternative<Spline>(curve)) return best;
    const std::vector<MonotonePortion> pieces = portions(curve, tolerance);
    std::vector<Box2> boxes;
    for (const MonotonePortion& piece : pieces) boxes.push_back(bounding_box(piece.curve));
    const EdgeTree tree(boxes);
    const Meetings meetings(curve, tolerance);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (const int found : tree.near(boxes[i], tolerance)) {
            const auto j = static_cast<std::size_t>(found);
            if (j <= i || (j == i + 1 && !turns_back(pieces[i], pieces[j]))) continue;
            const auto meeting = meetings.of(pieces[i], pieces[j]);
            if (meeting && (!best || meeting->t0 < best->t0)) best = meeting;
        }
        if (best) break;  // later pieces meet others later along the curve only
    }
    return best;
}

}  // namespace abut::geometry
