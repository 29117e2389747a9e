// SPDX-License-Identifier: GPL-3.0-or-later
// What `inspect` prints for people.
#include <algorithm>

#include "src/inspection/inspect.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/number_text.hpp"
#include "src/io/utf8.hpp"
#include "src/report/svg.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/part_levels.hpp"

namespace abut {

namespace {

constexpr std::size_t n_repairs_listed = 10;

using Row = std::vector<std::string>;

/// The first column to the left, numbers in the others to the right.
std::string columns(const std::vector<Row>& rows) {
    std::vector<std::size_t> width(rows.front().size());
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], text_width(row[i]));
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(width[i] - text_width(row[i]), ' ');
            line += i == 0 ? row[i] + blanks : "  " + blanks + row[i];
        }
        text += line + "\n";
    }
    return text;
}

std::string size_text(const Box2& box) {
    return number_text(box.size().x(), 5) + " x " + number_text(box.size().y(), 5);
}

std::string title(const Inspection& inspection) {
    std::string text =
        inspection.file + ": " + inspection.format + ", " + (inspection.unit.empty() ? "no unit stated" : inspection.unit);
    Box2 box;
    for (const ScenePart& part : inspection.scene.parts) box.extend(bounding_box(part.part));
    if (!box.empty()) text += ", " + size_text(box);
    const double to_mm = geometry::unit_factor(inspection.unit, "mm");
    if (!box.empty() && inspection.unit != "mm" && to_mm > 0)
        text += " (" + number_text(to_mm * box.size().x(), 5) + " x " + number_text(to_mm * box.size().y(), 5) + " mm)";
    text += "\n";
    for (const std::string& note : inspection.notes) text += note + "\n";
    for (const std::string& warning : inspection.scene.warnings) text += "warning: " + warning + "\n";
    return text;
}

std::string part_rows(const Inspection& inspection) {
    if (inspection.scene.parts.empty()) return "no parts: no closed outline was found\n";
    std::vector<Row> rows{{"part", "size", "area", "perimeter", "holes", "edges"}};
    for (const ScenePart& p : inspection.scene.parts)
        rows.push_back({p.name, size_text(bounding_box(p.part)), number_text(area(p.part), 6),
                        number_text(perimeter(p.part), 6), std::to_string(count_holes(p.part)),
                        std::to_string(p.part.edges.size())});
    const std::string levels = levels_text(inspection.scene);
    return columns(rows) + (levels.empty() ? "" : "levels: " + levels + "\n");
}

std::string edge_lines(const Inspection& inspection) {
    std::string text;
    for (const ScenePart& p : inspection.scene.parts) {
        std::vector<std::string> names;
        for (const geometry::Edge& edge : p.part.edges) names.push_back(edge.name);
        text += "  " + p.name + "/: " + listed(names) + "\n";
    }
    return text.empty() ? text : "\nedges\n" + text;
}

std::string entity_rows(const ImportRecord& record) {
    std::vector<Row> rows{{"entities", "read", "used", "ignored"}};
    for (const auto& [type, count] : record.counts)
        rows.push_back({type, std::to_string(count.read), std::to_string(count.used), std::to_string(count.ignored)});
    return rows.size() > 1 ? columns(rows) : "";
}

std::string ignored_lines(const ImportRecord& record) {
    std::string text;
    for (const geometry::Ignored& i : record.ignored)
        text += "  " + std::to_string(i.count) + " " + i.what + ": " + i.why + "\n";
    return text.empty() ? text : "ignored\n" + text;
}

std::string repair_lines(std::vector<geometry::Repair> repairs) {
    if (repairs.empty()) return {};
    std::stable_sort(repairs.begin(), repairs.end(), [](const auto& a, const auto& b) { return a.size > b.size; });
    const std::size_t n = std::min(repairs.size(), n_repairs_listed);
    std::string text = "repairs (" + std::to_string(repairs.size()) + (n < repairs.size() ? ", the largest" : "") + ")\n";
    for (std::size_t i = 0; i < n; ++i)
        text += "  " + repairs[i].what + ", " + number_text(repairs[i].size, 3) + ", at " + pair_text(repairs[i].at, 6) + "\n";
    return text;
}

std::string problem_lines(const Inspection& inspection) {
    std::string text;
    for (const geometry::SketchProblem& p : inspection.problems) {
        const std::string where = inspection.file + (p.line > 0 ? ":" + std::to_string(p.line) : "");
        const bool has_place = p.line > 0 || !p.entity.empty();
        text += "  " + one_line({where, p.what + (has_place ? ", at " + pair_text(p.at, 6) : ""), p.hint}) + "\n";
    }
    return text.empty() ? text : "\nproblems (" + std::to_string(inspection.problems.size()) + ")\n" + text;
}

}  // namespace

std::string inspection_table(const Inspection& inspection) {
    std::string text = title(inspection) + "\n" + part_rows(inspection) + edge_lines(inspection);
    for (const ImportRecord& record : inspection.imports) {
        text += "\n";
        if (record.file != inspection.file) text += record.file + ": " + record.format + "\n";
        text += entity_rows(record) + ignored_lines(record) + repair_lines(record.repairs);
    }
    const std::string own = repair_lines(geometry_repairs(inspection.scene));
    if (!own.empty()) text += "\n" + own;
    return text + problem_lines(inspection);
}

}  // namespace abut
