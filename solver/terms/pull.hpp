// SPDX-License-Identifier: GPL-3.0-or-later
// A part that is shortened across a cut through it, as a bolt is by tightening: the two sides of the cut are drawn together.
//
// The shortening is a displacement that leaves no stress, delta times p, where p draws one side towards the other by a unit:
// stresses are those of u - delta p, so the equilibrium is K u = f + delta K p. A rigid motion of one side against the other
// strains nothing but the cells that the cut goes through, and u - delta p is smooth there, whatever p does on its way from one
// side to the other.
#pragma once
#include "solver/linear_algebra/block_matrix.hpp"

namespace abut::solver {

/// One cut, how far it is shortened, and what a shortening of one does. Vectors are (2n).
struct Pull {
    Eigen::VectorXd displacement;  ///< p: one side is moved by a unit towards the other, which rests
    Eigen::VectorXd load;          ///< K p, of the part's own stiffness
    double stiffness = 0;          ///< p'K p: what the force across the cut would be per shortening if nothing gave way
    double shortening = 0;         ///< delta
};

/// stiffness: of the part alone, no supports in it.
Pull make_pull(const BlockMatrix& stiffness, Eigen::VectorXd displacement);

/// The force across the cut, tension positive, in a part with the displacement u: the work of its stresses in the motion that
/// takes the two sides apart by a unit. free_strain: the load of the part's free strain (free_strain_load), which leaves no
/// stress either; empty: it has none.
double force_across(const Pull& pull, const Eigen::VectorXd& u, const Eigen::VectorXd& free_strain = {});

}  // namespace abut::solver
