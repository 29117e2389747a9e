// SPDX-License-Identifier: GPL-3.0-or-later
// What small displacements leave out of the balance of forces, to the second order, as loads.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What a contact's force does more on one of its parts as the contact moves away from the part's points there and turns with
/// its normal: a force, and a moment about `at`, in assembly coordinates.
struct ContactChange {
    std::size_t contact, side, part;
    Vec2 at, force{0, 0};
    double moment = 0;
};
std::vector<ContactChange> changes_as_contacts_move(const Scene& scene, const SolvedAssembly& solved);

/// The load (2n) that works in a part's rigid motions what a force and a moment about its centre do, in its frame, evenly over
/// its functions.
Eigen::VectorXd even_load(const PartOnGrid& grid, const Vec2& force, double moment = 0);

/// Do edges that supports hold keep the part where it is? How it gives way there is strain.
bool is_held_by_edges(const SolvedAssembly& solved, std::size_t part);

/// The moment that loads which keep their directions, contacts' included, have more on a part that turns.
double moment_as_part_turns(const SolvedAssembly& solved, std::size_t part);

/// Finds what the balance of an answer leaves out, by part (2n): finite_motion_load, which is for contact forces that stay at
/// the same points of both bodies and keep their lines, and what they do otherwise. Rigid motions that nothing resists have no
/// share. Not with a solution structure.
std::vector<Eigen::VectorXd> second_order_loads(const Scene& scene, const SolvedAssembly& solved);

/// The assembly under further loads (2n, by part), with its contacts farther apart by some gaps (by contact, or none), by the
/// same rows and factors.
SolvedAssembly solved_under(const SolvedAssembly& solved, const std::vector<Eigen::VectorXd>& more,
                            const std::vector<double>& gaps, int threads);

}  // namespace abut
