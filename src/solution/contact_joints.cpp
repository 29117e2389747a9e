// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_joints.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"
#include "src/solution/table.hpp"

namespace abut {

namespace {

/// Of the larger curvature: circles that CAD has cut to pieces go on alike. And of the gap's: where it bends before nearly as
/// much as after, the pressure is hardly any steeper.
constexpr double least_change = 1e-3, least_share_of_gap = 0.5;

struct ChainJoint {
    double s;              // on the chain
    double before, after;  // curvatures, along the chain
};

std::vector<ChainJoint> joints_of(const geometry::Part& part, const geometry::Chain& chain) {
    std::vector<ChainJoint> joints;
    const std::size_t n = chain.edges.size();
    for (std::size_t k = chain.closed ? 0 : 1; k < n && n > 1; ++k) {
        const double before = curvature(part.edges[at(chain.edges[(k + n - 1) % n])].curve, 1);
        const double after = curvature(part.edges[at(chain.edges[k])].curve, 0);
        if (std::abs(after - before) > least_change * std::max(std::abs(after), std::abs(before)))
            joints.push_back({chain.begin[k], before, after});
    }
    return joints;
}

}  // namespace

std::vector<ContactJoint> contact_joints(const Scene& scene, const ContactInterface& contact) {
    std::vector<ContactJoint> joints;
    for (std::size_t side : {0u, 1u}) {
        const geometry::Chain& chain = side == 0 ? contact.zone.chain1 : contact.zone.chain2;
        // the second chain runs the other way; both ascend like this
        const double sign = side == 0 ? 1 : -1;
        std::vector<double> along;
        for (double s : side == 0 ? contact.s1 : contact.s2) along.push_back(sign * s);
        for (const ChainJoint& joint : joints_of(scene.parts[at(contact.part[side])].part, chain)) {
            double s = sign * joint.s;
            if (chain.closed) s += chain.length * std::ceil((along.front() - s) / chain.length);
            if (!(s > along.front() && s < along.back())) continue;
            const double middle = interpolate(along, contact.s, s);
            const geometry::FacingPair pair = pair_at(scene, contact, middle);
            if (!pair.found) continue;
            // the gap's second derivative is the sum of both curvatures
            const double partner = side == 0 ? pair.on2.curvature : pair.on1.curvature;
            const double largest = std::max(std::abs(joint.before + partner), std::abs(joint.after + partner));
            const double opening = sign * (joint.after - joint.before);
            if (std::abs(opening) >= least_share_of_gap * largest)
                joints.push_back({middle, {pair.on1.x, pair.on2.x}, opening});
        }
    }
    std::sort(joints.begin(), joints.end(), [](const ContactJoint& a, const ContactJoint& b) { return a.s < b.s; });
    return joints;
}

}  // namespace abut
