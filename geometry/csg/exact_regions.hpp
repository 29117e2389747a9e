// SPDX-License-Identifier: GPL-3.0-or-later
// Regions of the plane bounded by lines and circle arcs, in exact arithmetic: what Booleans are made of (boolean.cpp). CGAL
// stays behind this header, in one file.
#pragma once
#include <memory>
#include <vector>

#include "geometry/csg/boolean.hpp"
#include "geometry/csg/carriers.hpp"

namespace abut::geometry {

/// Polygons with holes that may overlap; copies share what they hold.
struct ExactPolygons {
    struct Data;
    std::shared_ptr<Data> data;
    ExactPolygons();
};

/// A region; copies share what they hold.
struct ExactRegion {
    struct Data;
    std::shared_ptr<Data> data;
};

/// The union of all polygons, in one go.
ExactRegion joined(const ExactPolygons& polygons);
void intersect(ExactRegion& region, const ExactRegion& with);
void subtract(ExactRegion& region, const ExactRegion& what);
void append(const ExactRegion& region, ExactPolygons& polygons);

/// The exact boundaries of all primitives, which (like the carriers) must outlive it. Neighbours of a loop share an exact point
/// or are joined by a bridge, as boolean.hpp tells.
class ExactPrimitives {
public:
    ExactPrimitives(const std::vector<Primitive>& primitives, const std::vector<PlacedSource>& sources,
                    const Carriers& carriers);
    ~ExactPrimitives();

    /// The k-th primitive; appends a problem for every loop that rounding makes cross itself.
    void append(std::size_t k, ExactPolygons& polygons, std::vector<GeometryProblem>& problems);
    /// The k-th primitive is a half plane: a polygon that holds its share of the disc, its line and three far edges.
    void append_half_plane(std::size_t k, const HalfPlane& half, const BoundingDisc& disc, ExactPolygons& polygons) const;

    /// Loops of a region made of these primitives, rounded; pieces know their source.
    std::vector<std::vector<RawPiece>> loops(const ExactRegion& region) const;

private:
    struct Model;
    std::unique_ptr<Model> model_;
};

}  // namespace abut::geometry
