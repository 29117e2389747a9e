// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/singular_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

/// Missed share at a slit, which splines tie together where it is narrower than a cell, and where a support ends on a straight
/// edge. Both fall with the square of how much more than half a turn the material takes (of the support: with its mirror
/// image), measured on notches of 135, 90, 45 and 10 degrees, an L and half supported blocks, cells of a tenth to a fortieth,
/// turned by 0 to 45 degrees: 0.02 to 0.04, 0.1 to 0.4, 0.3 to 1.4, 0.6 to 2.8; at supports 0.3 to 1.1. Of a clamp at a
/// corner 0.006 to 0.016; where contact ends at a corner 0.03 (blocks on blocks) to 0.6 (punches).
constexpr double missed_at_slit = 1.5, missed_at_support = 0.6, missed_at_clamp = 0.012, missed_at_contact = 0.1;

/// Moduli of bonded bodies that differ by less, of their sum, are those of one body.
constexpr double least_mismatch = 1e-6;

/// A vertex of a part: where an edge ends and the next one begins.
struct Vertex {
    int edge, next;
    Vec2 at;
    double turn;  ///< to the left; re-entrant: negative
};

std::vector<Vertex> vertices(const geometry::Part& part) {
    std::vector<Vertex> all;
    for (const geometry::Loop& loop : part.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const int edge = loop.edges[i], next = loop.edges[(i + 1) % loop.edges.size()];
            const Vec2 from = unit_tangent(part.edges[at(edge)].curve, 1), to = unit_tangent(part.edges[at(next)].curve, 0);
            all.push_back(
                {edge, next, point(part.edges[at(edge)].curve, 1), std::atan2(geometry::cross(from, to), from.dot(to))});
        }
    return all;
}

double at_corner(double turn) {
    return missed_at_slit * std::pow(turn / std::numbers::pi, 2);
}

/// 1 - lambda, sin(lambda w) = -lambda sin(w): stress opens a corner with free faces, of material through an angle w above pi,
/// like r^(lambda - 1) [Williams 1952].
double growth_at_corner(double turn) {
    const double w = std::numbers::pi - turn;
    double low = 0.5, high = 1;
    for (int k = 0; k < 40; ++k) {
        const double lambda = 0.5 * (low + high);
        (std::sin(lambda * w) + lambda * std::sin(w) > 0 ? low : high) = lambda;
    }
    return 1 - low;
}

/// Kolosov's constant.
double kolosov(const solver::Elasticity& d) {
    return (d.d11 + d.d33) / (d.d11 - d.d33);
}

/// The same of a corner of which one face slides along a plane: that of the corner with its mirror image.
double growth_at_guide(double turn) {
    return growth_at_corner(std::max(2 * turn - std::numbers::pi, -std::numbers::pi));
}

/// turn: of the boundary where the support ends.
double at_support_end(double turn) {
    return std::max(missed_at_clamp, missed_at_support * std::pow(std::max(0.0, 1 - 2 * turn / std::numbers::pi), 2));
}

/// Holds both components where it holds one?
bool is_clamp(const Support& support) {
    return (support.kind == Support::Kind::fix || support.kind == Support::Kind::displacement) && support.x && support.y;
}

/// Stress has a limit where a support ends at a corner of at most a right angle and the part slides along it (there the support
/// is a plane of symmetry of a smooth boundary), and where another support goes on; else it has none.
void append_support_ends(const Scene& scene, const ResolvedConditions& conditions, int part,
                         const solver::Elasticity& elasticity, std::vector<SingularPlace>& places) {
    struct End {
        Vec2 at;
        bool is_limited;
        int portions;
        double turn;
        bool is_clamped;
    };
    const geometry::Part& shape = scene.parts[at(part)].part;
    const double merge = merge_length(shape);
    const std::vector<Vertex> corners = vertices(shape);
    std::vector<End> ends;
    for (std::size_t s = 0; s < conditions.supports.size(); ++s) {
        if (scene.supports[s].kind == Support::Kind::spring) continue;
        for (const EdgePortion& portion : conditions.supports[s]) {
            if (portion.part != part) continue;
            for (double t : {portion.t0, portion.t1}) {
                const Vec2 place = point(shape.edges[at(portion.edge)].curve, t);
                const auto is_here = [&](const auto& other) { return (other.at - place).norm() <= merge; };
                const auto vertex = std::find_if(corners.begin(), corners.end(), is_here);
                const double right_angle = 0.5 * std::numbers::pi - 1e-3;
                const bool is_limited = !is_clamp(scene.supports[s]) && vertex != corners.end() && vertex->turn >= right_angle;
                const auto known = std::find_if(ends.begin(), ends.end(), is_here);
                if (known != ends.end()) {
                    ++known->portions;
                    continue;
                }
                const double turn = vertex == corners.end() ? 0 : vertex->turn;
                ends.push_back({place, is_limited, 1, turn, is_clamp(scene.supports[s])});
            }
        }
    }
    for (const End& end : ends)
        if (!end.is_limited && end.portions == 1)
            places.push_back({end.at, at_support_end(end.turn), false,
                              end.is_clamped ? growth_at_clamp(end.turn, kolosov(elasticity)) : growth_at_guide(end.turn),
                              true});
}

/// Has a butt joint that a straight boundary passes square, of these materials, stresses without a limit there (Bogy, J. Appl.
/// Mech. 35, 1968)? alpha, beta: Dundurs' constants.
bool is_singular_butt(const solver::Elasticity& a, const solver::Elasticity& b) {
    const auto modulus = [](const solver::Elasticity& d) { return d.d11 - d.d12 * d.d12 / d.d11; };
    const double alpha = (modulus(a) - modulus(b)) / (modulus(a) + modulus(b)),
                 beta = (a.d33 * (kolosov(b) - 1) - b.d33 * (kolosov(a) - 1)) /
                        (a.d33 * (kolosov(b) + 1) + b.d33 * (kolosov(a) + 1));
    return std::abs(alpha) > least_mismatch && alpha * (alpha - 2 * beta) > 0;
}

/// Places of a contact's middle curve where friction turns from its bound one way to that the other, within so little that
/// sticks that the knots there do not tell: the fits of a root at its two borders take half as many each.
std::vector<double> reversals_in(const SolvedAssembly& solved, std::size_t contact, const PressedStretch& stretch) {
    constexpr int samples = 2;    // by interval
    constexpr double untold = 8;  // knot intervals
    const solver::KnotVector& knots = solved.contacts[contact].face.pressure;
    std::vector<double> places;
    FrictionState last = FrictionState::open;
    double last_at = 0;
    for (std::size_t i = 0; i + 1 < knots.breakpoints.size(); ++i) {
        const double begin = knots.breakpoints[i], step = (knots.breakpoints[i + 1] - begin) / samples;
        for (int k = 0; k < samples; ++k) {
            const double s = begin + (k + 0.5) * step;
            if (s <= stretch.begin || s >= stretch.end) continue;
            const FrictionState state = state_at(solved, contact, s);
            if (state != FrictionState::slip_forward && state != FrictionState::slip_backward) continue;
            const bool is_other = last != FrictionState::open && state != last;
            if (is_other && s - last_at <= untold * samples * step) places.push_back(0.5 * (s + last_at));
            last = state;
            last_at = s;
        }
    }
    return places;
}

/// Does a support hold what a bond's end is cut off by, or the axis: a plane of symmetry, beyond which both go on?
bool goes_on_in_mirror(const Scene& scene, const ResolvedConditions& conditions, const BondEnd& end) {
    for (const std::size_t side : {0U, 1U}) {
        const geometry::Part& part = part_of(scene, end.parts[side]);
        const double merge = merge_length(part);
        if (scene.analysis == Analysis::axisymmetric && end.at[side].x() <= merge) return true;
        for (std::size_t s = 0; s < conditions.supports.size(); ++s)
            for (const EdgePortion& portion : conditions.supports[s])
                for (const double t : {portion.t0, portion.t1})
                    if (portion.part == end.parts[side] && scene.supports[s].kind != Support::Kind::spring &&
                        (point(part.edges[at(portion.edge)].curve, t) - end.at[side]).norm() <= merge)
                        return true;
    }
    return false;
}

}  // namespace

double growth_at_clamp(double turn, double kappa) {
    constexpr int steps = 100, bisections = 20;
    const double w = std::numbers::pi - turn;
    const auto left = [&](double lambda) {
        return 0.25 * (kappa + 1) * (kappa + 1) - std::pow(lambda * std::sin(w), 2) - kappa * std::pow(std::sin(lambda * w), 2);
    };
    double nearest = 1, least = std::numeric_limits<double>::infinity();
    for (int k = 1; k <= steps; ++k) {
        const double lambda = static_cast<double>(k) / steps, here = left(lambda);
        if (here < least) nearest = lambda;
        least = std::min(least, here);
        if (least > 0) continue;
        double low = lambda - 1.0 / steps, high = lambda;
        for (int i = 0; i < bisections; ++i) {
            const double middle = 0.5 * (low + high);
            (left(middle) > 0 ? low : high) = middle;
        }
        return 1 - low;
    }
    return 1 - nearest;
}

double turn_at(const geometry::Part& part, const Vec2& place) {
    const double merge = merge_length(part);
    for (const Vertex& v : vertices(part))
        if ((v.at - place).norm() <= merge) return v.turn;
    return 0;
}

std::vector<BondEnd> singular_bond_ends(const Scene& scene, const ResolvedConditions& conditions,
                                        const SolvedAssembly& solved) {
    std::vector<BondEnd> ends;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& contact = solved.contacts[k];
        if (!contact.face.bilateral || contact.face.periodic || contact.face.points.empty()) continue;
        for (double s : {contact.face.pressure.breakpoints.front(), contact.face.pressure.breakpoints.back()}) {
            const geometry::FacingPair pair = pair_at(scene, contact, s);
            // both fill half a turn less what their boundaries turn by
            const double excess = std::numbers::pi - turn_at(part_of(scene, contact.part[0]), pair.on1.x) -
                                  turn_at(part_of(scene, contact.part[1]), pair.on2.x);
            ends.push_back({k, contact.part, {pair.on1.x, pair.on2.x}, excess});
        }
    }
    const std::vector<BondEnd> all = ends;
    std::erase_if(ends, [&](const BondEnd& end) {
        const auto goes_on = [&](const BondEnd& other) {
            return other.parts == end.parts && (other.at[0] - end.at[0]).norm() <= merge_length(part_of(scene, end.parts[0]));
        };
        if (std::count_if(all.begin(), all.end(), goes_on) > 1) return true;
        const auto& of_face = solved.contacts[end.contact].face.part;
        if (end.excess > sharp_turn) return false;
        return end.excess < -sharp_turn ||
               !is_singular_butt(solved.grids[at(of_face[0])].input.elasticity,
                                 solved.grids[at(of_face[1])].input.elasticity) ||
               goes_on_in_mirror(scene, conditions, end);
    });
    return ends;
}

std::vector<char> peaks_at_bond_ends(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                                     const std::vector<Vec2>& peaks) {
    std::vector<char> stands(peaks.size(), 0);
    for (const BondEnd& end : singular_bond_ends(scene, conditions, solved))
        for (const std::size_t side : {0U, 1U})
            if ((end.at[side] - peaks[end.contact]).norm() <= merge_length(part_of(scene, end.parts[side])))
                stands[end.contact] = 1;
    return stands;
}

std::vector<SingularPlace> singular_places(const Scene& scene, const ResolvedConditions& conditions,
                                           const SolvedAssembly& solved, int part) {
    std::vector<SingularPlace> places;
    for (const Vertex& v : vertices(scene.parts[at(part)].part))
        if (v.turn < -sharp_turn) places.push_back({v.at, at_corner(v.turn), false, growth_at_corner(v.turn)});
    append_support_ends(scene, conditions, part, solved.grids[at(solved.solver_part[at(part)])].input.elasticity, places);
    for (const BondEnd& end : singular_bond_ends(scene, conditions, solved))
        for (const std::size_t side : {0U, 1U})
            if (end.parts[side] == part) places.push_back({end.at[side], end.excess > sharp_turn ? at_corner(end.excess) : 0});
    for (const Vec2& held : points_that_carry(scene, solved, at(solved.solver_part[at(part)]))) places.push_back({held, 0});
    for (std::size_t k = 0; k < solved.stretches.size(); ++k) {
        const ContactInterface& contact = solved.contacts[k];
        for (int side : {0, 1}) {
            if (contact.part[at(side)] != part) continue;
            for (const PressedEnd& end : pressed_ends(scene, solved, k))
                if (end.kind == StretchEnd::Kind::corner)
                    places.push_back({side == 0 ? end.pair.on1.x : end.pair.on2.x, missed_at_contact, true});
            if (friction_of(solved, k) == 0) continue;
            for (const PressedStretch& stretch : solved.stretches[k])
                for (const double s : reversals_in(solved, k, stretch)) {
                    const geometry::FacingPair pair = pair_at(scene, contact, s);
                    places.push_back({side == 0 ? pair.on1.x : pair.on2.x, 0, true});
                }
        }
    }
    return places;
}

}  // namespace abut
