// SPDX-License-Identifier: GPL-3.0-or-later
// Small displacements change gaps along the normals that were found where parts are drawn. Of a round part in a hollow, radii r
// and R, whose centre lies e from the hollow's and comes to rest at c n, c = R - r, that leaves out terms of the second order:
// along its radii, at the angle f from n,
//
//   drawn gap + motion = c - a cos f - (e x n(f))^2 / (2 R),    a = (e + motion) . n,
//
// over a middle curve of the radius (r + R - e.n) / 2, where the gap at rest is c (1 - cos f) - (c sin f)^2 / (2 R), over r.
// Two things err. The same force is spread over the longer curve: pressures are lower by the share it is longer by. And the
// gap's curvature k is another: by half planes (Hertz) a change dk, which opens the ends of a contact of half width b by dk b^2
// / 2, changes the largest pressure p under the same force by E* b dk / 4; a part that is thinner than b bends by that, which
// takes a share of some (width / b)^3 of this pressure: a belt lies on any drum. Lengths and curvatures are measured, so that
// this holds of any two faces: both gaps in the middle and at both ends of what is closed.
#include "src/analysis/moved_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "src/analysis/placed_pairs.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

struct PairedAt {
    Vec2 middle, normal;
    double gap;
};

using Stretch = std::array<PairedAt, 3>;  // its ends, and its middle between them

std::array<double, 2> halves_of(const Stretch& g) {
    return {(g[1].middle - g[0].middle).norm(), (g[2].middle - g[1].middle).norm()};
}

/// Of the gap over halves of these lengths. What closes it in the middle is a motion along the normal there.
double curvature_of(const Stretch& g, const std::array<double, 2>& halves) {
    const auto opened = [&](const PairedAt& end) { return end.gap - g[1].gap * end.normal.dot(g[1].normal); };
    return 2 * (opened(g[0]) / halves[0] + opened(g[2]) / halves[1]) / (halves[0] + halves[1]);
}

/// What the pairs as drawn have too much, beside those where the parts have moved to: length of the middle curve, relative, and
/// curvature of the gap. None where pairs are not found.
struct Excess {
    double length = 0, curvature = 0;
};
Excess excess_of(const Scene& scene, const ContactInterface& c, const PressedStretch& stretch, const PlacedFaces& faces) {
    Stretch drawn, moved;
    for (std::size_t k = 0; k < 3; ++k) {
        const geometry::FacingPair p =
            pair_at(scene, c, stretch.begin + 0.5 * static_cast<double>(k) * (stretch.end - stretch.begin));
        if (!p.found || (p.on1.curvature == 0 && p.on2.curvature == 0)) return {};  // flat faces stay so
        drawn[k] = {0.5 * (p.on1.x + p.on2.x), p.normal, p.gap + opening(faces, p)};
        const geometry::FacingPair q = placed_pair(c, faces, p);
        if (!q.found) return {};
        moved[k] = {0.5 * (q.on1.x + q.on2.x), q.normal, q.gap};
    }
    const std::array<double, 2> before = halves_of(drawn), now = halves_of(moved);
    return {(before[0] + before[1]) / (now[0] + now[1]) - 1, curvature_of(drawn, now) - curvature_of(moved, now)};
}

/// A part's mean width; one that does not deform does not bend.
double width_of(const Scene& scene, const SolvedAssembly& solved, int part) {
    const PartOnGrid& grid = solved.grids[at(part)];
    if (grid.is_rigid) return std::numeric_limits<double>::infinity();
    return 2 * grid.area / geometry::perimeter(scene.parts[at(grid.part)].part);
}

}  // namespace

std::vector<double> moved_pair_errors(const Scene& scene, const SolvedAssembly& solved) {
    std::vector<double> errors(solved.contacts.size(), 0.0);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (solved.stretches[k].empty() || c.face.bilateral || c.pairing != Pairing::middle) continue;
        const double compliance = compliance_of(solved, k), largest = pressure_of(solved, k).maxCoeff();
        if (compliance == 0) continue;
        const PlacedFaces faces = placed_faces(scene, solved, k);
        const double width = std::min(width_of(scene, solved, c.face.part[0]), width_of(scene, solved, c.face.part[1]));
        for (const PressedStretch& stretch : solved.stretches[k]) {
            const Excess more = excess_of(scene, c, stretch, faces);
            const double half = 0.5 * (stretch.end - stretch.begin), bends = std::min(1.0, std::pow(width / half, 3)),
                         error = std::abs(bends * half * more.curvature / (4 * compliance * largest) - more.length);
            if (std::isfinite(error)) errors[k] = std::max(errors[k], error);
        }
    }
    return errors;
}

}  // namespace abut
