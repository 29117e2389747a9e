// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/arc_fit.hpp"
#include "geometry/message_text.hpp"
#include "geometry/section_loops.hpp"

namespace abut::geometry {

namespace {

struct Box3 {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
    Vec3 size() const { return (high - low).cwiseMax(0); }
};

Box3 box_of(const std::vector<Mesh>& bodies) {
    Box3 box;
    for (const Mesh& body : bodies)
        for (const Vec3& v : body.vertices) {
            box.low = box.low.cwiseMin(v);
            box.high = box.high.cwiseMax(v);
        }
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

const char* axis_name(int axis) {
    return axis == 0 ? "x" : axis == 1 ? "y" : "z";
}

std::string text_of(const SectionPlane& plane) {
    return std::string(axis_name(plane.axis)) + " = " + number_text(plane.at);
}

// ---- planes that run along faces ----

struct Interval {
    double low, high;
    bool operator<(const Interval& other) const { return low < other.low; }
};

/// Heights of the faces that are parallel to the plane, within the band.
std::vector<Interval> flat_faces(const std::vector<const Mesh*>& bodies, int axis, double band) {
    std::vector<Interval> flat;
    for (const Mesh* body : bodies)
        for (const std::array<int, 3>& t : body->triangles) {
            const auto h = [&](std::size_t k) { return body->vertices[static_cast<std::size_t>(t[k])][axis]; };
            const auto [low, high] = std::minmax({h(0), h(1), h(2)});
            if (high - low <= 2 * band) flat.push_back({low, high});
        }
    return flat;
}

bool runs_along(const std::vector<Interval>& faces, double at, double band) {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const Interval& face) { return face.high >= at - band && face.low <= at + band; });
}

int n_met(const std::vector<const Mesh*>& bodies, const SectionPlane& plane) {
    int n = 0;
    for (const Mesh* body : bodies) {
        bool above = false, below = false;
        for (const Vec3& v : body->vertices) (v[plane.axis] >= plane.at ? above : below) = true;
        if (above && below) ++n;
    }
    return n;
}

/// The nearest plane off all faces; of the two sides that which meets more bodies, else the upper one.
SectionPlane off_faces(const std::vector<const Mesh*>& bodies, const SectionPlane& plane, double size) {
    const double band = face_band_fraction * size;
    const std::vector<Interval> faces = flat_faces(bodies, plane.axis, band);
    if (!runs_along(faces, plane.at, band)) return plane;
    SectionPlane best = plane;
    int most = 0;
    for (int k = 1; k <= most_nudges && most == 0; ++k)
        for (double sign : {1.0, -1.0}) {
            const SectionPlane moved{plane.axis, plane.at + sign * k * nudge_fraction * size};
            if (runs_along(faces, moved.at, band)) continue;
            const int n = n_met(bodies, moved);
            if (n > most) best = moved, most = n;
        }
    return best;
}

// ---- one body ----

class BodySection {
public:
    BodySection(const Mesh& body, double tolerance, Section& section) : body_(body), tolerance_(tolerance), section_(section) {}

    /// Does the plane meet the body?
    bool add() {
        const SectionLoops found = section_loops(body_, section_.plane);
        if (found.box.empty() || (found.loops.empty() && found.open.empty())) return false;
        const double size = found.box.diagonal();
        const double fit = std::max(tolerance_ > 0 ? tolerance_ : arc_fraction * size, least_arc_fraction * size);
        for (const std::vector<Vec2>& loop : found.loops)
            for (const FittedPiece& piece : fit_lines_and_arcs(loop, true, fit)) add(piece, loop.size());
        for (const SectionGap& gap : found.closed_cracks)
            section_.repairs.push_back(
                {"crack in the section of " + body_.name + " closed", gap.from, (gap.to - gap.from).norm()});
        for (const SectionGap& gap : found.open) report(gap);
        is_open_ = !found.open.empty();
        return true;
    }
    bool is_open() const { return is_open_; }

private:
    void add(const FittedPiece& piece, std::size_t n_points) {
        SketchEntity entity;
        entity.curve = piece.curve;
        if (Arc* arc = std::get_if<Arc>(&entity.curve)) {
            const bool is_full = piece.first == piece.last;
            // Whole circles as drawings hold them.
            if (is_full) arc->start = 0, arc->sweep = 2 * std::numbers::pi;
            report(*arc, piece, is_full, static_cast<int>(n_points));
        }
        entity.kind = "SECTION";
        entity.layer = entity.block = body_.name;
        entity.name = "e" + std::to_string(n_entities_++);
        section_.drawing.entities.push_back(std::move(entity));
    }

    void report(const Arc& arc, const FittedPiece& piece, bool is_full, int n_points) {
        const int n = is_full ? n_points : (piece.last - piece.first + n_points) % n_points + 1;
        section_.repairs.push_back({std::string(is_full ? "circle" : "arc") + " of radius " + number_text(arc.radius) +
                                        " through " + std::to_string(n) + " points of " + body_.name,
                                    point(arc, 0.5), piece.residual});
    }

    void report(const SectionGap& gap) {
        section_.drawing.problems.push_back({"the section of " + body_.name + " does not close: it ends at " +
                                                 place_text(gap.from) + ", a gap of " +
                                                 number_text((gap.to - gap.from).norm()) + " from " + place_text(gap.to),
                                             gap.from, body_.name, 0, "mend the mesh, or cut it at another place"});
    }

    const Mesh& body_;
    double tolerance_;
    Section& section_;
    int n_entities_ = 0;
    bool is_open_ = false;
};

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

}  // namespace

SectionPlane default_plane(const std::vector<Mesh>& bodies) {
    const Box3 box = box_of(bodies);
    const Vec3 size = box.size();
    if (!size.allFinite() || !box.low.allFinite()) return {};
    int axis = 2;
    const double rounding = face_band_fraction * size.norm();
    for (int other : {1, 0})
        if (size[other] < size[axis] - rounding) axis = other;
    return {axis, 0.5 * (box.low[axis] + box.high[axis])};
}

Section cut(const MeshFile& mesh, const SectionPlane& plane, double tolerance) {
    Section section{empty_drawing(mesh), plane, mesh.repairs};
    const std::vector<const Mesh*> bodies = sound_bodies(mesh, section.drawing.problems);
    Box3 box;
    for (const Mesh* body : bodies) {
        const Box3 own = box_of({*body});
        box.low = box.low.cwiseMin(own.low);
        box.high = box.high.cwiseMax(own.high);
    }
    if (bodies.empty() || !box.size().allFinite()) return section;
    section.plane = off_faces(bodies, plane, box.size().norm());
    if (section.plane.at != plane.at)
        section.repairs.push_back({"the plane " + text_of(plane) + " runs along faces: cut at " + text_of(section.plane),
                                   Vec2::Zero(), std::abs(section.plane.at - plane.at)});
    bool is_met = false;
    for (const Mesh* body : bodies) {
        BodySection own(*body, tolerance, section);
        if (own.add()) {
            is_met = true;
            pass_on_faults(mesh, body->name, own.is_open(), section);
            continue;
        }
        section.drawing.ignored.push_back(
            {"body " + body->name, 1, "the plane " + text_of(section.plane) + " does not meet it"});
        EntityCount& count = section.drawing.counts["body"];
        if (count.used > 0) --count.used, ++count.ignored;
    }
    if (!is_met) report_missed(box, section);
    return section;
}

Drawing section(const MeshFile& mesh, const SectionPlane& plane, double tolerance) {
    return cut(mesh, plane, tolerance).drawing;
}

}  // namespace abut::geometry
