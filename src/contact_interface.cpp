// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: s1, s2 arc lengths on the two chains, s on the middle curve; a piece is a stretch without a grid line or a knot
// inside.
#include "src/contact_interface.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/gauss.hpp"

namespace abut {

namespace {

using geometry::Chain;
using geometry::FacingPair;
using geometry::FacingZone;

constexpr int points_per_piece = 3;
constexpr int min_intervals = 4;
/// Pieces shorter than this fraction of the zone are rounding between crossings that coincide.
constexpr double shortest_piece = 1e-9;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

const geometry::Part& part_of(const Scene& scene, int part) {
    return scene.parts[at(part)].part;
}

/// Arc lengths on a chain where its part's grid lines cross it or its edges meet, within [low, high] (which may run past a
/// turn).
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

/// Linear interpolation of a partner's arc length between the zone's ends: a first guess.
double guess2(const FacingZone& z, double s1) {
    return z.begin2 + (s1 - z.begin1) / (z.end1 - z.begin1) * (z.end2 - z.begin2);
}
double guess1(const FacingZone& z, double s2) {
    return z.begin1 + (s2 - z.begin2) / (z.end2 - z.begin2) * (z.end1 - z.begin1);
}

std::vector<double> breakpoints(const Scene& scene, const FacingZone& z, const PartOnGrid& first, const PartOnGrid& second) {
    std::vector<double> b = crossings(first, z.chain1, z.begin1, z.end1);
    const geometry::Part &p1 = part_of(scene, first.part), &p2 = part_of(scene, second.part);
    for (double s2 : crossings(second, z.chain2, std::min(z.begin2, z.end2), std::max(z.begin2, z.end2))) {
        const FacingPair pair = pair_from_second(p1, p2, z, s2, guess1(z, s2));
        if (pair.found && pair.s1 > z.begin1 && pair.s1 < z.end1) b.push_back(pair.s1);
    }
    b.push_back(z.begin1);
    b.push_back(z.end1);
    std::sort(b.begin(), b.end());
    const double shortest = shortest_piece * (z.end1 - z.begin1);
    std::vector<double> kept{b.front()};
    for (double v : b)
        if (v - kept.back() > shortest) kept.push_back(v);
    if (kept.size() > 1 && z.end1 - kept.back() < shortest) kept.back() = z.end1;
    return kept;
}

/// Size of the cell around a boundary point, along the boundary.
double size_along(const PartOnGrid& g, const geometry::ChainPoint& p) {
    const geometry::Grid& grid = g.cells.grid;
    const int cell = piece_at(g.cells, p.edge, p.t).cell;
    const auto i = at(grid.column_of(cell)), j = at(grid.row_of(cell));
    const Vec2 t = g.frame.vector_to_local(p.tangent);
    return 1 / Vec2(t.x() / (grid.x[i + 1] - grid.x[i]), t.y() / (grid.y[j + 1] - grid.y[j])).norm();
}

double compliance(const Scene& scene, const PartOnGrid& g) {
    return 1 / scene.materials[at(scene.parts[at(g.part)].material)].E;
}

struct Piece {
    double begin1, end1;
    double length;  // on the middle curve
    double size;    // wanted knot spacing
};

std::vector<Piece> measure(const Scene& scene, const ContactInterface& c, const PartOnGrid& first, const PartOnGrid& second) {
    const std::vector<double> b = breakpoints(scene, c.zone, first, second);
    const double c1 = compliance(scene, first), c2 = compliance(scene, second);
    const auto& rule = geometry::gauss_rule(points_per_piece);
    std::vector<Piece> pieces;
    double partner = c.zone.begin2;
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
        Piece piece{b[k], b[k + 1], 0, 0};
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double s1 = b[k] + rule.points[q] * (b[k + 1] - b[k]);
            const FacingPair pair =
                pair_from_first(part_of(scene, first.part), part_of(scene, second.part), c.zone, s1, partner);
            if (!pair.found) continue;
            partner = pair.s2;
            piece.length += rule.weights[q] * (b[k + 1] - b[k]) * pair.stretch;
            if (q != rule.points.size() / 2) continue;
            double size = std::numeric_limits<double>::infinity();
            if (c1 >= compliance_share * (c1 + c2)) size = size_along(first, pair.on1);
            if (c2 >= compliance_share * (c1 + c2)) size = std::min(size, size_along(second, pair.on2));
            piece.size = multiplier_spacing * size;
        }
        if (piece.length > 0 && piece.size > 0) pieces.push_back(piece);
    }
    return pieces;
}

/// Knots at equal shares of the integral of ds / size, as places on the middle curve; and that curve's table against chain 1.
std::vector<double> place_knots(const std::vector<Piece>& pieces, ContactInterface& c) {
    std::vector<double> count{0};
    c.s = {0};
    c.s1 = {pieces.front().begin1};
    for (const Piece& p : pieces) {
        count.push_back(count.back() + p.length / p.size);
        c.s.push_back(c.s.back() + p.length);
        c.s1.push_back(p.end1);
    }
    const int n = std::max(min_intervals, static_cast<int>(std::lround(count.back())));
    std::vector<double> knots{0};
    std::size_t i = 0;
    for (int k = 1; k < n; ++k) {
        const double target = count.back() * k / n;
        while (i + 2 < count.size() && count[i + 1] < target) ++i;
        knots.push_back(c.s[i] + (target - count[i]) / (count[i + 1] - count[i]) * (c.s[i + 1] - c.s[i]));
    }
    knots.push_back(c.s.back());
    return knots;
}

double interpolate(const std::vector<double>& from, const std::vector<double>& to, double v) {
    const auto i = std::clamp<std::ptrdiff_t>(std::upper_bound(from.begin(), from.end(), v) - from.begin() - 1, 0,
                                              static_cast<std::ptrdiff_t>(from.size()) - 2);
    const auto k = static_cast<std::size_t>(i);
    return to[k] + (v - from[k]) / (from[k + 1] - from[k]) * (to[k + 1] - to[k]);
}

void append_point(ContactInterface& c, const FacingPair& pair, const PartOnGrid& first, const PartOnGrid& second, double s,
                  double weight, double closing, bool no_overlap) {
    solver::InterfacePoint p;
    p.s = s;
    p.weight = weight;
    p.gap = (no_overlap ? std::max(0.0, pair.gap) : pair.gap) - closing;
    p.element = {element_of(first, pair.on1), element_of(second, pair.on2)};
    p.x = {first.frame.to_local(pair.on1.x), second.frame.to_local(pair.on2.x)};
    p.normal = {first.frame.vector_to_local(pair.normal), second.frame.vector_to_local(pair.normal)};
    c.face.points.push_back(p);
    c.own_normals.push_back({first.frame.vector_to_local(pair.on1.normal), second.frame.vector_to_local(pair.on2.normal)});
}

}  // namespace

int element_of(const PartOnGrid& on_grid, const geometry::ChainPoint& p) {
    const geometry::BoundaryPiece& piece = piece_at(on_grid.cells, p.edge, p.t);
    return on_grid.elements.of_piece[static_cast<std::size_t>(&piece - on_grid.cells.pieces.data())];
}

ContactInterface make_interface(const Scene& scene, const FacingZone& zone, const PartOnGrid& first, const PartOnGrid& second,
                                std::array<int, 2> solver_part, double closing, bool no_overlap) {
    ContactInterface c;
    c.part = {first.part, second.part};
    c.zone = zone;
    const geometry::Part &p1 = part_of(scene, first.part), &p2 = part_of(scene, second.part);
    const std::vector<Piece> pieces = measure(scene, c, first, second);
    if (pieces.empty()) return c;
    const std::vector<double> knots = place_knots(pieces, c);
    c.face.part = solver_part;
    c.face.thickness = std::min(first.input.thickness, second.input.thickness);
    c.face.periodic = zone.closed;
    c.face.pressure = zone.closed ? solver::periodic_knots(knots, solver::multiplier_degree)
                                  : solver::clamped_knots(knots, solver::multiplier_degree);
    // between crossings and knots everything is smooth: these are the pieces that are integrated
    std::vector<double> cuts = c.s1;
    for (double k : knots) cuts.push_back(interpolate(c.s, c.s1, k));
    std::sort(cuts.begin(), cuts.end());
    const double shortest = shortest_piece * (zone.end1 - zone.begin1);
    const auto& rule = geometry::gauss_rule(points_per_piece);
    double partner = zone.begin2;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double length = cuts[k + 1] - cuts[k];
        if (length <= shortest) continue;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double s1 = cuts[k] + rule.points[q] * length;
            const FacingPair pair = pair_from_first(p1, p2, zone, s1, partner);
            if (!pair.found) continue;
            partner = pair.s2;
            append_point(c, pair, first, second, interpolate(c.s1, c.s, s1), rule.weights[q] * length * pair.stretch, closing,
                         no_overlap);
        }
    }
    for (double s1 : c.s1) c.s2.push_back(pair_from_first(p1, p2, zone, s1, guess2(zone, s1)).s2);
    // stiffness of a Winkler foundation as deep as the larger body's tenth: only the start of the active set depends on it
    const double depth = 0.1 * std::max(first.size, second.size);
    c.foundation = 1 / ((compliance(scene, first) + compliance(scene, second)) * depth);
    return c;
}

geometry::FacingPair pair_at(const Scene& scene, const ContactInterface& contact, double s) {
    const double s1 = interpolate(contact.s, contact.s1, s);
    return pair_from_first(part_of(scene, contact.part[0]), part_of(scene, contact.part[1]), contact.zone, s1,
                           interpolate(contact.s, contact.s2, s));
}

}  // namespace abut
