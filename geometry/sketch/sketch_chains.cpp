// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_chains.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "geometry/sketch/sketch_blocks.hpp"

namespace abut::geometry {

namespace {

std::string four_digits(double value) {
    std::ostringstream text;
    text.precision(4);
    text << value;
    return text.str();
}

/// A gap that is this many times as wide as the tolerance is not a careless joint but a missing piece.
constexpr double bridgeable = 500;

struct Tracer {
    const std::vector<SketchPiece>& entities;
    const Joints& joints;
    double tolerance;
    std::vector<int> block_of{};
    std::vector<SketchProblem> branchings{};

    const SketchPiece& entity(const EntityEnd& end) const { return entities[static_cast<std::size_t>(end.entity)]; }
    const Joint& joint(int index) const { return joints.joints[static_cast<std::size_t>(index)]; }
    int joint_of(int entity_index, bool is_begin) const {
        return (is_begin ? joints.at_begin : joints.at_end)[static_cast<std::size_t>(entity_index)];
    }

    // ---- closed chains ----

    /// The other ends of the block in the joint where this one lies.
    std::vector<EntityEnd> partners(const EntityEnd& end) const {
        const int block = block_of[static_cast<std::size_t>(end.entity)];
        std::vector<EntityEnd> found;
        for (const EntityEnd& other : joint(joint_of(end.entity, end.is_begin)).ends) {
            const bool is_same = other.entity == end.entity && other.is_begin == end.is_begin;
            if (!is_same && block_of[static_cast<std::size_t>(other.entity)] == block) found.push_back(other);
        }
        return found;
    }

    bool is_cycle(const std::vector<int>& block) const {
        return std::all_of(block.begin(), block.end(), [&](int e) {
            return partners({e, true}).size() == 1 && partners({e, false}).size() == 1;
        });
    }

    EntityChain walk(int first) const {
        EntityChain chain{{first, true}};
        for (EntityEnd next = partners({first, false}).front(); next.entity != first;
             next = partners({next.entity, !next.is_begin}).front())
            chain.push_back({next.entity, next.is_begin});
        return chain;
    }

    bool is_bridge(const std::vector<int>& block) const {
        return block.size() == 1 && joint_of(block.front(), true) != joint_of(block.front(), false);
    }

    void take(const std::vector<std::vector<int>>& blocks, EntityChains& chains) {
        for (const auto& block : blocks)
            for (const int e : block) block_of[static_cast<std::size_t>(e)] = block.front();
        for (const auto& block : blocks) {
            if (is_cycle(block))
                chains.closed.push_back(walk(block.front()));
            else
                chains.divided.push_back(block);
        }
    }

    bool ends_openly(const std::vector<int>& block) const {
        return std::any_of(block.begin(), block.end(), [&](int e) {
            return joint(joint_of(e, true)).ends.size() == 1 || joint(joint_of(e, false)).ends.size() == 1;
        });
    }

    void trace(EntityChains& chains) {
        std::vector<bool> is_seen(entities.size(), false);
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const int first = static_cast<int>(i);
            if (is_seen[i]) continue;
            if (joints.at_begin[i] < 0) {
                chains.closed.push_back({{first, true}});
                continue;
            }
            const auto blocks = connected_blocks(joints, first, is_seen);
            const bool is_open = std::any_of(blocks.begin(), blocks.end(), [&](const auto& b) { return ends_openly(b); });
            const auto bridge = std::find_if(blocks.begin(), blocks.end(), [&](const auto& b) { return is_bridge(b); });
            if (!is_open && bridge == blocks.end()) {
                take(blocks, chains);
                continue;
            }
            add_branchings(blocks);
            if (!is_open) branchings.push_back(bounds_nothing(bridge->front()));
        }
    }

    // ---- what is wrong with the others ----

    SketchProblem branching(const Joint& at) const {
        constexpr std::size_t most_names = 8;
        std::string names;
        for (std::size_t i = 0; i < std::min(at.ends.size(), most_names); ++i)
            names += (i == 0 ? "" : ", ") + entity(at.ends[i]).name;
        if (at.ends.size() > most_names) names += ", ...";
        const SketchPiece& first = entity(at.ends.front());
        return {std::to_string(at.ends.size()) + " ends meet in one point on layer " + first.layer + ": " + names, at.at, names,
                first.line, "delete what is surplus, or put each part on a layer of its own"};
    }

    /// Of the joints of what is not taken, each once.
    void add_branchings(const std::vector<std::vector<int>>& blocks) {
        std::set<int> at;
        for (const auto& block : blocks)
            for (const int e : block)
                for (const bool is_begin : {true, false})
                    if (joint(joint_of(e, is_begin)).ends.size() > 2) at.insert(joint_of(e, is_begin));
        for (const int j : at) branchings.push_back(branching(joint(j)));
    }

    SketchProblem bounds_nothing(int index) const {
        const SketchPiece& e = entities[static_cast<std::size_t>(index)];
        return {e.kind + " " + e.name + " on layer " + e.layer + " joins two outlines and bounds nothing", point(e.curve, 0.5),
                e.name, e.line, "delete it in CAD, or put it on a layer that is off"};
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
        const SketchPiece& e = entity(end);
        return {e.kind + " " + e.name + " on layer " + e.layer + " ends where nothing continues it", position(entities, end),
                e.name, e.line, "close the outline in CAD"};
    }

    SketchProblem joined_to_nothing(int index) const {
        const SketchPiece& e = entities[static_cast<std::size_t>(index)];
        return {e.kind + " " + e.name + " on layer " + e.layer + " is joined to nothing", point(e.curve, 0.5), e.name, e.line,
                "delete it, or switch its layer off, or give it the line type CENTER if it is a centre line"};
    }

    SketchProblem gap_between(const EntityEnd& end, const EntityEnd& other) const {
        const SketchPiece &a = entity(end), &b = entity(other);
        const Vec2 p = position(entities, end), q = position(entities, other);
        const bool is_same = end.entity == other.entity;
        const std::string names = is_same ? a.name : a.name + ", " + b.name;
        const double gap = (p - q).norm();
        return {"open outline on layer " + a.layer + ": the ends of " + names + " are " + four_digits(gap) + " apart",
                0.5 * (p + q), names, std::min(a.line, b.line),
                gap > bridgeable * tolerance
                    ? "complete the outline in CAD, or switch the layer off if it is none"
                    : "close the gap in CAD or give a larger tolerance (it was " + four_digits(tolerance) + ")"};
    }

    /// Does it hang together with nothing, with no end that something else nearly continues? Centre lines do.
    bool is_lone(const std::vector<EntityEnd>& open, int e) const {
        for (const bool is_begin : {true, false}) {
            if (joint(joint_of(e, is_begin)).ends.size() != 1) return false;
            const Vec2 here = position(entities, {e, is_begin});
            for (const EntityEnd& other : open)
                if ((other.entity != e || other.is_begin != is_begin) &&
                    (position(entities, other) - here).norm() <= bridgeable * tolerance)
                    return false;
        }
        return true;
    }

    SketchProblem rest_of(const EntityEnd& end, const std::vector<bool>& is_told) const {
        SketchProblem rest = lone_end(end);
        rest.what =
            std::to_string(std::count(is_told.begin(), is_told.end(), false)) + " more open ends on layer " + entity(end).layer;
        return rest;
    }

    /// The problem of the first end, and which other one it tells of.
    std::pair<SketchProblem, std::size_t> open_problem(const std::vector<EntityEnd>& open, std::size_t i) const {
        const int e = open[i].entity;
        if (is_lone(open, e)) {
            const auto other = std::find_if(open.begin() + static_cast<std::ptrdiff_t>(i) + 1, open.end(),
                                            [&](const EntityEnd& end) { return end.entity == e; });
            return {joined_to_nothing(e), other == open.end() ? i : static_cast<std::size_t>(other - open.begin())};
        }
        const std::size_t k = nearest(open, i);
        return {k == i ? lone_end(open[i]) : gap_between(open[i], open[k]), k};
    }

    std::vector<SketchProblem> open_problems() const {
        const std::vector<EntityEnd> open = open_ends();
        std::vector<bool> is_told(open.size(), false);
        std::vector<SketchProblem> problems;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (is_told[i]) continue;
            if (problems.size() == max_open_ends) {
                problems.push_back(rest_of(open[i], is_told));
                break;
            }
            auto [problem, other] = open_problem(open, i);
            problems.push_back(std::move(problem));
            is_told[i] = is_told[other] = true;
        }
        return problems;
    }
};

}  // namespace

EntityChains trace_chains(const std::vector<SketchPiece>& entities, const Joints& joints, double tolerance) {
    Tracer tracer{entities, joints, tolerance};
    tracer.block_of.assign(entities.size(), -1);
    EntityChains chains;
    tracer.trace(chains);
    std::sort(chains.closed.begin(), chains.closed.end(),
              [](const EntityChain& a, const EntityChain& b) { return a.front().entity < b.front().entity; });
    chains.is_loose.assign(entities.size(), true);
    for (const EntityChain& chain : chains.closed)
        for (const ChainLink& link : chain) chains.is_loose[static_cast<std::size_t>(link.entity)] = false;
    chains.problems = tracer.open_problems();
    chains.problems.insert(chains.problems.end(), tracer.branchings.begin(), tracer.branchings.end());
    return chains;
}

}  // namespace abut::geometry
