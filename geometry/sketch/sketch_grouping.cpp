// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_grouping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "geometry/brep/closest_points.hpp"
#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/brep/outline.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

using Path = std::vector<std::string>;

/// "CLAMP/PIN" as CLAMP, PIN.
Path path_of(const std::string& block) {
    Path path;
    for (std::size_t begin = 0; begin < block.size();) {
        const std::size_t end = std::min(block.find('/', begin), block.size());
        path.push_back(block.substr(begin, end - begin));
        begin = end + 1;
    }
    return path;
}

/// How many blocks all entities have in common from outside.
std::size_t common_depth(const std::vector<SketchEntity>& entities) {
    Path common = entities.empty() ? Path() : path_of(entities.front().block);
    for (const SketchEntity& entity : entities) {
        const Path path = path_of(entity.block);
        const auto differs = std::mismatch(common.begin(), common.end(), path.begin(), path.end()).first;
        common.erase(differs, common.end());
    }
    return common.size();
}

/// The block at that depth, with its insertion's number if that is what is counted: not if a block further inside is.
std::string block_name(const SketchEntity& entity, std::size_t depth) {
    const Path path = path_of(entity.block);
    if (path.empty()) return "";
    const std::size_t level = std::min(depth, path.size() - 1);
    const std::string counted = entity.instance.substr(0, entity.instance.rfind('#'));
    const bool is_counted = std::find(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(level) + 1, counted) !=
                            path.begin() + static_cast<std::ptrdiff_t>(level) + 1;
    return is_counted && !entity.instance.empty() ? entity.instance : path[level];
}

std::vector<EntityGroup> grouped(const std::vector<SketchEntity>& entities,
                                 const std::function<std::string(const SketchEntity&)>& name_of) {
    std::vector<EntityGroup> groups;
    std::map<std::string, std::size_t> known;
    for (const SketchEntity& entity : entities) {
        const std::string name = name_of(entity);
        const auto [at, is_new] = known.emplace(name, groups.size());
        if (is_new) groups.push_back({name, {}});
        groups[at->second].entities.push_back(entity);
    }
    return groups;
}

/// Outlines do not cross as a rule; where they do, some corner or middle of an edge tells.
bool lies_in_material(const Part& inner, const SlabbedPieces& outer_pieces, const Part& outer) {
    for (const int e : inner.loops.front().edges)
        for (const double t : {0.0, 0.5})
            if (!contains(outer_pieces, point(inner.edges[static_cast<std::size_t>(e)].curve, t))) return false;
    const std::vector<MonotonePiece> covered = monotone_pieces(outer_outline(inner));
    return std::none_of(outer.loops.begin() + 1, outer.loops.end(), [&](const Loop& hole) {
        return contains(covered, point(outer.edges[static_cast<std::size_t>(hole.edges.front())].curve, 0.5));
    });
}

/// The group whose parts' boxes reach farthest: of a plate and its holes the plate's.
std::string surrounding_group(const std::vector<Part>& parts, const std::vector<std::string>& group) {
    std::map<std::string, Box2> boxes;
    for (std::size_t i = 0; i < parts.size(); ++i) boxes[group[i]].extend(bounding_box(parts[i]));
    const auto is_smaller = [](const auto& a, const auto& b) { return a.second.diagonal() < b.second.diagonal(); };
    return std::max_element(boxes.begin(), boxes.end(), is_smaller)->first;
}

bool lies_in_hole(const Part& inner, const Part& outer) {
    if (outer.loops.size() < 2 || inner.edges.empty()) return false;
    const Vec2 p = point(inner.edges.front().curve, 0.5);
    return contains(monotone_pieces(outer_outline(outer)), p) && !contains(monotone_pieces(outer), p);
}

}  // namespace

std::vector<EntityGroup> group_entities(const std::vector<SketchEntity>& entities, PartsBy parts_by) {
    switch (parts_by) {
        case PartsBy::block: {
            const std::size_t depth = common_depth(entities);
            return grouped(entities, [&](const SketchEntity& entity) { return block_name(entity, depth); });
        }
        case PartsBy::color:
            return grouped(entities, [](const SketchEntity& entity) { return "color" + std::to_string(entity.color); });
        case PartsBy::loop:
            return grouped(entities, [](const SketchEntity&) { return std::string(); });
        case PartsBy::layer:
        case PartsBy::automatic:
            break;
    }
    return grouped(entities, [](const SketchEntity& entity) { return entity.layer; });
}

std::vector<std::vector<SketchEntity>> by_instance(const std::vector<SketchEntity>& entities) {
    std::vector<std::vector<SketchEntity>> groups(1);
    for (EntityGroup& group : grouped(entities, [](const SketchEntity& entity) { return entity.instance; })) {
        if (group.name.empty())
            groups.front() = std::move(group.entities);
        else
            groups.push_back(std::move(group.entities));
    }
    return groups;
}

bool is_all_in_blocks(const std::vector<SketchEntity>& entities) {
    const bool is_inside =
        std::none_of(entities.begin(), entities.end(), [](const auto& entity) { return entity.block.empty(); });
    return is_inside && group_entities(entities, PartsBy::block).size() > 1;
}

bool are_others_its_holes(const std::vector<Part>& parts, const std::vector<std::string>& group) {
    ENSURE(parts.size() == group.size(), "every part is of some group");
    std::vector<Box2> boxes;
    for (const Part& part : parts) boxes.push_back(bounding_box(part));
    const EdgeTree tree(boxes);
    std::vector<bool> is_nested(parts.size(), false);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<std::size_t> inside;
        for (const int near : tree.near(boxes[i], 0)) {
            const auto k = static_cast<std::size_t>(near);
            const bool is_within =
                (boxes[k].min.array() > boxes[i].min.array()).all() && (boxes[k].max.array() < boxes[i].max.array()).all();
            if (is_within && group[k] != group[i]) inside.push_back(k);
        }
        if (inside.empty()) continue;
        const SlabbedPieces pieces = slabbed(monotone_pieces(parts[i]));
        for (const std::size_t k : inside) is_nested[k] = is_nested[k] || lies_in_material(parts[k], pieces, parts[i]);
    }
    std::set<std::string> all(group.begin(), group.end()), others;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!is_nested[i]) others.insert(group[i]);
    return all.size() > 1 && others.size() == 1;
}

bool do_others_touch(const std::vector<Part>& parts, const std::vector<std::string>& group, double coincidence) {
    ENSURE(parts.size() == group.size(), "every part is of some group");
    if (parts.empty()) return false;
    const std::string surrounding = surrounding_group(parts, group);
    std::vector<Box2> boxes;
    for (const Part& part : parts) boxes.push_back(bounding_box(part));
    const EdgeTree tree(boxes);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (group[i] == surrounding) continue;
        for (const int near : tree.near(boxes[i], coincidence)) {
            const auto k = static_cast<std::size_t>(near);
            if (group[k] == surrounding || group[k] == group[i]) continue;
            if (lies_in_hole(parts[k], parts[i]) || (k > i && closest_points(parts[i], parts[k], coincidence))) return true;
        }
    }
    return false;
}

bool are_divided(const std::vector<Part>& before, const std::vector<Part>& after) {
    const auto total = [](const std::vector<Part>& parts) {
        double sum = 0;
        for (const Part& part : parts) sum += area(part);
        return sum;
    };
    const double area_before = total(before);
    return after.size() > before.size() && std::abs(total(after) - area_before) <= merge_fraction * area_before;
}

bool are_bodies(const std::vector<SketchEntity>& entities) {
    return std::all_of(entities.begin(), entities.end(), [](const auto& entity) { return entity.layer == entity.block; });
}

}  // namespace abut::geometry
