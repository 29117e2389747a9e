// SPDX-License-Identifier: GPL-3.0-or-later
// The sign of fields that know their distance to the edges.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "geometry/brep/monotone.hpp"
#include "geometry/implicit/curve_distance.hpp"
#include "geometry/implicit/r_functions.hpp"

namespace abut::geometry {

/// The boundary for point-in-part, and the distance within which a point counts as on it (on_edge_fraction, implicit.hpp).
struct BoundarySide {
    SlabbedPieces pieces;
    double on_edge = 0;
};
BoundarySide boundary_side(const Part& part);

/// The fields of several edges as one: their equivalence (r_functions.hpp), sided as the nearest of them.
template <class T>
NearCurve<T> joined(const std::vector<NearCurve<T>>& near, int m) {
    std::vector<T> w;
    w.reserve(near.size());
    for (const NearCurve<T>& each : near) w.push_back(each.w);
    const std::span<const T> all(w);
    return {equivalence(all, m), near[nearest_to_zero(all)].sided};
}

/// The field's size, positive everywhere; within `on_edge` of an edge the material's side goes on smoothly, so that the
/// derivatives are its.
inline double without_side(const NearCurve<double>& near, double) {
    return near.w < 0 ? -near.w : near.w;
}
inline Jet without_side(const NearCurve<Jet>& near, double on_edge) {
    if (!(near.w.v < 0)) return near.w;
    if (near.w.v < -on_edge) return -near.w;
    Jet w = near.w;
    w.v = -w.v;
    return w;
}

/// The field with a sign, positive inside, negative outside; within `on_edge` of an edge its own side decides.
inline double with_side(const NearCurve<double>& near, double on_edge, bool inside) {
    if (near.sided && std::abs(near.w) <= on_edge) return near.w;
    return inside == (near.w > 0) ? near.w : -near.w;
}
inline Jet with_side(const NearCurve<Jet>& near, double on_edge, bool inside) {
    if (near.sided && std::abs(near.w.v) <= on_edge) return near.w;
    return inside == (near.w.v > 0) ? near.w : -near.w;
}

/// The place of a point, without derivatives.
inline Vec2 position(const PointOf<double>& p) {
    return {p.x, p.y};
}
inline Vec2 position(const PointOf<Jet>& p) {
    return {p.x.v, p.y.v};
}

}  // namespace abut::geometry
