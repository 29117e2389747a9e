// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that a pass did not see. Its gaps are means over functions of the pressure, a few cells wide: where bodies overlap
// less far than that, they can pass as open. So every zone is looked at point by point.
#pragma once
#include <vector>

#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A stretch of a zone without pressure where the bodies overlap.
struct MissedContact {
    PressedStretch stretch{};  ///< with free ends
    double depth = 0;          ///< of the overlap, at its deepest
    /// What it may carry, over the largest force on the part that has less: two half planes that are pressed together by the
    /// depth answer with less than E* times thickness times depth.
    double share = 0;
};

/// What was seen of one contact under the displacements.
struct SeenContact {
    std::vector<MissedContact> overlaps{};  ///< stretches without pressure, without their shares
    double least_gap = 0;                   ///< 0: under pressure, or not looked at
};
/// Looks at every contact point by point. Contacts side by side on `threads` threads.
std::vector<SeenContact> look_at_contacts(const Scene& scene, const SolvedAssembly& solved, int threads = 1);

/// The missed stretches by contact, ascending along its zone; those that may carry more than `least_share` of the largest force
/// on the part that has less. What overlaps a part that nothing acts on and nothing holds carries nothing where the part may
/// get out of its way. seen: of the solution's contacts.
using MissedContacts = std::vector<std::vector<MissedContact>>;
MissedContacts missed_contacts(const SolvedAssembly& solved, const std::vector<SeenContact>& seen, double least_share);

/// Is there a missed stretch in any contact?
bool any_missed(const MissedContacts& missed);

/// The pressed stretches of each contact with its missed ones among them, ascending.
PressedStretches with_missed(PressedStretches stretches, const MissedContacts& missed);

}  // namespace abut
