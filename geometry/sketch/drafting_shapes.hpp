// SPDX-License-Identifier: GPL-3.0-or-later
// What all lines of a drawing close to together, as shapes that may be frames, tables or balloons.
#pragma once
#include <optional>
#include <vector>

#include "geometry/sketch/sketch_outlines.hpp"

namespace abut::geometry {

/// A closed outline of everything that is drawn, or a divided one.
struct Shape {
    Part outline;               ///< counter-clockwise
    std::vector<int> entities;  ///< given entities that it is made of
    Box2 box;
    double area = 0;
    std::vector<Part> faces;  ///< of divided ones
};

/// What is set aside is called, by kind.
struct DraftingKinds {
    const char *frame = "frame of a sheet", *table = "title block or table", *sheet = "content of the sheet",
               *balloon = "balloon", *leader = "leader or arrow", *dot = "dot of a leader";
};
inline constexpr DraftingKinds drafting_kinds;

/// All that is drawn as shapes, and what of it was set aside.
struct DraftingSearch {
    const Drawing& drawing;
    std::optional<MendedLines> mended{};  ///< where none of them share areas
    ClosedOutlines closed{};
    double tolerance = 0;  ///< ends within this were joined
    std::vector<Shape> shapes{};
    std::vector<const char*> kind{};  ///< by entity; null of what is kept
    std::vector<bool> is_out{};       ///< by shape

    void leave(const std::vector<int>& entities, const char* as);
    void leave(std::size_t shape, const char* as);
    /// Leaves all entities and shapes in the box.
    void leave_inside(const Box2& box, const char* as);
};
/// Closes all lines of the drawing together; nothing is set aside yet.
DraftingSearch drafting_search(const Drawing& drawing, const SketchOptions& options);

/// The shape inside a chain; `faces` are left empty.
Shape shape_of(const Outlines& outlines, const EntityChain& chain);
/// Is it a rectangle with sides along the axes?
bool is_upright_rectangle(const Shape& shape);
/// The circle that it is, in one piece or cut; nothing where it is none.
std::optional<Arc> circle_of(const Shape& shape, double tolerance);

/// Has the box the proportions of a sheet of paper, upright or not?
bool has_proportions_of_paper(const Box2& box);
/// The box, larger by so much on all sides.
Box2 grown(Box2 box, double by);
/// Is the point in the box, or on its boundary?
bool holds(const Box2& box, const Vec2& p);

}  // namespace abut::geometry
