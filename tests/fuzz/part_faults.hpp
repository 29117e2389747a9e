// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every part that a reader hands out, whatever it was read from.
#pragma once
#include <cmath>
#include <string>

#include "geometry/brep/input_error.hpp"
#include "geometry/brep/part.hpp"

namespace abut::fuzz {

/// Edges of a loop meet within this fraction of its size (and of its coordinates): readers join what nearly meets, so what is
/// left is rounding.
inline constexpr double meeting_fraction = 1e-6;

inline std::string fault_of_loop(const geometry::Part& part, const geometry::Loop& loop, double slack) {
    if (loop.edges.empty()) return "a loop without edges";
    for (std::size_t k = 0; k < loop.edges.size(); ++k) {
        const int here = loop.edges[k], next = loop.edges[(k + 1) % loop.edges.size()];
        if (here < 0 || static_cast<std::size_t>(here) >= part.edges.size()) return "a loop names an edge that is not there";
        const geometry::Edge& edge = part.edges[static_cast<std::size_t>(here)];
        if (!geometry::is_finite(edge.curve)) return "an edge is not finite: " + edge.name;
        if (edge.name.empty()) return "an edge has no name";
        const geometry::Vec2 end = geometry::point(edge.curve, 1);
        const geometry::Vec2 begin = geometry::point(part.edges.at(static_cast<std::size_t>(next)).curve, 0);
        if (!((end - begin).norm() <= slack)) return "two edges do not meet, at the end of " + edge.name;
    }
    return "";
}

/// Empty where all is well.
inline std::string fault_of_part(const geometry::Part& part) {
    if (part.name.empty()) return "a part has no name";
    if (part.loops.empty()) return "a part has no boundary: " + part.name;
    const geometry::Box2 box = geometry::bounding_box(part);
    const double size = box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
    if (!std::isfinite(size)) return "a part has no finite box: " + part.name;
    for (const geometry::Loop& loop : part.loops) {
        const std::string fault = fault_of_loop(part, loop, meeting_fraction * size);
        if (!fault.empty()) return fault + " of part " + part.name;
    }
    const double area = geometry::area(part);
    return std::isfinite(area) && area > 0 ? "" : "a part has no area: " + part.name;
}

/// A refusal tells the user something.
inline std::string fault_of_refusal(const InputError& error) {
    if (error.problems().empty()) return "a refusal without a problem";
    for (const Problem& problem : error.problems())
        if (problem.what.empty()) return "a problem that says nothing";
    return "";
}

}  // namespace abut::fuzz
