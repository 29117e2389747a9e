// SPDX-License-Identifier: GPL-3.0-or-later
// A contact of convex bodies. Symbols: body 1 has its outward normal n towards body 2, k1 and k2 are their curvatures (positive
// convex), a1 and a2 how far the contact moves along t, n turned right, on either body. Where bodies turn by w1 and w2 and move
// against each other along t by d, a1 = d + a2 and w1 - k1 a1 = w2 + k2 a2, both the angle that the normal turns by:
//
//   (k1 w2 + k2 w1 - k1 k2 d) / (k1 + k2),    a2 = (w1 - w2 - k1 d) / (k1 + k2).
//
// Small displacements have moved the contact along already: by what the faces are inclined to each other as drawn where they
// press, which adds to the angles that their bodies turn by.
//
// In a hollow face the pressure moves along as it has to: a joint about the centre of the body inside. Flat faces give their
// force to any place within them.
#include "src/analysis/moved_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/analysis/face_motion.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

using geometry::cross, geometry::left_of;

/// Faces that make a larger angle where they meet have a corner there; fillets, however small, turn by less within a contact.
constexpr double meeting_angle = 0.1;

/// How far body 1 has the contact move along t, and the angle that the normal turns by.
struct Rolled {
    double along = 0, angle = 0;
};

/// Of convex bodies; a corner's curvature may be infinite.
Rolled rolled(double k1, double k2, double w1, double w2, double d) {
    if (std::isinf(k1)) return {0, w2 - k2 * d};
    if (std::isinf(k2)) return {d, w1 - k1 * d};
    const double sum = k1 + k2;
    return {d + (w1 - w2 - k1 * d) / sum, (k1 * w2 + k2 * w1 - k1 * k2 * d) / sum};
}

Vec2 turned_by(const Vec2& v, double angle) {
    return v * std::cos(angle) + left_of(v) * std::sin(angle);
}

double angle_between(const Vec2& from, const Vec2& to) {
    return std::atan2(cross(from, to), from.dot(to));
}

MovedForce moved_force(const ContactInterface& c, const geometry::FacingPair& pair, const Vec2& force, double pressing,
                       const solver::RigidMotion& m1, const solver::RigidMotion& m2, bool has_friction) {
    const double k1 = pair.on1.curvature, k2 = pair.on2.curvature;
    MovedForce line{0, pair.on1.x, pair.on1.x, force, force, has_friction};
    if (k1 < 0 || k2 < 0) {
        const double inner = k1 < 0 ? k2 : k1;
        if (inner > 0) line.drawn += (k1 < 0 ? 1 : -1) / inner * pair.normal;
        if (inner > 0) line.virial = (k1 < 0 ? 1 : -1) / inner * pressing;
        line.moved = line.drawn + (k1 < 0 ? m2 : m1).at(line.drawn);
        line.any_direction = true;
    } else if (k1 + k2 == 0 || c.face.bilateral) {
        const double angle = 0.5 * (m1.rotation + m2.rotation);
        line.moved += 0.5 * (m1.at(line.drawn) + m2.at(line.drawn));
        line.normal = turned_by(pair.normal, angle);
        line.turned = turned_by(force, angle);
        line.any_place = true;
        line.any_direction = has_friction || c.face.bilateral;
    } else {
        const Vec2 along = -left_of(pair.normal);
        const double slide = (m2.at(pair.on2.x) - m1.at(pair.on1.x)).dot(along);
        const double drawn1 = angle_between(pair.normal, pair.on1.normal),
                     drawn2 = angle_between(pair.normal, -pair.on2.normal);
        const Rolled r = rolled(k1, k2, drawn1 + m1.rotation, drawn2 + m2.rotation, slide);
        // no farther than the faces go
        const double most = std::min(c.zone.chain1.length, c.zone.chain2.length);
        line.along = std::clamp(rolled(k1, k2, drawn1, drawn2, 0).along, -most, most) * along;
        line.moved += m1.at(line.drawn) + std::clamp(r.along, -most, most) * along;
        line.turned = turned_by(force, r.angle);
        line.normal = turned_by(pair.normal, r.angle);
    }
    return line;
}

/// The force of a stretch under pressure on its first part, and the pair in its middle.
struct StretchForce {
    std::size_t contact;
    geometry::FacingPair pair;
    double half_length;
    Vec2 force;
    double pressing;  ///< the integral of the pressure
    bool has_friction;
};

std::vector<StretchForce> stretch_forces(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<StretchForce> forces;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        const std::vector<PressedStretch>& stretches = solved.stretches[k];
        for (const PressedStretch& stretch : stretches) {
            const geometry::FacingPair pair = pair_at(scene, c, 0.5 * (stretch.begin + stretch.end));
            if (!pair.found) continue;
            const Vec2 force = stretches.size() == 1 ? contact_force(solved, k).force
                                                     : contact_force_between(solved, k, stretch.begin, stretch.end).force;
            forces.push_back({k, pair, 0.5 * (stretch.end - stretch.begin), force,
                              stretches.size() == 1 ? pressing_force(solved, k) : force.norm(), friction_of(solved, k) > 0});
        }
    }
    return forces;
}

/// Two faces that meet in a corner of one body press the same place of the other: what each of them bears is no matter of where
/// bodies have moved to, but what both bear together, along the other's normal. False: they do not meet, and stay.
bool join_at_corner(const SolvedAssembly& solved, const StretchForce& other, StretchForce& to) {
    if (solved.contacts[other.contact].part != solved.contacts[to.contact].part || solved.contacts[to.contact].face.bilateral)
        return false;
    if ((other.pair.on1.x - to.pair.on1.x).norm() > 2 * (other.half_length + to.half_length)) return false;
    const double turn1 = std::abs(angle_between(other.pair.on1.normal, to.pair.on1.normal)),
                 turn2 = std::abs(angle_between(other.pair.on2.normal, to.pair.on2.normal));
    // where the other body turns, too, it has a corner of its own in this one's: it rests on two faces
    if (std::max(turn1, turn2) <= meeting_angle || std::min(turn1, turn2) > 0.5 * std::max(turn1, turn2)) return false;
    const Vec2 force = other.force + to.force;
    if (other.force.norm() > to.force.norm()) to = other;
    to.force = force;
    (turn1 > turn2 ? to.pair.on1 : to.pair.on2).curvature = std::numeric_limits<double>::infinity();
    to.pair.normal = turn1 > turn2 ? Vec2(-to.pair.on2.normal) : to.pair.on1.normal;
    return true;
}

/// motion: of a contact's side.
template <class MotionOf>
std::vector<MovedForce> moved_by(const Scene& scene, const SolvedAssembly& solved, const MotionOf& motion) {
    std::vector<StretchForce> forces;
    for (const StretchForce& f : stretch_forces(scene, solved))
        if (std::none_of(forces.begin(), forces.end(), [&](StretchForce& to) { return join_at_corner(solved, f, to); }))
            forces.push_back(f);
    std::vector<MovedForce> lines;
    for (const StretchForce& f : forces) {
        lines.push_back(moved_force(solved.contacts[f.contact], f.pair, f.force, f.pressing, motion(f.contact, 0),
                                    motion(f.contact, 1), f.has_friction));
        lines.back().contact = f.contact;
    }
    return lines;
}

}  // namespace

std::vector<MovedForce> moved_forces(const Scene& scene, const SolvedAssembly& solved,
                                     const std::vector<solver::RigidMotion>& motions) {
    return moved_by(scene, solved, [&](std::size_t contact, std::size_t side) {
        return motions[at(solved.contacts[contact].face.part[side])];
    });
}

std::vector<MovedForce> moved_forces(const Scene& scene, const SolvedAssembly& solved) {
    return moved_by(scene, solved, [&](std::size_t contact, std::size_t side) { return face_motion(solved, contact, side); });
}

}  // namespace abut
