// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/lever_changes.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/moved_forces.hpp"
#include "src/analysis/placement.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/index.hpp"
#include "src/motion/leads.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

using geometry::cross;

/// Of a part's size: where nothing leads parts, lever arms that change by less are those of small displacements.
constexpr double noted_places = 5e-3;
/// Of forces times the part's size: a moment that is next to nothing.
constexpr double next_to_nothing = 0.01;

bool leads(const Support& s) {
    return s.kind == Support::Kind::rigid && prescribes_motion(s);
}
bool are_led(const Scene& scene) {
    return std::any_of(scene.supports.begin(), scene.supports.end(), leads);
}
/// Does a support lead a part as a whole?
bool is_led(const Scene& scene, const SolvedAssembly& solved, std::size_t grid) {
    const std::string& name = scene.parts[at(solved.grids[grid].part)].name;
    return std::any_of(scene.supports.begin(), scene.supports.end(),
                       [&](const Support& s) { return leads(s) && s.part == name; });
}

/// Is a part half of one, whose other half bears such moments?
bool is_half(const Scene& scene, const SolvedAssembly& solved, std::size_t grid) {
    const std::vector<solver::SupportRecord>& supports = solved.problem.parts[grid].supports;
    return std::any_of(supports.begin(), supports.end(), [&](const solver::SupportRecord& record) {
        return scene.supports[at(record.set.tag)].kind == Support::Kind::symmetry;
    });
}

/// What moves as bodies do, and the contacts' forces with it.
struct MovedBodies {
    std::vector<solver::RigidMotion> motions;  ///< by grid
    std::vector<MovedForce> lines;
};

MovedBodies moved_bodies(const Scene& scene, const SolvedAssembly& solved) {
    MovedBodies moved;
    for (std::size_t i = 0; i < solved.grids.size(); ++i) {
        solver::RigidMotion motion = rigid_motion_of(solved, i);
        if (motions_left_to_contacts(solved, i).empty() && !is_led(scene, solved, i)) motion = {{0, 0}, 0, motion.center};
        moved.motions.push_back(motion);
    }
    moved.lines = moved_forces(scene, solved, moved.motions);
    return moved;
}

/// Where a line's force has moved to; that of flat faces goes with the body that goes farther, and its loads.
Vec2 taken_along(const SolvedAssembly& solved, const MovedBodies& moved, const MovedForce& line) {
    if (!line.any_place) return line.moved;
    const auto goes = [&](std::size_t side) {
        return moved.motions[at(solved.contacts[line.contact].face.part[side])].at(line.drawn);
    };
    return line.drawn + (goes(0).norm() > goes(1).norm() ? goes(0) : goes(1));
}

/// Does a part bear the moment of its contacts' forces alone?
bool bears_moments(const Scene& scene, const SolvedAssembly& solved, std::size_t grid) {
    const std::vector<solver::RigidMotion> free = motions_left_to_contacts(solved, grid);
    const double size = solved.grids[grid].size;
    return !solved.grids[grid].input.axis && !is_half(scene, solved, grid) &&
           std::none_of(free.begin(), free.end(),
                        [&](const solver::RigidMotion& m) { return std::abs(m.rotation) * size > known_places; });
}

LeverChange lever_change(const Scene& scene, const SolvedAssembly& solved, const MovedBodies& bodies, std::size_t grid) {
    const solver::RigidMotion& motion = bodies.motions[grid];
    const Vec2 center = motion.center, moved_center = center + motion.translation;
    double drawn = 0, moved = 0, forces = 0, known = 0;
    for (const MovedForce& l : bodies.lines)
        for (const int side : {0, 1}) {
            if (at(solved.contacts[l.contact].face.part[at(side)]) != grid) continue;
            const double sign = side == 0 ? 1 : -1;
            drawn += sign * cross(l.drawn - center, l.force);
            moved += sign * cross(taken_along(solved, bodies, l) - moved_center, l.turned);
            forces += l.force.norm();
            known += (known_within_contact * 0.5 * length_of(solved.stretches[l.contact]) + l.along.norm()) * l.force.norm();
        }
    const double change = std::abs(moved - drawn), all = forces * solved.grids[grid].size;
    if (change <= known) return {};
    if (!are_led(scene)) return {change > noted_places * all ? change / all : 0};
    const bool is_small = change <= known_places * all || std::max(change, std::abs(drawn)) <= next_to_nothing * all;
    return {is_small && !is_led(scene, solved, grid) ? 0 : std::min(1.0, change / std::abs(drawn)), true};
}

}  // namespace

std::vector<LeverChange> lever_changes(const Scene& scene, const SolvedAssembly& solved) {
    const MovedBodies moved = moved_bodies(scene, solved);
    std::vector<LeverChange> changes(solved.grids.size());
    for (std::size_t i = 0; i < changes.size(); ++i)
        if (bears_moments(scene, solved, i)) changes[i] = lever_change(scene, solved, moved, i);
    return changes;
}

}  // namespace abut
