// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing out of a DXF file. The pre-pass finds the records and judges which are outlines; dxflib then reads their numbers.
// dxflib is given only records that passed the checks here, each with its index in place of its layer's name: that leads back
// from dxflib's call to the record, its line, handle and layer.
#include <dl_creationadapter.h>
#include <dl_dxf.h>

#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "geometry/dxf_ignored.hpp"
#include "geometry/dxf_prepass.hpp"
#include "geometry/input_error.hpp"
#include "geometry/sketch.hpp"

namespace abut::geometry {

namespace {

using dxf::Group;
using dxf::Record;
using dxf::Structure;

constexpr double degree = std::numbers::pi / 180;
/// Coordinates beyond this are damage, not drawing: their squares would eat all digits of anything else.
constexpr double largest_coordinate = 1e12;

/// An entity to be read: its record, and for POLYLINE those of its vertices.
struct Outline {
    const Record* record;
    std::vector<const Record*> vertices;
    std::string name;  ///< "h2F" or "l123"
};

// ---- the drawing's length unit ----

std::string unit_of(const std::map<std::string, std::string>& header) {
    static const std::map<std::string, std::string> by_insunits{{"1", "in"},  {"2", "ft"}, {"4", "mm"},  {"5", "cm"},
                                                                {"6", "m"},   {"7", "km"}, {"9", "mil"}, {"10", "yd"},
                                                                {"13", "um"}, {"14", "dm"}};
    const auto value = [&](const char* variable) {
        const auto found = header.find(variable);
        return found == header.end() ? std::string() : found->second;
    };
    if (const auto unit = by_insunits.find(value("$INSUNITS")); unit != by_insunits.end()) return unit->second;
    if (value("$MEASUREMENT") == "0") return "in";
    if (value("$MEASUREMENT") == "1") return "mm";
    return {};
}

// ---- checks before dxflib, which takes what it cannot read for zero ----

std::string missing_number(const Record& record, std::initializer_list<int> codes) {
    for (int code : codes) {
        const Group* group = record.find(code);
        double number = 0;
        const std::string label = "group " + std::to_string(code);
        if (!group) return label + " is missing";
        if (!dxf::parse_number(group->value, number))
            return label + " is '" + group->value.substr(0, 40) + "', which is no number";
        if (std::abs(number) > largest_coordinate)
            return label + " is " + group->value.substr(0, 40) + ", which is no sensible size";
    }
    return {};
}

std::string wrong_lwpolyline(const Record& record) {
    int n_x = 0, n_y = 0;
    for (const Group& group : record.groups) {
        if (group.code != 10 && group.code != 20 && group.code != 42) continue;
        if (group.code == 10) ++n_x;
        if (group.code == 20) ++n_y;
        const bool is_in_step = group.code == 20 ? n_x == n_y : group.code == 10 ? n_x == n_y + 1 : n_x >= 1;
        if (!is_in_step) return "its vertices lack coordinates";
        const Record alone{record.type, record.line, {group}};
        if (std::string wrong = missing_number(alone, {group.code}); !wrong.empty()) return wrong;
    }
    if (n_x != n_y) return "its vertices lack coordinates";
    return n_x < 2 ? "it has fewer than two vertices" : "";
}

std::string wrong_polyline(const Outline& outline) {
    if (outline.vertices.size() < 2) return "it has fewer than two vertices";
    for (const Record* vertex : outline.vertices) {
        std::string wrong = missing_number(*vertex, {10, 20});
        if (wrong.empty() && vertex->find(42)) wrong = missing_number(*vertex, {42});
        if (!wrong.empty()) return "vertex at line " + std::to_string(vertex->line) + ": " + wrong;
    }
    return {};
}

std::string wrong_radius(const Record& record) {
    double radius = 0;
    dxf::parse_number(record.text(40), radius);
    return radius < 0 ? "its radius is negative" : "";
}

/// What makes the entity unreadable; empty if nothing does.
std::string what_is_wrong(const Outline& outline) {
    const Record& record = *outline.record;
    if (record.type == "LINE") return missing_number(record, {10, 20, 11, 21});
    if (record.type == "LWPOLYLINE") return wrong_lwpolyline(record);
    if (record.type == "POLYLINE") return wrong_polyline(outline);
    const std::string wrong =
        record.type == "ARC" ? missing_number(record, {10, 20, 40, 50, 51}) : missing_number(record, {10, 20, 40});
    return wrong.empty() ? wrong_radius(record) : wrong;
}

// ---- the clean text for dxflib ----

void write_groups(std::ostream& text, const Record& record, std::size_t index, std::initializer_list<int> codes) {
    text << "0\n" << record.type << "\n8\n" << index << "\n";
    for (int code : codes)
        if (const Group* group = record.find(code)) text << code << "\n" << group->value << "\n";
}

void write_lwpolyline(std::ostream& text, const Record& record, std::size_t index) {
    std::size_t n = 0;
    for (const Group& group : record.groups) n += group.code == 10;
    write_groups(text, record, index, {70});
    text << "90\n" << n << "\n";
    for (const Group& group : record.groups)
        if (group.code == 10 || group.code == 20 || group.code == 42) text << group.code << "\n" << group.value << "\n";
}

std::string clean_text(const std::vector<Outline>& outlines) {
    std::ostringstream text;
    text << "0\nSECTION\n2\nENTITIES\n";
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const Record& record = *outlines[i].record;
        if (record.type == "LWPOLYLINE")
            write_lwpolyline(text, record, i);
        else
            write_groups(text, record, i, {70, 10, 20, 11, 21, 40, 50, 51});
        for (const Record* vertex : outlines[i].vertices) write_groups(text, *vertex, i, {10, 20, 42});
        if (record.type == "POLYLINE") text << "0\nSEQEND\n8\n" << i << "\n";
    }
    text << "0\nENDSEC\n0\nEOF\n";
    return text.str();
}

// ---- from dxflib's numbers to curves ----

/// Along the parts' common normal -z the file's x runs backwards (the "arbitrary axis" of an extrusion (0, 0, -1)).
Curve mirrored_in_x(const Curve& curve) {
    const auto mirror = [](const Vec2& p) { return Vec2(-p.x(), p.y()); };
    if (const auto* s = std::get_if<Segment>(&curve)) return Segment{mirror(s->from), mirror(s->to)};
    const Arc& arc = std::get<Arc>(curve);
    return Arc{mirror(arc.center), arc.radius, std::numbers::pi - arc.start, -arc.sweep};
}

bool is_seen_from_below(const Record& record) {
    double z = 1;
    return dxf::has_own_plane(record) && dxf::parse_number(record.text(230, "1"), z) && z < 0;
}

/// From vertex to vertex; bulge = tan(sweep / 4), positive counter-clockwise.
Curve from_bulge(const Vec2& from, const Vec2& to, double bulge) {
    constexpr double straight = 1e-12;  // sagitta below a rounding error of the chord
    if (std::abs(bulge) < straight || from == to) return Segment{from, to};
    const Vec2 center = 0.5 * (from + to) + (1 - bulge * bulge) / (4 * bulge) * left_of(to - from);
    const Vec2 d = from - center;
    return Arc{center, d.norm(), std::atan2(d.y(), d.x()), 4 * std::atan(bulge)};
}

/// Counter-clockwise from one angle to the other (degrees); equal angles are a full turn.
Arc arc_between(const Vec2& center, double radius, double from, double to) {
    double sweep = std::fmod(to - from, 360.0);
    if (sweep <= 0) sweep += 360;
    return Arc{center, radius, from * degree, sweep * degree};
}

class Listener : public DL_CreationAdapter {
public:
    Listener(const std::vector<Outline>& outlines, std::vector<SketchEntity>& entities)
        : outlines_(outlines), entities_(entities) {}

    void addLine(const DL_LineData& d) override { add(Segment{{d.x1, d.y1}, {d.x2, d.y2}}, current(), ""); }
    void addArc(const DL_ArcData& d) override { add(arc_between({d.cx, d.cy}, d.radius, d.angle1, d.angle2), current(), ""); }
    void addCircle(const DL_CircleData& d) override {
        add(Arc{{d.cx, d.cy}, d.radius, 0, 2 * std::numbers::pi}, current(), "");
    }

    void addPolyline(const DL_PolylineData& d) override {
        finish_polyline();
        polyline_ = current();
        is_closed_ = (d.flags & 1) != 0;
    }
    void addVertex(const DL_VertexData& d) override { vertices_.push_back(d); }
    void endSequence() override { finish_polyline(); }

    /// dxflib announces no end of an LWPOLYLINE: it ends where the next entity begins.
    void finish_polyline() {
        const std::size_t n = vertices_.size();
        for (std::size_t k = 0; k + (is_closed_ ? 0 : 1) < n; ++k) {
            const DL_VertexData &a = vertices_[k], &b = vertices_[(k + 1) % n];
            const Vec2 from(a.x, a.y), to(b.x, b.y);
            if (k + 1 == n && from == to) break;  // the first point was repeated, and the polyline flagged as closed besides
            add_entity(from_bulge(from, to, a.bulge), polyline_, "." + std::to_string(k));
        }
        vertices_.clear();
    }

private:
    std::size_t current() { return std::stoul(getAttributes().getLayer()); }

    void add(const Curve& curve, std::size_t index, const std::string& suffix) {
        finish_polyline();
        add_entity(curve, index, suffix);
    }

    void add_entity(const Curve& curve, std::size_t index, const std::string& suffix) {
        const Outline& outline = outlines_.at(index);
        const Record& record = *outline.record;
        entities_.push_back({is_seen_from_below(record) ? mirrored_in_x(curve) : curve, record.type, record.text(8, "0"),
                             outline.name + suffix, record.line});
    }

    const std::vector<Outline>& outlines_;
    std::vector<SketchEntity>& entities_;
    std::vector<DL_VertexData> vertices_;
    std::size_t polyline_ = 0;
    bool is_closed_ = false;
};

void read_outlines(const std::vector<Outline>& outlines, std::vector<SketchEntity>& entities) {
    std::istringstream text(clean_text(outlines));
    Listener listener(outlines, entities);
    DL_Dxf reader;
    reader.in(text, &listener);
    listener.finish_polyline();
}

// ---- sorting the records ----

/// Vertices that follow record i; control points of spline-fitted polylines (flag 16) are not on the curve.
std::vector<const Record*> vertices_of(const std::vector<Record>& records, std::size_t i) {
    constexpr int control_point = 16;
    std::vector<const Record*> vertices;
    for (++i; i < records.size() && records[i].type == "VERTEX"; ++i)
        if ((records[i].integer(70, 0) & control_point) == 0) vertices.push_back(&records[i]);
    return vertices;
}

/// The handle, or the line where there is none or the file gives it twice.
std::string name_of(const Record& record, std::set<std::string>& handles) {
    const std::string handle = dxf::upper_case(record.text(5));
    const bool is_usable = !handle.empty() && handle.find_first_not_of("0123456789ABCDEF") == std::string::npos;
    return is_usable && handles.insert(handle).second ? "h" + handle : "l" + std::to_string(record.line);
}

Vec2 first_point(const Record& record) {
    Vec2 at(0, 0);
    dxf::parse_number(record.text(10), at.x());
    dxf::parse_number(record.text(20), at.y());
    return at;
}

void count_ignored(Drawing& drawing, const Record& record, const std::string& why) {
    const bool is_hidden_by_layer = why.rfind("layer", 0) == 0;
    const std::string what = is_hidden_by_layer ? record.type + " on layer " + record.text(8, "0") : record.type;
    for (Ignored& ignored : drawing.ignored) {
        if (ignored.what != what || ignored.why != why) continue;
        ++ignored.count;
        return;
    }
    drawing.ignored.push_back({what, 1, why});
}

/// Counts every entity and keeps those that are to be read.
std::vector<Outline> sort_out(const Structure& structure, Drawing& drawing) {
    std::vector<Outline> outlines;
    std::set<std::string> handles;
    for (std::size_t i = 0; i < structure.entities.size(); ++i) {
        const Record& record = structure.entities[i];
        if (dxf::is_subentity(record)) continue;
        const std::string why = dxf::why_ignored(record, structure);
        if (!dxf::is_in_paper_space(record)) ++drawing.counts[record.type].read;
        if (!why.empty()) {
            count_ignored(drawing, record, why);
            if (!dxf::is_in_paper_space(record)) ++drawing.counts[record.type].ignored;
            continue;
        }
        Outline outline{&record, record.type == "POLYLINE" ? vertices_of(structure.entities, i) : std::vector<const Record*>{},
                        name_of(record, handles)};
        if (const std::string wrong = what_is_wrong(outline); !wrong.empty()) {
            drawing.problems.push_back({record.type + " cannot be read: " + wrong, first_point(record), outline.name,
                                        record.line, "mend or delete it in CAD"});
            ++drawing.counts[record.type].ignored;
            continue;
        }
        ++drawing.counts[record.type].used;
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace

Drawing read_dxf(const std::string& path) {
    const Structure structure = dxf::read_structure(path);
    Drawing drawing;
    drawing.file = path;
    const auto version = structure.header.find("$ACADVER");
    drawing.format = version == structure.header.end() ? "DXF" : "DXF " + version->second;
    drawing.unit = unit_of(structure.header);
    read_outlines(sort_out(structure, drawing), drawing.entities);
    return drawing;
}

}  // namespace abut::geometry
