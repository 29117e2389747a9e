// SPDX-License-Identifier: GPL-3.0-or-later
// The first picture of `inspect`: parts, names and directions of their edges, a scale, numbered marks at repairs and problems,
// and a legend.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "src/inspection/inspect.hpp"
#include "src/inspection/inspect_page.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/label_placement.hpp"
#include "src/report/svg.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using namespace inspect;

// Pixels.
constexpr double name_size = 15, edge_size = 10;
constexpr double arrow_length = 9, arrow_width = 6;  ///< of the heads that tell an edge's direction
constexpr double mark_radius = 8;
constexpr double shortest_labelled = 7;  ///< an edge below is seen as a dot
constexpr std::size_t n_marks = 12;      ///< of each kind; more cannot be told apart

struct Mark {
    Vec2 at;
    std::string text;
    bool is_problem;
};

Box2 box_of(const Inspection& inspection, const std::vector<Mark>& marks) {
    Box2 box = box_of_parts(inspection.scene);
    for (const geometry::Curve& curve : inspection.loose) box.extend(bounding_box(curve));
    for (const Mark& mark : marks) box.extend(mark.at);
    return box;
}

// ---- parts ----

std::string part_shapes(const Inspection& inspection, const View& view) {
    std::string svg;
    for (std::size_t i = 0; i < inspection.scene.parts.size(); ++i)
        svg += path_element(path_data(inspection.scene.parts[i].part, view), "part",
                            " fill=\"" + part_color(static_cast<int>(i)) + "\"");
    for (const geometry::Curve& curve : inspection.loose) svg += path_element(path_data(curve, 0, 1, view), "loose");
    return svg;
}

double clearance(const geometry::Part& part, const Vec2& p) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const geometry::Edge& edge : part.edges)
        smallest = std::min(smallest, (point(edge.curve, closest_parameter(edge.curve, p)) - p).norm());
    return smallest;
}

Box2 name_box(const ScenePart& part, const Vec2& middle) {
    constexpr double bold = 1.2;  // wider letters, and some air
    return text_box(part.name, bold * name_size, middle);
}

/// The point of a lattice over the part that is deepest inside it and where the name fits; where it fits nowhere, none.
std::optional<Vec2> place_for_name(const ScenePart& part, const View& view, const LabelPlacement& labels) {
    constexpr int n = 24;
    const Box2 box = bounding_box(part.part);
    std::optional<Vec2> best;
    double deepest = 0;
    for (int i = 1; i < n; ++i)
        for (int j = 1; j < n; ++j) {
            const Vec2 p = box.min + box.size().cwiseProduct(Vec2(i, j)) / n;
            if (!labels.is_free(name_box(part, view(p)), true) || !contains(part.part, p)) continue;
            const double depth = clearance(part.part, p);
            if (depth <= deepest) continue;
            deepest = depth;
            best = p;
        }
    return best;
}

/// Names of regions, by which a scene says what they are; of many only those that leave something open.
std::string region_names(const Inspection& inspection, const View& view, LabelPlacement& labels) {
    constexpr std::size_t many = 40;
    std::string svg;
    for (const geometry::SketchRegion& region : inspection.regions) {
        if (inspection.regions.size() > many && !region.is_doubtful) continue;
        const Vec2 p = view(region.at);
        labels.take(text_box(region.name, edge_size, p));
        svg +=
            text_element({p.x(), p.y() + 0.35 * edge_size}, "region", "middle", region.name + (region.is_doubtful ? "?" : ""));
    }
    return svg;
}

std::string part_names(const Inspection& inspection, const View& view, LabelPlacement& labels) {
    std::string svg;
    for (std::size_t i = 0; i < inspection.scene.parts.size(); ++i) {
        const ScenePart& part = inspection.scene.parts[i];
        const auto at = place_for_name(part, view, labels);
        if (!at) continue;
        const Vec2 p = view(*at);
        labels.take(name_box(part, p));
        svg += text_element({p.x(), p.y() + 0.35 * name_size}, "name", "middle", part.name, ink_of(static_cast<int>(i)));
    }
    return svg;
}

// ---- edges: direction, names ----

/// A head on the edge, pointing the way the edge runs: the material is on its left. Not in the middle, where symmetric parts
/// touch.
std::string direction_head(const geometry::Curve& curve, const View& view) {
    const double t = parameter_at_length(curve, length(curve) / 3);
    const Vec2 tangent = unit_tangent(curve, t), along(tangent.x(), -tangent.y());
    const Vec2 across = 0.5 * arrow_width * geometry::left_of(along), middle = view(point(curve, t));
    const Vec2 tip = middle + 0.5 * arrow_length * along, tail = middle - 0.5 * arrow_length * along;
    std::string data = "M";
    for (const Vec2& p : {tip, Vec2(tail + across), Vec2(tail - across)})
        data += (data.size() > 1 ? "L" : "") + coordinate_text(p.x()) + " " + coordinate_text(p.y());
    return path_element(data + "Z", "way");
}

std::string edge_directions(const Inspection& inspection, const View& view) {
    std::string svg;
    for (const ScenePart& part : inspection.scene.parts)
        for (const geometry::Edge& edge : part.part.edges)
            if (length(edge.curve) * view.scale > 2 * arrow_length) svg += direction_head(edge.curve, view);
    return svg;
}

struct EdgeLabel {
    const geometry::Edge* edge;
    int part;
    double length;  ///< pixels
};

/// Longest first: where there is no room for all, the large features keep their names.
std::vector<EdgeLabel> edge_labels(const Inspection& inspection, const View& view) {
    std::vector<EdgeLabel> labels;
    for (std::size_t i = 0; i < inspection.scene.parts.size(); ++i)
        for (const geometry::Edge& edge : inspection.scene.parts[i].part.edges)
            labels.push_back({&edge, static_cast<int>(i), length(edge.curve) * view.scale});
    std::erase_if(labels, [](const EdgeLabel& label) { return label.length < shortest_labelled; });
    std::stable_sort(labels.begin(), labels.end(), [](const auto& a, const auto& b) { return a.length > b.length; });
    return labels;
}

/// Centre of the label's box when it stands beside the point on the given side (unit vector, picture coordinates).
Vec2 beside(const Vec2& p, const Vec2& side, const std::string& text) {
    constexpr double clear_of_line = 4;
    const Box2 box = text_box(text, edge_size, {0, 0});
    return p + (side.cwiseAbs().dot(box.max) + clear_of_line) * side;
}

/// On the outside of the edge's middle if there is room, else of other places on it, else on its inside; none where all are
/// taken.
std::optional<Vec2> place_for_edge(const EdgeLabel& label, const View& view, const LabelPlacement& labels) {
    for (double side : {1.0, -1.0})
        for (double t : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
            const Vec2 normal = outward_normal(label.edge->curve, t);
            const Vec2 seen(side * normal.x(), -side * normal.y());
            const Vec2 at = beside(view(point(label.edge->curve, t)), seen, label.edge->name);
            if (labels.is_free(text_box(label.edge->name, edge_size, at), true)) return at;
        }
    return std::nullopt;
}

std::string edge_names(const Inspection& inspection, const View& view, LabelPlacement& labels) {
    std::string svg;
    for (const EdgeLabel& label : edge_labels(inspection, view)) {
        const auto at = place_for_edge(label, view, labels);
        if (!at) continue;
        labels.take(text_box(label.edge->name, edge_size, *at));
        svg += text_element({at->x(), at->y() + 0.35 * edge_size}, "edge", "middle", label.edge->name, ink_of(label.part));
    }
    return svg;
}

// ---- marks and legend ----

/// Problems first, then the largest repairs: those are worth a look.
std::vector<Mark> marks_of(const Inspection& inspection) {
    std::vector<Mark> marks;
    for (const geometry::SketchProblem& p : inspection.problems)
        marks.push_back({p.at, p.what + (p.line > 0 ? " (line " + std::to_string(p.line) + ")" : ""), true});
    std::vector<geometry::Repair> repairs = all_repairs(inspection);
    std::stable_sort(repairs.begin(), repairs.end(), [](const auto& a, const auto& b) { return a.size > b.size; });
    for (const geometry::Repair& r : repairs) marks.push_back({r.at, r.what + ", " + number_text(r.size, 3), false});
    return marks;
}

std::vector<Mark> shown(const std::vector<Mark>& marks) {
    std::vector<Mark> some;
    for (bool problems : {true, false}) {
        std::size_t n = 0;
        for (const Mark& mark : marks)
            if (mark.is_problem == problems && n++ < n_marks) some.push_back(mark);
    }
    return some;
}

Vec2 place_for_mark(const Vec2& p, LabelPlacement& labels) {
    for (double distance : {18.0, 30.0, 44.0})
        for (int k = 0; k < 12; ++k) {
            const double angle = (k + 0.5) * std::numbers::pi / 6;
            const Vec2 at = p + distance * Vec2(std::cos(angle), -std::sin(angle));
            Box2 box;
            box.extend(Vec2(at - Vec2(mark_radius, mark_radius)));
            box.extend(Vec2(at + Vec2(mark_radius, mark_radius)));
            if (!labels.is_free(box, distance < 40)) continue;
            labels.take(box);
            return at;
        }
    return p;
}

std::string number_disc(const Vec2& at, std::size_t number, bool is_problem) {
    return circle_element(at, mark_radius, is_problem ? "problem" : "repair") +
           text_element({at.x(), at.y() + 3.5}, "number", "middle", std::to_string(number));
}

std::string mark_elements(const std::vector<Mark>& marks, const View& view, LabelPlacement& labels) {
    std::string svg;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Vec2 p = view(marks[i].at), at = place_for_mark(p, labels);
        svg +=
            line_element(p, at, "leader") + report::circle(p, 2, "fill=\"#000\"") + number_disc(at, i + 1, marks[i].is_problem);
    }
    return svg;
}

struct LegendLine {
    std::size_t number;  ///< 0: none
    bool is_problem;
    std::string text;
};

std::vector<LegendLine> legend_lines(const std::vector<Mark>& all, const std::vector<Mark>& some) {
    std::vector<LegendLine> lines;
    for (bool problems : {true, false}) {
        const auto of_kind = [&](const Mark& mark) { return mark.is_problem == problems; };
        for (std::size_t i = 0; i < some.size(); ++i)
            if (of_kind(some[i])) lines.push_back({i + 1, problems, (problems ? "problem: " : "repair: ") + some[i].text});
        const auto n_left = std::count_if(all.begin(), all.end(), of_kind) - std::count_if(some.begin(), some.end(), of_kind);
        if (n_left > 0)
            lines.push_back(
                {0, problems, "and " + counted(static_cast<std::size_t>(n_left), problems ? "more problem" : "more repair")});
    }
    return lines;
}

std::string legend(const std::vector<LegendLine>& lines, double top) {
    std::string svg;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double y = top + legend_step * static_cast<double>(i);
        if (lines[i].number > 0) svg += number_disc({page_margin - axis_distance, y - 4}, lines[i].number, lines[i].is_problem);
        svg += text_element({page_margin - axis_distance + 16, y}, "legend", "start", lines[i].text);
    }
    return svg;
}

std::string style() {
    return ".region{font-size:10px;fill:#555;font-style:italic}.part{stroke:#222;stroke-width:1.2;fill-opacity:.55;fill-rule:"
           "evenodd}.loose{fill:none;stroke:#b00020;stroke-width:"
           "1.5;stroke-dasharray:5 3}"
           ".name{font-size:" +
           coordinate_text(name_size) + "px;font-weight:bold}.edge{font-size:" + coordinate_text(edge_size) +
           "px}.way{fill:#222}.number{font-size:10px;font-weight:bold;fill:#fff}"
           ".leader{stroke:#000;stroke-width:.8}.problem{fill:#b00020}.repair{fill:#9a6700}";
}

}  // namespace

namespace {

/// What is marked where the pointer is near: each edge once more, wide and unseen, on top of all.
std::string edge_targets(const Inspection& inspection, const View& view) {
    std::string svg;
    for (const ScenePart& part : inspection.scene.parts)
        for (const geometry::Edge& edge : part.part.edges)
            svg += "<g data-edge=\"" + escape_xml(part.name + "/" + edge.name) + "\" data-about=\"" +
                   escape_xml(kind_name(edge.curve) + ", length " + with_unit(length(edge.curve), 6, inspection.unit)) + "\">" +
                   path_element(path_data(edge.curve, 0, 1, view), "target") + "</g>\n";
    return svg;
}

std::string picture_of(const Inspection& inspection, bool with_targets) {
    const std::vector<Mark> all = marks_of(inspection), some = shown(all);
    const View view = page_view(box_of(inspection, all));
    const double left = page_margin - axis_distance, bottom = view(view.box.min).y() + axis_distance;
    LabelPlacement labels({Vec2(left + 4, 30), Vec2(page_width - 4, bottom - 4)});
    for (const ScenePart& part : inspection.scene.parts)
        for (const geometry::Edge& edge : part.part.edges) labels.add_line(edge.curve, view);
    for (const geometry::Curve& curve : inspection.loose) labels.add_line(curve, view);

    const std::vector<LegendLine> lines = legend_lines(all, some);
    const double legend_top = view.height + 14;
    const double height = lines.empty() ? view.height : legend_top + legend_step * static_cast<double>(lines.size());
    std::string svg = page_opening(height, std::filesystem::path(inspection.file).filename().string(), style()) +
                      page_axes(view, inspection.unit) + part_shapes(inspection, view) + edge_directions(inspection, view);
    // What is placed first finds room first.
    const std::string names = part_names(inspection, view, labels) + region_names(inspection, view, labels),
                      marks = mark_elements(some, view, labels);
    svg += edge_names(inspection, view, labels) + names + marks + legend(lines, legend_top);
    return svg + (with_targets ? edge_targets(inspection, view) : "") + "</svg>\n";
}

constexpr const char* page_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>abut inspect</title>
<style>
body { margin: 0; font: 15px Helvetica, Arial, 'Liberation Sans', sans-serif; }
#said { margin: 0; position: sticky; top: 0; padding: 8px 14px; background: #f3f3f3; border-bottom: 1px solid #ccc; min-height: 1.3em; }
svg { display: block; }
.target { fill: none; stroke: #0a58ca; stroke-width: 12; stroke-linecap: round; stroke-opacity: 0; pointer-events: none; }
.near .target { stroke-opacity: .35; }
</style>
</head>
<body>
<p id="said">Point at an edge for its name and length; click to copy its selector.</p>
)";

// Browsers that give pages of files no clipboard copy what is selected.
constexpr const char* page_script = R"(<script>
"use strict";
const said = document.getElementById("said");
function copy(text) {
  const selected = () => {
    const field = document.body.appendChild(document.createElement("textarea"));
    field.value = text;
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    return done ? Promise.resolve() : Promise.reject();
  };
  return navigator.clipboard ? navigator.clipboard.writeText(text).catch(selected) : selected();
}
// Each edge as points a pixel or two apart: the pointer takes the nearest edge, and where several lie on each other all of them.
const svg = document.querySelector("svg");
const edges = [...document.querySelectorAll("[data-edge]")].map(edge => {
  const path = edge.querySelector("path"), length = path.getTotalLength(), n = Math.max(2, Math.min(600, Math.ceil(length / 2)));
  return {edge, points: Array.from({length: n + 1}, (_, i) => path.getPointAtLength(length * i / n))};
});
function distance(points, p) {
  let least = Infinity;
  for (let i = 0; i + 1 < points.length; ++i) {
    const a = points[i], u = points[i + 1].x - a.x, v = points[i + 1].y - a.y, w = u * u + v * v;
    const t = w > 0 ? Math.max(0, Math.min(1, ((p.x - a.x) * u + (p.y - a.y) * v) / w)) : 0;
    least = Math.min(least, Math.hypot(a.x + t * u - p.x, a.y + t * v - p.y));
  }
  return least;
}
function nearest(event) {
  const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const all = edges.map(e => ({edge: e.edge, away: distance(e.points, p)})), least = Math.min(...all.map(e => e.away));
  return least > 12 ? [] : all.filter(e => e.away < least + 0.5).map(e => e.edge);
}
svg.addEventListener("mousemove", event => {
  const near = nearest(event);
  for (const e of edges) e.edge.classList.toggle("near", near.includes(e.edge));
  svg.style.cursor = near.length ? "pointer" : "";
  if (near.length) said.textContent = near.map(e => e.dataset.edge + ": " + e.dataset.about).join("; ");
});
svg.addEventListener("click", event => {
  const names = nearest(event).map(e => e.dataset.edge).join(", ");
  if (names) copy(names).then(() => { said.textContent = "copied: " + names; }, () => { said.textContent = "not copied, the browser forbids it: " + names; });
});
</script>
</body>
</html>
)";

}  // namespace

std::string inspection_svg(const Inspection& inspection) {
    return picture_of(inspection, false);
}

std::string inspection_html(const Inspection& inspection) {
    return page_head + picture_of(inspection, true) + page_script;
}

}  // namespace abut
