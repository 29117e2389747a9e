// SPDX-License-Identifier: GPL-3.0-or-later
// Each boundary is a cycle of half edges, known by entity and direction. Inside a part both directions of an entity occur: such
// lines go, and the walk along a cycle that comes to one goes on behind it in the cycle on its other side, as about a joint.
#include "geometry/sketch/sketch_joined.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/sketch/sketch_hatches.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// An edge of a cycle.
struct HalfEdge {
    int cycle = 0, place = 0;
};

using Direction = std::pair<int, bool>;  ///< an entity, and whether it is run along

struct Joining {
    const std::vector<Region>& regions;
    const std::vector<SketchPiece>& entities;
    const std::vector<Hatch>& hatches;
    const std::vector<SketchRegion>& named;
    std::vector<const Region*> cycles{};  ///< boundaries with material on their left
    std::vector<int> material{};          ///< by cycle: the region of that material
    std::map<Direction, HalfEdge> half_edges{};
    std::vector<int> first{};  ///< by region: the first of those that are one part with it

    void add_cycle(const Region& cycle, int region) {
        for (std::size_t k = 0; k < cycle.entity.size(); ++k)
            half_edges[{cycle.entity[k], cycle.outline.edges[k].along_source}] = {static_cast<int>(cycles.size()),
                                                                                  static_cast<int>(k)};
        cycles.push_back(&cycle);
        material.push_back(region);
    }

    Direction direction(const HalfEdge& half) const {
        const Region& cycle = *cycles[at(half.cycle)];
        return {cycle.entity[at(half.place)], cycle.outline.edges[at(half.place)].along_source};
    }

    // ---- which are one part ----

    bool is_line_twice(int entity) const { return entities[at(entity)].times_drawn % 2 == 0; }

    /// What the user says that the region is a part of: itself where nothing is said.
    const std::string& joins(int region) const {
        const std::string& other = regions[at(region)].joins;
        return other.empty() ? named[at(region)].name : other;
    }

    bool are_one(int a, int b, const std::vector<int>& lines, bool is_all_twice) const {
        const Region &one = regions[at(a)], &other = regions[at(b)];
        if (one.is_chosen || other.is_chosen) return joins(a) == joins(b) || (!one.name.empty() && one.name == other.name);
        return look_alike(hatches, one.hatches, other.hatches) &&
               (is_all_twice || std::none_of(lines.begin(), lines.end(), [&](int e) { return is_line_twice(e); }));
    }

    void join() {
        first.resize(regions.size());
        std::iota(first.begin(), first.end(), 0);
        const bool is_all_twice = std::all_of(half_edges.begin(), half_edges.end(),
                                              [&](const auto& known) { return is_line_twice(known.first.first); });
        std::map<std::pair<int, int>, std::vector<int>> between;
        for (const auto& [run, half] : half_edges) {
            const auto twin = half_edges.find({run.first, !run.second});
            if (!run.second || twin == half_edges.end()) continue;
            const int a = material[at(half.cycle)], b = material[at(twin->second.cycle)];
            if (a != b) between[std::minmax(a, b)].push_back(run.first);
        }
        for (const auto& [pair, lines] : between) {
            if (!are_one(pair.first, pair.second, lines, is_all_twice)) continue;
            const auto [low, high] = std::minmax({first[at(pair.first)], first[at(pair.second)]});
            std::replace(first.begin(), first.end(), high, low);
        }
    }

    // ---- their boundaries ----

    /// Behind the edge in its cycle.
    HalfEdge next(const HalfEdge& half) const {
        const auto n = static_cast<int>(cycles[at(half.cycle)]->entity.size());
        return {half.cycle, (half.place + 1) % n};
    }

    /// The same line, seen from the other side, where that is the same part; else null.
    const HalfEdge* twin_inside(const HalfEdge& half) const {
        const Direction run = direction(half);
        const auto twin = half_edges.find({run.first, !run.second});
        if (twin == half_edges.end()) return nullptr;
        const int own = first[at(material[at(half.cycle)])], others = first[at(material[at(twin->second.cycle)])];
        return own == others && material[at(half.cycle)] != material[at(twin->second.cycle)] ? &twin->second : nullptr;
    }

    JoinedLoop loop_from(HalfEdge half, std::vector<std::vector<bool>>& is_done) const {
        JoinedLoop loop;
        while (!is_done[at(half.cycle)][at(half.place)]) {
            is_done[at(half.cycle)][at(half.place)] = true;
            const Region& cycle = *cycles[at(half.cycle)];
            loop.edges.push_back(cycle.outline.edges[at(half.place)]);
            loop.entity.push_back(cycle.entity[at(half.place)]);
            half = next(half);
            while (const HalfEdge* twin = twin_inside(half)) half = next(*twin);
        }
        return loop;
    }

    std::vector<JoinedPart> parts() const {
        std::vector<std::vector<bool>> is_done;
        for (const Region* cycle : cycles) is_done.emplace_back(cycle->entity.size(), false);
        std::map<int, JoinedPart> found;  // by first region
        for (std::size_t c = 0; c < cycles.size(); ++c)
            for (std::size_t k = 0; k < cycles[c]->entity.size(); ++k) {
                const HalfEdge half{static_cast<int>(c), static_cast<int>(k)};
                if (is_done[c][k] || twin_inside(half)) continue;
                found[first[at(material[c])]].loops.push_back(loop_from(half, is_done));
            }
        for (std::size_t i = 0; i < regions.size(); ++i)
            if (regions[i].is_filled) found[first[i]].regions.push_back(static_cast<int>(i));
        std::vector<JoinedPart> parts;
        for (auto& [root, part] : found) {
            const auto size = [](const JoinedLoop& loop) {
                Part outline;
                outline.edges = loop.edges;
                return area(outline);
            };
            std::iter_swap(part.loops.begin(),
                           std::max_element(part.loops.begin(), part.loops.end(),
                                            [&](const auto& a, const auto& b) { return size(a) < size(b); }));
            parts.push_back(std::move(part));
        }
        return parts;
    }
};

std::string names_of(const std::vector<SketchRegion>& named, const std::vector<int>& regions) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t k = 0; k < std::min(regions.size(), most); ++k) text += (k == 0 ? "" : ", ") + named[at(regions[k])].name;
    return regions.size() > most ? text + ", ..." : text;
}

void tell_joined(const Joining& joining, const JoinedPart& part, std::vector<SketchRegion>& named,
                 std::vector<SketchProblem>& warnings) {
    const Region& region = joining.regions[at(part.regions.front())];
    const bool is_said =
        std::any_of(part.regions.begin(), part.regions.end(), [&](int i) { return joining.regions[at(i)].is_chosen; });
    if (part.regions.size() < 2 || is_said) return;
    for (const int i : part.regions) named[at(i)].is_doubtful = true;
    const SketchRegion& last = named[at(part.regions.back())];
    const SketchPiece& first = joining.entities[at(joining.regions[at(part.regions.back())].first_entity)];
    warnings.push_back(
        {"lines between areas that are hatched alike (" + look_text(joining.hatches[at(region.hatches.front())].look) +
             ") are taken as drawn on one part, not as its outline: " + names_of(named, part.regions),
         last.at, first.name, first.line,
         "say \"regions\": {\"" + last.name + "\": \"part\"} where it is a part by itself, \"void\" where it is a hole"});
}

/// What was to be one part and shares no line with it.
void tell_not_joined(const Joining& joining, const std::vector<SketchRegion>& named, std::vector<SketchProblem>& warnings) {
    for (std::size_t i = 0; i < joining.regions.size(); ++i) {
        const std::string& other = joining.regions[i].joins;
        if (other.empty()) continue;
        bool is_joined = false;
        for (std::size_t k = 0; k < named.size(); ++k)
            is_joined = is_joined || (named[k].name == other && joining.first[k] == joining.first[i]);
        if (!is_joined)
            warnings.push_back({"region " + named[i].name + " is to be one part with " + other +
                                    ", but no lines lead there between areas of that part: it is a part by itself",
                                named[i].at,
                                {},
                                0,
                                "abut inspect -o DIR draws the regions"});
    }
}

/// One hatch over areas apart says that they are one part behind or before the drawing's plane; there they are several.
void tell_apart(const Joining& joining, const std::vector<SketchRegion>& named, std::vector<SketchProblem>& warnings) {
    std::map<int, std::vector<int>> covered;  // by hatch: one region for each part
    for (std::size_t i = 0; i < joining.regions.size(); ++i)
        if (joining.regions[i].is_filled && joining.first[i] == static_cast<int>(i))
            for (const int h : joining.regions[i].hatches) covered[h].push_back(static_cast<int>(i));
    for (const auto& [h, parts] : covered) {
        if (parts.size() < 2) continue;
        const Hatch& hatch = joining.hatches[at(h)];
        warnings.push_back({"one hatch (" + look_text(hatch.look) +
                                ") covers areas that share no line, or lines drawn twice: " + names_of(named, parts) +
                                " are taken as parts by themselves",
                            named[at(parts.front())].at, hatch.name, hatch.line,
                            "hold and load each of them where they are pieces of one part"});
    }
}

}  // namespace

std::vector<JoinedPart> join_regions(const std::vector<Region>& regions, const std::vector<Region>& holes,
                                     const std::vector<SketchPiece>& entities, const std::vector<Hatch>& hatches,
                                     std::vector<SketchRegion>& named, std::vector<SketchProblem>& warnings) {
    Joining joining{regions, entities, hatches, named};
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].is_filled) joining.add_cycle(regions[i], static_cast<int>(i));
    for (const Region& hole : holes) joining.add_cycle(hole, hole.around);
    joining.join();
    std::vector<JoinedPart> parts = joining.parts();
    for (const JoinedPart& part : parts) tell_joined(joining, part, named, warnings);
    tell_not_joined(joining, named, warnings);
    tell_apart(joining, named, warnings);
    return parts;
}

}  // namespace abut::geometry
