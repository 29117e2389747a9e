// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's rules for pairs of edges: which stretches of a candidate zone fall under which.
#pragma once
#include <vector>

#include "src/candidates.hpp"

namespace abut {

/// A candidate with the rule that it falls under (index into ContactOptions::pairs; -1: none).
struct Ruled {
    Candidate candidate;
    int rule;
};

/// A zone may run over several edges: it is cut where the rules for them change. Of several rules for the same edges the last
/// counts.
std::vector<Ruled> split_by_rules(const Scene& scene, const Candidate& c);

}  // namespace abut
