// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement fields with their stresses and body forces, in closed form.
#pragma once
#include <functional>
#include <vector>

#include "geometry/curves/vec2.hpp"
#include "solver/assembly/elasticity.hpp"

namespace abut::test {

using geometry::Vec2;
using solver::Elasticity;

/// Stress: (xx, yy, xy).
struct ExactField {
    std::function<Vec2(const Vec2&)> displacement;
    std::function<Eigen::Vector3d(const Vec2&)> stress;
    std::function<Vec2(const Vec2&)> body_force;  ///< per volume; empty: none
};

/// E1: constant strain.
ExactField constant_strain(const Elasticity& d, double exx, double eyy, double gxy);

/// E6: a bar of that length hanging under its own weight, 1 per volume; E and nu in plane stress.
ExactField hanging_bar(double E, double nu, double length);

/// amplitude * sin(wave . x + phase)
struct PlaneWave {
    Vec2 amplitude, wave;
    double phase;
};
ExactField plane_waves(const Elasticity& d, const std::vector<PlaneWave>& waves);
/// (sin(kx x) cos(ky y), a cos(kx x) sin(ky y)): u_x vanishes on x = 0, u_y on y = 0.
ExactField symmetric_waves(const Elasticity& d, const Vec2& k, double a);

/// E3: hole of radius 1 about the origin, unit tension along x far away [Timoshenko70, art. 35].
ExactField kirsch(const Elasticity& d);

/// E4: ring with a pressure on its inner circle, about the origin.
struct Ring {
    double inner, outer, pressure;
};
ExactField lame(const Elasticity& d, const Ring& ring);

/// E9: first symmetric mode of a re-entrant right angle at the origin whose bisector points along (1, 1) [Szabo91, 4.2].
inline constexpr double corner_exponent = 0.544483736782464;
ExactField corner_mode(const Elasticity& d);

}  // namespace abut::test
