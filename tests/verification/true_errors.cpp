// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/true_errors.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "solver/terms/stress.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::test {

Scene adaptive_scene(const EstimateCase& c) {
    Scene scene = read_scene(std::string(ABUT_SOURCE_DIR) + "/data/" + c.scene, c.parameters);
    if (c.analysis) scene.analysis = *c.analysis;
    scene.accuracy = {};
    return scene;
}

Outcome solved_to(Scene scene, double target) {
    scene.accuracy.target = target;
    Stopwatches seconds;
    AnalyzeOptions options;
    options.threads = 1;
    return solve_adaptively(scene, resolve_conditions(scene), options, seconds);
}

TrueErrors errors_against(const Outcome& out, const Outcome& reference) {
    TrueErrors e;
    const PassRecord &now = out.passes.back(), &finer = reference.passes.back();
    double strongest = 0, largest_peak = 0, largest_force = 0;
    for (std::size_t k = 0; k < now.contacts.size(); ++k) {
        const PressureChange c = change_of(now.contacts[k], finer.contacts.at(k));
        const auto& estimate = out.errors.back().contacts[k];
        strongest = std::max(strongest, c.norm);
        largest_peak = std::max(largest_peak, c.peak_before);
        largest_force = std::max(largest_force, std::abs(c.force_before));
        e.contact_pressure = std::max(e.contact_pressure, c.difference);
        if (estimate && !estimate->at_corner) e.peak = std::max(e.peak, std::abs(c.peak - c.peak_before));
        e.force = std::max(e.force, c.force_change * std::abs(c.force));
        if (estimate) e.force_estimate = std::max(e.force_estimate, estimate->force * std::abs(c.force));
    }
    if (strongest > 0) {
        e.contact_pressure /= strongest;
        e.peak /= largest_peak;
        e.force /= largest_force;
        e.force_estimate /= largest_force;
    }
    e.energy = std::abs(now.energy - finer.energy) / finer.energy;
    e.stress = std::sqrt(e.energy);
    return e;
}

double pressure_error(const Scene& scene, const Outcome& out, const std::function<double(double x)>& exact) {
    const ContactRecord& c = out.passes.back().contacts.at(0);
    const auto& rule = geometry::gauss_rule(8);  // the root at the end lies inside an interval
    double error = 0, norm = 0;
    for (std::size_t i = 0; i + 1 < c.pressure.breakpoints.size(); ++i) {
        const double a = c.pressure.breakpoints[i], h = c.pressure.breakpoints[i + 1] - a;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double s = a + h * rule.points[q];
            const geometry::FacingPair pair = pair_at(scene, out.solved.contacts.at(0), s);
            const double p = exact(0.5 * (pair.on1.x.x() + pair.on2.x.x()));
            const double difference = solver::pressure_at(c.pressure, c.coefficients, s) - p;
            error += h * rule.weights[q] * difference * difference;
            norm += h * rule.weights[q] * p * p;
        }
    }
    return std::sqrt(error / norm);
}

double stress_error(const Outcome& out, const StressField& exact) {
    double error = 0, norm = 0;
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) {
        const PartOnGrid& grid = out.solved.grids[k];
        const solver::StressOf stress(grid.input, out.solved.solution.displacement[k]);
        Eigen::Matrix3d flexibility = Eigen::Matrix3d::Zero();
        const solver::Elasticity& d = grid.input.elasticity;
        flexibility.topLeftCorner<2, 2>() = (Eigen::Matrix2d() << d.d11, d.d12, d.d12, d.d11).finished().inverse();
        flexibility(2, 2) = 1 / d.d33;
        for_all_cells(grid.input, [&](const solver::CellRule& cell) {
            for (std::size_t q = 0; q < cell.points.size(); ++q) {
                const Eigen::Vector3d s = exact(grid.frame.to_global(cell.points[q]));
                const Eigen::Vector3d difference = stress(cell.element, cell.points[q]) - s;
                error += cell.weights[q] * difference.dot(flexibility * difference);
                norm += cell.weights[q] * s.dot(flexibility * s);
            }
        });
    }
    return std::sqrt(error / norm);
}

}  // namespace abut::test
