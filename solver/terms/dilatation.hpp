// SPDX-License-Identifier: GPL-3.0-or-later
// Nearly incompressible parts: the volume strain projected onto splines of one degree less, each direction, and of one order
// less smooth (B-bar with a global projection [Elguedj08], the same as a displacement-pressure method whose pressures are
// eliminated). In the standard form lambda keeps every point's volume strain small, which splines have too few fields for: it
// locks.
//
// Legend: u displacement coefficients (2n), N and q functions of displacement and pressure, lambda and mu Lame's moduli, d and
// v a support's direction and value (d.u = v), n the normal.
//
//   K = A + lambda B' M^-1 B,   load + lambda B' M^-1 g,   p = lambda M^-1 (B u - g)
//   A: 2 mu eps and all that Nitsche's method adds for it;   M = int q q'
//   B u = int q div u - sum over Nitsche's supports int q (d.n) (d.u),   g = - sum int q (d.n) v + int q 3 e  (e the free
//   strain) stress = 2 mu eps(u) + p I
//
// K is symmetric positive definite wherever A is, whatever B is; but full, so it is never made: [A B'; B -M / lambda] is
// factorised (Factorization's Schur complement), products go through M's own factor. Boundary terms of p belong to the
// projection: gamma then need not grow with lambda, and the traction is that of the pressure that the part feels.
// The pressure's space has the same elements, branches and extension as the displacement's, so that cuts do not matter.
//
// Measured on the quarter of a thick ring, cells of a tenth, nu = 0.4999 (before the arrow: 0.3, standard form in brackets).
//   degree   displacement, L2              largest stress                 condition
//   1        2.3e-3 -> 2.3e-3 (1.7e-1)     7.2e-2 -> 3.3e-2 (31)          1.3e7 (6.0e6)
//   2        2.0e-5 -> 2.4e-5 (3.7e-3)     2.9e-3 -> 1.4e-3 (6.1)         1.0e7 (8.0e6)
//   3        1.1e-6 -> 1.3e-6 (3.1e-5)     2.6e-4 -> 2.7e-4 (0.33)        1.8e7 (6.4e6)
//   4        7.6e-8 -> 9.3e-8 (1.9e-6)     2.7e-5 -> 2.2e-5 (0.023)       1.3e8 (1.3e7)
// Time of assembly and factor over the standard form's, 2e3 and 2e4 unknowns: degree 1 1.6 and 1.4, 2 3.3 and 2.4, 3 3.5 and
// 2.9, 4 3.8 and 3.4; the factor has 1.1 to 2.1 times the entries.
// Rejected: projections onto polynomials that are discontinuous over macros of m x m cells [Antolin17], which leave K sparse:
// on a square of 12 x 12 cells they did not lock for degree 2 and m = 2, but made the displacements of a field of varying
// pressure 6 times worse (m = 3: 200 times); for degree 3 and m = 2 stresses still grew 4 to 25 times, for m = 1 all locked.
#pragma once
#include <Eigen/SparseCore>
#include <memory>
#include <string>

#include "solver/assembly/assembly.hpp"
#include "solver/linear_algebra/factorization.hpp"
#include "solver/terms/supports.hpp"

namespace abut::solver {

/// The projection of one part with its supports. The pressure p = modulus M^-1 (B u - g) belongs to a displacement u: a spline
/// of `space`.
struct Dilatation {
    SplineSpace space;                       ///< of degree one less in both directions, on the same elements
    double modulus = 0;                      ///< lambda
    Eigen::SparseMatrix<double> divergence;  ///< B, (pressure functions x 2n)
    Eigen::VectorXd prescribed;              ///< g
    SparseSymmetric mass;                    ///< M
    Factorization mass_factor;
    std::string failure;  ///< not empty: no such space, and why
};

/// Makes B, M and g of a part and the supports that Nitsche's method imposes.
std::shared_ptr<const Dilatation> make_dilatation(const PartInput& input, const std::vector<const SupportSet*>& by_nitsche);

/// The projection that a part's system was made with; std::logic_error before that (a bug of the caller).
const Dilatation& dilatation_of(const PartInput& input);

/// The coefficients of the pressure p that belongs to a displacement (2n).
Eigen::VectorXd pressure(const Dilatation& d, const Eigen::VectorXd& displacement);

/// What the projection adds to the product K u: modulus B' M^-1 B u (2n).
Eigen::VectorXd volume_forces(const Dilatation& d, const Eigen::VectorXd& displacement);
/// What the projection adds to the load: modulus B' M^-1 g (2n).
Eigen::VectorXd volume_load(const Dilatation& d);
/// What the projection adds to the strain energy: p'M p / (2 modulus).
double volume_energy(const Dilatation& d, const Eigen::VectorXd& displacement);

/// The factorised matrix [A B'; B -M / modulus], with A and number as restricted() has them.
SparseSymmetric with_pressures(const SparseSymmetric& a, const Dilatation& d, const std::vector<int>& number);

}  // namespace abut::solver
