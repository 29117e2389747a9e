// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_conflicts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/sketch/sketch_crossings.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

std::vector<EntityChain> all_chains(const Outlines& outlines) {
    std::vector<EntityChain> all = outlines.closed;
    for (const DividedOutline& divided : outlines.divided)
        for (const Face& face : divided.faces) all.push_back(face.boundary);
    return all;
}

struct Conflicts {
    const Outlines& outlines;
    const std::vector<EntityChain>& chains;
    double tolerance;

    const SketchPiece& first(int chain) const { return outlines.entities[at(chains[at(chain)].front().entity)]; }

    /// The circle that the chain is, in one piece or cut.
    std::optional<Arc> circle(int chain) const {
        if (at(chain) >= outlines.closed.size()) return std::nullopt;
        const auto* arc = std::get_if<Arc>(&first(chain).curve);
        if (!arc) return std::nullopt;
        for (const ChainLink& link : chains[at(chain)]) {
            const auto* other = std::get_if<Arc>(&outlines.entities[at(link.entity)].curve);
            if (!other || (other->center - arc->center).norm() + std::abs(other->radius - arc->radius) > tolerance)
                return std::nullopt;
        }
        return *arc;
    }

    bool is_pitch_circle(int chain) const {
        const std::optional<Arc> own = circle(chain);
        if (!own) return false;
        int n_on_it = 0;
        for (std::size_t c = 0; c < outlines.closed.size(); ++c) {
            const std::optional<Arc> other = circle(static_cast<int>(c));
            if (other && other->radius < own->radius &&
                std::abs((other->center - own->center).norm() - own->radius) <= tolerance)
                ++n_on_it;
        }
        return n_on_it >= 2;
    }

    /// Which of the two is drawn over the other; -1: that cannot be told.
    int upper(const Crossing& crossing) const {
        if (crossing.chain == crossing.other) return -1;
        const bool is_round = circle(crossing.chain).has_value(), is_other_round = circle(crossing.other).has_value();
        if (is_round != is_other_round) return is_round ? crossing.chain : crossing.other;
        const auto is_free = [&](int chain) { return at(chain) < outlines.closed.size(); };
        if (crossing.at_corners && is_free(crossing.chain)) return crossing.chain;
        if (crossing.at_others_corners && is_free(crossing.other)) return crossing.other;
        return -1;
    }
};

SketchProblem left_out(const SketchPiece& circle, const Vec2& where, const std::string& why) {
    return {circle.kind + " " + circle.name + " on layer " + circle.layer + " left out: " + why, where, circle.name,
            circle.line, "give it the line type CENTER"};
}

SketchProblem overlap(const SketchPiece& upper, const SketchPiece& other, const Vec2& where) {
    return {"the outline of " + upper.kind + " " + upper.name + " on layer " + upper.layer + " is drawn over that of " +
                other.kind + " " + other.name + ": both are taken as parts that overlap",
            where, upper.name + ", " + other.name, upper.line,
            "draw the other outline around it, or give it the line type CENTER where it is construction"};
}

}  // namespace

Outlines without_conflicts(const Outlines& outlines, double tolerance, bool is_one_part, std::vector<bool>& is_overlaid,
                           std::vector<SketchProblem>& problems, std::vector<SketchProblem>& warnings) {
    const std::vector<EntityChain> all = all_chains(outlines);
    const std::vector<Crossing> crossings = find_crossings(outlines.entities, all, tolerance);
    const Conflicts conflicts{outlines, all, tolerance};
    std::vector<bool> is_out(all.size(), false), is_upper(all.size(), false), is_pitch(all.size(), false);
    for (const Crossing& crossing : crossings)
        for (const int chain : {crossing.chain, crossing.other}) {
            if (is_pitch[at(chain)] || crossing.chain == crossing.other) continue;
            const int other = chain == crossing.chain ? crossing.other : crossing.chain;
            const bool is_pitch_circle = conflicts.is_pitch_circle(chain);
            if (!is_pitch_circle && !(is_one_part && conflicts.circle(chain) && !conflicts.circle(other))) continue;
            is_pitch[at(chain)] = is_out[at(chain)] = true;
            warnings.push_back(left_out(conflicts.first(chain), crossing.problem.at,
                                        is_pitch_circle
                                            ? "it runs through the middles of other circles, as pitch circles do"
                                            : "it crosses the outline of its layer, as circles of construction do"));
        }
    for (const Crossing& crossing : crossings) {
        if (is_pitch[at(crossing.chain)] || is_pitch[at(crossing.other)]) continue;
        const int upper = conflicts.upper(crossing);
        if (upper < 0) {
            is_out[at(crossing.chain)] = is_out[at(crossing.other)] = true;
            problems.push_back(crossing.problem);
            continue;
        }
        const int other = upper == crossing.chain ? crossing.other : crossing.chain;
        is_upper[at(upper)] = true;
        warnings.push_back(overlap(conflicts.first(upper), conflicts.first(other), crossing.problem.at));
    }
    Outlines sound{outlines.entities, {}, {}};
    std::size_t chain = 0;
    is_overlaid.clear();
    for (const EntityChain& closed : outlines.closed) {
        if (!is_out[chain]) {
            sound.closed.push_back(closed);
            is_overlaid.push_back(is_upper[chain]);
        }
        ++chain;
    }
    for (const DividedOutline& divided : outlines.divided) {
        bool is_crossing = false;
        for (std::size_t k = 0; k < divided.faces.size(); ++k) is_crossing = is_out[chain++] || is_crossing;
        if (!is_crossing) sound.divided.push_back(divided);
    }
    return sound;
}

}  // namespace abut::geometry
