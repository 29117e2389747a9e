// SPDX-License-Identifier: GPL-3.0-or-later
// Where solid bodies are cut, whatever they are made of.
#pragma once
#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geometry/curves/vec2.hpp"

namespace abut::geometry {

using Vec3 = Eigen::Vector3d;

/// The plane coordinate `axis` (0 x, 1 y, 2 z) = at. In it z gives (x, y), x gives (y, z), y gives (x, z).
struct SectionPlane {
    int axis = 2;
    double at = 0;
};

/// A face whose points are all closer to the plane than this fraction of the diagonal of all bodies lies in it.
inline constexpr double face_band_fraction = 1e-6;
/// One step off such faces, as a fraction of the diagonal of all bodies; steps are tried on both sides in turn.
inline constexpr double nudge_fraction = 1e-5;
inline constexpr int most_nudges = 64;

/// A box in space; empty as it is made.
struct Box3 {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
    Vec3 size() const { return (high - low).cwiseMax(0); }
    void add(const Vec3& point);
    void add(const Box3& box);
};

/// What is asked for: an axis (-1: of the directions along which all walls run the thinnest, without any such direction the
/// thinnest of all; of directions equally thin z, else y), and a place along it (unset: the middle).
struct SectionChoice {
    int axis = -1;
    std::optional<double> at;
};

/// Do all walls run along an axis (x, y, z)? An extrusion along it has that section anywhere.
using WallAxes = std::array<bool, 3>;

/// The plane of a choice, where all bodies together lie in `box`.
SectionPlane plane_of(const SectionChoice& choice, const Box3& box, const WallAxes& along_walls = {});

/// Heights above the plane's coordinate 0: of a face that is parallel to it, of a body.
struct HeightRange {
    double low, high;
};

/// The nearest plane off all faces; of the two sides that which meets more bodies, else the upper one. size: the diagonal of
/// all bodies.
SectionPlane off_faces(const std::vector<HeightRange>& faces, const std::vector<HeightRange>& bodies, const SectionPlane& plane,
                       double size);

/// The point in the plane's two coordinates.
Vec2 in_plane(const Vec3& point, int axis);

/// "z = 5".
std::string text_of(const SectionPlane& plane);

}  // namespace abut::geometry
