// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings: unordered entities out of a file, and the parts that they bound.
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/brep/repair.hpp"

namespace abut::geometry {

/// A curve of a drawing with what the file says of it.
struct SketchEntity {
    Curve curve;
    std::string kind;  ///< "LINE", "ARC", "CIRCLE", "LWPOLYLINE"
    std::string layer;
    std::string name;      ///< "h2F" (the handle), "h2F.0" for a polyline's segment, "l123" (file line) without a handle
    int line = 0;          ///< in the file, counted from 1
    std::string block;     ///< block (or mesh node) that it stands in, outermost first: "CLAMP/PIN"; empty outside of blocks
    std::string instance;  ///< "PIN#0", "PIN#1", ... where the block is inserted more than once, else empty
    int color = 7;         ///< AutoCAD colour index, by layer or block where the entity says so
    int insertion = -1;    ///< the innermost insertion of a block that it stands in (Drawing::insertions); -1: none
};

/// An insertion of a block.
struct Insertion {
    std::string block;
    int around = -1;  ///< the insertion that it stands in; -1: none
};

/// How many entities of a type were read, used and ignored.
struct EntityCount {
    int read = 0, used = 0, ignored = 0;
};
struct Ignored {
    std::string what;
    int count = 0;
    std::string why;
};
struct SketchProblem {
    std::string what;
    Vec2 at;
    std::string entity;
    int line = 0;
    std::string hint;
    bool is_crossing = false;  ///< of lines or outlines that cross or touch
};

/// A text of a drawing: it tells balloons, leaders and tables from parts.
struct DrawnText {
    std::string text;
    Vec2 at{0, 0};  ///< where it begins, or its middle
    double height = 0;
};

/// How a hatch looks. Areas of one part look alike, parts beside each other do not (ISO 128-3).
struct HatchLook {
    std::string pattern;  ///< "ANSI31", "SOLID"
    double angle = 0;     ///< degrees, as it is seen
    double scale = 1;     ///< as it is seen
    std::string layer;
    int color = 7;  ///< AutoCAD colour index, or RRGGBB + 2^24
};

/// A hatched or filled area: there is material.
struct Hatch {
    std::vector<std::vector<Curve>> loops;  ///< closed each; what lies in an odd number of them is hatched
    HatchLook look;
    std::string name;
    int line = 0;
};

/// The entities of a file, unordered, with what could not be read.
struct Drawing {
    std::string file, format;  ///< format: "DXF AC1014"
    std::string unit;          ///< "mm", "in", ...; empty when the file states none
    std::string cut_at;        ///< of solids: the plane, "z = 5"
    double factor = 1;         ///< what the coordinates have been multiplied by since they were read
    std::vector<SketchEntity> entities;
    std::map<std::string, EntityCount> counts;  ///< by entity type; the sum of read is every entity of the model space
    std::vector<Ignored> ignored;
    std::vector<SketchProblem> problems;  ///< unreadable entities
    std::vector<SketchProblem> warnings;  ///< curves that were left out or projected, units that were guessed
    std::vector<DrawnText> texts;
    std::vector<Vec2> arrows;  ///< corners of small filled areas: tips of arrows
    std::vector<Hatch> hatches;
    std::vector<Insertion> insertions;         ///< of blocks of which something is drawn, each after the one that it stands in
    std::vector<std::string> drafting_layers;  ///< those that were left out for their names
    std::set<std::string> hole_layers;         ///< layers, and blocks, whose names say that they hold holes
    std::vector<Repair> repairs;               ///< of meshes: what was mended, arcs recovered, the plane moved
    std::string replaced_unit;                 ///< what the file states, where an option says that `unit` is meant
};

/// What belongs to one part: what is on one layer, in one block instance, of one colour; or (loop) every outline by itself,
/// whatever it is drawn on. `automatic`: by layer where more than one holds closed outlines, else by block where everything
/// lies in several blocks or insertions of blocks, else by loop. By loop, too, where layers close only together, or where all
/// layers or blocks but one lie wholly in the material of that one: they hold its holes (bodies of meshes never do, nor do
/// layers of which parts touch or lie in each other's holes: an assembly in the frame of a sheet). Never by loop where that
/// only cuts the parts of one layer by lines of another.
enum class PartsBy { automatic, layer, block, loop, color };

/// A gap in what does not close, below this fraction of the length of what is drawn, is a fault of the drawing; wider ones
/// belong to leaders, threads, arrows, and axes.
inline constexpr double nearly_closed_fraction = 0.01;

/// The choices of making parts from a drawing.
struct SketchOptions {
    double tolerance = 0;  ///< endpoint joining distance; 0: joining_fraction of each part's diagonal or total length
    PartsBy parts_by = PartsBy::automatic;
    bool recognise_arcs = true;  ///< facets and splines that are arcs within the tolerance become arcs
    bool keep_drafting = false;  ///< frames, tables and balloons are outlines like any other
    bool leave_open = false;     ///< outlines that nearly close are set aside, too
    /// Blocks, as patterns with * and ?, of which the outline around everything is taken (sketch_silhouettes.hpp).
    std::vector<std::string> block_outline{};
    /// What regions are, by their names (SketchRegion): "void", "part", the name of the part, or the region that it is one part
    /// with ("r3").
    std::map<std::string, std::string> regions{};
};
/// Default joining distance of endpoints as a fraction of the diagonal of the entities being joined, or of the total length of
/// what is drawn where that is less (outlines far apart).
inline constexpr double joining_fraction = 2e-5;

/// An area that lines bound, material or not.
struct SketchRegion {
    std::string name;  ///< "r1", "r2", ... in the order of the file
    Vec2 at{0, 0};     ///< a point inside, clear of its boundary
    std::string part;  ///< the part's name; empty: no material
    bool is_doubtful = false;
};

/// The parts of a drawing, how they were told apart, and what was mended and wrong.
struct SketchParts {
    std::vector<Part> parts;            ///< in order of first appearance in the file
    std::vector<std::string> layers;    ///< layer (block instance, colour) of each part
    PartsBy parts_by = PartsBy::layer;  ///< what was done, and why where it was left open
    std::string why;
    std::vector<Repair> repairs;
    std::vector<SketchProblem> problems;
    std::vector<SketchProblem> warnings;  ///< what was set aside or guessed, each with its place
    std::vector<SketchRegion> regions;
    double open_length = 0;  ///< of all lines that were set aside since they bound nothing
    double tolerance = 0;    ///< the largest that was used
    double merged = 0;       ///< curves nearer than this were taken for one, at most
    double rounding = 0;     ///< what the digits of the coordinates may have moved outlines by (written_digits.hpp)
};

/// Joins the entities of each group into closed outlines and sorts them by nesting into parts: one part per outer outline.
/// Parts are named after the layer, the block or its instance, or `color3` (by loop: the layer); `LAYER#0`, `LAYER#1`, ...
/// where several have one name, `INSTANCE:LAYER` where a repeated block's geometry is grouped by layer. Edges are named after
/// their entities; adjacent ones are never merged but where facets stand for an arc. Where outlines share edges that are drawn
/// once, each area is a part (sketch_faces.hpp). Lines that bound nothing are set aside with a warning, what belongs to the
/// sheet or explains the drawing as well (sketch_drafting.hpp); outlines that nearly close (a gap below nearly_closed_fraction
/// of their length) and crossings are problems with place, gap size and file line; everything that was mended is a repair. The
/// numbers of the results are in the file's coordinates.
SketchParts parts_of(const Drawing& drawing, const SketchOptions& options);

/// Factor from one length unit to another ("mm", "cm", "m", "in", "ft", "um"); 0 for unknown names.
double unit_factor(const std::string& from, const std::string& to);

}  // namespace abut::geometry
