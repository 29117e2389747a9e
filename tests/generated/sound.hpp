// SPDX-License-Identifier: GPL-3.0-or-later
// What every answer must keep, whatever the scene.
#pragma once
#include <string>
#include <vector>

#include "src/analysis/analysis.hpp"

namespace abut::test {

/// One line for each thing that no answer with status ok may have: numbers that are not finite, a negative energy or pressure,
/// parts moved by more than their own size, forces or moments that do not balance: of the whole and part by part, where the
/// loads are given as forces. Empty: sound.
/// balanced: what forces may be off by, of the largest; moments of that times the assembly's size.
std::vector<std::string> faults_of(const Scene& scene, const Result& result, double balanced = 1e-9);

/// Runs a scene; InputError and status failed are both refusals, with their message.
struct Answer {
    Result result;
    bool refused = false;
    std::string message;
};
Answer answer_of(const Scene& scene);

}  // namespace abut::test
