// SPDX-License-Identifier: GPL-3.0-or-later
// Is an answer the same where nothing but the way of writing the scene changed?
#pragma once
#include <string>
#include <vector>

#include "tests/generated/assemblies.hpp"
#include "tests/generated/sound.hpp"

namespace abut::test {

/// One line for every force, largest pressure (but for those at corners) and energy that differs by more than both answers say
/// they may be off, and where one is refused and the other is not.
std::vector<std::string> differences(const Answer& drawn, const Answer& other, const Change& change);

/// Everything that is wrong with an assembly: of the answer as drawn, and of all changes; each line begins with the change.
/// balanced: as faults_of has it.
std::vector<std::string> faults_of_assembly(const std::string& scene, const std::vector<Change>& changes,
                                            double balanced = 1e-9);

/// Turned, mirrored, in another order, in metres; by the seed.
std::vector<Change> changes_of(std::uint64_t seed);

}  // namespace abut::test
