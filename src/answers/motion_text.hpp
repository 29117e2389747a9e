// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "geometry/interfaces/screw.hpp"
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// A twist (vx, vy of the point at the origin, w) in words: "slides along (1, 0)" or "rotates about (3, 4)".
std::string motion_words(const geometry::Screw& twist, const geometry::ScrewScale& scale);

/// A part's motion as a twist, in assembly coordinates.
PartTwist twist_of(const SolvedAssembly& solved, const solver::PartMotion& motion);
/// All of them.
std::vector<PartTwist> twists_of(const SolvedAssembly& solved, const std::vector<solver::PartMotion>& motions);

/// A part's motion in words: "pin slides along (1, 0)" or "pin rotates about (3, 4)", in assembly coordinates.
std::string motion_text(const Scene& scene, const SolvedAssembly& solved, const solver::PartMotion& motion);

/// The first few motions in words, and how many more there are.
std::string motions_text(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::PartMotion>& motions);

}  // namespace abut
