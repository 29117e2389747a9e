// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated errors beside true ones: those against a solution whose own error is a tenth or less, or against a closed form.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "src/analysis/adaptive.hpp"

namespace abut::test {

/// A scene below data/, to be solved for one accuracy or another.
struct EstimateCase {
    std::string scene;
    std::map<std::string, double> parameters{};
    std::optional<Analysis> analysis{};
};

/// The scene with grids and sizes of its own taken away, so that it is solved adaptively.
Scene adaptive_scene(const EstimateCase& c);

/// The passes towards a target.
Outcome solved_to(Scene scene, double target);

/// Relative errors, of what ErrorEstimate estimates; 0 where there is nothing.
struct TrueErrors {
    double contact_pressure = 0;    ///< the largest L2 error away from corners, relative to the strongest contact's pressure
    double peak = 0, force = 0;     ///< the largest ones; peaks but for those at corners; relative to the largest of all
    double force_estimate = 0;      ///< the same of the estimates
    double energy = 0, stress = 0;  ///< stress: the root
};
/// reference: the same scene, a target ten times smaller or less.
TrueErrors errors_against(const Outcome& out, const Outcome& reference);

/// Relative L2 error of the first contact's pressure against one over x, in the scene's coordinates.
double pressure_error(const Scene& scene, const Outcome& out, const std::function<double(double x)>& exact);

/// Stress (xx, yy, xy) at a place, both in assembly coordinates.
using StressField = std::function<Eigen::Vector3d(const Vec2&)>;
/// Relative error of the stresses in the energy norm, of the displacements' own; grids along the axes.
double stress_error(const Outcome& out, const StressField& exact);

}  // namespace abut::test
