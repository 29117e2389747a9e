// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch_chains.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

namespace abut::geometry {

namespace {

std::string short_number(double value) {
    std::ostringstream text;
    text.precision(4);
    text << value;
    return text.str();
}

/// A gap that is this many times as wide as the tolerance is not a careless joint but a missing piece.
constexpr double bridgeable = 500;

struct Tracer {
    const std::vector<SketchEntity>& entities;
    const Joints& joints;
    double tolerance;

    const SketchEntity& entity(const EntityEnd& end) const { return entities[static_cast<std::size_t>(end.entity)]; }
    const Joint& joint(int index) const { return joints.joints[static_cast<std::size_t>(index)]; }
    int joint_of(int entity_index, bool is_begin) const {
        return (is_begin ? joints.at_begin : joints.at_end)[static_cast<std::size_t>(entity_index)];
    }

    // ---- closed chains ----

    /// All entities connected with the given one over joints.
    std::vector<int> connected(int first, std::vector<bool>& is_seen) const {
        std::vector<int> group{first};
        is_seen[static_cast<std::size_t>(first)] = true;
        for (std::size_t i = 0; i < group.size(); ++i)
            for (bool is_begin : {true, false})
                for (const EntityEnd& end : joint(joint_of(group[i], is_begin)).ends) {
                    if (is_seen[static_cast<std::size_t>(end.entity)]) continue;
                    is_seen[static_cast<std::size_t>(end.entity)] = true;
                    group.push_back(end.entity);
                }
        return group;
    }

    bool is_closed(const std::vector<int>& group) const {
        return std::all_of(group.begin(), group.end(), [&](int e) {
            return joint(joint_of(e, true)).ends.size() == 2 && joint(joint_of(e, false)).ends.size() == 2;
        });
    }

    EntityEnd other_end(const EntityEnd& end) const {
        const Joint& here = joint(joint_of(end.entity, end.is_begin));
        const bool is_first = here.ends[0].entity == end.entity && here.ends[0].is_begin == end.is_begin;
        return here.ends[is_first ? 1 : 0];
    }

    std::vector<ChainLink> walk(int first) const {
        std::vector<ChainLink> chain{{first, true}};
        for (EntityEnd next = other_end({first, false}); next.entity != first; next = other_end({next.entity, !next.is_begin}))
            chain.push_back({next.entity, next.is_begin});
        return chain;
    }

    // ---- what is wrong with the others ----

    SketchProblem branching(const Joint& at) const {
        std::string names;
        for (const EntityEnd& end : at.ends) names += (names.empty() ? "" : ", ") + entity(end).name;
        const SketchEntity& first = entity(at.ends.front());
        return {std::to_string(at.ends.size()) + " ends meet in one point on layer " + first.layer + ": " + names, at.at, names,
                first.line, "delete what is surplus, or put each part on a layer of its own"};
    }

    std::vector<EntityEnd> open_ends() const {
        std::vector<EntityEnd> open;
        for (const Joint& j : joints.joints)
            if (j.ends.size() == 1) open.push_back(j.ends.front());
        return open;
    }

    std::size_t nearest(const std::vector<EntityEnd>& open, std::size_t i) const {
        const Vec2 here = position(entities, open[i]);
        std::size_t best = i;
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < open.size(); ++k) {
            const double distance = (position(entities, open[k]) - here).norm();
            if (k == i || distance >= smallest) continue;
            smallest = distance;
            best = k;
        }
        return best;
    }

    SketchProblem lone_end(const EntityEnd& end) const {
        const SketchEntity& e = entity(end);
        return {e.kind + " " + e.name + " on layer " + e.layer + " ends where nothing continues it", position(entities, end),
                e.name, e.line, "close the outline in CAD"};
    }

    SketchProblem gap_between(const EntityEnd& end, const EntityEnd& other) const {
        const SketchEntity &a = entity(end), &b = entity(other);
        const Vec2 p = position(entities, end), q = position(entities, other);
        const bool is_same = end.entity == other.entity;
        const std::string names = is_same ? a.name : a.name + ", " + b.name;
        const double gap = (p - q).norm();
        return {"open outline on layer " + a.layer + ": the ends of " + names + " are " + short_number(gap) + " apart",
                0.5 * (p + q), names, std::min(a.line, b.line),
                gap > bridgeable * tolerance
                    ? "complete the outline in CAD, or switch the layer off if it is none"
                    : "close the gap in CAD or give a larger tolerance (it was " + short_number(tolerance) + ")"};
    }

    std::vector<SketchProblem> open_problems() const {
        const std::vector<EntityEnd> open = open_ends();
        std::vector<bool> is_told(open.size(), false);
        std::vector<SketchProblem> problems;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (is_told[i]) continue;
            if (problems.size() == max_open_ends) {
                const auto n = std::count(is_told.begin(), is_told.end(), false);
                SketchProblem rest = lone_end(open[i]);
                rest.what = std::to_string(n) + " more open ends on layer " + entity(open[i]).layer;
                problems.push_back(rest);
                break;
            }
            const std::size_t k = nearest(open, i);
            problems.push_back(k == i ? lone_end(open[i]) : gap_between(open[i], open[k]));
            is_told[i] = is_told[k] = true;
        }
        return problems;
    }
};

}  // namespace

Chains trace_chains(const std::vector<SketchEntity>& entities, const Joints& joints, double tolerance) {
    const Tracer tracer{entities, joints, tolerance};
    Chains chains;
    chains.is_loose.assign(entities.size(), true);
    std::vector<bool> is_seen(entities.size(), false);
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const int first = static_cast<int>(i);
        if (is_seen[i]) continue;
        if (joints.at_begin[i] < 0)
            chains.closed.push_back({{first, true}});
        else if (tracer.is_closed(tracer.connected(first, is_seen)))
            chains.closed.push_back(tracer.walk(first));
    }
    for (const auto& chain : chains.closed)
        for (const ChainLink& link : chain) chains.is_loose[static_cast<std::size_t>(link.entity)] = false;
    chains.problems = tracer.open_problems();
    for (const Joint& joint : joints.joints)
        if (joint.ends.size() > 2) chains.problems.push_back(tracer.branching(joint));
    return chains;
}

}  // namespace abut::geometry
