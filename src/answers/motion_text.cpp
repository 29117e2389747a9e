// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/motion_text.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"

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

std::string motion_words(const geometry::Screw& twist, const geometry::ScrewScale& scale) {
    const Vec2 c = scale.center;
    const Vec2 at_center(twist[0] - twist[2] * c.y(), twist[1] + twist[2] * c.x());
    if (std::abs(twist[2]) * scale.size <= slide_fraction * at_center.norm())
        return "slides along " + point_text(at_center.normalized(), 1);
    return "rotates about " + point_text(c + Vec2(-at_center.y(), at_center.x()) / twist[2], scale.size);
}

PartTwist twist_of(const SolvedAssembly& solved, const solver::PartMotion& motion) {
    const PartOnGrid& g = solved.grids[static_cast<std::size_t>(motion.part)];
    const solver::RigidMotion& m = motion.motion;
    const Vec2 v = g.frame.vector_to_global(m.at({0, 0})), origin = g.frame.to_global({0, 0});
    return {g.part, {v.x() + m.rotation * origin.y(), v.y() - m.rotation * origin.x(), m.rotation}};
}

std::vector<PartTwist> twists_of(const SolvedAssembly& solved, const std::vector<solver::PartMotion>& motions) {
    std::vector<PartTwist> twists;
    for (const solver::PartMotion& motion : motions) twists.push_back(twist_of(solved, motion));
    return twists;
}

std::string motion_text(const Scene& scene, const SolvedAssembly& solved, const solver::PartMotion& motion) {
    const PartOnGrid& g = solved.grids[static_cast<std::size_t>(motion.part)];
    return scene.parts[static_cast<std::size_t>(g.part)].name + " " +
           motion_words(twist_of(solved, motion).twist, {g.frame.to_global(motion.motion.center), g.size});
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
