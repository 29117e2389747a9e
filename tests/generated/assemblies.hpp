// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies made up from a kind and a seed, and what may be done to a scene without changing its answer.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abut::test {

/// Plates on rollers and on loose discs, filleted and crowned blocks, pins in holes, levers, rings, wedges and discs in
/// grooves, discs in boxes and in piles, punches, stacks, beams on stops, press fits.
const std::vector<std::string>& assembly_kinds();

/// A scene as JSON text, the same for the same kind and seed: 2 to 6 parts whose sizes, clearances, materials, loads and guides
/// are drawn at random. In mm and N, guided by nothing that knows the axes, so that it may be turned.
std::string random_scene(const std::string& kind, std::uint64_t seed);

/// Turned about the origin, mirrored at x = 0 before, measured in another unit of length, parts listed in another order.
struct Change {
    std::string name{};
    double turn = 0;  ///< degrees
    bool mirror = false;
    double unit = 1;  ///< of length, in the old ones; forces keep theirs
    std::optional<std::uint64_t> order{};
};
std::string changed(const std::string& scene, const Change& change);

}  // namespace abut::test
