// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/penalty_interface.hpp"

#include <algorithm>

#include "geometry/curves/gauss.hpp"
#include "src/scene/scene.hpp"
#include "src/solution/contact_pairing.hpp"

namespace abut {

namespace {

/// Pressure per penetration at a pair of points.
double stiffness_at(const Scene& scene, const PartOnGrid& first, const PartOnGrid& second, const geometry::FacingPair& pair) {
    const PenaltyOptions& penalty = *scene.contacts.penalty;
    const double c1 = compliance(scene, first), c2 = compliance(scene, second);
    const double stiffer = 1 / (first.is_rigid || second.is_rigid ? std::max(c1, c2) : std::min(c1, c2));
    if (penalty.length) return penalty.factor * stiffer / *penalty.length;
    // a rigid part has no cells to take the length from
    const double length = first.is_rigid ? cell_size(second, pair.on2) : cell_size(first, pair.on1);
    return penalty.factor * stiffer / length;
}

/// Pairs along the zone, one call for every place in ascending order.
class Partners {
public:
    Partners(const Scene& scene, const ContactInterface& c) : scene_(scene), c_(c), guess_(c.zone.begin2) {}
    geometry::FacingPair at(double s1) {
        const geometry::FacingPair pair =
            paired(part_of(scene_, c_.part[0]), part_of(scene_, c_.part[1]), c_.zone, c_.pairing, s1, guess_);
        if (pair.found) guess_ = pair.s2;
        return pair;
    }
    double guess() const { return guess_; }

private:
    const Scene& scene_;
    const ContactInterface& c_;
    double guess_;
};

/// Where the first part's own cells along the zone begin and end.
std::vector<double> master_crossings(const PartOnGrid& first, const geometry::FacingZone& z) {
    std::vector<double> places = crossings(first, z.chain1, z.begin1, z.end1);
    places.push_back(z.begin1);
    places.push_back(z.end1);
    return without_short_pieces(std::move(places), z.end1 - z.begin1);
}

/// Pieces that are integrated, and the table against the interface's own arc length: the first part's from the zone's begin.
void make_table(const Scene& scene, const PartOnGrid& first, const PartOnGrid& second, ContactInterface& c) {
    const geometry::FacingZone& z = c.zone;
    c.s1 = scene.contacts.penalty->split_by_second ? crossings_of_both(scene, z, first, second) : master_crossings(first, z);
    Partners partners(scene, c);
    for (double s1 : c.s1) {
        partners.at(s1);
        c.s.push_back(s1 - z.begin1);
        c.s2.push_back(partners.guess());
    }
}

}  // namespace

ContactInterface make_penalty_interface(const Scene& scene, const geometry::FacingZone& zone, const PartOnGrid& first,
                                        const PartOnGrid& second, std::array<int, 2> solver_part, const GapRule& rule) {
    ContactInterface c;
    c.drawn = rule;
    c.part = {first.part, second.part};
    c.zone = zone;
    c.pairing = scene.contacts.penalty->pairing;
    make_table(scene, first, second, c);
    c.face.part = solver_part;
    c.face.thickness = std::min(first.input.thickness, second.input.thickness);
    c.face.periodic = zone.closed;
    const solver::SplineSpace& space = first.input.space;
    const auto& gauss = geometry::gauss_rule(std::max(space.x.degree, space.y.degree) + 1);
    Partners partners(scene, c);
    for (std::size_t k = 0; k + 1 < c.s1.size(); ++k) {
        const double length = c.s1[k + 1] - c.s1[k];
        for (std::size_t q = 0; q < gauss.points.size(); ++q) {
            const double s1 = c.s1[k] + gauss.points[q] * length;
            const geometry::FacingPair pair = partners.at(s1);
            if (!pair.found) continue;
            append_point(c, pair, first, second, s1 - zone.begin1, gauss.weights[q] * length * pair.length_rate);
            c.face.penalty.push_back(stiffness_at(scene, first, second, pair));
        }
    }
    c.face.pressure = solver::polyline_knots(c.face.points, 0, c.s.back());
    c.foundation = winkler_stiffness(scene, first, second);
    return c;
}

}  // namespace abut
