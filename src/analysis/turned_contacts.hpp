// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts whose line of action turns as parts move: small displacements take forces along the normals of where parts are
// drawn.
#pragma once
#include "src/analysis/outcome.hpp"
#include "src/results/result.hpp"

namespace abut {

/// Do rigid motions of parts turn the normals of contacts so that forces change by more than they are to be known to?
bool are_forces_turned(const Scene& scene, const Outcome& out);

/// Does nothing but contact that small displacements move along with a part, while its loads stay, hold most of what drives it:
/// a disc that rolls?
bool do_parts_go_on(const Scene& scene, const SolvedAssembly& solved);

/// The share by which each contact's force changes as rigid motions of parts that are not followed turn and move it, 1 at most.
/// Bonds, across which parts are as one, have none.
std::vector<double> turned_shares(const Scene& scene, const SolvedAssembly& solved);

/// Warns, with a reason against the answer, where the rigid motions of parts that are not followed turn a contact's normal by
/// more than forces are to be known to, where nothing balances the loads of a part in a motion once it has moved (a disc that
/// rolls), and where friction would then have to bear more than it can.
void warn_of_turned_contacts(const Scene& scene, const Outcome& out, Result& result);

/// Warns, with a reason against the answer, where parts are balanced on each other as friction lets them roll, and any push
/// would have them go on: a plate on one roller, loaded above the roller's middle. Without friction this was seen as the parts
/// were put where they come to rest.
void warn_of_unstable_balance(const Scene& scene, const SolvedAssembly& solved, Result& result);

}  // namespace abut
