// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: body 1 has its outward normal n towards body 2, k1 and k2 are their curvatures (positive convex), a1 and a2 how far
// the contact moves along t, n turned right, on either body. Where bodies turn by w1 and w2 and move against each other along t
// by d, a1 = d + a2 and w1 - k1 a1 = w2 + k2 a2, both the angle that the normal turns by:
//
//   (k1 w2 + k2 w1 - k1 k2 d) / (k1 + k2).
#include "src/analysis/turned_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

/// Forces are known to about a tenth of what pressures are.
constexpr double noted_turn = 0.5;  // of the target

struct Turned {
    double normal = 0, lever = 0;  ///< radians; the lever's turn over the coefficient of friction
};

Turned turned_at(const geometry::FacingPair& pair, const solver::RigidMotion& m1, const solver::RigidMotion& m2,
                 double friction) {
    const double k1 = pair.on1.curvature, k2 = pair.on2.curvature;
    if (k1 < 0 || k2 < 0 || k1 + k2 == 0) return {};  // hollow and flat faces: pressure moves along them as it has to
    const Vec2 along = -geometry::left_of(pair.normal);
    const double slide = (m2.at(pair.on2.x) - m1.at(pair.on1.x)).dot(along);
    Turned turned;
    turned.normal = std::abs(k1 * m2.rotation + k2 * m1.rotation - k1 * k2 * slide) / (k1 + k2);
    if (friction > 0) turned.lever = std::abs(m1.rotation - m2.rotation) / friction;
    return turned;
}

}  // namespace

void warn_of_turned_contacts(const Scene& scene, const Outcome& out, Result& result) {
    const SolvedAssembly& solved = out.solved;
    const double noted = noted_turn * out.target;
    double largest = 0;
    for (const ContactResult& c : result.contacts) largest = std::max(largest, c.force.norm());
    std::vector<Finding> normals, levers;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (solved.runs[k].empty() || c.face.bilateral) continue;
        const ContactRun& run = solved.runs[k].front();
        const geometry::FacingPair pair = pair_at(scene, c, 0.5 * (run.begin + run.end));
        if (!pair.found) continue;
        const Turned turned = turned_at(pair, rigid_motion_of(solved, at(c.face.part[0])),
                                        rigid_motion_of(solved, at(c.face.part[1])), out.candidates[k].friction);
        const std::string number = contact_number(k), advice = "; draw the parts nearer to where they come to rest";
        const double share = result.contacts[k].force.norm() / largest;
        if (share * turned.normal > noted)
            normals.push_back(
                {turned.normal, "contact " + number,
                 "parts move so far that the force of contact " + number + " turns by " + percent_text(turned.normal) +
                     " of itself, which the answer leaves out: forces may be off by more than their errors say" + advice,
                 "the force of contact " + number + " turns by " + percent_text(turned.normal) + " of itself as parts move"});
        if (share * turned.lever > noted)
            levers.push_back(
                {turned.lever, "contact " + number,
                 "a round part turns so far that friction in contact " + number + " seems to bear a moment that is " +
                     percent_text(turned.lever) + " too large" + advice,
                 "friction in contact " + number + " bears a moment that is " + percent_text(turned.lever) + " too large"});
    }
    tell(std::move(normals), "turned_force", result);
    tell(std::move(levers), "turned_lever", result);
}

}  // namespace abut
