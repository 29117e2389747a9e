// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of the candidates: where parts face each other within the first search distance, with some of the pairs.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "src/base/index.hpp"
#include "src/inspection/inspect_stages.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_svg.hpp"
#include "src/results/result_units.hpp"

namespace abut::inspect {

namespace {

constexpr std::array<const char*, 6> zone_colors{"#c1121f", "#0b5cad", "#2a7f3b", "#8a3ffc", "#b35900", "#007d79"};
constexpr double arrow_pixels = 24, pair_distance = 16;  ///< length of a normal; arc length between drawn pairs
constexpr int least_pairs = 3, most_pairs = 40;          ///< of a zone
constexpr std::size_t names_listed = 2;                  ///< of a chain's edges: a line of the legend has its length

/// The chain from arc length a to b; on closed chains it may run past the end.
std::string stretch_data(const geometry::Part& part, const geometry::Chain& chain, double a, double b, const View& view) {
    std::string data;
    const int last_turn = chain.closed ? static_cast<int>(std::floor(b / chain.length)) : 0;
    const int first_turn = chain.closed ? static_cast<int>(std::floor(a / chain.length)) : 0;
    for (int turn = first_turn; turn <= last_turn; ++turn)
        for (std::size_t k = 0; k < chain.edges.size(); ++k) {
            const geometry::Curve& curve = part.edges[at(chain.edges[k])].curve;
            const double begin = chain.begin[k] + turn * chain.length, whole = length(curve);
            const double from = std::max(a - begin, 0.0), to = std::min(b - begin, whole);
            if (from >= to) continue;
            data += path_data(curve, parameter_at_length(curve, from), parameter_at_length(curve, to), view);
        }
    return data;
}

/// Both points of a pair joined, and the normal from part 1 to part 2 at the middle.
std::string pair_element(const geometry::FacingPair& pair, const std::string& color, const View& view) {
    const Vec2 a = view(pair.on1.x), b = view(pair.on2.x), middle = 0.5 * (a + b);
    const Vec2 along = arrow_pixels * Vec2(pair.normal.x(), -pair.normal.y());
    return line_element(a, b, "pair") + report::arrow(middle - 0.5 * along, middle + 0.5 * along, color);
}

std::string pair_elements(const geometry::Part& part1, const geometry::Part& part2, const geometry::FacingZone& zone,
                          const std::string& color, const View& view) {
    const double length1 = zone.end1 - zone.begin1;
    const int n = std::clamp(static_cast<int>(length1 * view.scale / pair_distance), least_pairs, most_pairs);
    std::string svg;
    double partner = zone.begin2;
    for (int k = 0; k < n; ++k) {
        const double s1 = zone.begin1 + (k + 0.5) / n * length1;
        const geometry::FacingPair pair = pair_from_first(part1, part2, zone, s1, partner);
        if (!pair.found) continue;
        partner = pair.s2;
        svg += pair_element(pair, color, view);
    }
    return svg;
}

std::string edge_list(const ScenePart& part, const geometry::Chain& chain) {
    std::vector<std::string> names;
    for (const int edge : chain.edges) names.push_back(part.name + "/" + part.part.edges[at(edge)].name);
    if (names.size() <= names_listed) return joined(names, ", ");
    const std::size_t n_more = names.size() - names_listed;
    names.resize(names_listed);
    return joined(names, ", ") + " and " + std::to_string(n_more) + " more";
}

std::string zone_text(const Scene& scene, const Candidate& c) {
    const geometry::FacingZone& zone = c.zone;
    std::string text = edge_list(scene.parts[at(c.first)], zone.chain1) + " - " +
                       edge_list(scene.parts[at(c.second)], zone.chain2) + ": gap " + number_text(zone.gap_min, 4) + " to " +
                       number_text(zone.gap_max, 4) + ", length " + number_text(zone.end1 - zone.begin1, 4);
    if (zone.closed) return text + ", all the way round";
    const int limits = int(zone.begin_is_limit) + int(zone.end_is_limit);
    if (limits > 0) text += limits == 2 ? ", ended by the search distance" : ", one end by the search distance";
    return text;
}

}  // namespace

std::string candidates_svg(const Inspection& inspection, const Stages& stages) {
    const Scene& scene = inspection.scene;
    const View view = page_view(box_of_parts(scene));
    const std::string css =
        ".part{stroke:#555;stroke-width:.8;fill-rule:evenodd}.zone{fill:none;stroke-width:4;stroke-opacity:.55;stroke-linecap:"
        "butt}.pair{stroke:#000;stroke-width:.7}";
    std::string zones, pairs;
    std::vector<LegendEntry> legend;
    for (std::size_t k = 0; k < stages.candidates.size(); ++k) {
        const Candidate& c = stages.candidates[k];
        const std::string color = zone_colors[k % zone_colors.size()];
        const geometry::Part &p1 = scene.parts[at(c.first)].part, &p2 = scene.parts[at(c.second)].part;
        const auto [low2, high2] = std::minmax(c.zone.begin2, c.zone.end2);
        zones += path_element(stretch_data(p1, c.zone.chain1, c.zone.begin1, c.zone.end1, view) +
                                  stretch_data(p2, c.zone.chain2, low2, high2, view),
                              "zone", " stroke=\"" + color + "\"");
        pairs += pair_elements(p1, p2, c.zone, color, view);
        legend.push_back({color, zone_text(scene, c)});
    }
    if (legend.empty()) legend.push_back({"", "no two parts face each other within the first search distance"});
    const std::string file = std::filesystem::path(inspection.file).filename().string();
    return page_with_legend(view, file + ": facing zones and some of their pairs, normals from the first part to the second",
                            css, page_axes(view, inspection.unit) + pale_parts(scene, view) + zones + pairs, legend);
}

}  // namespace abut::inspect
