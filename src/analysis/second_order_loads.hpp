// SPDX-License-Identifier: GPL-3.0-or-later
// What small displacements leave out of the balance of forces, to the second order, as loads.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A force, and its moment about a part's centre, in the part's frame.
struct Wrench {
    Vec2 force{0, 0};
    double moment = 0;
};

/// The load (2n) that works in rigid motions what the wrench does, evenly over the part's functions.
Eigen::VectorXd load_of(const PartOnGrid& grid, const Wrench& wrench);

/// Do edges that supports hold keep the part where it is? How it gives way there is strain.
bool is_held_by_edges(const SolvedAssembly& solved, std::size_t part);

/// Finds what contacts' forces do more on each part as they move away from its points and turn with their normals. Parts are
/// taken as rigid; those that edges hold stay, since how they give way is strain.
std::vector<Wrench> wrenches_as_contacts_move(const Scene& scene, const SolvedAssembly& solved);

/// The moment that loads which keep their directions, contacts' included, have more on a part that turns.
double moment_as_part_turns(const SolvedAssembly& solved, std::size_t part);

/// Finds what the balance of an answer leaves out, by part (2n): finite_motion_load, which is for contact forces that stay at
/// the same points of both bodies and keep their lines, and what they do otherwise. Rigid motions that nothing resists have no
/// share. Not with a solution structure.
std::vector<Eigen::VectorXd> second_order_loads(const Scene& scene, const SolvedAssembly& solved);

/// The assembly under further loads (2n, by part), by the same rows and factors.
SolvedAssembly solved_under(const SolvedAssembly& solved, const std::vector<Eigen::VectorXd>& more, int threads);

}  // namespace abut
