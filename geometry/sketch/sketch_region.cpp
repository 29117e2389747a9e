// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_region.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

Edge edge_of(const SketchPiece& entity, bool along) {
    return {along ? entity.curve : reversed(entity.curve), entity.name, entity.source, along, entity.source_begin};
}

/// Distance to the boundaries of a region and of those inside it; 0 where the point is not between them.
double clearance(const std::vector<Region>& regions, int region, const std::vector<int>& inside, const Vec2& p) {
    if (!contains(finder_of(regions[at(region)]).pieces, p)) return 0;
    double least = std::numeric_limits<double>::infinity();
    const auto take = [&](const Region& r) {
        for (const Edge& edge : r.outline.edges)
            least = std::min(least, (point(edge.curve, closest_parameter(edge.curve, p)) - p).norm());
    };
    take(regions[at(region)]);
    Box2 here;
    here.extend(p);
    for (const int k : inside) {
        if (!regions[at(k)].box.overlaps(here, least)) continue;
        if (contains(finder_of(regions[at(k)]).pieces, p)) return 0;
        take(regions[at(k)]);
    }
    return least;
}

Vec2 inner_point(const std::vector<Region>& regions, int region, const std::vector<int>& inside) {
    constexpr std::size_t most_edges = 12;
    constexpr double enough = 0.2;
    const Region& own = regions[at(region)];
    const std::size_t step = (own.outline.edges.size() + most_edges - 1) / most_edges;
    const double width = 2 * own.area / perimeter(own.outline);  // of a long strip; half the radius of a circle
    Vec2 best = point(own.outline.edges.front().curve, 0.5);
    double largest = 0;
    for (std::size_t e = 0; e < own.outline.edges.size(); e += step)
        for (const double share : {0.5, 0.125, 1.0}) {
            const Curve& curve = own.outline.edges[e].curve;
            const Vec2 p = point(curve, 0.5) + share * width * left_of(unit_tangent(curve, 0.5));
            const double clear = clearance(regions, region, inside, p);
            if (clear <= largest) continue;
            largest = clear;
            best = p;
            if (largest >= enough * width) return best;
        }
    return best;
}

}  // namespace

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

const RegionFinder& finder_of(const Region& region) {
    if (!region.finder)
        region.finder =
            std::make_unique<RegionFinder>(RegionFinder{EdgeTree(region.outline), slabbed(monotone_pieces(region.outline))});
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

std::vector<Vec2> inner_points(const std::vector<Region>& regions) {
    std::vector<std::vector<int>> inside(regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i)
        if (regions[i].around >= 0) inside[at(regions[i].around)].push_back(static_cast<int>(i));
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < regions.size(); ++i) points.push_back(inner_point(regions, static_cast<int>(i), inside[i]));
    return points;
}

}  // namespace abut::geometry
