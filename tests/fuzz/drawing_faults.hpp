// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of every drawing, and of the parts that it bounds.
#pragma once
#include <string>

#include "geometry/sketch.hpp"
#include "tests/fuzz/part_faults.hpp"

namespace abut::fuzz {

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
        const std::string fault = fault_of_part(part);
        if (!fault.empty()) return fault;
    }
    return "";
}

}  // namespace abut::fuzz
