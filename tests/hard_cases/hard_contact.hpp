// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that are hard to find, to close or to keep apart, each with a parameter that runs over many decades.
#pragma once
#include <string>
#include <vector>

#include "tests/hard_cases/contact_case.hpp"

namespace abut::test {

struct HardAnswer {
    std::string family, what;  ///< what: the case's parameters, in words
    std::string failure{};     ///< empty: converged and balanced
    double error = 0;          ///< of the pressure, relative: largest where the exact one is known, else L2 over the contact
    double residual = 0, unbalance = 0;
    int iterations = 0;
    bool fallback = false;
};
using HardAnswers = std::vector<HardAnswer>;

/// A block on a block, nu = 0, under a uniform body force: the contact pressure is uniform. Ratios of moduli from 1e-4 to
/// 1e4, gaps and overlaps from 1e-12 to 1e-1, grid angles, slivers from 1e-1 to 1e-10 cells at the contact.
HardAnswers floating_blocks();
/// The same, held at the far sides: overlaps make a pressure in proportion, gaps stay open.
HardAnswers held_blocks();
/// The upper block is drawn tilted by 1e-10 to 1e-2: contact starts at its corner and ends
/// uniform but for a share of the tilt: the error is relative to that.
HardAnswers tilted_blocks();
/// 1 to 16 blocks side by side on one base: as many pairs, and those between neighbours.
HardAnswers many_pairs();
/// Up to 50 blocks on each other.
HardAnswers stacks();
/// A disc on a block: contact starts at a point. Against a grid four times finer.
HardAnswers discs(const std::vector<double>& moduli);
/// A disc in a hole of the same radius, ratios of moduli from 1e-4 to 1e4. Without an error.
HardAnswers conforming_discs();

/// A disc of radius 1 on a block, as it is in `discs`; order: which of them is drawn first.
struct DiscOnBlock {
    double modulus = 1, gap = 0, half_width = 0.1, cells = 6;  ///< cells in half the width of contact
    double angle = 0, sliver = 0.5;
    bool disc_first = false;
    double direction = -1;  ///< of the load, along y
};
ContactCase disc_on_block(const DiscOnBlock& d);
/// Its Hertzian largest pressure.
double hertz_peak(const DiscOnBlock& d);

HardAnswer judge(const SolvedAssembly& solved, double size);
void write_hard_contacts(const std::vector<HardAnswers>& families);

}  // namespace abut::test
