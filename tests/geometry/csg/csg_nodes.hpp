// SPDX-License-Identifier: GPL-3.0-or-later
// Short ways to write geometry trees, and what every evaluated tree must satisfy.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "geometry/csg/csg.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "tests/geometry/curves/sample_curves.hpp"

namespace abut::geometry::csg_nodes {

using test::nurbs_circle;
inline constexpr double pi = std::numbers::pi;

template <class Shape>
CsgNode node(Shape shape, std::string name = "") {
    return {std::move(shape), std::move(name), "/geometry"};
}
inline CsgNode rectangle(double x0, double y0, double x1, double y1, std::string name = "") {
    return node(Rectangle{{x0, y0}, {x1, y1}}, std::move(name));
}
inline CsgNode circle(double x, double y, double r, std::string name = "") {
    return node(Circle{{x, y}, r}, std::move(name));
}
inline CsgNode ellipse(double x, double y, double a, double b, double degrees = 0, std::string name = "") {
    return node(Ellipse{{x, y}, {a, b}, degrees}, std::move(name));
}
inline CsgNode slot(double x0, double y0, double x1, double y1, double r, std::string name = "") {
    return node(Slot{{x0, y0}, {x1, y1}, r}, std::move(name));
}
inline CsgNode half_plane(double x, double y, double nx, double ny) {
    return node(HalfPlane{{x, y}, {nx, ny}});
}
inline CsgNode join(std::vector<CsgNode> of) {
    return node(Union{std::move(of)});
}
inline CsgNode common(std::vector<CsgNode> of) {
    return node(Intersection{std::move(of)});
}
inline CsgNode less(std::vector<CsgNode> of) {
    return node(Difference{std::move(of)});
}
inline CsgNode place(CsgNode of, double rotate, Vec2 translate = {0, 0}, Vec2 about = {0, 0}, double scale = 1,
                     Mirror mirror = Mirror::none) {
    return node(Placed{{std::move(of)}, rotate, translate, about, scale, mirror});
}
inline CsgNode import(Part part, std::string name = "") {
    return node(Imported{std::move(part)}, std::move(name));
}
/// One loop of curves, head to tail, named e0, e1, ...
inline CsgNode loop_of(const std::vector<Curve>& curves) {
    std::vector<LoopEdge> edges;
    for (const Curve& curve : curves) {
        const std::string k = std::to_string(edges.size());
        edges.push_back({curve, "e" + k, "/" + k});
    }
    return node(Loops{{edges}});
}

/// A closed, smooth, non-convex cubic B-spline about c, of a radius between 0.7 r and 1.3 r.
inline Curve blob(const Vec2& c, double r) {
    Nurbs nurbs{3, {}, {}, {}};
    constexpr int n = 8;
    for (int i = 0; i < n + 3; ++i) {
        const double angle = 2 * pi * i / n;
        nurbs.points.push_back(c + r * (i % n % 2 == 0 ? 1.3 : 0.7) * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = 0; i < n + 7; ++i) nurbs.knots.push_back(i);
    return nurbs_curves(nurbs).front();
}

using Names = std::set<std::string>;

inline Names names(const Part& part) {
    Names all;
    for (const Edge& edge : part.edges) all.insert(edge.name);
    return all;
}

inline const Edge& edge(const Part& part, const std::string& name) {
    const auto found = std::find_if(part.edges.begin(), part.edges.end(), [&](const Edge& e) { return e.name == name; });
    if (found == part.edges.end()) throw std::runtime_error("no edge " + name);
    return *found;
}

/// Largest distance between an edge's end and the next one's begin, over all loops.
inline double largest_gap(const Part& part) {
    double largest = 0;
    for (const Loop& loop : part.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const Curve& a = part.edges[static_cast<std::size_t>(loop.edges[i])].curve;
            const Curve& b = part.edges[static_cast<std::size_t>(loop.edges[(i + 1) % loop.edges.size()])].curve;
            largest = std::max(largest, (point(a, 1) - point(b, 0)).norm());
        }
    return largest;
}

/// Edges join to within this fraction of the size where nothing had to be moved.
inline constexpr double joint_fraction = 1e-11;

inline void expect_valid(const Part& part, double gap_fraction = joint_fraction) {
    EXPECT_FALSE(part.loops.empty());
    EXPECT_EQ(names(part).size(), part.edges.size());
    std::size_t n_used = 0;
    for (const Loop& loop : part.loops) n_used += loop.edges.size();
    EXPECT_EQ(n_used, part.edges.size());
    EXPECT_LE(largest_gap(part), gap_fraction * bounding_box(part).diagonal());
}

/// The part, after checks that hold for every result: no problem, closed loops, names given once.
inline Part good(const CsgNode& tree, double gap_fraction = joint_fraction) {
    const CsgResult result = evaluate(tree);
    for (const GeometryProblem& problem : result.problems) ADD_FAILURE() << problem.where << ": " << problem.what;
    expect_valid(result.part, gap_fraction);
    return result.part;
}

inline double area_of(const CsgNode& tree) {
    return area(good(tree));
}

inline std::string problem_of(const CsgNode& tree) {
    const CsgResult result = evaluate(tree);
    return result.problems.empty() ? "" : result.problems.front().what;
}

inline void expect_same_point(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " / " << b.transpose();
}

}  // namespace abut::geometry::csg_nodes
