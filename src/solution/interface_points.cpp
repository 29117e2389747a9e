// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/interface_points.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"

namespace abut {

namespace {

using geometry::Chain;
using geometry::FacingPair;

/// Linear interpolation between the zone's ends: a first guess.
double guess1(const geometry::FacingZone& z, double s2) {
    return z.begin1 + (s2 - z.begin2) / (z.end2 - z.begin2) * (z.end1 - z.begin1);
}

}  // namespace

std::vector<double> crossings(const PartOnGrid& g, const Chain& chain, double low, double high) {
    std::vector<double> found;
    for (std::size_t k = 0; k < chain.edges.size(); ++k) {
        const int e = chain.edges[k];
        const geometry::Curve& curve = g.local.edges[at(e)].curve;
        for (int i = g.cells.first_piece[at(e)]; i < g.cells.first_piece[at(e) + 1]; ++i) {
            double v = chain.begin[k] + length(curve, 0, g.cells.pieces[at(i)].t0);
            if (chain.closed) {
                const double turns = std::ceil((low - v) / chain.length);
                v += turns * chain.length;
            }
            for (; v < high; v += chain.length) {
                if (v > low) found.push_back(v);
                if (!chain.closed) break;
            }
        }
    }
    return found;
}

std::vector<double> crossings_of_both(const Scene& scene, const geometry::FacingZone& z, const PartOnGrid& first,
                                      const PartOnGrid& second) {
    std::vector<double> b = crossings(first, z.chain1, z.begin1, z.end1);
    const geometry::Part &p1 = scene.parts[at(first.part)].part, &p2 = scene.parts[at(second.part)].part;
    for (double s2 : crossings(second, z.chain2, std::min(z.begin2, z.end2), std::max(z.begin2, z.end2))) {
        const FacingPair pair = pair_from_second(p1, p2, z, s2, guess1(z, s2));
        if (pair.found && pair.s1 > z.begin1 && pair.s1 < z.end1) b.push_back(pair.s1);
    }
    b.push_back(z.begin1);
    b.push_back(z.end1);
    return without_short_pieces(std::move(b), z.end1 - z.begin1);
}

std::vector<double> without_short_pieces(std::vector<double> places, double whole) {
    std::sort(places.begin(), places.end());
    const double shortest = shortest_piece * whole;
    std::vector<double> kept{places.front()};
    for (double v : places)
        if (v - kept.back() > shortest) kept.push_back(v);
    if (kept.size() > 1 && places.back() - kept.back() < shortest) kept.back() = places.back();
    return kept;
}

double cell_size(const PartOnGrid& g, const geometry::ChainPoint& p) {
    return g.cells.grid.box(piece_at(g.cells, p.edge, p.t).cell).size().maxCoeff();
}

double compliance(const Scene& scene, const PartOnGrid& g) {
    if (g.is_rigid) return 0;
    return 1 / scene.materials[at(scene.parts[at(g.part)].material)].E;
}

void append_point(ContactInterface& c, const FacingPair& pair, const PartOnGrid& first, const PartOnGrid& second, double s,
                  double weight) {
    solver::InterfacePoint p;
    p.s = s;
    // around an axis: the radius midway, the same for both, so that what one presses the other feels
    p.weight = first.input.axis ? weight * 0.5 * (pair.on1.x.x() + pair.on2.x.x()) : weight;
    p.gap = c.drawn.of(pair.gap);
    p.element = {element_of(first, pair.on1), element_of(second, pair.on2)};
    p.x = {first.frame.to_local(pair.on1.x), second.frame.to_local(pair.on2.x)};
    p.normal = {first.frame.vector_to_local(pair.normal), second.frame.vector_to_local(pair.normal)};
    c.face.points.push_back(p);
    // a corner has the normal of what it stands on
    const Vec2 own1 = c.zone.at_corner[0] ? pair.normal : pair.on1.normal,
               own2 = c.zone.at_corner[1] ? Vec2(-pair.normal) : pair.on2.normal;
    c.own_normals.push_back({first.frame.vector_to_local(own1), second.frame.vector_to_local(own2)});
}

double winkler_stiffness(const Scene& scene, const PartOnGrid& first, const PartOnGrid& second) {
    const double depth = 0.1 * std::max(first.size, second.size);
    return 1 / ((compliance(scene, first) + compliance(scene, second)) * depth);
}

}  // namespace abut
