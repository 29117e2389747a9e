// SPDX-License-Identifier: GPL-3.0-or-later
// What the next grids' candidates learn from a solution, and whether they must reach farther.
#pragma once
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// Has contact reached an end of a candidate zone that could be longer?
bool zone_too_short(const SolvedAssembly& solved);

/// The factor on the first search distance with which every pair is found that the displacements could close.
double needed_search_factor(const Scene& scene, const SolvedAssembly& solved);

/// Moves the seams of closed zones: they start where the gap is largest; where contact reaches that seam all the same (a pin
/// drawn in the middle of its hole), the seam moves to the middle of the longest open stretch.
void move_seams(const Scene& scene, const SolvedAssembly& solved, std::vector<Candidate>& candidates);

/// Gives the candidates the free ends of all stretches, as the next pressure splines expect them; stretches: as they were
/// found, or where they are expected.
void expect_ends(const Scene& scene, const SolvedAssembly& solved, const PressedStretches& stretches,
                 std::vector<Candidate>& candidates);

/// Gives the candidates of some contacts alone the free ends of their stretches, as they were found: the others keep their
/// pressure's knots.
void expect_ends(const Scene& scene, const SolvedAssembly& solved, const std::vector<std::size_t>& contacts,
                 std::vector<Candidate>& candidates);

/// Gives the candidates the pressures of all contacts: where the next search for the active set begins.
void expect_pressures(const SolvedAssembly& solved, std::vector<Candidate>& candidates);

/// Gives candidates of another search what those before expect along the same faces: ends and pressures.
void inherit_expected(const std::vector<Candidate>& before, std::vector<Candidate>& candidates);

/// The contacts whose free ends lie elsewhere than the candidates expected, by so much that other knots would tell more.
std::vector<std::size_t> moved_ends(const Scene& scene, const SolvedAssembly& solved, const std::vector<Candidate>& candidates);

}  // namespace abut
