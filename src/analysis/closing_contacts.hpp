// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts with friction that the loads close: what their friction is not told.
#pragma once
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Tells of contacts with friction that were open when the loads began and are closed now: slip counts from where parts were
/// then, so that what they move along each other before they touch is taken for slip, which speaks against the answer. Of no
/// account is a gap that is less of the parts' displacement than the error aimed at, `target`.
void tell_closing_contacts(const SolvedAssembly& solved, double target, Result& result);

}  // namespace abut
