// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/contour_area.hpp"

#include "geometry/curves/curve_moments.hpp"

namespace abut::geometry {

double area_share(const Part& part, const ContourPiece& c, double x0, double x1) {
    if (c.edge < 0) return (x1 - x0) * (c.t1 - c.t0);
    const Curve& curve = part.edges[static_cast<std::size_t>(c.edge)].curve;
    const Vec2 a = point(curve, c.t0), b = point(curve, c.t1);
    const double share = (0.5 * (a.x() + b.x()) - x0) * (b.y() - a.y());
    return std::holds_alternative<Segment>(curve) ? share : share + bulge(curve, c.t0, c.t1, a).area;
}

}  // namespace abut::geometry
