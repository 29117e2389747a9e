// SPDX-License-Identifier: GPL-3.0-or-later
// What every answer must keep, whatever the scene.
#pragma once
#include <string>
#include <vector>

#include "src/analysis.hpp"

namespace abut::test {

/// One line for each thing that no answer with status ok may have: numbers that are not finite, a negative energy or pressure,
/// parts moved by more than their own size, forces or moments that do not balance: of the whole and part by part, where the
/// loads are given as forces. Empty: sound.
std::vector<std::string> faults_of(const Scene& scene, const Result& result);

/// Runs a scene; InputError and status failed are both refusals, with their message.
struct Answer {
    Result result;
    bool refused = false;
    std::string message;
};
Answer answer_of(const Scene& scene);

}  // namespace abut::test
