// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/load_ends.hpp"

#include <algorithm>

#include "src/analysis/singular_places.hpp"
#include "src/base/index.hpp"
#include "src/plan/loads.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

std::vector<LoadEnd>::iterator end_at(const Vec2& place, double merge, std::vector<LoadEnd>& ends) {
    return std::find_if(ends.begin(), ends.end(), [&](const LoadEnd& end) { return (end.at - place).norm() <= merge; });
}

/// Where a contact presses up to a place the load may have ended only because the pressure goes on for it.
void subtract_pressures(const Scene& scene, const SolvedAssembly& solved, int part, double merge, std::vector<LoadEnd>& ends) {
    for (std::size_t k = 0; k < solved.stretches.size(); ++k) {
        const ContactInterface& contact = solved.contacts[k];
        for (int side : {0, 1}) {
            if (contact.part[at(side)] != part) continue;
            for (const PressedEnd& pressed : pressed_ends(scene, solved, k)) {
                const Vec2 place = side == 0 ? pressed.pair.on1.x : pressed.pair.on2.x;
                const auto here = end_at(place, merge, ends);
                if (here == ends.end()) continue;
                const double pressure = solver::pressure_at(contact.face.pressure, pressure_of(solved, k), pressed.s);
                const Vec2 traction = pressure * pressed.pair.normal;
                for (const Vec2& other : {Vec2(here->jump + traction), Vec2(here->jump - traction)})
                    if (other.norm() < here->jump.norm()) here->jump = other;
            }
        }
    }
}

}  // namespace

std::vector<LoadEnd> load_ends(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved,
                               int part) {
    constexpr double rounding = 1e-9;  // of the largest traction
    const geometry::Part& shape = scene.parts[at(part)].part;
    const double merge = merge_length(shape);
    std::vector<LoadEnd> ends;
    double largest = 0;
    for (std::size_t l = 0; l < conditions.loads.size(); ++l) {
        const Load& load = scene.loads[l];
        const std::vector<EdgePortion>& portions = conditions.loads[l];
        const auto is_here = [&](const EdgePortion& portion) { return portion.part == part; };
        if (!is_edge_load(load) || std::none_of(portions.begin(), portions.end(), is_here)) continue;
        const EdgeTraction spread = edge_traction(scene, load, portions);
        for (const EdgePortion& portion : portions) {
            if (!is_here(portion)) continue;
            const geometry::Curve& curve = shape.edges[at(portion.edge)].curve;
            for (const auto& [t, sign] : {std::pair(portion.t0, 1), std::pair(portion.t1, -1)}) {
                const Vec2 place = point(curve, t), traction = traction_at(load, spread, place, outward_normal(curve, t));
                largest = std::max(largest, traction.norm());
                const auto known = end_at(place, merge, ends);
                if (known == ends.end())
                    ends.push_back({place, sign * traction});
                else
                    known->jump += sign * traction;
            }
        }
    }
    if (!ends.empty()) subtract_pressures(scene, solved, part, merge, ends);
    std::erase_if(ends, [&](const LoadEnd& end) {
        return end.jump.norm() <= rounding * largest || std::abs(turn_at(shape, end.at)) > sharp_turn;
    });
    return ends;
}

}  // namespace abut
