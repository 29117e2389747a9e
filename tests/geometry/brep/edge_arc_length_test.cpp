// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/curves/spline_shape.hpp"

namespace edge_arc_length_test {

namespace {

using namespace abut::geometry;
constexpr double pi = std::numbers::pi;

/// Whatever portion of a drawn curve an edge is, and whichever way it runs: the drawn curve's point at the arc length told is
/// the edge's own.
TEST(EdgeArcLength, LeadsToThePointOfTheDrawnCurve) {
    const std::vector<Curve> drawn{Segment{{0, 0}, {3, 4}}, Arc{{1, 2}, 1.5, 0.3, -4},
                                   EllipticArc{{0, 0}, {2, 1}, {-0.25, 0.5}, 0.2, 2 * pi},
                                   bezier_curve({{0, 0}, {1, 2}, {2, -1.5}, {3, 1}}, {})};
    for (const Curve& source : drawn)
        for (const auto& [t0, t1] : {std::pair(0.0, 1.0), std::pair(0.0, 0.4), std::pair(0.25, 0.8)})
            for (const bool along : {true, false}) {
                Edge edge{trimmed(source, t0, t1), "piece#0", "drawn"};
                if (!along) edge.curve = reversed(edge.curve);
                edge.along_source = along;
                edge.source_begin = length(source, 0, t0);
                for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0}) {
                    const double along_drawn = edge.source_begin + edge_arc_length(edge, t);
                    const Vec2 at = point(source, parameter_at_length(source, along_drawn));
                    EXPECT_LE((at - point(edge.curve, t)).norm(), 2e-14);
                }
            }
}

}  // namespace

}  // namespace edge_arc_length_test
