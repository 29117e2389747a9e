// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that know their answers: the key "expect".
#pragma once
#include <string>
#include <vector>

#include "src/results/case_result.hpp"
#include "src/scene/scene.hpp"
#include "src/verification/verify.hpp"

namespace abut {

/// Every expectation of a scene, compared with its answer; seconds are left to be filled in. A quantity that result.json does
/// not have, or that is no number there, and an analysis that failed give rows that do not pass.
std::vector<VerifyRow> compared_with_expectations(const Scene& scene, const Result& result);

/// Every expectation of a scene with load cases, compared with the answers, which are in the scene's order; quantities begin
/// with the case's name.
std::vector<VerifyRow> compared_with_cases(const Scene& scene, const std::vector<CaseResult>& cases);

/// Solves the scene of a file and compares. Throws InputError where the scene cannot be read.
std::vector<VerifyRow> verify_scene(const std::string& file);

/// The scenes below a folder that have expectations, in order of their names; or the file itself. Throws InputError where there
/// is none, and where a file that ends in .json is no JSON.
std::vector<std::string> scenes_with_expectations(const std::string& path);

}  // namespace abut
