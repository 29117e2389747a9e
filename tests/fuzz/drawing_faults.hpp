// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every drawing, and of the parts that it bounds.
#pragma once
#include <algorithm>
#include <iterator>
#include <string>

#include "geometry/sketch/sketch.hpp"
#include "tests/fuzz/part_faults.hpp"

namespace abut::fuzz {

/// With more, one run would take as long as hundreds of small ones and show nothing else. Where two ellipses or splines meet is
/// looked for on hundreds of arcs each.
inline constexpr std::ptrdiff_t most_fuzzed_entities = 300, most_fuzzed_general_entities = 4;

inline bool is_small(const geometry::Drawing& drawing) {
    const auto n_general = std::count_if(drawing.entities.begin(), drawing.entities.end(), [](const auto& entity) {
        return std::holds_alternative<geometry::EllipticArc>(entity.curve) ||
               std::holds_alternative<geometry::Spline>(entity.curve);
    });
    return std::ssize(drawing.entities) <= most_fuzzed_entities && n_general <= most_fuzzed_general_entities;
}

/// Empty where all is well.
inline std::string fault_of_drawing(const geometry::Drawing& drawing) {
    for (const auto& [kind, count] : drawing.counts)
        if (count.read != count.used + count.ignored) return "entities are lost: " + kind;
    for (const geometry::SketchEntity& entity : drawing.entities) {
        if (!geometry::is_finite(entity.curve)) return "an entity is not finite: " + entity.name;
        if (entity.name.empty()) return "an entity has no name";
    }
    for (const geometry::SketchProblem& problem : drawing.problems)
        if (problem.what.empty()) return "a problem that says nothing";
    return "";
}

/// Empty where all is well.
inline std::string fault_of_parts(const geometry::SketchParts& sketch) {
    if (sketch.layers.size() != sketch.parts.size()) return "a part without its layer";
    if (sketch.why.empty()) return "no reason for the way parts were told apart";
    for (const geometry::SketchProblem& problem : sketch.problems)
        if (problem.what.empty() || !problem.at.allFinite()) return "a problem without a place: " + problem.what;
    for (const geometry::Repair& repair : sketch.repairs)
        if (!repair.at.allFinite()) return "a repair without a place: " + repair.what;
    for (const geometry::Part& part : sketch.parts) {
        // one whose outline crosses itself is told, and then refused by every command: it may have any area
        const auto is_of_part = [&](const geometry::SketchProblem& p) {
            return p.what.starts_with("part " + part.name + ": ");
        };
        if (std::any_of(sketch.problems.begin(), sketch.problems.end(), is_of_part)) continue;
        const std::string fault = fault_of_part(part);
        if (!fault.empty()) return fault;
    }
    return "";
}

}  // namespace abut::fuzz
