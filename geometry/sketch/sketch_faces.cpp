// SPDX-License-Identifier: GPL-3.0-or-later
// Half edge 2 k runs along entity k of the block, 2 k + 1 against it. About a joint they are sorted by where they cross a small
// circle around it: that is the order of their tangents, and of their curvatures where tangents agree.
#include "geometry/sketch/sketch_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

struct HalfEdges {
    const std::vector<SketchPiece>& entities;
    const std::vector<int>& block;
    std::vector<int> from;                              ///< joint by half edge
    std::unordered_map<int, std::vector<int>> leaving;  ///< half edges by joint, counter-clockwise once sorted
    std::vector<int> next;                              ///< by half edge: along the area on its left

    const Curve& curve(int half) const { return entities[at(block[at(half / 2)])].curve; }
    bool along(int half) const { return half % 2 == 0; }
};

int twin(int half) {
    return half ^ 1;
}

// ---- order about a joint ----

/// Where the half edge is a quarter of its length from its joint: closer to it, nothing else of it lies.
double parameter_of_quarter(const HalfEdges& halves, int half) {
    const Curve& curve = halves.curve(half);
    const double whole = length(curve);
    return parameter_at_length(curve, halves.along(half) ? whole / 4 : 3 * whole / 4);
}

/// Where it crosses the circle of that radius about its beginning, seen from there.
Vec2 leaving_direction(const HalfEdges& halves, int half, double radius) {
    const Curve& curve = halves.curve(half);
    const double begin = halves.along(half) ? 0 : 1;
    const Vec2 center = point(curve, begin);
    double near = begin, far = parameter_of_quarter(halves, half);
    constexpr int n_bisections = 60;  // to the last bit
    for (int k = 0; k < n_bisections; ++k) {
        const double middle = 0.5 * (near + far);
        ((point(curve, middle) - center).norm() < radius ? near : far) = middle;
    }
    return point(curve, far) - center;
}

void sort_about(const HalfEdges& halves, std::vector<int>& leaving) {
    double radius = std::numeric_limits<double>::infinity();
    for (const int half : leaving) {
        const Curve& curve = halves.curve(half);
        const Vec2 quarter = point(curve, parameter_of_quarter(halves, half)) - point(curve, halves.along(half) ? 0 : 1);
        radius = std::min(radius, quarter.norm());
    }
    std::vector<std::pair<double, int>> angles;
    for (const int half : leaving) {
        const Vec2 d = leaving_direction(halves, half, radius);
        angles.emplace_back(std::atan2(d.y(), d.x()), half);
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t k = 0; k < angles.size(); ++k) leaving[k] = angles[k].second;
}

HalfEdges half_edges(const std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<int>& block) {
    HalfEdges halves{entities, block, {}, {}, {}};
    for (const int e : block)
        for (const int joint : {joints.at_begin[at(e)], joints.at_end[at(e)]}) {
            halves.leaving[joint].push_back(static_cast<int>(halves.from.size()));
            halves.from.push_back(joint);
        }
    halves.next.assign(halves.from.size(), -1);
    for (auto& [joint, leaving] : halves.leaving) {
        if (leaving.size() > 2) sort_about(halves, leaving);
        // Arriving against `here`, an area on the left goes on with what leaves next to it clockwise.
        for (std::size_t k = 0; k < leaving.size(); ++k) {
            const int here = leaving[k], clockwise = leaving[(k + leaving.size() - 1) % leaving.size()];
            halves.next[at(twin(here))] = clockwise;
        }
    }
    return halves;
}

// ---- areas ----

struct FaceWalk {
    std::vector<int> halves;
    double area = 0;  ///< signed
};

double signed_area(const HalfEdges& halves, const std::vector<int>& walk) {
    Part part;
    for (const int half : walk) {
        const Curve& curve = halves.curve(half);
        part.edges.push_back({halves.along(half) ? curve : reversed(curve), {}, {}, true, 0.0});
    }
    return area(part);
}

std::vector<FaceWalk> all_walks(const HalfEdges& halves, std::vector<int>& walk_of) {
    std::vector<FaceWalk> walks;
    walk_of.assign(halves.next.size(), -1);
    for (std::size_t h = 0; h < halves.next.size(); ++h) {
        if (walk_of[h] >= 0) continue;
        FaceWalk walk;
        for (int half = static_cast<int>(h); walk_of[at(half)] < 0; half = halves.next[at(half)]) {
            walk_of[at(half)] = static_cast<int>(walks.size());
            walk.halves.push_back(half);
        }
        walk.area = signed_area(halves, walk.halves);
        walks.push_back(std::move(walk));
    }
    return walks;
}

EntityChain chain_of(const HalfEdges& halves, const std::vector<int>& walk) {
    EntityChain chain;
    for (const int half : walk) chain.push_back({halves.block[at(half / 2)], halves.along(half)});
    std::rotate(chain.begin(),
                std::min_element(chain.begin(), chain.end(), [](const auto& a, const auto& b) { return a.entity < b.entity; }),
                chain.end());
    return chain;
}

EntityChain backwards(EntityChain chain) {
    std::reverse(chain.begin() + 1, chain.end());  // the first stays first
    for (ChainLink& link : chain) link.along = !link.along;
    return chain;
}

// ---- which are filled ----

/// How often each entity of the block counts; empty where some line stands for two outlines.
std::vector<int> crossings_by_entity(const HalfEdges& halves) {
    std::vector<int> times;
    for (const int e : halves.block) times.push_back(halves.entities[at(e)].times_drawn);
    if (std::all_of(times.begin(), times.end(), [](int n) { return n % 2 == 0; }))
        for (int& n : times) n /= 2;
    for (const auto& [joint, leaving] : halves.leaving) {
        int n_ends = 0;
        for (const int half : leaving) n_ends += times[at(half / 2)];
        if (n_ends % 2 != 0) return {};
    }
    return times;
}

/// Parity of the lines crossed from outside, by walk.
std::vector<bool> parities(const std::vector<FaceWalk>& walks, const std::vector<int>& walk_of, int outside,
                           const std::vector<int>& times) {
    std::vector<bool> is_odd(walks.size(), false), is_known(walks.size(), false);
    std::vector<int> open{outside};
    is_known[at(outside)] = true;
    while (!open.empty()) {
        const int here = open.back();
        open.pop_back();
        for (const int half : walks[at(here)].halves) {
            const int beyond = walk_of[at(twin(half))];
            if (is_known[at(beyond)]) continue;
            is_known[at(beyond)] = true;
            is_odd[at(beyond)] = is_odd[at(here)] != (times[at(half / 2)] % 2 != 0);
            open.push_back(beyond);
        }
    }
    return is_odd;
}

}  // namespace

DividedOutline walk_faces(const std::vector<SketchPiece>& entities, const Joints& joints, const std::vector<int>& block) {
    const HalfEdges halves = half_edges(entities, joints, block);
    std::vector<int> walk_of;
    const std::vector<FaceWalk> walks = all_walks(halves, walk_of);
    const auto outside =
        std::min_element(walks.begin(), walks.end(), [](const FaceWalk& a, const FaceWalk& b) { return a.area < b.area; });
    const std::vector<int> times = crossings_by_entity(halves);
    const int outer = static_cast<int>(outside - walks.begin());

    DividedOutline found;
    found.contour = backwards(chain_of(halves, outside->halves));
    found.is_even_odd = !times.empty();
    const std::vector<bool> is_odd = found.is_even_odd ? parities(walks, walk_of, outer, times) : std::vector<bool>();
    for (std::size_t w = 0; w < walks.size(); ++w)
        if (static_cast<int>(w) != outer)
            found.faces.push_back({chain_of(halves, walks[w].halves), is_odd.empty() || is_odd[w]});
    std::stable_sort(found.faces.begin(), found.faces.end(),
                     [](const Face& a, const Face& b) { return a.boundary.front().entity < b.boundary.front().entity; });
    return found;
}

}  // namespace abut::geometry
