// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/contact/candidate_faces.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/interfaces/facing_edges.hpp"
#include "geometry/interfaces/interface_kind.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

using geometry::Chain;
using geometry::ClosestPoints;
using geometry::FacingPair;
using geometry::Part;

/// Shares that differ by less are equal but for rounding: the first one counts, however the assembly lies.
constexpr double equal_shares = 1e-9;
/// Two faces farther from parallel than this make contact at a corner, not along a face (cosine of 1 degree).
constexpr double least_flush = 0.99985;

geometry::ScrewScale scale_of(const Part& first, const Part& second) {
    geometry::Box2 box = bounding_box(first);
    box.extend(bounding_box(second));
    return {box.center(), box.diagonal()};
}

/// A chain's end at a corner of the part: edge and parameter.
struct ChainEnd {
    int edge;
    double t;
};
ChainEnd snapped(const Chain& chain, double s, const geometry::ChainPoint& p, double tolerance) {
    if (!chain.closed && s <= tolerance) return {chain.edges.front(), 0};
    if (!chain.closed && s >= chain.length - tolerance) return {chain.edges.back(), 1};
    return {p.edge, p.t};
}

/// The end of the zone where a corner meets a face, if its faces come closest there.
std::optional<ClosestPoints> corner_of(const Scene& scene, const Candidate& c) {
    const Part &first = part_of(scene, c.first), &second = part_of(scene, c.second);
    const double touching = touching_length(first, second);
    if (c.zone.closed) return std::nullopt;
    for (const auto& [s1, guess] : {std::pair(c.zone.begin1, c.zone.begin2), std::pair(c.zone.end1, c.zone.end2)}) {
        const FacingPair p = pair_from_first(first, second, c.zone, s1, guess);
        if (p.gap > c.zone.gap_min + touching || -p.on1.normal.dot(p.on2.normal) >= least_flush) continue;
        const ChainEnd end1 = snapped(c.zone.chain1, p.s1, p.on1, touching),
                       end2 = snapped(c.zone.chain2, p.s2, p.on2, touching);
        if (is_convex_corner(first, end1.edge, end1.t) || is_convex_corner(second, end2.edge, end2.t))
            return ClosestPoints{p.gap, end1.edge, end2.edge, end1.t, end2.t, p.on1.x, p.on2.x};
    }
    return std::nullopt;
}

std::string kind_at(const Scene& scene, const Candidate& c, const ClosestPoints& corner) {
    return corner_interface(part_of(scene, c.first), corner.edge1, corner.t1, part_of(scene, c.second), corner.edge2,
                            corner.t2);
}

std::array<int, 2> longest(const std::map<std::array<int, 2>, double>& lengths) {
    double most = 0;
    for (const auto& [edges, length] : lengths) most = std::max(most, length);
    const auto carries = [&](const auto& share) { return share.second >= (1 - equal_shares) * most; };
    return std::find_if(lengths.begin(), lengths.end(), carries)->first;
}

FunctionalInterface bonded_interface(const geometry::FacingEdges& stretch) {
    FunctionalInterface result;
    result.kind = "bonded";
    result.at = 0.5 * (stretch.ends[0] + stretch.ends[1]);
    result.wrenches = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return result;
}

}  // namespace

std::string name_of_edge(const ScenePart& part, int edge) {
    return part.name + "/" + part.part.edges[static_cast<std::size_t>(edge)].name;
}

std::array<std::vector<std::string>, 2> edge_names(const Scene& scene, const Candidate& c, const CandidateFaces& faces) {
    constexpr double least_share = 1e-3;  // of the facing length: less is rounding next to the ends of others
    const std::array<int, 2> part{c.first, c.second};
    std::array<std::vector<std::string>, 2> names;
    double whole = 0;
    for (const auto& [edges, length] : faces.lengths) whole += length;
    for (std::size_t side = 0; side < 2; ++side) {
        std::map<int, double> lengths;
        for (const auto& [edges, length] : faces.lengths) lengths[edges[side]] += length;
        for (const auto& [edge, length] : lengths)
            if (edge == faces.carrying[side] || length > least_share * whole)
                names[side].push_back(name_of_edge(scene_part(scene, part[side]), edge));
    }
    return names;
}

std::optional<std::string> corner_kind(const Scene& scene, const Candidate& candidate) {
    const std::optional<ClosestPoints> corner = corner_of(scene, candidate);
    return corner ? std::optional(kind_at(scene, candidate, *corner)) : std::nullopt;
}

FunctionalInterface functional_at_corner(const Scene& scene, int first, int second, const ClosestPoints& at,
                                         const std::string& kind) {
    const Part &a = part_of(scene, first), &b = part_of(scene, second);
    return functional_interface(a, b, kind, {{at.edge1, at.edge2, {at.x1, at.x1}, 0, at.distance}}, scale_of(a, b));
}

CandidateFaces faces_of(const Scene& scene, const Candidate& c) {
    const Part &first = part_of(scene, c.first), &second = part_of(scene, c.second);
    const double touching = touching_length(first, second);
    CandidateFaces faces;
    std::vector<geometry::FacingEdges> stretches;
    for (const geometry::ZonePiece& piece : zone_pieces(first, second, c.zone)) {
        const double length = piece.end1 - piece.begin1;
        faces.lengths[{piece.edge1, piece.edge2}] += length;
        stretches.push_back(facing_edges(first, second, c.zone, piece));
        if (std::max(std::abs(piece.gap_min), std::abs(piece.gap_max)) <= touching) faces.shared_length += length;
    }
    if (stretches.empty()) return faces;
    faces.carrying = longest(faces.lengths);
    put_first(stretches, faces.carrying[0], faces.carrying[1]);
    const std::optional<ClosestPoints> corner = corner_of(scene, c);
    faces.kind =
        corner ? kind_at(scene, c, *corner) : geometry::interface_kind(first, faces.carrying[0], second, faces.carrying[1]);
    if (c.bonded)
        faces.functional = bonded_interface(stretches.front());
    else if (corner)
        faces.functional = functional_at_corner(scene, c.first, c.second, *corner, faces.kind);
    else
        faces.functional = functional_interface(first, second, faces.kind, stretches, scale_of(first, second));
    return faces;
}

}  // namespace abut
