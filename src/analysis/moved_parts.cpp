// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/moved_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/brep/closest_points.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/contact/search_distances.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

/// Motions below this, of a part's size, are not looked at.
constexpr double least_motion = 1e-3;

using Pair = std::pair<int, int>;

/// The scene where the answer's motions have its parts, and how well the outline of each is known there: they bend, too, and
/// small displacements turn them along straight lines.
struct MovedScene {
    Scene scene;
    std::vector<double> unknown;  ///< by part
    std::vector<Vec2> way;        ///< by part
    bool any = false;             ///< does any part go far enough to be looked at?
};

MovedScene moved_scene(const Scene& drawn, const SolvedAssembly& solved) {
    MovedScene moved{drawn, std::vector<double>(drawn.parts.size(), 0), std::vector<Vec2>(drawn.parts.size(), Vec2(0, 0))};
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        const std::size_t part = at(solved.grids[i].part);
        const double size = solved.grids[i].size;
        const FittedMotion fitted = fitted_motion_of(solved, i);
        const solver::RigidMotion& m = fitted.motion;
        const double turned = 0.5 * size * std::abs(m.rotation);
        moved.unknown[part] = fitted.rest + turned * std::abs(m.rotation);
        moved.any = moved.any || m.translation.norm() + turned > least_motion * size;
        moved.way[part] = m.translation;
        const double c = std::cos(m.rotation), s = std::sin(m.rotation);
        const Vec2 turned_center(c * m.center.x() - s * m.center.y(), s * m.center.x() + c * m.center.y());
        turn_and_shift(moved.scene.parts[part], c, s, m.center + m.translation - turned_center);
    }
    return moved;
}

double largest_interference(const Scene& scene) {
    double largest = 0;
    for (const PairRule& rule : scene.contacts.pairs) largest = std::max(largest, std::abs(rule.interference));
    return largest;
}

/// The pairs of parts that press, and those that are bonded.
struct Pressing {
    std::set<Pair> pressing, bonded;
};

Pressing pressing_of(const SolvedAssembly& solved) {
    Pressing found;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (solved.stretches[k].empty()) continue;
        const Pair pair = std::minmax(c.part[0], c.part[1]);
        (c.face.bilateral ? found.bonded : found.pressing).insert(pair);
    }
    return found;
}

}  // namespace

void warn_of_moved_parts(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    if (scene.analysis == Analysis::axisymmetric) return;  // parts move along their axis alone
    const MovedScene moved = moved_scene(scene, solved);
    if (!moved.any) return;
    const Pressing pairs = pressing_of(solved);
    std::vector<Finding> overlaps, apart;
    const auto names = [&](const Pair& p) { return scene.parts[at(p.first)].name + " and " + scene.parts[at(p.second)].name; };
    const auto unknown = [&](const Pair& p) { return moved.unknown[at(p.first)] + moved.unknown[at(p.second)]; };
    for (const Encounter& e : find_encounters(moved.scene, 1)) {
        const Pair pair = std::minmax(e.first, e.second);
        if (!e.overlap || e.overlap->depth <= 2 * unknown(pair) || pairs.pressing.count(pair) || pairs.bonded.count(pair))
            continue;
        const double drawn = geometry::overlap(scene.parts[at(e.first)].part, scene.parts[at(e.second)].part, 0).depth;
        if (e.overlap->depth <= drawn + 2 * unknown(pair)) continue;
        const std::string text = names(pair) + " overlap by " + with_unit(e.overlap->depth, 2, scene.length_unit) + " near " +
                                 place_text(e.overlap->at, model_size(result)) + " where the answer has them";
        overlaps.push_back({e.overlap->depth, names(pair),
                            text + ": they come together there, which small displacements do not see. Draw them nearer to "
                                   "where they meet",
                            text});
    }
    const double interference = largest_interference(scene);
    for (const Pair& pair : pairs.pressing) {
        const geometry::Part &first = moved.scene.parts[at(pair.first)].part, &second = moved.scene.parts[at(pair.second)].part;
        // along round faces the way is a tangent
        const double size = std::min(bounding_box(first).diagonal(), bounding_box(second).diagonal()),
                     along = (moved.way[at(pair.first)] - moved.way[at(pair.second)]).norm(),
                     known = 2 * unknown(pair) + along * along / size + interference + touching_length(first, second);
        if (pair.first == pair.second || closest_points(first, second, known)) continue;
        const std::string text = names(pair) + " press each other as drawn, and are apart where the answer has them";
        apart.push_back({0, names(pair), text + ": they have slid off each other. Draw them where they are to meet", text});
    }
    tell(std::move(overlaps), "missed_contact", result);
    tell(std::move(apart), "moved_pairs", result);
}

}  // namespace abut
