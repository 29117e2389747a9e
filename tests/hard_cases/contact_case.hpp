// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies of the contact sweeps: parts with grids of their own, loads, clamped edges, solved by one pass of the program.
#pragma once
#include <string>
#include <vector>

#include "src/solution/assembly_model.hpp"
#include "tests/hard_cases/shapes.hpp"

namespace abut::test {

struct ContactCase {
    Scene scene;
    ResolvedConditions conditions;
};

/// Plane stress, unit thickness. Named "0", "1", ... by index; returns the index.
int add_part(ContactCase& c, const geometry::Part& part, double E, double nu = 0.3);
/// Lines at begin + k h over the part in the axes of its grid, turned by `angle` (radians): the first line no further than one
/// cell outside.
void set_even_grid(ContactCase& c, int part, double h, const Vec2& begin, double angle = 0);
/// Cells of size h in the box (axes turned by `angle`), growing away from it.
void set_graded_grid(ContactCase& c, int part, const geometry::Box2& box, double h, double angle = 0);
/// The same with all lines moved, so that a point has a line of each direction so many cells below it.
struct GridPlace {
    Vec2 through;  ///< in the turned axes
    Vec2 below;    ///< cells between the line and the point
};
void set_graded_grid(ContactCase& c, int part, const geometry::Box2& box, double h, double angle, const GridPlace& place);
void clamp(ContactCase& c, int part, int edge, bool x = true, bool y = true);
void press(ContactCase& c, int part, int edge, double pressure);
/// As a uniform body force.
void push(ContactCase& c, int part, const Vec2& force);

/// One pass on the given grids, with candidates searched `search` times as far as usual.
SolvedAssembly solve_case(const ContactCase& c, double search = 1);

/// The loads times `factor`, on the same factors: replaces solved.solution.
void scale_loads(SolvedAssembly& solved, double factor);
/// Solution and runs of solved.problem, anew.
void solve_again(SolvedAssembly& solved);

/// What a contact does to its first body, in assembly axes, about the origin.
struct ContactForce {
    Vec2 force{0, 0};
    double moment = 0;
};
ContactForce force_on_first(const SolvedAssembly& solved, std::size_t contact);

/// Largest sum of forces, or of moments over `size`, on a part that no support touches, relative to the largest force there.
double unbalance(const SolvedAssembly& solved, double size);

double peak_pressure(const SolvedAssembly& solved, std::size_t contact);

}  // namespace abut::test
