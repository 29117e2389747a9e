// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/linear_algebra/dense.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

/// A finite turn about the motion's centre, then its translation.
struct Placement {
    double c, s;
    Vec2 shift;  // x -> turned x + shift
    Vec2 of(const Vec2& x) const { return Vec2(c * x.x() - s * x.y(), s * x.x() + c * x.y()) + shift; }
};

Placement placement_of(const solver::RigidMotion& motion) {
    Placement p{std::cos(motion.rotation), std::sin(motion.rotation), {0, 0}};
    p.shift = motion.center + motion.translation - p.of(motion.center);
    return p;
}

/// A motion is known no better than the deformation that goes with it: digits beyond would only turn parts out of the symmetry
/// that they were drawn with.
double rounded(double value, double motion) {
    constexpr double digits = 1e-6;
    return digits * motion * std::round(value / (digits * motion));
}

std::string words_of(const std::string& name, const solver::RigidMotion& motion, double size) {
    std::string text =
        name + " by (" + number_text(motion.translation.x(), 3) + ", " + number_text(motion.translation.y(), 3) + ")";
    const double degrees = motion.rotation * 180 / std::numbers::pi;
    constexpr double told = 1e-3;  // of its size, by what a turn moves the part's rim
    if (std::abs(motion.rotation) * size > told * size) text += " and " + number_text(degrees, 2) + " degrees";
    return text;
}

/// Is something given that means another thing where the parts have gone: a value by place, a prescribed motion?
bool depends_on_place(const Scene& scene) {
    const auto varies = [](const Load& load) { return !load.value[0].is_constant() || !load.value[1].is_constant(); };
    const auto moves = [](const Support& s) {
        return s.kind == Support::Kind::displacement || s.rigid_x.value_or(0) != 0 || s.rigid_y.value_or(0) != 0 ||
               s.rigid_rotation.value_or(0) != 0;
    };
    return std::any_of(scene.loads.begin(), scene.loads.end(), varies) ||
           std::any_of(scene.supports.begin(), scene.supports.end(), moves);
}

}  // namespace

solver::RigidMotion rigid_motion_of(const SolvedAssembly& solved, std::size_t grid) {
    const solver::PartSystem& system = solved.problem.parts[grid];
    const PartOnGrid& g = solved.grids[grid];
    solver::RigidMotion motion{{0, 0}, 0, g.frame.to_global(g.center)};
    const Eigen::VectorXd& u = solved.solution.displacement[grid];
    if (system.free_motions.empty() || u.size() != system.modes.rows()) return motion;
    const Eigen::VectorXd share =
        solver::PivotedCholesky(system.modes.transpose() * system.modes).solve(system.modes.transpose() * u);
    Vec2 at_center(0, 0);
    for (Eigen::Index k = 0; k < share.size(); ++k) {
        const solver::RigidMotion& unit = system.free_motions[static_cast<std::size_t>(k)];
        at_center += share[k] * unit.at(g.center);
        motion.rotation += share[k] * unit.rotation;
    }
    motion.translation = g.frame.vector_to_global(at_center);
    return motion;
}

std::optional<PlacedScene> placed_at_rest(const Scene& scene, const SolvedAssembly& solved) {
    // bonds hold as drawn
    const bool has_bond = std::any_of(solved.problem.interfaces.begin(), solved.problem.interfaces.end(),
                                      [](const solver::Interface& face) { return face.bilateral; });
    if (has_bond || scene.analysis == Analysis::axisymmetric || depends_on_place(scene)) return std::nullopt;
    PlacedScene placed{scene, {}};
    if (placed.scene.contacts.overlap == "report") placed.scene.contacts.overlap = "press_fit";
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        ScenePart& part = placed.scene.parts[at(solved.grids[k].part)];
        const double size = solved.grids[k].size;
        solver::RigidMotion motion = rigid_motion_of(solved, k);
        if (const double far = std::max(motion.translation.norm(), size * std::abs(motion.rotation)); far > 0) {
            motion.translation = {rounded(motion.translation.x(), far), rounded(motion.translation.y(), far)};
            motion.rotation = rounded(motion.rotation * size, far) / size;
        }
        const Placement p = placement_of(motion);
        part.part = geometry::transformed(part.part, p.c, p.s, p.shift);
        for (Probe& probe : placed.scene.output.probes)
            if (probe.part == part.name) probe.at = p.of(probe.at);
        for (Load& load : placed.scene.loads)
            if (load.kind == Load::Kind::preload && load.part == part.name)
                load.across = {p.of(load.across[0]), p.of(load.across[1])};
        if (std::max(motion.translation.norm(), 0.5 * size * std::abs(motion.rotation)) > placed_fraction * size)
            placed.moved.push_back(words_of(part.name, motion, size));
    }
    if (placed.moved.empty()) return std::nullopt;
    return placed;
}

}  // namespace abut
