// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings: unordered entities out of a file, and the parts that they bound.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "geometry/part.hpp"

namespace abut::geometry {

struct SketchEntity {
    Curve curve;
    std::string kind;  ///< "LINE", "ARC", "CIRCLE", "LWPOLYLINE"
    std::string layer;
    std::string name;  ///< "h2F" (the handle), "h2F.0" for a polyline's segment, "l123" (file line) without a handle
    int line = 0;      ///< in the file, counted from 1
};

struct EntityCount {
    int read = 0, used = 0, ignored = 0;
};
struct Ignored {
    std::string what;
    int count = 0;
    std::string why;
};
struct Repair {
    std::string what;
    Vec2 at;
    double size = 0;
};
struct SketchProblem {
    std::string what;
    Vec2 at;
    std::string entity;
    int line = 0;
    std::string hint;
};

struct Drawing {
    std::string file, format;  ///< format: "DXF AC1014"
    std::string unit;          ///< "mm", "in", ...; empty when the file states none
    std::vector<SketchEntity> entities;
    std::map<std::string, EntityCount> counts;  ///< by entity type; the sum of read is every entity of the model space
    std::vector<Ignored> ignored;
    std::vector<SketchProblem> problems;  ///< unreadable entities
};

/// Reads an ASCII DXF file through dxflib. Throws InputError (file, line) if it is missing, empty, truncated or no DXF.
Drawing read_dxf(const std::string& path);

struct SketchOptions {
    double tolerance = 0;  ///< endpoint joining distance; 0: joining_fraction of each part's diagonal
};
/// Default joining distance of endpoints as a fraction of the diagonal of the entities being joined.
inline constexpr double joining_fraction = 2e-5;

struct SketchParts {
    std::vector<Part> parts;          ///< in order of first appearance in the file; named after the layer
    std::vector<std::string> layers;  ///< layer of each part
    std::vector<Repair> repairs;
    std::vector<SketchProblem> problems;
    double tolerance = 0;  ///< the largest that was used
};

/// Joins the entities of each layer into closed loops and sorts them by nesting into parts: one part per outer loop
/// (`LAYER`, or `LAYER#0`, `LAYER#1`, ... where a layer holds several). Edges are named after their entities; adjacent
/// entities are never merged. Open chains and branchings are problems with place, gap size and file line.
SketchParts parts_by_layer(const Drawing& drawing, const SketchOptions& options);

/// Factor from one length unit to another ("mm", "cm", "m", "in", "ft", "um"); 0 for unknown names.
double unit_factor(const std::string& from, const std::string& to);

}  // namespace abut::geometry
