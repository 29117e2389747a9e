// SPDX-License-Identifier: GPL-3.0-or-later
// Regions are simple outlines and the areas of divided ones. Those around a region are found by boxes, the smallest first;
// since none crosses another, the first that has a point of the region inside is the one directly around it.
#include "geometry/sketch/sketch_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"
#include "geometry/sketch/sketch_crossings.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// What answers fast where a point lies, of regions that are asked.
struct Finder {
    EdgeTree tree;
    SlabbedPieces pieces;
};

/// A closed chain as a part without holes, run counter-clockwise.
struct Region {
    Part outline;
    std::vector<int> entity;  ///< by edge
    Box2 box;
    double area = 0;
    int first_entity = 0;
    int divided = -1;  ///< the divided outline that it is an area of; -1: none
    bool is_face_filled = true;
    int around = -1;  ///< the region directly around it
    bool is_filled = false;
    mutable std::unique_ptr<Finder> finder{};  ///< made when first asked
};

Edge edge_of(const SketchPiece& entity, bool along) {
    return {along ? entity.curve : reversed(entity.curve), entity.name, entity.source, along, entity.source_begin};
}

/// The same boundary run the other way; the first edge stays first.
void turn(Region& region) {
    std::reverse(region.outline.edges.begin() + 1, region.outline.edges.end());
    std::reverse(region.entity.begin() + 1, region.entity.end());
    for (Edge& edge : region.outline.edges) {
        edge.curve = reversed(edge.curve);
        edge.along_source = !edge.along_source;
    }
}

Region region_of(const std::vector<SketchPiece>& entities, const EntityChain& chain) {
    Region region;
    for (const ChainLink& link : chain) {
        region.outline.edges.push_back(edge_of(entities[at(link.entity)], link.along));
        region.entity.push_back(link.entity);
    }
    region.area = area(region.outline);
    if (region.area < 0) turn(region);
    region.area = std::abs(region.area);
    region.box = bounding_box(region.outline);
    region.first_entity = chain.front().entity;
    return region;
}

const Finder& finder_of(const Region& region) {
    if (!region.finder)
        region.finder = std::make_unique<Finder>(Finder{EdgeTree(region.outline), slabbed(monotone_pieces(region.outline))});
    return *region.finder;
}

bool is_on_boundary(const Region& region, const Vec2& p, double tolerance) {
    Box2 here;
    here.extend(p);
    for (const int e : finder_of(region).tree.near(here, tolerance)) {
        const Curve& curve = region.outline.edges[at(e)].curve;
        if ((point(curve, closest_parameter(curve, p)) - p).norm() <= tolerance) return true;
    }
    return false;
}

/// How close to an outline is on it.
struct Margins {
    double tolerance, coincidence;
};

/// Outlines do not cross here by more than the tolerance, so one point decides that is farther than that from the other's
/// boundary, which the inner one may touch; or, in a narrow clearance, one that is not on it.
bool is_inside(const Region& inner, const Region& outer, const Margins& margins) {
    if (inner.area >= outer.area || !inner.box.is_within(outer.box, margins.tolerance)) return false;
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
    Box2 corner;
    corner.extend(inner.box.min);
    std::vector<int> candidates = tree.near(corner, margins.tolerance);
    std::erase_if(candidates, [&](int k) {
        const Region& outer = regions[at(k)];
        const bool is_sibling = inner.divided >= 0 && outer.divided == inner.divided;
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

void fill(std::vector<Region>& regions, const std::vector<DividedOutline>& divided) {
    std::vector<int> outermost_first(regions.size());
    std::iota(outermost_first.begin(), outermost_first.end(), 0);
    std::stable_sort(outermost_first.begin(), outermost_first.end(),
                     [&](int a, int b) { return regions[at(a)].area > regions[at(b)].area; });
    for (const int i : outermost_first) {
        Region& region = regions[at(i)];
        const bool is_inside_material = region.around >= 0 && regions[at(region.around)].is_filled;
        if (region.divided < 0)
            region.is_filled = !is_inside_material;
        else if (divided[at(region.divided)].is_even_odd)
            region.is_filled = region.is_face_filled != is_inside_material;
        else
            region.is_filled = true;
    }
}

void append_loop(Part& part, std::vector<int>& entities, const Region& region) {
    Loop loop;
    for (const Edge& edge : region.outline.edges) {
        loop.edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back(edge);
    }
    part.loops.push_back(std::move(loop));
    entities.insert(entities.end(), region.entity.begin(), region.entity.end());
}

void assemble(const std::vector<Region>& regions, std::vector<Region>& holes, NestedParts& nested) {
    std::vector<int> part_of(regions.size(), -1);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!regions[i].is_filled) continue;
        part_of[i] = static_cast<int>(nested.parts.size());
        nested.first_entity.push_back(regions[i].first_entity);
        append_loop(nested.parts.emplace_back(), nested.entity.emplace_back(), regions[i]);
    }
    for (Region& hole : holes) {
        const auto part = at(part_of[at(hole.around)]);
        turn(hole);
        append_loop(nested.parts[part], nested.entity[part], hole);
    }
}

bool is_in_material(const std::vector<Region>& regions, const Region& region) {
    return region.around >= 0 && regions[at(region.around)].is_filled;
}

Repair remark(const std::vector<SketchPiece>& entities, const DividedOutline& divided) {
    const auto n_filled = std::count_if(divided.faces.begin(), divided.faces.end(), [](const Face& f) { return f.is_filled; });
    const SketchPiece& first = entities[at(divided.contour.front().entity)];
    Box2 box;
    for (const ChainLink& link : divided.contour) box.extend(bounding_box(entities[at(link.entity)].curve));
    return {"outlines on layer " + first.layer + " share edges (near " + first.name + "): taken as " +
                std::to_string(n_filled) + (n_filled == 1 ? " part" : " parts that touch") +
                (n_filled < static_cast<std::ptrdiff_t>(divided.faces.size()) ? ", with what lies between left open" : ""),
            box.center(), box.diagonal()};
}

/// Simple outlines and areas, in order of their first entities.
std::vector<Region> regions_of(const Outlines& outlines) {
    std::vector<Region> regions;
    for (const EntityChain& chain : outlines.closed) regions.push_back(region_of(outlines.entities, chain));
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

/// Simple outlines inside parts, and contours of divided outlines inside parts.
std::vector<Region> holes_of(const Outlines& outlines, const std::vector<Region>& regions) {
    std::vector<Region> holes;
    std::vector<bool> is_done(outlines.divided.size(), false);
    for (const Region& region : regions) {
        if (!is_in_material(regions, region)) continue;
        if (region.divided < 0) {
            holes.push_back({region.outline, region.entity, region.box, region.area, region.first_entity});
            holes.back().around = region.around;
        } else if (!is_done[at(region.divided)]) {
            is_done[at(region.divided)] = true;
            holes.push_back(region_of(outlines.entities, outlines.divided[at(region.divided)].contour));
            holes.back().around = region.around;
        }
    }
    return holes;
}

// ---- what crosses ----

std::vector<EntityChain> all_chains(const Outlines& outlines) {
    std::vector<EntityChain> all = outlines.closed;
    for (const DividedOutline& divided : outlines.divided)
        for (const Face& face : divided.faces) all.push_back(face.boundary);
    return all;
}

/// Holes and bosses do not cross outlines, but circles of construction (pitch circles, frames of details) do: of a circle and
/// what it crosses, the circle is left out, and a remark says so. By chain.
std::vector<bool> construction_circles(const Outlines& outlines, const std::vector<EntityChain>& chains,
                                       const std::vector<Crossing>& crossings, std::vector<Repair>& remarks) {
    const auto is_circle = [&](int chain) {
        const EntityChain& links = chains[at(chain)];
        return links.size() == 1 && is_full_turn(outlines.entities[at(links.front().entity)].curve);
    };
    std::vector<bool> is_construction(chains.size(), false);
    for (const Crossing& crossing : crossings) {
        if (is_circle(crossing.chain) == is_circle(crossing.other)) continue;
        const int chain = is_circle(crossing.chain) ? crossing.chain : crossing.other;
        if (is_construction[at(chain)]) continue;
        is_construction[at(chain)] = true;
        const SketchPiece& circle = outlines.entities[at(chains[at(chain)].front().entity)];
        remarks.push_back({circle.kind + " " + circle.name + " on layer " + circle.layer +
                               " left out: it crosses an outline, as circles of construction do",
                           crossing.problem.at, length(circle.curve)});
    }
    return is_construction;
}

/// Takes what crosses out: simple outlines, and divided ones of which an area does.
Outlines without_crossings(const Outlines& outlines, double tolerance, NestedParts& nested) {
    const std::vector<EntityChain> all = all_chains(outlines);
    const std::vector<Crossing> crossings = find_crossings(outlines.entities, all, tolerance);
    std::vector<bool> is_out = construction_circles(outlines, all, crossings, nested.remarks);
    const std::vector<bool> is_construction = is_out;
    for (const Crossing& crossing : crossings) {
        if (is_construction[at(crossing.chain)] || is_construction[at(crossing.other)]) continue;
        is_out[at(crossing.chain)] = is_out[at(crossing.other)] = true;
        nested.problems.push_back(crossing.problem);
    }
    Outlines sound{outlines.entities, {}, {}};
    std::size_t chain = 0;
    for (const EntityChain& closed : outlines.closed)
        if (!is_out[chain++]) sound.closed.push_back(closed);
    for (const DividedOutline& divided : outlines.divided) {
        bool is_crossing = false;
        for (std::size_t k = 0; k < divided.faces.size(); ++k) is_crossing = is_out[chain++] || is_crossing;
        if (!is_crossing) sound.divided.push_back(divided);
    }
    return sound;
}

}  // namespace

NestedParts nest(const Outlines& outlines, double tolerance, double coincidence) {
    NestedParts nested;
    const Outlines sound = without_crossings(outlines, tolerance, nested);
    for (const DividedOutline& divided : sound.divided) nested.remarks.push_back(remark(sound.entities, divided));
    std::vector<Region> regions = regions_of(sound);
    remove_without_area(sound.entities, regions, coincidence, nested.problems);
    find_surroundings(regions, {tolerance, coincidence});
    fill(regions, sound.divided);
    std::vector<Region> holes = holes_of(sound, regions);
    assemble(regions, holes, nested);
    return nested;
}

}  // namespace abut::geometry
