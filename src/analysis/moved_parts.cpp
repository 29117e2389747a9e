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
        moved.unknown[part] = fitted.bending() + turned * std::abs(m.rotation);
        moved.any = moved.any || m.translation.norm() + turned > least_motion * size;
        moved.way[part] = m.translation;
        const Placement p = about_center(m.center, m.translation, m.rotation);
        turn_and_shift(moved.scene.parts[part], std::cos(p.angle), std::sin(p.angle), p.shift);
    }
    return moved;
}

double largest_interference(const Scene& scene) {
    double largest = 0;
    for (const PairRule& rule : scene.contacts.pairs) largest = std::max(largest, std::abs(rule.interference));
    return largest;
}

/// The pairs of two parts with stretches that press, or are bonded.
std::set<Pair> pairs_where(const SolvedAssembly& solved, bool is_bonded) {
    std::set<Pair> pairs;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (!solved.stretches[k].empty() && c.face.bilateral == is_bonded && c.part[0] != c.part[1])
            pairs.insert(std::minmax(c.part[0], c.part[1]));
    }
    return pairs;
}

}  // namespace

void warn_of_moved_parts(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    if (scene.analysis == Analysis::axisymmetric) return;  // parts move along their axis alone
    const MovedScene moved = moved_scene(scene, solved);
    if (!moved.any) return;
    const std::set<Pair> pressing = pairs_where(solved, false), bonded = pairs_where(solved, true);
    std::vector<Finding> overlaps, apart;
    const auto names = [&](const Pair& p) { return scene.parts[at(p.first)].name + " and " + scene.parts[at(p.second)].name; };
    const auto unknown = [&](const Pair& p) { return moved.unknown[at(p.first)] + moved.unknown[at(p.second)]; };
    for (const Encounter& e : find_encounters(moved.scene, 1)) {
        const Pair pair = std::minmax(e.first, e.second);
        if (!e.overlap || e.overlap->depth <= 2 * unknown(pair) || pressing.count(pair) || bonded.count(pair)) continue;
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
    for (const Pair& pair : pressing) {
        const geometry::Part &first = moved.scene.parts[at(pair.first)].part, &second = moved.scene.parts[at(pair.second)].part;
        // along round faces the way is a tangent
        const double size = std::min(bounding_box(first).diagonal(), bounding_box(second).diagonal()),
                     along = (moved.way[at(pair.first)] - moved.way[at(pair.second)]).norm(),
                     known = 2 * unknown(pair) + along * along / size + interference + touching_length(first, second);
        if (closest_points(first, second, known)) continue;
        const std::string text = names(pair) + " press each other as drawn, and are apart where the answer has them";
        apart.push_back({0, names(pair), text + ": they have slid off each other. Draw them where they are to meet", text});
    }
    tell(std::move(overlaps), "missed_contact", result);
    tell(std::move(apart), "moved_pairs", result);
}

}  // namespace abut
