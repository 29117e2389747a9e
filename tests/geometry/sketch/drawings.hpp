// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings made of curves, without a file, and what must hold for the parts found in any drawing.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

using Entities = std::vector<SketchEntity>;

inline SketchEntity drawn(const Curve& curve, const std::string& name, const std::string& layer = "0") {
    SketchEntity entity;
    entity.curve = curve;
    entity.kind = std::holds_alternative<Segment>(curve) ? "LINE" : std::holds_alternative<Arc>(curve) ? "ARC" : "SPLINE";
    entity.layer = layer;
    entity.name = name;
    return entity;
}

inline SketchEntity drawn_line(const Vec2& from, const Vec2& to, const std::string& name, const std::string& layer = "0") {
    return drawn(Segment{from, to}, name, layer);
}

inline SketchEntity drawn_circle(const Vec2& center, double radius, const std::string& name, const std::string& layer = "0") {
    return drawn(Arc{center, radius, 0, 2 * std::numbers::pi}, name, layer);
}

/// Corner to corner, counter-clockwise as given; names prefix0, prefix1, ...
inline Entities drawn_polygon(const std::vector<Vec2>& corners, const std::string& prefix, const std::string& layer = "0") {
    Entities sides;
    for (std::size_t k = 0; k < corners.size(); ++k)
        sides.push_back(drawn_line(corners[k], corners[(k + 1) % corners.size()], prefix + std::to_string(k), layer));
    return sides;
}

inline Entities drawn_rectangle(const Vec2& min, const Vec2& max, const std::string& prefix, const std::string& layer = "0") {
    return drawn_polygon({min, {max.x(), min.y()}, max, {min.x(), max.y()}}, prefix, layer);
}

inline Entities operator+(Entities a, const Entities& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// As a file: entities one to a line.
inline Drawing drawing_of(Entities entities) {
    Drawing drawing;
    int line = 1;
    for (SketchEntity& entity : entities) entity.line = line++;
    drawing.entities = std::move(entities);
    return drawing;
}

inline SketchParts parts_by(const Entities& entities, PartsBy way, double tolerance = 0) {
    SketchOptions options;
    options.parts_by = way;
    options.tolerance = tolerance;
    return parts_of(drawing_of(entities), options);
}

inline void shuffle_and_turn(Entities& entities, std::mt19937& random) {
    for (std::size_t i = entities.size(); i > 1; --i) std::swap(entities[i - 1], entities[random() % i]);
    for (SketchEntity& entity : entities)
        if (random() % 2 == 0) entity.curve = reversed(entity.curve);
}

/// Loops are closed head to tail, the first one of a part runs counter-clockwise, the others clockwise; every edge lies in one
/// loop, and has a name of its own.
inline void expect_sound(const Part& part, double tolerance = 1e-12) {
    std::size_t n_edges = 0;
    std::set<std::string> names;
    for (std::size_t k = 0; k < part.loops.size(); ++k) {
        const Loop& loop = part.loops[k];
        Part alone;
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const Edge& edge = part.edges.at(static_cast<std::size_t>(loop.edges[i]));
            const Edge& next = part.edges.at(static_cast<std::size_t>(loop.edges[(i + 1) % loop.edges.size()]));
            EXPECT_LE((point(edge.curve, 1) - point(next.curve, 0)).norm(), tolerance * bounding_box(part).diagonal())
                << edge.name;
            EXPECT_TRUE(names.insert(edge.name).second) << "two edges of " << part.name << " are called " << edge.name;
            alone.edges.push_back(edge);
        }
        n_edges += loop.edges.size();
        EXPECT_EQ(area(alone) > 0, k == 0) << part.name << ", loop " << k;
    }
    EXPECT_EQ(n_edges, part.edges.size());
}

inline double total_area(const SketchParts& sketch) {
    double sum = 0;
    for (const Part& part : sketch.parts) sum += area(part);
    return sum;
}

inline std::vector<double> sorted_areas(const SketchParts& sketch) {
    std::vector<double> areas;
    for (const Part& part : sketch.parts) areas.push_back(area(part));
    std::sort(areas.begin(), areas.end());
    return areas;
}

inline std::vector<std::string> part_names(const SketchParts& sketch) {
    std::vector<std::string> names;
    for (const Part& part : sketch.parts) names.push_back(part.name);
    return names;
}

inline const Part* part_called(const SketchParts& sketch, const std::string& name) {
    for (const Part& part : sketch.parts)
        if (part.name == name) return &part;
    return nullptr;
}

inline bool says(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

}  // namespace abut::geometry
