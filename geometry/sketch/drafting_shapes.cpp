// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/drafting_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Sides of a sheet: ISO 216, and ANSI A to F with their halves.
constexpr std::array paper_proportions{std::numbers::sqrt2, 11.0 / 8.5, 17.0 / 11, 36.0 / 24, 48.0 / 36, 40.0 / 28};
constexpr double paper_accuracy = 0.005;  ///< sheets are trimmed to the millimetre
}  // namespace

Shape shape_of(const Outlines& outlines, const EntityChain& chain) {
    Shape shape;
    for (const ChainLink& link : chain) {
        const SketchPiece& piece = outlines.entities[at(link.entity)];
        shape.outline.edges.push_back({link.along ? piece.curve : reversed(piece.curve), {}, {}, true, 0.0});
        shape.entities.insert(shape.entities.end(), piece.of.begin(), piece.of.end());
    }
    shape.area = area(shape.outline);
    if (shape.area < 0) {
        std::reverse(shape.outline.edges.begin(), shape.outline.edges.end());
        for (Edge& edge : shape.outline.edges) edge.curve = reversed(edge.curve);
        shape.area = -shape.area;
    }
    shape.box = bounding_box(shape.outline);
    return shape;
}

std::optional<Arc> circle_of(const Shape& shape, double tolerance) {
    const auto* first = std::get_if<Arc>(&shape.outline.edges.front().curve);
    if (!first || !shape.faces.empty()) return std::nullopt;
    for (const Edge& edge : shape.outline.edges) {
        const auto* arc = std::get_if<Arc>(&edge.curve);
        if (!arc || (arc->center - first->center).norm() + std::abs(arc->radius - first->radius) > tolerance)
            return std::nullopt;
    }
    return *first;
}

bool is_upright_rectangle(const Shape& shape) {
    const Vec2 size = shape.box.size();
    return size.minCoeff() > 0 && std::abs(size.prod() - shape.area) <= merge_fraction * shape.area &&
           std::all_of(shape.outline.edges.begin(), shape.outline.edges.end(),
                       [](const Edge& edge) { return std::holds_alternative<Segment>(edge.curve); });
}

bool has_proportions_of_paper(const Box2& box) {
    const double ratio = box.size().maxCoeff() / box.size().minCoeff();
    return std::any_of(paper_proportions.begin(), paper_proportions.end(),
                       [&](double paper) { return std::abs(ratio / paper - 1) <= paper_accuracy; });
}

Box2 grown(Box2 box, double by) {
    box.min -= Vec2(by, by);
    box.max += Vec2(by, by);
    return box;
}

bool holds(const Box2& box, const Vec2& p) {
    return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all();
}

}  // namespace abut::geometry
