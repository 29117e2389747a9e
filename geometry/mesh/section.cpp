// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/section.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/brep/message_text.hpp"
#include "geometry/mesh/section_bulges.hpp"
#include "geometry/mesh/section_loops.hpp"

namespace abut::geometry {

namespace {

Box3 box_of(const Mesh& body) {
    Box3 box;
    for (const Vec3& v : body.vertices) box.add(v);
    return box;
}

bool is_sound(const Mesh& body) {
    for (const Vec3& v : body.vertices)
        if (!v.allFinite() || v.cwiseAbs().maxCoeff() > largest_mesh_coordinate) return false;
    const int n = static_cast<int>(body.vertices.size());
    for (const std::array<int, 3>& t : body.triangles)
        for (int i : t)
            if (i < 0 || i >= n) return false;
    return true;
}

// ---- planes that run along faces ----

/// Heights of the faces that are parallel to the plane, within the band.
std::vector<HeightRange> flat_faces(const std::vector<const Mesh*>& bodies, int axis, double band) {
    std::vector<HeightRange> flat;
    for (const Mesh* body : bodies)
        for (const std::array<int, 3>& t : body->triangles) {
            const auto h = [&](std::size_t k) { return body->vertices[static_cast<std::size_t>(t[k])][axis]; };
            const auto [low, high] = std::minmax({h(0), h(1), h(2)});
            if (high - low <= 2 * band) flat.push_back({low, high});
        }
    return flat;
}

/// The nearest plane off all faces.
SectionPlane off_faces(const std::vector<const Mesh*>& bodies, const SectionPlane& plane, double size) {
    std::vector<HeightRange> heights;
    for (const Mesh* body : bodies) {
        const Box3 box = box_of(*body);
        heights.push_back({box.low[plane.axis], box.high[plane.axis]});
    }
    return off_faces(flat_faces(bodies, plane.axis, face_band_fraction * size), heights, plane, size);
}

// ---- one body ----

/// What the plane cuts out of a body.
struct BodyCut {
    const Mesh* body;
    std::vector<SectionGap> open, closed_cracks;
};

std::string counted_points(int n, const Mesh& body) {
    return " through " + std::to_string(n) + " points of " + body.name;
}

/// What was recovered, and how far the points are from it.
void report(const RecoveredPiece& piece, const Mesh& body, std::vector<Repair>& repairs) {
    using Kind = RecoveredPiece::Kind;
    if (piece.kind == Kind::line) return;
    const Vec2 at = point(piece.curves[piece.curves.size() / 2], piece.curves.size() > 1 ? 0 : 0.5);
    if (piece.kind == Kind::curve) {
        repairs.push_back({"curve of " + std::to_string(piece.curves.size()) + " arcs" +
                               counted_points(piece.n_facets + 1, body) + ", up to " + number_text(piece.sagitta) +
                               " from its facets",
                           at, piece.residual});
        return;
    }
    const bool is_full = piece.kind == Kind::circle;
    repairs.push_back({std::string(is_full ? "circle" : "arc") + " of radius " +
                           number_text(std::get<Arc>(piece.curves.front()).radius) +
                           counted_points(piece.n_facets + (is_full ? 0 : 1), body),
                       at, piece.residual});
}

void add_entities(const BodyOutlines& found, const Mesh& body, Section& section) {
    int n = 0;
    for (const RecoveredOutline& outline : found.outlines)
        for (const RecoveredPiece& piece : outline.pieces) {
            report(piece, body, section.repairs);
            for (const Curve& curve : piece.curves) {
                SketchEntity entity;
                entity.curve = curve;
                entity.kind = "SECTION";
                entity.layer = entity.block = body.name;
                entity.name = "e" + std::to_string(n++);
                section.drawing.entities.push_back(std::move(entity));
            }
        }
}

void report(const SectionGap& gap, const Mesh& body, Section& section) {
    section.drawing.problems.push_back({"the section of " + body.name + " does not close: it ends at " + place_text(gap.from) +
                                            ", a gap of " + number_text((gap.to - gap.from).norm()) + " from " +
                                            place_text(gap.to),
                                        gap.from, body.name, 0, "mend the mesh, or cut it at another place"});
}

// ---- all bodies ----

/// Curves that cross what their facets do not become facets again. Which may then be in the way of others, so once more.
void leave_facets_where_curves_cross(const std::vector<BodyCut>& cuts, std::vector<BodyOutlines>& bodies, Section& section) {
    for (auto conflicts = conflicts_of_bulges(bodies); !conflicts.empty(); conflicts = conflicts_of_bulges(bodies))
        for (auto conflict = conflicts.rbegin(); conflict != conflicts.rend(); ++conflict) {  // places before stay valid
            const auto own = static_cast<std::size_t>(conflict->body), other = static_cast<std::size_t>(conflict->other);
            RecoveredOutline& outline = bodies[own].outlines[static_cast<std::size_t>(conflict->outline)];
            const auto place = outline.pieces.begin() + conflict->piece;
            const std::vector<RecoveredPiece> facets = facets_of(outline, *place);
            section.repairs.push_back({std::to_string(facets.size()) + " facets of " + cuts[own].body->name +
                                           " left as they are: a curve through their points would cross " +
                                           (own == other ? "it elsewhere" : cuts[other].body->name),
                                       conflict->at, conflict->depth});
            outline.pieces.insert(outline.pieces.erase(place), facets.begin(), facets.end());
        }
}

/// What is wrong with a body's mesh matters where its section does not close, and is told in any case.
void pass_on_faults(const MeshFile& mesh, const std::string& body, bool is_open, Section& section) {
    for (const SketchProblem& problem : mesh.problems) {
        if (problem.entity != body) continue;
        if (is_open)
            section.drawing.problems.push_back(problem);
        else
            section.repairs.push_back({body + ": " + problem.what + "; its section closes all the same", problem.at, 0});
    }
}

void report_missed(const Box3& box, Section& section) {
    const int axis = section.plane.axis;
    section.drawing.problems.push_back({"the plane " + text_of(section.plane) + " meets no body", Vec2::Zero(), "", 0,
                                        "choose a section; the bodies lie between " + text_of({axis, box.low[axis]}) + " and " +
                                            text_of({axis, box.high[axis]})});
}

void report_missed_body(const Mesh& body, Section& section) {
    section.drawing.ignored.push_back({"body " + body.name, 1, "the plane " + text_of(section.plane) + " does not meet it"});
    EntityCount& count = section.drawing.counts["body"];
    if (count.used > 0) --count.used, ++count.ignored;
}

void add(const BodyCut& cut, const BodyOutlines& outlines, const MeshFile& mesh, Section& section) {
    add_entities(outlines, *cut.body, section);
    for (const SectionGap& gap : cut.closed_cracks)
        section.repairs.push_back(
            {"crack in the section of " + cut.body->name + " closed", gap.from, (gap.to - gap.from).norm()});
    for (const SectionGap& gap : cut.open) report(gap, *cut.body, section);
    pass_on_faults(mesh, cut.body->name, !cut.open.empty(), section);
}

Drawing empty_drawing(const MeshFile& mesh) {
    Drawing drawing;
    drawing.file = mesh.file;
    drawing.format = mesh.format;
    drawing.unit = mesh.unit;
    drawing.counts = mesh.counts;
    drawing.ignored = mesh.ignored;
    return drawing;
}

std::vector<const Mesh*> sound_bodies(const MeshFile& mesh, std::vector<SketchProblem>& problems) {
    std::vector<const Mesh*> sound;
    for (const Mesh& body : mesh.bodies) {
        if (is_sound(body))
            sound.push_back(&body);
        else
            problems.push_back({"the mesh of " + body.name + " is damaged", Vec2::Zero(), body.name, 0, "export it again"});
    }
    return sound;
}

/// Facets of walls lean by what rounding makes of them, and small ones by more: a share of the area may.
constexpr double most_leaning = 1e-3;  ///< sine
constexpr double leaning_share = 1e-3;

WallAxes wall_axes(const std::vector<Mesh>& bodies) {
    double all = 0;
    Vec3 leaning = Vec3::Zero();  // by axis: area of facets that are neither along it nor across
    for (const Mesh& body : bodies) {
        if (!is_sound(body)) continue;
        for (const std::array<int, 3>& t : body.triangles) {
            const auto corner = [&](std::size_t k) -> const Vec3& { return body.vertices[static_cast<std::size_t>(t[k])]; };
            const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)) / 2;
            const double area = normal.norm();
            all += area;
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 within = normal;
                within[axis] = 0;
                if (std::min(std::abs(normal[axis]), within.norm()) > most_leaning * area) leaning[axis] += area;
            }
        }
    }
    WallAxes axes{};
    for (int axis = 0; axis < 3; ++axis) axes[static_cast<std::size_t>(axis)] = leaning[axis] <= leaning_share * all;
    return axes;
}

}  // namespace

SectionPlane plane_of(const SectionChoice& choice, const std::vector<Mesh>& bodies) {
    Box3 box;
    for (const Mesh& body : bodies) box.add(box_of(body));
    return plane_of(choice, box, choice.axis < 0 ? wall_axes(bodies) : WallAxes{});
}

Section cut(const MeshFile& mesh, const SectionPlane& plane, const SectionOptions& options) {
    Section section{empty_drawing(mesh), plane, mesh.repairs};
    const std::vector<const Mesh*> bodies = sound_bodies(mesh, section.drawing.problems);
    Box3 box;
    for (const Mesh* body : bodies) box.add(box_of(*body));
    if (bodies.empty() || !box.size().allFinite()) return section;
    section.plane = off_faces(bodies, plane, box.size().norm());
    section.drawing.cut_at = text_of(section.plane);
    if (section.plane.at != plane.at)
        section.repairs.push_back({"the plane " + text_of(plane) + " runs along faces: cut at " + text_of(section.plane),
                                   Vec2::Zero(), std::abs(section.plane.at - plane.at)});
    std::vector<BodyCut> cuts;
    std::vector<BodyOutlines> outlines;
    for (const Mesh* body : bodies) {
        SectionLoops found = section_loops(*body, section.plane);
        if (found.box.empty() || (found.loops.empty() && found.open.empty())) {
            report_missed_body(*body, section);
            continue;
        }
        const double size = found.box.diagonal();
        outlines.push_back(
            {{}, std::max(options.tolerance > 0 ? options.tolerance : arc_fraction * size, least_arc_fraction * size)});
        for (const std::vector<Vec2>& loop : found.loops)
            outlines.back().outlines.push_back(outline_of(loop, outlines.back().tolerance, options.recognise_arcs));
        cuts.push_back({body, std::move(found.open), std::move(found.closed_cracks)});
    }
    leave_facets_where_curves_cross(cuts, outlines, section);
    for (std::size_t k = 0; k < cuts.size(); ++k) add(cuts[k], outlines[k], mesh, section);
    if (cuts.empty()) report_missed(box, section);
    return section;
}

Section cut(const MeshFile& mesh, const SectionPlane& plane, double tolerance) {
    return cut(mesh, plane, SectionOptions{tolerance, true});
}

Drawing section(const MeshFile& mesh, const SectionPlane& plane, double tolerance) {
    return cut(mesh, plane, tolerance).drawing;
}

}  // namespace abut::geometry
