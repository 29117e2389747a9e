// SPDX-License-Identifier: GPL-3.0-or-later
// Regions are simple outlines and the areas of divided ones. Those around a region are found by boxes, the smallest first;
// since none crosses another, the first that has a point of the region inside is the one directly around it.
#include "geometry/sketch/sketch_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/sketch/sketch_conflicts.hpp"
#include "geometry/sketch/sketch_joined.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// How close to an outline is on it.
struct Margins {
    double tolerance, coincidence;
};

/// Outlines do not cross here by more than the tolerance, so one point decides that is farther than that from the other's
/// boundary, which the inner one may touch; or, in a narrow clearance, one that is not on it.
bool is_inside(const Region& inner, const Region& outer, const Margins& margins) {
    if (inner.area >= outer.area || !inner.box.is_within(outer.box, margins.tolerance)) return false;
    if (outer.is_overlaid)  // others may cross it
        return std::all_of(inner.outline.edges.begin(), inner.outline.edges.end(), [&](const Edge& edge) {
            return contains(finder_of(outer).pieces, point(edge.curve, 0)) &&
                   contains(finder_of(outer).pieces, point(edge.curve, 0.5));
        });
    for (const double margin : {margins.tolerance, margins.coincidence})
        for (const Edge& edge : inner.outline.edges)
            for (const double t : {0.0, 0.5}) {
                const Vec2 p = point(edge.curve, t);
                if (!is_on_boundary(outer, p, margin)) return contains(finder_of(outer).pieces, p);
            }
    return false;
}

/// `by_size`: ranks of the regions, the smallest 0.
int directly_around(const std::vector<Region>& regions, std::size_t i, const EdgeTree& tree, const std::vector<int>& rank,
                    const Margins& margins) {
    const Region& inner = regions[i];
    if (inner.is_overlaid) return -1;
    Box2 corner;
    corner.extend(inner.box.min);
    std::vector<int> candidates = tree.near(corner, margins.tolerance);
    std::erase_if(candidates, [&](int k) {
        const Region& outer = regions[at(k)];
        const bool is_sibling = inner.divided >= 0 && (outer.divided == inner.divided || outer.is_overlaid);
        return at(k) == i || is_sibling || outer.area <= inner.area || !inner.box.is_within(outer.box, margins.tolerance);
    });
    const auto is_larger = [&](int a, int b) { return rank[at(a)] > rank[at(b)]; };
    std::make_heap(candidates.begin(), candidates.end(), is_larger);  // the smallest on top: mostly one or two are asked
    while (!candidates.empty()) {
        std::pop_heap(candidates.begin(), candidates.end(), is_larger);
        if (is_inside(inner, regions[at(candidates.back())], margins)) return candidates.back();
        candidates.pop_back();
    }
    return -1;
}

void find_surroundings(std::vector<Region>& regions, const Margins& margins) {
    std::vector<int> by_size(regions.size());
    std::iota(by_size.begin(), by_size.end(), 0);
    std::stable_sort(by_size.begin(), by_size.end(), [&](int a, int b) { return regions[at(a)].area < regions[at(b)].area; });
    std::vector<int> rank(regions.size());
    for (std::size_t k = 0; k < by_size.size(); ++k) rank[at(by_size[k])] = static_cast<int>(k);
    std::vector<Box2> boxes;
    for (const Region& region : regions) boxes.push_back(region.box);
    const EdgeTree tree(boxes);
    for (std::size_t i = 0; i < regions.size(); ++i) regions[i].around = directly_around(regions, i, tree, rank, margins);
}

void append_loop(Part& part, std::vector<int>& entities, const JoinedLoop& boundary) {
    Loop loop;
    for (const Edge& edge : boundary.edges) {
        loop.edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back(edge);
    }
    part.loops.push_back(std::move(loop));
    entities.insert(entities.end(), boundary.entity.begin(), boundary.entity.end());
}

void assemble(const std::vector<Region>& regions, const std::vector<JoinedPart>& joined, NestedParts& nested) {
    nested.part_of_region.assign(regions.size(), -1);
    for (const JoinedPart& one : joined) {
        for (const int region : one.regions) nested.part_of_region[at(region)] = static_cast<int>(nested.parts.size());
        const Region& first = regions[at(one.regions.front())];
        nested.name.push_back(first.name);
        nested.first_entity.push_back(first.first_entity);
        Part& part = nested.parts.emplace_back();
        std::vector<int>& entities = nested.entity.emplace_back();
        for (const JoinedLoop& loop : one.loops) append_loop(part, entities, loop);
    }
}

bool is_in_material(const std::vector<Region>& regions, const Region& region) {
    return region.around >= 0 && regions[at(region.around)].is_filled;
}

/// Simple outlines and areas, in order of their first entities.
std::vector<Region> regions_of(const Outlines& outlines, const std::vector<bool>& is_overlaid) {
    std::vector<Region> regions;
    for (std::size_t c = 0; c < outlines.closed.size(); ++c) {
        regions.push_back(region_of(outlines.entities, outlines.closed[c]));
        regions.back().is_overlaid = !is_overlaid.empty() && is_overlaid[c];
    }
    for (std::size_t d = 0; d < outlines.divided.size(); ++d)
        for (const Face& face : outlines.divided[d].faces) {
            regions.push_back(region_of(outlines.entities, face.boundary));
            regions.back().divided = static_cast<int>(d);
            regions.back().is_face_filled = face.is_filled;
        }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const Region& a, const Region& b) { return a.first_entity < b.first_entity; });
    return regions;
}

/// Takes out what is thinner than the coincidence all along: lines drawn there and back.
void remove_without_area(const std::vector<SketchPiece>& entities, std::vector<Region>& regions, double coincidence,
                         std::vector<SketchProblem>& problems) {
    std::erase_if(regions, [&](const Region& region) {
        if (region.area > coincidence * perimeter(region.outline) / 2) return false;
        const SketchPiece& first = entities[at(region.first_entity)];
        problems.push_back(
            {"the outline that begins with " + first.kind + " " + first.name + " on layer " + first.layer + " encloses no area",
             point(first.curve, 0.5), first.name, first.line, "delete what is drawn twice in CAD"});
        return true;
    });
}

/// Simple outlines inside parts, and contours of divided outlines inside parts, all clockwise.
std::vector<Region> holes_of(const Outlines& outlines, const std::vector<Region>& regions) {
    std::vector<Region> holes;
    std::vector<bool> is_done(outlines.divided.size(), false);
    for (const Region& region : regions) {
        if (!is_in_material(regions, region)) continue;
        if (region.divided < 0) {
            holes.push_back({region.outline, region.entity, region.box, region.area, region.first_entity});
            holes.back().around = region.around;
            turn(holes.back());
        } else if (!is_done[at(region.divided)]) {
            is_done[at(region.divided)] = true;
            holes.push_back(region_of(outlines.entities, outlines.divided[at(region.divided)].contour));
            holes.back().around = region.around;
            turn(holes.back());
        }
    }
    return holes;
}

}  // namespace

NestedParts nest(const Outlines& outlines, double tolerance, double coincidence, const MaterialHints& hints) {
    ENSURE(tolerance >= 0 && coincidence >= 0, "outlines are one within a distance");
    NestedParts nested;
    std::vector<bool> is_overlaid;
    const Outlines sound =
        without_conflicts(outlines, tolerance, hints.is_one_part, is_overlaid, nested.problems, nested.warnings);
    std::vector<Region> regions = regions_of(sound, is_overlaid);
    remove_without_area(sound.entities, regions, coincidence, nested.problems);
    find_surroundings(regions, {tolerance, coincidence});
    nested.regions = decide_material(regions, sound, hints, nested.warnings);
    const std::vector<Region> holes = holes_of(sound, regions);
    assemble(regions, join_regions(regions, holes, sound.entities, hints.hatches, nested.regions, nested.warnings), nested);
    return nested;
}

}  // namespace abut::geometry
