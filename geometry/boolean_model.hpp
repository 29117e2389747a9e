// SPDX-License-Identifier: GPL-3.0-or-later
// The exact boundaries of primitives, piece by piece, for Booleans (boolean.cpp). Includes CGAL, as boolean_kernel.hpp does.
#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/boolean.hpp"
#include "geometry/boolean_kernel.hpp"
#include "geometry/carriers.hpp"

namespace abut::geometry::exact {

/// What one exact line or arc is of its source: all of it, or of an ellipse or spline the portion that one arc follows.
struct SourcePortion {
    int source = -1;
    double t0 = 0, t1 = 1;
    int turn = 0;    ///< in the source's own direction: 0 line, +1 or -1 arc
    Vec2 way{0, 0};  ///< lines: the source's own direction
};

/// A primitive's edge as its boundary runs through it, with its exact line or circle, or its run of a carrier's arcs.
struct ExactEdge {
    int portion = -1;   ///< its number; for a run of arcs that of the source's first arc
    Curve curve;        ///< rounded, placed, along the boundary
    int turn = 0;       ///< 0 line, +1 or -1 arc
    Rational from, to;  ///< lines: their ends
    Rational center;    ///< arcs
    Number radius;
    const CarrierRun* run = nullptr;  ///< ellipses and splines
    bool along = true;                ///< of their source
};

/// A carrier's arcs between rational points. An end that meets a line or circle is that one's exact end.
struct ExactCarrier {
    std::vector<Rational> points, middles;
    std::vector<bool> is_joined;  ///< by point
};

/// Where one edge ends and the next begins: one point, or two with a bridge between them.
struct Joint {
    OneRoot end, begin;
    std::optional<std::pair<Rational, Rational>> bridge;
};

/// The exact boundaries of all primitives, which (like the carriers) must outlive it. Neighbours of a loop share an exact point
/// or are joined by a bridge, as boolean.hpp tells.
class ExactModel {
public:
    ExactModel(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources, const Carriers& carriers);

    /// By the number that a monotone curve carries, unless that is bridge_source or far_source. The turns of a carrier's arcs
    /// are known once `boundary` has been asked for a loop that runs along them.
    std::vector<SourcePortion> portions;

    /// The loop in its own direction, head to tail.
    std::vector<MonotoneCurve> boundary(std::size_t primitive, std::size_t loop);

    /// A polygon that holds the half plane's share of the disc: its line, and three far edges.
    std::vector<MonotoneCurve> half_plane(std::size_t primitive, const HalfPlane& half, const Reach& reach) const;

private:
    void number_portions(const Curve& curve, int source);
    void add_primitive(const Primitive& primitive, int first_source);
    /// The i-th point of a run, in the boundary's direction, as an index into its carrier's points.
    std::size_t point_index(const ExactEdge& edge, int i) const;
    ExactCarrier& carrier_of(const ExactEdge& edge);
    /// The exact end or begin of any edge that meets a run of arcs.
    Rational exact_end(const ExactEdge& edge, bool at_end);
    /// Moves a run's end to p, unless it has been joined to something else.
    void move_end(const ExactEdge& edge, bool at_end, const Rational& p);
    /// Gives neighbours the same exact end where one of them is a run of arcs. A line whose neighbour was joined to another
    /// primitive's edge (equal but for rounding) gives way; a circle cannot, and gets a bridge.
    void join_carriers(std::vector<ExactEdge>& edges);
    Joint joint_of(const ExactEdge& a, const ExactEdge& b, double size);
    void add_closed(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces);
    void add_arcs(const ExactEdge& edge, std::vector<MonotoneCurve>& pieces);

    const std::vector<Primitive>& primitives_;
    const Carriers& carriers_;
    std::vector<ExactCarrier> exact_carriers_;
    std::vector<ExactMap> maps_;
    std::vector<int> first_portion_;               ///< by source
    std::vector<int> first_portion_of_primitive_;  ///< by primitive
    std::vector<std::vector<std::vector<ExactEdge>>> loops_;
};

}  // namespace abut::geometry::exact
