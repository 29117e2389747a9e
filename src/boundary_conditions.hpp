// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's supports and loads as what the solver takes: points of the boundary, in the frame of each part's grid.
#pragma once
#include <string>
#include <vector>

#include "solver/assembly_solve.hpp"
#include "src/discretize.hpp"
#include "src/result.hpp"
#include "src/selection.hpp"

namespace abut {

/// The scene's selections turned into portions of edges, once for all grids.
struct ResolvedConditions {
    std::vector<std::vector<EdgePortion>> supports, loads;  ///< parallel to Scene::supports, Scene::loads
};
ResolvedConditions resolve_conditions(const Scene& scene);

/// Supports of one part along its boundary. SupportSet::tag is the index of the scene's support.
std::vector<solver::SupportSet> support_sets(const Scene& scene, const ResolvedConditions& conditions,
                                             const PartOnGrid& on_grid);

/// Mean constraints of one part ("rigid" supports); `part` is the index among the solver's parts.
std::vector<solver::MeanConstraint> mean_constraints(const Scene& scene, const PartOnGrid& on_grid, int part);

/// Load vector of one part, and the size of the largest single load (sum of its magnitudes).
struct PartLoad {
    Eigen::VectorXd vector;
    double scale = 0;
};
PartLoad load_vector(const Scene& scene, const ResolvedConditions& conditions, const PartOnGrid& on_grid);

/// Does anything act on the part: a load, a prescribed displacement that is not zero?
bool is_driven(const Scene& scene, const ResolvedConditions& conditions, int part);

/// Label for tables: "fix x, y on base/hA16".
std::string support_label(const Scene& scene, int support);

std::vector<SupportMark> support_marks(const Scene& scene, const ResolvedConditions& conditions);
std::vector<LoadMark> load_marks(const Scene& scene, const ResolvedConditions& conditions);

}  // namespace abut
