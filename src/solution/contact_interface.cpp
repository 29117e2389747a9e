// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: s1, s2 arc lengths on the two chains, s on the middle curve; a piece is a stretch without a grid line or a knot
// inside.
#include "src/solution/contact_interface.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/curves/gauss.hpp"
#include "src/base/index.hpp"
#include "src/scene/scene.hpp"
#include "src/solution/contact_pairing.hpp"
#include "src/solution/penalty_interface.hpp"
#include "src/solution/table.hpp"

namespace abut {

namespace {

using geometry::FacingPair;
using geometry::FacingZone;

constexpr int points_per_piece = 3;
constexpr int min_intervals = 4;
constexpr double most_in_piece = 2;  // intervals of the pressure

struct Piece {
    double begin1, end1;
    double begin2, end2;  // their partners
    double length;        // on the middle curve
    double size;          // wanted knot spacing
};

/// A pair found by the sum of the lengths run along both chains, m = s1 - s2: neither body is preferred, so that swapping them
/// changes no point of the quadrature.
struct MiddlePair {
    FacingPair pair;
    double length_rate = 0;  // d(middle curve's length)/dm
};

/// s1 begins as the guess that it comes with; s2 likewise.
MiddlePair pair_in_middle(const Scene& scene, const ContactInterface& c, double m, double s1, double s2) {
    constexpr int max_steps = 20;
    const double rounding = 1e-14 * (c.zone.chain1.length + c.zone.chain2.length);
    MiddlePair found{{}, 0};
    for (int step = 0; step < max_steps; ++step) {
        found.pair = pair_from_first(part_of(scene, c.part[0]), part_of(scene, c.part[1]), c.zone, s1, s2);
        if (!found.pair.found) return found;
        s2 = found.pair.s2;
        const double left = m - (found.pair.s1 - s2), rate = 1 - found.pair.slope;
        found.length_rate = found.pair.length_rate / rate;
        if (std::abs(left) <= rounding) break;
        s1 = std::clamp(s1 + left / rate, c.zone.begin1, c.zone.end1);
    }
    return found;
}

/// The size of a cell, of the splines that are this face's alone.
double own_size(const PartOnGrid& g, const geometry::ChainPoint& p, const FacesByCell& faces) {
    return cell_size(g, p) * faces_sharing(g, p, faces);
}

std::vector<Piece> measure(const Scene& scene, const ContactInterface& c, const PartOnGrid& first, const PartOnGrid& second,
                           const FacesByCell& faces1, const FacesByCell& faces2) {
    const std::vector<double> b = crossings_of_both(scene, c.zone, first, second);
    const double c1 = compliance(scene, first), c2 = compliance(scene, second);
    const auto& rule = geometry::gauss_rule(points_per_piece);
    std::vector<Piece> pieces;
    const auto partner_of = [&](double s1, double guess) {
        const FacingPair pair = pair_from_first(part_of(scene, first.part), part_of(scene, second.part), c.zone, s1, guess);
        return pair.found ? pair.s2 : guess;
    };
    double begin2 = partner_of(b.front(), c.zone.begin2);
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
        Piece piece{b[k], b[k + 1], begin2, partner_of(b[k + 1], begin2 + b[k] - b[k + 1]), 0, 0};
        begin2 = piece.end2;
        const double m = piece.begin1 - piece.begin2, whole = piece.end1 - piece.end2 - m;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double t = rule.points[q];
            const auto [pair, length_rate] =
                pair_in_middle(scene, c, m + t * whole, piece.begin1 + t * (piece.end1 - piece.begin1),
                               piece.begin2 + t * (piece.end2 - piece.begin2));
            if (!pair.found) continue;
            piece.length += rule.weights[q] * whole * length_rate;
            if (q != rule.points.size() / 2) continue;
            double sizes = 0;
            if (c1 > 0) sizes += c1 * own_size(first, pair.on1, faces1);
            if (c2 > 0) sizes += c2 * own_size(second, pair.on2, faces2);
            const bool halved = first.cells.grid.tree || second.cells.grid.tree;
            piece.size = (halved ? multiplier_spacing_of_halved : multiplier_spacing) * sizes / (c1 + c2);
        }
        // cells are as long as a piece at least, but where their boundaries are not seen: beside places at which pairs hardly
        // move
        piece.size = std::max(piece.size, piece.length / most_in_piece);
        if (piece.length > 0 && piece.size > 0) pieces.push_back(piece);
    }
    return pieces;
}

/// The middle curve's table against the chains; and at its places the integral of ds / size.
std::vector<double> make_table(const std::vector<Piece>& pieces, ContactInterface& c) {
    std::vector<double> count{0};
    c.s = {0};
    c.s1 = {pieces.front().begin1};
    c.s2 = {pieces.front().begin2};
    for (const Piece& p : pieces) {
        count.push_back(count.back() + p.length / p.size);
        c.s.push_back(c.s.back() + p.length);
        c.s1.push_back(p.end1);
        c.s2.push_back(p.end2);
    }
    return count;
}

/// Counts at which the knots are to be double: just beyond where contact is expected to end. step: that they are rounded to; 0:
/// none.
std::vector<double> double_knots(const std::vector<double>& count, const ContactInterface& c,
                                 const std::vector<ExpectedEnd>& ends, double step) {
    std::vector<double> wanted;
    for (const ExpectedEnd& e : ends) {
        double s1 = e.s1;
        if (c.zone.closed) s1 += c.zone.chain1.length * std::ceil((c.s1.front() - s1) / c.zone.chain1.length);
        const double place = interpolate(c.s1, count, s1) + end_overhang * e.outward;
        wanted.push_back(step > 0 ? step * std::round(place / step) : place);
    }
    std::sort(wanted.begin(), wanted.end());
    std::vector<double> kept{0};  // whole intervals between them, and to the ends
    for (double w : wanted)
        if (w - kept.back() >= 1 && count.back() - w >= 1) kept.push_back(w);
    kept.erase(kept.begin());
    return kept;
}

struct Knots {
    std::vector<double> places;
    std::vector<int> multiplicity;
};

/// A short zone gets a few knots more, but no more intervals than it has cells: a pressure with more coefficients than there
/// are displacements to press on is not determined.
int intervals_for(double share, bool is_whole_zone) {
    const int cells = static_cast<int>(multiplier_spacing * share * (1 + 1e-9));
    return std::max({1, static_cast<int>(std::lround(share)), is_whole_zone ? std::min(min_intervals, cells) : 1});
}

/// Knots on the middle curve, at equal shares of the count between the double ones.
Knots place_knots(const std::vector<double>& count, const ContactInterface& c, const std::vector<double>& doubled) {
    std::vector<double> stops{0};
    stops.insert(stops.end(), doubled.begin(), doubled.end());
    stops.push_back(count.back());
    Knots knots;
    for (std::size_t e = 0; e + 1 < stops.size(); ++e) {
        const double share = stops[e + 1] - stops[e];
        const int n = intervals_for(share, doubled.empty());
        for (int k = 0; k < n; ++k) {
            knots.places.push_back(interpolate(count, c.s, stops[e] + share * k / n));
            knots.multiplicity.push_back(k == 0 && e > 0 ? 2 : 1);
        }
    }
    knots.places.push_back(c.s.back());
    knots.multiplicity.push_back(1);
    return knots;
}

/// The place s1 on the zone's first chain of a place s on the middle curve; where the zone is closed, in the period that begins
/// at `from`.
double chain_place(const ContactInterface& c, double s, double from) {
    const double s1 = interpolate(c.s, c.s1, s), period = c.zone.chain1.length;
    return c.zone.closed ? s1 - period * std::floor((s1 - from) / period) : s1;
}

/// The place s on the middle curve where function k of the pressure has its coefficient.
double place_of_function(const ContactInterface& c, int k) {
    const double place = solver::greville(c.face.pressure, k), length = c.s.back();
    return c.zone.closed ? place - length * std::floor(place / length) : place;
}

/// Of the solution before: of each function the coefficient of that whose place was nearest. So the same functions are expected
/// to be closed beside an end of contact, wherever it has moved to.
std::vector<double> expected_coefficients(const ContactInterface& c, const ExpectedPressure& before) {
    std::vector<double> expected;
    if (before.s1.empty()) return expected;
    for (int k = 0; k < n_rows(c.face); ++k) {
        const double s1 = chain_place(c, place_of_function(c, k), before.s1.front());
        const auto after = std::lower_bound(before.s1.begin(), before.s1.end(), s1);
        auto nearest = after == before.s1.end() ? after - 1 : after;
        if (after != before.s1.begin() && after != before.s1.end() && s1 - *(after - 1) < *after - s1) nearest = after - 1;
        expected.push_back(before.pressure[static_cast<std::size_t>(nearest - before.s1.begin())]);
    }
    return expected;
}

}  // namespace

int element_of(const PartOnGrid& on_grid, const geometry::ChainPoint& p) {
    const geometry::BoundaryPiece& piece = piece_at(on_grid.cells, p.edge, p.t);
    return on_grid.elements.of_piece[static_cast<std::size_t>(&piece - on_grid.cells.pieces.data())];
}

namespace {

MeasuredZone measured_zone(const Scene& scene, const Candidate& candidate, const PartOnGrid& first, const PartOnGrid& second,
                           std::array<int, 2> solver_part, const std::vector<FacesByCell>& faces) {
    MeasuredZone zone;
    ContactInterface& c = zone.on_middle;
    c.drawn = {candidate.closing(), candidate.no_overlap};
    c.part = {first.part, second.part};
    c.zone = candidate.zone;
    const std::vector<Piece> pieces = measure(scene, c, first, second, faces[at(solver_part[0])], faces[at(solver_part[1])]);
    if (!pieces.empty()) zone.count = make_table(pieces, c);
    return zone;
}

ContactInterface with_knots(const Scene& scene, const MeasuredZone& zone, const std::vector<double>& doubled,
                            const PartOnGrid& first, const PartOnGrid& second, std::array<int, 2> solver_part) {
    ContactInterface c = zone.on_middle;
    const Knots knots = place_knots(zone.count, c, doubled);
    c.face.part = solver_part;
    c.face.thickness = std::min(first.input.thickness, second.input.thickness);
    c.face.periodic = c.zone.closed;
    c.face.pressure = c.zone.closed ? solver::periodic_knots(knots.places, solver::multiplier_degree, knots.multiplicity)
                                    : solver::clamped_knots(knots.places, solver::multiplier_degree, knots.multiplicity);
    // between crossings and knots everything is smooth: these are the pieces that are integrated
    std::vector<double> middle, cuts;
    for (std::size_t k = 0; k < c.s1.size(); ++k) middle.push_back(c.s1[k] - c.s2[k]);
    cuts = middle;
    for (double k : knots.places) cuts.push_back(interpolate(c.s, middle, k));
    std::sort(cuts.begin(), cuts.end());
    const double shortest = shortest_piece * (cuts.back() - cuts.front());
    const auto& rule = geometry::gauss_rule(points_per_piece);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double length = cuts[k + 1] - cuts[k];
        if (length <= shortest) continue;
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double m = cuts[k] + rule.points[q] * length;
            const auto [pair, length_rate] =
                pair_in_middle(scene, c, m, interpolate(middle, c.s1, m), interpolate(middle, c.s2, m));
            if (!pair.found) continue;
            append_point(c, pair, first, second, interpolate(middle, c.s, m), rule.weights[q] * length * length_rate);
        }
    }
    c.foundation = winkler_stiffness(scene, first, second);
    return c;
}

bool is_same(const geometry::FacingZone& a, const geometry::FacingZone& b) {
    const auto numbers = [](const geometry::FacingZone& z) {
        return std::tuple(z.begin1, z.end1, z.begin2, z.end2, z.closed, z.begin_is_limit, z.end_is_limit, z.chain1.length,
                          z.chain2.length, z.is_acting, z.sharpness, z.at_corner, z.in_hollow);
    };
    return numbers(a) == numbers(b) && a.chain1.edges == b.chain1.edges && a.chain2.edges == b.chain2.edges;
}

bool is_same(const Candidate& a, const Candidate& b) {
    return a.first == b.first && a.second == b.second && a.closing() == b.closing() && a.no_overlap == b.no_overlap &&
           is_same(a.zone, b.zone);
}

/// measure: makes the zone where it is not among them.
template <class Measure>
KnownInterfaces::Zone& known_zone(KnownInterfaces& known, const Candidate& candidate, std::array<int, 2> solver_part,
                                  const Measure& measure) {
    const auto found = std::find_if(known.zones.begin(), known.zones.end(), [&](const KnownInterfaces::Zone& z) {
        return z.solver_part == solver_part && is_same(z.of, candidate);
    });
    if (found != known.zones.end()) return *found;
    known.zones.push_back({candidate, solver_part, measure()});
    return known.zones.back();
}

template <class Make>
const ContactInterface& known_interface(KnownInterfaces::Zone& zone, const std::vector<double>& doubled, const Make& make) {
    const auto found = std::find_if(zone.made.begin(), zone.made.end(), [&](const auto& m) { return m.doubled == doubled; });
    if (found != zone.made.end()) return found->interface;
    if (zone.made.size() == KnownInterfaces::most) zone.made.erase(zone.made.begin());
    zone.made.push_back({doubled, make()});
    return zone.made.back().interface;
}

}  // namespace

ContactInterface make_interface(const Scene& scene, const Candidate& candidate, const PartOnGrid& first,
                                const PartOnGrid& second, std::array<int, 2> solver_part, const std::vector<FacesByCell>& faces,
                                KnownInterfaces* known) {
    if (scene.contacts.penalty)
        return make_penalty_interface(scene, candidate.zone, first, second, solver_part,
                                      {candidate.closing(), candidate.no_overlap});
    ContactInterface c;
    if (known && known->faces == faces) {
        const std::scoped_lock lock(known->busy);
        KnownInterfaces::Zone& zone = known_zone(
            *known, candidate, solver_part, [&] { return measured_zone(scene, candidate, first, second, solver_part, faces); });
        if (zone.measured.count.empty()) return zone.measured.on_middle;
        const std::vector<double> doubled =
            double_knots(zone.measured.count, zone.measured.on_middle, candidate.ends, KnownInterfaces::step);
        c = known_interface(zone, doubled,
                            [&] { return with_knots(scene, zone.measured, doubled, first, second, solver_part); });
    } else {
        MeasuredZone zone = measured_zone(scene, candidate, first, second, solver_part, faces);
        if (zone.count.empty()) return std::move(zone.on_middle);
        const std::vector<double> doubled = double_knots(zone.count, zone.on_middle, candidate.ends, 0);
        c = with_knots(scene, zone, doubled, first, second, solver_part);
    }
    c.face.expected = expected_coefficients(c, candidate.expected);
    return c;
}

void expect_pressures_of(const solver::AssemblySolution& solution, std::vector<solver::Interface>& faces) {
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const Eigen::VectorXd& pressure = solution.pressure[k];
        faces[k].expected.assign(pressure.begin(), pressure.begin() + n_rows(faces[k]));
    }
}

geometry::FacingPair pair_at(const Scene& scene, const ContactInterface& contact, double s) {
    const double s1 = interpolate(contact.s, contact.s1, s);
    return paired(part_of(scene, contact.part[0]), part_of(scene, contact.part[1]), contact.zone, contact.pairing, s1,
                  interpolate(contact.s, contact.s2, s));
}

}  // namespace abut
