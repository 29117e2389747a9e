// SPDX-License-Identifier: GPL-3.0-or-later
// How well the numbers of a tree are known.
#include <algorithm>

#include "geometry/csg/csg.hpp"
#include "geometry/curves/written_digits.hpp"

namespace abut::geometry {

namespace {

/// What rounding has moved each shape's outline by.
struct WrittenRounding {
    double size;

    double points(const std::vector<Vec2>& all) const { return geometry::written_rounding(all, size); }
    double lengths(const std::vector<double>& all) const { return geometry::written_rounding(all, size); }

    double operator()(const Rectangle& r) const { return points({r.min, r.max}); }
    double operator()(const Circle& c) const { return points({c.center}) + lengths({c.radius}); }
    double operator()(const Ellipse& e) const { return points({e.center}) + lengths({e.radii.x(), e.radii.y()}); }
    double operator()(const Slot& s) const { return points({s.from, s.to}) + lengths({s.radius}); }
    double operator()(const Polygon& p) const { return points(p.points); }
    double operator()(const HalfPlane& h) const { return points({h.point}); }
    double operator()(const Imported& i) const { return i.rounding; }
    double operator()(const Loops& l) const {
        std::vector<Vec2> ends;
        for (const std::vector<LoopEdge>& loop : l.loops)
            for (const LoopEdge& edge : loop)
                if (std::holds_alternative<Segment>(edge.curve))
                    for (const double t : {0.0, 1.0}) ends.push_back(point(edge.curve, t));
        return points(ends);
    }
    double operator()(const Placed& p) const {
        return points({p.translate}) + p.scale * WrittenRounding{size / p.scale}.largest(p.of);
    }
    template <class Operation>
    double operator()(const Operation& operation) const {
        return largest(operation.of);
    }

    double largest(const std::vector<CsgNode>& nodes) const {
        double most = 0;
        for (const CsgNode& node : nodes) most = std::max(most, written_rounding(node, size));
        return most;
    }
};

}  // namespace

double written_rounding(const CsgNode& tree, double size) {
    return std::visit(WrittenRounding{size}, tree.shape);
}

}  // namespace abut::geometry
