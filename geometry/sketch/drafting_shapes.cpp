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

Shape shape_of_divided(const Outlines& outlines, const DividedOutline& divided) {
    Shape shape = shape_of(outlines, divided.contour);
    shape.entities.clear();
    for (const Face& face : divided.faces) {
        const Shape one = shape_of(outlines, face.boundary);
        shape.entities.insert(shape.entities.end(), one.entities.begin(), one.entities.end());
        shape.faces.push_back(one.outline);
    }
    return shape;
}

}  // namespace

void DraftingSearch::leave(const std::vector<int>& entities, const char* as) {
    for (const int e : entities)
        if (!kind[at(e)]) kind[at(e)] = as;
}

void DraftingSearch::leave(std::size_t shape, const char* as) {
    leave(shapes[shape].entities, as);
    is_out[shape] = true;
}

void DraftingSearch::leave_inside(const Box2& box, const char* as) {
    for (std::size_t i = 0; i < kind.size(); ++i)
        if (!kind[i] && bounding_box(drawing.entities[i].curve).is_within(box, tolerance)) kind[i] = as;
    for (std::size_t s = 0; s < shapes.size(); ++s)
        if (shapes[s].box.is_within(box, tolerance)) is_out[s] = true;
}

DraftingSearch drafting_search(const Drawing& drawing, const SketchOptions& options) {
    SketchOptions plain = options;
    plain.recognise_arcs = false;
    Box2 box;
    for (const SketchEntity& entity : drawing.entities) box.extend(bounding_box(entity.curve));
    const double size = std::max(box.diagonal(), box.max.cwiseAbs().maxCoeff());
    DraftingSearch search{drawing};
    MendedLines lines = mended_lines(drawing.entities, plain, precision_of(drawing, size), Mending::usual);
    if (lines.chains.divided.empty()) search.mended = lines;
    cut_tables(lines);
    search.closed = close_outlines(std::move(lines), plain);
    search.tolerance = search.closed.tolerance;
    const Outlines& outlines = search.closed.outlines;
    for (const EntityChain& chain : outlines.closed) search.shapes.push_back(shape_of(outlines, chain));
    for (const DividedOutline& divided : outlines.divided) search.shapes.push_back(shape_of_divided(outlines, divided));
    search.kind.assign(drawing.entities.size(), nullptr);
    search.is_out.assign(search.shapes.size(), false);
    return search;
}

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
