// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/section_plane.hpp"

#include <algorithm>

#include "geometry/brep/message_text.hpp"

namespace abut::geometry {

namespace {

bool runs_along(const std::vector<HeightRange>& faces, double at, double band) {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const HeightRange& face) { return face.high >= at - band && face.low <= at + band; });
}

std::ptrdiff_t n_met(const std::vector<HeightRange>& bodies, double at) {
    return std::count_if(bodies.begin(), bodies.end(),
                         [&](const HeightRange& body) { return body.low < at && body.high >= at; });
}

}  // namespace

void Box3::add(const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
}

void Box3::add(const Box3& box) {
    low = low.cwiseMin(box.low);
    high = high.cwiseMax(box.high);
}

SectionPlane plane_of(const SectionChoice& choice, const Box3& box, const WallAxes& along_walls) {
    const Vec3 size = box.size();
    if (!size.allFinite() || !box.low.allFinite()) return {choice.axis < 0 ? 2 : choice.axis, choice.at.value_or(0)};
    int axis = choice.axis;
    const bool any_walls = along_walls[0] || along_walls[1] || along_walls[2];
    const double rounding = face_band_fraction * size.norm();
    for (int other : {2, 1, 0}) {
        if (choice.axis >= 0 || (any_walls && !along_walls[static_cast<std::size_t>(other)])) continue;
        if (axis < 0 || size[other] < size[axis] - rounding) axis = other;
    }
    return {axis, choice.at.value_or(0.5 * (box.low[axis] + box.high[axis]))};
}

SectionPlane off_faces(const std::vector<HeightRange>& faces, const std::vector<HeightRange>& bodies, const SectionPlane& plane,
                       double size) {
    const double band = face_band_fraction * size;
    if (!runs_along(faces, plane.at, band)) return plane;
    SectionPlane best = plane;
    std::ptrdiff_t most = 0;
    for (int k = 1; k <= most_nudges && most == 0; ++k)
        for (double sign : {1.0, -1.0}) {
            const SectionPlane moved{plane.axis, plane.at + sign * k * nudge_fraction * size};
            if (runs_along(faces, moved.at, band)) continue;
            const std::ptrdiff_t n = n_met(bodies, moved.at);
            if (n > most) best = moved, most = n;
        }
    return best;
}

Vec2 in_plane(const Vec3& point, int axis) {
    if (axis == 0) return {point.y(), point.z()};
    if (axis == 1) return {point.x(), point.z()};
    return {point.x(), point.y()};
}

std::string text_of(const SectionPlane& plane) {
    return std::string(1, "xyz"[plane.axis]) + " = " + number_text(plane.at);
}

}  // namespace abut::geometry
