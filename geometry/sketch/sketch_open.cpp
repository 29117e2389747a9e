// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_open.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/message_text.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// A free end, and what it nearly ends on.
struct Gap {
    std::size_t loose;  ///< among chains.loose
    Vec2 from, to;
    int entity, other;
    double width() const { return (from - to).norm(); }
};

class Nodes {
public:
    explicit Nodes(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int i) {
        while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
        return i;
    }
    void merge(int a, int b) { parent_[at(root(a))] = root(b); }

private:
    std::vector<int> parent_;
};

/// The entity whose end this is, and which of its joints.
int entity_at(const std::vector<SketchPiece>& entities, const LooseEntities& loose, const Vec2& end) {
    for (const int e : loose.entities)
        if (position(entities, {e, true}) == end || position(entities, {e, false}) == end) return e;
    return loose.entities.front();
}

/// From each free end the nearest curve within reach that is not its own, nor joined to it there.
std::vector<Gap> find_gaps(const std::vector<SketchPiece>& entities, const EntityChains& chains) {
    double total = 0;
    for (const LooseEntities& loose : chains.loose) total += loose.length;
    const double reach = nearly_closed_fraction * total;
    std::vector<Box2> boxes;
    for (const SketchPiece& entity : entities) boxes.push_back(bounding_box(entity.curve));
    const EdgeTree tree(boxes);
    std::vector<Gap> gaps;
    for (std::size_t k = 0; k < chains.loose.size(); ++k)
        for (const Vec2& end : chains.loose[k].free_ends) {
            const int own = entity_at(entities, chains.loose[k], end);
            Box2 here;
            here.extend(end);
            Gap best{k, end, end, own, -1};
            for (const int e : tree.near(here, reach)) {
                if (e == own) continue;
                const Curve& curve = entities[at(e)].curve;
                const Vec2 foot = point(curve, closest_parameter(curve, end));
                if (best.other < 0 || (foot - end).norm() < best.width()) {
                    best.to = foot;
                    best.other = e;
                }
            }
            // of a single curve its own other end
            const Curve& curve = entities[at(own)].curve;
            const Vec2 far = point(curve, 0) == end ? point(curve, 1) : point(curve, 0);
            if ((far - end).norm() <= reach && (best.other < 0 || (far - end).norm() < best.width())) {
                best.to = far;
                best.other = own;
            }
            if (best.other >= 0 && best.width() <= reach) gaps.push_back(best);
        }
    return gaps;
}

/// Gaps by the ring they are in, those of no ring left out: pruned from the dead ends on.
std::vector<Gap> in_rings(const EntityChains& chains, std::vector<Gap> gaps) {
    for (bool is_change = true; is_change;) {
        is_change = false;
        std::map<int, int> n_at;  // by component: how many gaps join it; one from either side of one gap counts once
        const auto twin = [&](const Gap& a, const Gap& b) { return a.entity == b.other && b.entity == a.other; };
        std::vector<bool> is_repeated(gaps.size(), false);
        for (std::size_t i = 0; i < gaps.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (twin(gaps[i], gaps[k]) && (gaps[i].from - gaps[k].to).norm() <= 1e-9 * (1 + gaps[i].width()))
                    is_repeated[i] = true;
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            if (is_repeated[i]) continue;
            ++n_at[chains.component[at(gaps[i].entity)]];
            ++n_at[chains.component[at(gaps[i].other)]];
        }
        const std::size_t before = gaps.size();
        std::erase_if(gaps, [&](const Gap& gap) {
            return n_at[chains.component[at(gap.entity)]] < 2 || n_at[chains.component[at(gap.other)]] < 2;
        });
        is_change = gaps.size() < before;
    }
    return gaps;
}

/// A gap that is this many times as wide as the tolerance is not a careless joint but a missing piece.
constexpr double bridgeable = 500;

SketchProblem gap_problem(const std::vector<SketchPiece>& entities, const Gap& gap, double tolerance) {
    const SketchPiece &a = entities[at(gap.entity)], &b = entities[at(gap.other)];
    const std::string names = gap.entity == gap.other ? a.name : a.name + ", " + b.name;
    return {"open outline on layer " + a.layer + ": the ends of " + names + " are " + number_text(gap.width()) + " apart",
            0.5 * (gap.from + gap.to), names, std::min(a.line, b.line),
            (gap.width() > bridgeable * tolerance ? "complete the outline in CAD"
             : gap.width() <= tolerance
                 ? "they run beside each other there: remove the one that is drawn twice"
                 : "close the gap in CAD or give a larger tolerance (it was " + number_text(tolerance) + ")") +
                std::string(", or leave it out as no outline (--leave-open, or \"leave_open\" in a scene)")};
}

std::string kind_of(const LooseEntities& loose) {
    return loose.free_ends.empty()       ? "joining outlines"
           : loose.free_ends.size() == 1 ? "ending on an outline"
                                         : "joined to nothing";
}

/// "3 lines on layer 0 set aside, since they bound nothing (joined to nothing): hAF, hB0, ..."
SketchProblem set_aside(const std::vector<SketchPiece>& entities, const std::string& kind,
                        const std::vector<const LooseEntities*>& all) {
    constexpr std::size_t most_names = 8;
    std::size_t n = 0;
    std::string names;
    const LooseEntities* longest = all.front();
    for (const LooseEntities* loose : all) {
        for (const int e : loose->entities)
            if (n++ < most_names) names += (names.empty() ? "" : ", ") + entities[at(e)].name;
        if (loose->length > longest->length) longest = loose;
    }
    if (n > most_names) names += ", ...";
    const SketchPiece& first = entities[at(longest->entities.front())];
    return {(n == 1 ? first.kind : std::to_string(n) + " lines and arcs") + " on layer " + first.layer +
                (n == 1 ? " bounds" : " bound") + " nothing (" + kind + ", " + (all.size() > 1 ? "the longest " : "") +
                number_text(longest->length) + " long) and " + (n == 1 ? "was" : "were") + " set aside: " + names,
            point(first.curve, 0.5), names, first.line, "complete the outline in CAD where it is one"};
}

}  // namespace

OpenLines tell_open_lines(const std::vector<SketchPiece>& entities, const EntityChains& chains, double tolerance,
                          bool leave_open) {
    OpenLines told;
    std::vector<bool> is_problem(chains.loose.size(), false);
    if (!leave_open && !chains.loose.empty()) {
        const std::vector<Gap> gaps = in_rings(chains, find_gaps(entities, chains));
        Nodes nodes(entities.size());
        for (const Gap& gap : gaps) nodes.merge(chains.component[at(gap.entity)], chains.component[at(gap.other)]);
        std::map<int, double> length, widest;
        for (const Gap& gap : gaps) {
            double& width = widest[nodes.root(chains.component[at(gap.entity)])];
            width = std::max(width, gap.width());
        }
        for (const LooseEntities& loose : chains.loose)
            length[nodes.root(chains.component[at(loose.entities.front())])] += loose.length;
        std::size_t n = 0;
        for (const Gap& gap : gaps) {
            const int ring = nodes.root(chains.component[at(gap.entity)]);
            if (widest[ring] > nearly_closed_fraction * length[ring]) continue;
            for (std::size_t k = 0; k < chains.loose.size(); ++k)
                if (nodes.root(chains.component[at(chains.loose[k].entities.front())]) == ring) is_problem[k] = true;
            const SketchProblem problem = gap_problem(entities, gap, tolerance);
            const bool is_told = std::any_of(told.problems.begin(), told.problems.end(), [&](const SketchProblem& p) {
                return p.line == problem.line && (p.at - problem.at).norm() <= 1e-9 * (1 + gap.width());
            });
            if (is_told) continue;
            if (++n <= max_open_ends) told.problems.push_back(problem);
        }
        if (n > max_open_ends) {
            told.problems.push_back(told.problems.back());
            told.problems.back().what = std::to_string(n - max_open_ends) + " more gaps of open outlines";
        }
    }
    std::map<std::pair<std::string, std::string>, std::vector<const LooseEntities*>> by_kind;
    for (std::size_t k = 0; k < chains.loose.size(); ++k) {
        if (is_problem[k]) continue;
        const LooseEntities& loose = chains.loose[k];
        told.length += loose.length;
        by_kind[{entities[at(loose.entities.front())].layer, kind_of(loose)}].push_back(&loose);
    }
    for (const auto& [key, all] : by_kind) told.warnings.push_back(set_aside(entities, key.second, all));
    return told;
}

}  // namespace abut::geometry
