// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of `inspect`: parts, names of their edges, a scale, numbered marks at repairs and problems, and a legend.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "src/inspect.hpp"
#include "src/label_placement.hpp"
#include "src/result_units.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

// Pixels.
constexpr double width = 1200, max_height = 820, margin = 96;
constexpr double axis_distance = 52;  ///< of the axes from the parts: room for labels on their outside
constexpr double name_size = 15, edge_size = 10, legend_size = 12, legend_step = 18;
constexpr double mark_radius = 8;
constexpr double shortest_labelled = 7;  ///< an edge below is seen as a dot
constexpr std::size_t n_marks = 12;      ///< of each kind; more cannot be told apart

struct Mark {
    Vec2 at;
    std::string text;
    bool is_problem;
};

std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + coordinate_text(value) + "\"";
}

std::string text_element(const Vec2& at, const std::string& css_class, const std::string& anchor, const std::string& text,
                         const std::string& fill = "") {
    return "<text" + attribute("x", at.x()) + attribute("y", at.y()) + " class=\"" + css_class + "\" text-anchor=\"" + anchor +
           "\"" + (fill.empty() ? "" : " fill=\"" + fill + "\"") + ">" + escape_xml(text) + "</text>\n";
}

std::string line_element(const Vec2& a, const Vec2& b, const std::string& css_class) {
    return "<line" + attribute("x1", a.x()) + attribute("y1", a.y()) + attribute("x2", b.x()) + attribute("y2", b.y()) +
           " class=\"" + css_class + "\"/>\n";
}

/// The part's colour, dark enough to read and saturated, so that the names of two parts' edges can be told apart.
std::string ink_of(int part) {
    const std::string color = part_color(part);
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) rgb[i] = std::stoi(color.substr(1 + 2 * i, 2), nullptr, 16);
    const auto [lowest, highest] = std::minmax_element(rgb.begin(), rgb.end());
    constexpr int brightest = 140;
    static constexpr char digits[] = "0123456789abcdef";
    std::string ink = "#";
    for (int channel : rgb) {
        const int dark = *highest > *lowest ? (channel - *lowest) * brightest / (*highest - *lowest) : 0;
        ink += {digits[dark / 16], digits[dark % 16]};
    }
    return ink;
}

Box2 box_of(const Inspection& inspection, const std::vector<Mark>& marks) {
    Box2 box;
    for (const ScenePart& part : inspection.scene.parts) box.extend(bounding_box(part.part));
    for (const geometry::Curve& curve : inspection.loose) box.extend(bounding_box(curve));
    for (const Mark& mark : marks) box.extend(mark.at);
    if (box.empty() || box.diagonal() == 0) {
        const Vec2 middle = box.empty() ? Vec2(0, 0) : box.center();
        box.extend(Vec2(middle - Vec2(1, 1)));
        box.extend(Vec2(middle + Vec2(1, 1)));
    }
    return box;
}

// ---- scale ----

std::string x_axis(const View& view, const std::string& unit) {
    const double y = view(view.box.min).y() + axis_distance, right = view(view.box.max).x();
    std::string svg = line_element({view(view.box.min).x(), y}, {right, y}, "axis");
    for (double tick : nice_ticks(view.box.min.x(), view.box.max.x(), 10)) {
        if (tick < view.box.min.x() || tick > view.box.max.x()) continue;
        const double x = view({tick, 0}).x();
        svg += line_element({x, y}, {x, y + 6}, "axis") + text_element({x, y + 20}, "tick", "middle", number_text(tick, 6));
    }
    return svg + text_element({right, y + 36}, "tick", "end", unit.empty() ? "x" : "x [" + unit + "]");
}

std::string y_axis(const View& view, const std::string& unit) {
    const double x = view(view.box.min).x() - axis_distance, top = view(view.box.max).y(), bottom = view(view.box.min).y();
    std::string svg = line_element({x, bottom}, {x, top}, "axis");
    const int n = std::max(2, static_cast<int>((bottom - top) / 70));
    for (double tick : nice_ticks(view.box.min.y(), view.box.max.y(), n)) {
        if (tick < view.box.min.y() || tick > view.box.max.y()) continue;
        const double y = view({0, tick}).y();
        svg += line_element({x - 6, y}, {x, y}, "axis") + text_element({x - 9, y + 4}, "tick", "end", number_text(tick, 6));
    }
    return svg + text_element({x, top - 12}, "tick", "middle", unit.empty() ? "y" : "y [" + unit + "]");
}

// ---- parts ----

std::string part_shapes(const Inspection& inspection, const View& view) {
    std::string svg;
    for (std::size_t i = 0; i < inspection.scene.parts.size(); ++i)
        svg += "<path d=\"" + path_data(inspection.scene.parts[i].part, view) + "\" class=\"part\" fill=\"" +
               part_color(static_cast<int>(i)) + "\"/>\n";
    for (const geometry::Curve& curve : inspection.loose)
        svg += "<path d=\"" + path_data(curve, 0, 1, view) + "\" class=\"loose\"/>\n";
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

// ---- names of edges ----

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
    std::vector<geometry::Repair> repairs;
    for (const ImportRecord& record : inspection.imports)
        repairs.insert(repairs.end(), record.repairs.begin(), record.repairs.end());
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
    return "<circle" + attribute("cx", at.x()) + attribute("cy", at.y()) + attribute("r", mark_radius) + " class=\"" +
           (is_problem ? "problem" : "repair") + "\"/>\n" +
           text_element({at.x(), at.y() + 3.5}, "number", "middle", std::to_string(number));
}

std::string mark_elements(const std::vector<Mark>& marks, const View& view, LabelPlacement& labels) {
    std::string svg;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const Vec2 p = view(marks[i].at), at = place_for_mark(p, labels);
        svg += line_element(p, at, "leader") + "<circle" + attribute("cx", p.x()) + attribute("cy", p.y()) +
               " r=\"2\" fill=\"#000\"/>\n" + number_disc(at, i + 1, marks[i].is_problem);
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
        if (lines[i].number > 0) svg += number_disc({margin - axis_distance, y - 4}, lines[i].number, lines[i].is_problem);
        svg += text_element({margin - axis_distance + 16, y}, "legend", "start", lines[i].text);
    }
    return svg;
}

std::string style() {
    return "<style>text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif}"
           ".part{stroke:#222;stroke-width:1.2;fill-opacity:.55;fill-rule:evenodd}.loose{fill:none;stroke:#b00020;stroke-width:"
           "1.5;stroke-dasharray:5 3}"
           ".axis{stroke:#666;stroke-width:1}.tick{font-size:11px;fill:#444}.title{font-size:14px;fill:#222}"
           ".name{font-size:" +
           coordinate_text(name_size) + "px;font-weight:bold}.edge{font-size:" + coordinate_text(edge_size) +
           "px}"
           ".legend{font-size:" +
           coordinate_text(legend_size) +
           "px;fill:#222}.number{font-size:10px;font-weight:bold;fill:#fff}"
           ".leader{stroke:#000;stroke-width:.8}.problem{fill:#b00020}.repair{fill:#9a6700}</style>\n";
}

std::string opening(double height) {
    const std::string w = coordinate_text(width), h = coordinate_text(height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
           "\">\n" + style() + "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

}  // namespace

std::string inspection_svg(const Inspection& inspection) {
    const std::vector<Mark> all = marks_of(inspection), some = shown(all);
    const View view = fit_view(box_of(inspection, all), width, max_height, margin);
    LabelPlacement labels({Vec2(margin - axis_distance + 4, 30), Vec2(width - 4, view(view.box.min).y() + axis_distance - 4)});
    for (const ScenePart& part : inspection.scene.parts)
        for (const geometry::Edge& edge : part.part.edges) labels.add_line(edge.curve, view);
    for (const geometry::Curve& curve : inspection.loose) labels.add_line(curve, view);

    const std::vector<LegendLine> lines = legend_lines(all, some);
    const double legend_top = view.height + 14;
    const double height = lines.empty() ? view.height : legend_top + legend_step * static_cast<double>(lines.size());
    std::string svg = opening(height) + text_element({margin - axis_distance, 20}, "title", "start",
                                                     std::filesystem::path(inspection.file).filename().string());
    svg += x_axis(view, inspection.unit) + y_axis(view, inspection.unit) + part_shapes(inspection, view);
    // What is placed first finds room first.
    const std::string names = part_names(inspection, view, labels), marks = mark_elements(some, view, labels);
    return svg + edge_names(inspection, view, labels) + names + marks + legend(lines, legend_top) + "</svg>\n";
}

}  // namespace abut
