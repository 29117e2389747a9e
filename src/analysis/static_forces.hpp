// SPDX-License-Identifier: GPL-3.0-or-later
// Contact forces that equilibrium alone gives: they know nothing of how parts yield, and err by what their lines of action do.
#pragma once
#include <vector>

#include "src/solution/assembly_model.hpp"

namespace abut {

/// Does a contact's force (by contact), and that of all others on the same free parts, follow from statics, with the lines of
/// action as they were found? False where there is no force.
std::vector<char> given_by_statics(const SolvedAssembly& solved);

/// How far statics leaves it open what a constraint bears and what contacts do (by constraint): 0, they are independent, to
/// 1/2. Lines of action may go as far as contacts reach.
std::vector<double> shared_with_contacts(const SolvedAssembly& solved);

/// The combinations of a solved part's free motions, orthonormal columns by motion, that supports of means and of points let
/// go; are_led_free: of those alone that hold what they hold where it is, not elsewhere.
Eigen::MatrixXd combinations_let_go(const SolvedAssembly& solved, std::size_t grid, bool are_led_free);

/// The rigid motions of a solved part that nothing but contacts holds, in its own frame: its free motions, and of those that
/// supports of means or of points resist the combinations that they let go.
std::vector<solver::RigidMotion> motions_left_to_contacts(const SolvedAssembly& solved, std::size_t grid);

/// Does a support hold a mean displacement or the mean rotation of a solved part (`rigid`)? What is held so is no free motion
/// less, but not left to contact alone.
bool has_held_means(const SolvedAssembly& solved, std::size_t grid);

}  // namespace abut
