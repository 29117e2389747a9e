// SPDX-License-Identifier: GPL-3.0-or-later
// The Euler-Bernoulli beam on weighted B-splines, E I v'''' = p [Grishin10, appendices A and B]: a beam anywhere on a grid that
// need not conform to it. v = w (sum of c_i N_i) + phi, where w vanishes as the held ends demand and phi takes their values.
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "solver/assembly/cell_integrals.hpp"
#include "solver/splines/bspline.hpp"

namespace abut::solver {

/// Knots of the translates of one B-spline [Grishin10, eq A.3] on the cells [k h, (k + 1) h], k = first_cell and on: they go on
/// beyond both ends of the grid. Function i lives on [j, j + degree + 1] h, j = first_cell - degree + i.
KnotVector uniform_knots(double cell_size, int first_cell, int n_cells, int degree);

/// pinned: the deflection is prescribed; clamped: the slope, too.
enum class BeamEnd { free, pinned, clamped };

/// How an end of the beam is held.
struct BeamHold {
    BeamEnd end = BeamEnd::free;
    double deflection = 0, slope = 0;  ///< prescribed; read where the end holds them
};

/// The part of an interval inside the beam counts as none where it is not longer than this many units in the last place of the
/// beam's coordinates: it is the rounding of an end that lies on a grid line.
inline constexpr double grid_line_units = 16;

/// How far a rule may be off 1 / (d + 1), the integral of the highest power t^d that it has to integrate.
inline constexpr double rule_rounding = 1e-12;

/// A beam; units are the caller's, consistent. Deflections, forces and p point the same way.
struct Beam {
    KnotVector
        knots;  ///< degree 2 to 6, inner knots of multiplicity p - 1 at most (slopes are continuous), over the whole beam
    double begin = 0, end = 1;
    double rigidity = 1;              ///< E I
    std::array<BeamHold, 2> holds{};  ///< at begin and end; at least two values held, or nothing resists a rigid motion
    LineRule rule;                    ///< for the piece of each interval inside the beam; exact to 2 (p + values held - 2)
};

/// A force at a point of the beam, and a moment, which works on the slope.
struct BeamPointLoad {
    double x, force = 0, moment = 0;
};
struct BeamLoad {
    std::function<double(double)> per_length{};  ///< p(x); empty: none. Integrated by the beam's rule
    std::vector<BeamPointLoad> points{};
};

/// The factors that the functions are multiplied with. none: 1. corner: those that meet the beam in one cell only, which it
/// does not fill, are divided by their largest value there [Grishin10, eq B.1]. jacobi: the stiffness has a unit diagonal.
/// Measured, 2-norm condition numbers over shifts of 1e-1 to 1e-8 cells, degrees 3 to 5: jacobi within a factor of 2 of the
/// grid that fits; none up to 1e96, corner up to 1e31 (a function's largest value says little of its bending energy). The
/// solution is the same to 1e-12 with all three, since Cholesky's method does not feel the scaling. What no scaling mends is a
/// beam much shorter than its cell: at a twentieth of it 1e9 to 1e15 for degrees 3 to 5; at a whole cell and more, 2e6 for
/// degree 6.
enum class BeamScaling { none, corner, jacobi };

/// Galerkin's equations [Grishin10, eqs A.8 to A.11], in the scaled functions. Dense: n^2 numbers for n functions on the beam.
struct BeamSystem {
    int first_function = 0;     ///< the functions on the beam follow each other
    Eigen::VectorXd scale;      ///< (n) factors of the functions
    Eigen::MatrixXd stiffness;  ///< (n x n)
    Eigen::VectorXd load;       ///< (n), with what the prescribed values add
    std::string failure;        ///< not empty: why there is no such system; nothing else is filled in
};

/// Makes the beam's system with w = (s^a / a!) (t^b / b!), s and t the distances from the beam's ends over its length, a and b
/// the values they hold [Grishin10, eq A.7]; phi the lowest polynomial with the prescribed values. What cannot be made is told
/// in `failure`. Cost: points of the rule x intervals x (p + 1)^2.
BeamSystem assemble_beam(const Beam& beam, const BeamLoad& load, BeamScaling scaling = BeamScaling::jacobi);

/// The deflection as a spline, or why there is none.
struct BeamSolution {
    Eigen::VectorXd coefficient;  ///< of every function of the knots, not scaled; 0: it is not on the beam
    std::string failure;          ///< not empty: the system's, or what its factorisation found
};

/// Solves the beam's system by Cholesky's method, n^3 / 6; a matrix that is not positive definite is told in `failure`.
BeamSolution solve_beam(const Beam& beam, const BeamSystem& system);

/// The deflection, slope and curvature v'' at a point; the bending moment is the rigidity times the curvature.
struct BeamState {
    double deflection, slope, curvature;
};
BeamState beam_state(const Beam& beam, const BeamSolution& solution, double x);

/// |K| |K^-1| in three norms; infinite where K is not positive definite to working precision. The condition numbers that
/// [Grishin10] prints in appendix B are those of the 1-norm.
struct ConditionNumbers {
    double one, two, frobenius;
};

/// The condition numbers of a dense symmetric positive definite matrix, from its inverse: right to a few digits also where they
/// are far beyond 1e16, if that is due to the scaling of rows and columns. Cost of order n^3.
ConditionNumbers condition_numbers(const Eigen::MatrixXd& matrix);

}  // namespace abut::solver
