// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies that friction holds, or does not, made up from a kind and a seed.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace abut::test {

/// A scene as JSON text, and what statics says of it.
struct FrictionCase {
    std::string text;
    bool rests = true;  ///< else it slides under its last load
    double mu = 0;
};

/// Cylinders and filleted punches whose turning is held, blocks that may tip, pins in holes under a moment.
const std::vector<std::string>& friction_kinds();

/// The same for the same kind and seed: coefficients up to 2, loads up to 0.99 of what friction bears, either way, one in
/// sixteen beyond; stiffnesses that differ by up to 1000, one body rigid; at once or in steps; the whole turned by any angle,
/// on grids of the program's own or on given ones, turned and moved.
FrictionCase friction_case(const std::string& kind, std::uint64_t seed);

}  // namespace abut::test
