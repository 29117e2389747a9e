// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's supports and loads: what they act on, and how they are named and drawn. support_sets.hpp and load_vector.hpp turn
// them into what the solver takes.
#pragma once
#include <string>
#include <vector>

#include "src/results/result.hpp"
#include "src/scene/selection.hpp"

namespace abut {

/// The scene's selections turned into portions of edges, once for all grids.
struct ResolvedConditions {
    std::vector<std::vector<EdgePortion>> supports, loads;  ///< parallel to Scene::supports, Scene::loads
};
ResolvedConditions resolve_conditions(const Scene& scene);
/// Are these a scene's conditions: a list for each of its supports and loads?
bool is_resolved(const Scene& scene, const ResolvedConditions& conditions);

/// Does anything act on the part: a load, a prescribed displacement that is not zero?
bool is_driven(const Scene& scene, const ResolvedConditions& conditions, int part);

/// The label of a support for tables: "fix x, y on base/hA16".
std::string support_label(const Scene& scene, int support);

/// The marks of supports and loads for the pictures: points along the edges, directions (condition_marks.cpp).
std::vector<SupportMark> support_marks(const Scene& scene, const ResolvedConditions& conditions);
std::vector<LoadMark> load_marks(const Scene& scene, const ResolvedConditions& conditions);

}  // namespace abut
