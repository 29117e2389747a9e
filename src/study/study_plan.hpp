// SPDX-License-Identifier: GPL-3.0-or-later
// Which runs a study has, and which of them its budget allows.
#pragma once
#include <optional>
#include <vector>

#include "src/scene/scene.hpp"
#include "src/study/study_measure.hpp"

namespace abut {

/// The settings of the levels: one, `level_as_given`, where the scene gives its grids.
std::vector<StudySetting> level_settings(const Scene& scene);

/// The settings of the levels with so many threads; none with one thread.
std::vector<StudySetting> threaded_settings(const Scene& scene, int threads);

/// The settings on given grids, size by size: all degrees, both bases, equal cells of degree 2, and where the scene allows it
/// the dissertation's method with its degree 2. Of a scene by the dissertation's method: that alone.
std::vector<StudySetting> grid_settings(const Scene& scene, const StudyOptions& options);

/// The setting of the run that the others are compared with: grids that follow the contacts down to a fifth of fine's target,
/// or where the scene gives its grids these, finer than all others.
StudySetting reference_setting(const Scene& scene, const StudyOptions& options);

/// The seconds that one solution at the setting will take, by the next coarser runs of its family; unset where there is none.
std::optional<double> predicted_seconds(const std::vector<StudyRun>& runs, const StudySetting& setting);

/// The size of cells of which as many fill the parts as the grids have: where `size` of equal cells is 1.
double equal_cell_size(const Scene& scene, const std::vector<StudyGrid>& grids);

}  // namespace abut
