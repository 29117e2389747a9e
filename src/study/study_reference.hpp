// SPDX-License-Identifier: GPL-3.0-or-later
// What the errors of a study are against: closed forms of the verification problems, or a run of its own.
#pragma once
#include <string>
#include <vector>

#include "src/study/study_measure.hpp"

namespace abut {

/// The verification problem that is this very scene: the same file, or one of the same text that imports nothing, with the same
/// values of its parameters, one run, and nothing else replaced. nullptr: there is none.
const VerifyProblem* known_problem(const std::string& scene_path, const Scene& scene, const std::string& data_folder);

/// The quantities that differences from a reference run are made of. Those of contacts together, each relative to the root of
/// the sum of squares over all contacts, so that light contacts do not count like heavy ones.
std::vector<StudyMeasure> measures_of(const StudyAnswer& reference);

/// The differences of an answer from the reference by measure; NaN where the answers have different contacts. Pressures are
/// compared point by point along the first part's edge, integrated over the arc length of the reference's profile.
std::vector<double> differences(const StudyAnswer& answer, const StudyAnswer& reference);

}  // namespace abut
