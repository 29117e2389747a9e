// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that no load reaches: they are not analysed, and are named.
#pragma once
#include <string>
#include <vector>

#include "src/plan/boundary_conditions.hpp"
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// Which parts an analysis of the scene leaves out, as an entry of the plan. Cost: the search for contacts. Where that is not
/// possible (drawn overlaps) the entry says so.
Effect left_out_effect(const Scene& scene, const ResolvedConditions& conditions);

/// The names of a result's parts that were left out; none where no part was solved, which is told otherwise.
std::vector<std::string> left_out_parts(const Result& result);

/// The left out parts in words: "parts a, b are not analysed: they carry no load, and no face of them touches a part that does";
/// empty for none.
std::string left_out_text(const std::vector<std::string>& parts);

}  // namespace abut
