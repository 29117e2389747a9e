// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness of a part around an axis.
#pragma once
#include "solver/assembly/assembly.hpp"

namespace abut::solver {

/// What the hoop strain adds to the integrals of one element, weights with the radius r: N N' / r^2, gx N' / r, gy N' / r.
struct HoopIntegrals {
    Eigen::MatrixXd nn, xn, yn;
};

/// assemble_stiffness of a part with an axis (which calls this): strains u_x,x, u_y,y, u_x / r and the shear, of the local
/// elasticity. Full cells by products of one-variable integrals with the weights r, 1 and 1 / r along x, cut cells by their
/// rules. Functions that do not vanish on the axis have no finite integral of N N' / r there; theirs mean nothing, and they are
/// dropped (hold_axis.hpp).
///
/// Accuracy of the quadrature: N N' r is a polynomial of degree 2p + 1, which p + 1 Gauss points integrate exactly. 1 / r is
/// smooth in all cells but the first at the axis, where what is left of N N' / r is a polynomial. Linear displacements pass
/// whatever the rule is: N u / r is a polynomial then, too.
BlockMatrix assemble_ring_stiffness(const PartInput& input);

}  // namespace abut::solver
