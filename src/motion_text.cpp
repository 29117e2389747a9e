// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion_text.hpp"

#include <algorithm>
#include <cmath>

#include "src/svg.hpp"

namespace abut {

namespace {

/// Rotation times size below this fraction of the translation is a slide: the centre is a thousand sizes away. Words, not
/// numbers, depend on it.
constexpr double slide_fraction = 1e-3;

/// v with rounding noise taken out: what is below a millionth of scale reads as 0.
std::string tidy(double v, double scale) {
    return number_text(std::abs(v) < 1e-6 * scale ? 0.0 : v, 4);
}

std::string point_text(const Vec2& p, double scale) {
    return "(" + tidy(p.x(), scale) + ", " + tidy(p.y(), scale) + ")";
}

}  // namespace

std::string motion_text(const Scene& scene, const SolvedAssembly& solved, const solver::PartMotion& motion) {
    const PartOnGrid& g = solved.grids[static_cast<std::size_t>(motion.part)];
    const std::string name = scene.parts[static_cast<std::size_t>(g.part)].name;
    const solver::RigidMotion& m = motion.motion;
    if (std::abs(m.rotation) * g.size <= slide_fraction * m.translation.norm()) {
        const Vec2 d = g.frame.vector_to_global(m.translation).normalized();
        return name + " slides along " + point_text(d, 1);
    }
    const Vec2 pole = m.center + Vec2(-m.translation.y(), m.translation.x()) / m.rotation;
    return name + " rotates about " + point_text(g.frame.to_global(pole), g.size);
}

std::string motions_text(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::PartMotion>& motions) {
    constexpr std::size_t named = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(named, motions.size()); ++k)
        text += (text.empty() ? "" : "; ") + motion_text(scene, solved, motions[k]);
    if (motions.size() > named) text += "; and " + std::to_string(motions.size() - named) + " more";
    return text;
}

}  // namespace abut
