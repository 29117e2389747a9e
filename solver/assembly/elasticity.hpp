// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic linear elasticity in the plane, small displacements.
#pragma once
#include <Eigen/Core>

namespace abut::solver {

/// sigma = D epsilon with engineering shear strain: xx = d11 exx + d12 eyy, yy = d12 exx + d11 eyy, xy = d33 gxy,
/// zz = out_of_plane (xx + yy). With a free strain e: less expansion e in xx and yy, and zz = out_of_plane (xx + yy) -
/// expansion_zz e. Around an axis x is the radius, zz the hoop direction, and zz follows from its own strain.
struct Elasticity {
    double d11 = 0, d12 = 0, d33 = 0;
    double out_of_plane = 0;  ///< nu in plane strain, 0 in plane stress
    /// What a free strain e (thermal expansion, the same in all directions) takes off xx and yy, and further off zz.
    double expansion = 0, expansion_zz = 0;
};

/// The elasticity of a modulus E (force per area) and a Poisson's ratio, without stress out of the plane (nu < 1) or without
/// strain out of it (nu < 1/2).
inline Elasticity plane_stress(double E, double nu) {
    return {E / (1 - nu * nu), nu * E / (1 - nu * nu), E / (2 * (1 + nu)), 0, E / (1 - nu), 0};
}

inline Elasticity plane_strain(double E, double nu) {
    const double c = E / ((1 + nu) * (1 - 2 * nu));
    return {c * (1 - nu), c * nu, E / (2 * (1 + nu)), nu, E / (1 - 2 * nu), E};
}

/// The elasticity without lambda: stress 2 mu epsilon.
inline Elasticity without_volume(const Elasticity& d) {
    return {2 * d.d33, 0, d.d33, d.out_of_plane, 2 * d.d33, d.expansion_zz};
}

/// The stress (xx, yy, xy) of a displacement gradient (rows: u_x, u_y; columns: d/dx, d/dy).
inline Eigen::Vector3d stress_of(const Elasticity& d, const Eigen::Matrix2d& gradient) {
    const double exx = gradient(0, 0), eyy = gradient(1, 1), gxy = gradient(0, 1) + gradient(1, 0);
    return {d.d11 * exx + d.d12 * eyy, d.d12 * exx + d.d11 * eyy, d.d33 * gxy};
}

}  // namespace abut::solver
