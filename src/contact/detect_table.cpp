// SPDX-License-Identifier: GPL-3.0-or-later
// What `contacts` prints for people.
#include <algorithm>

#include "src/contact/detect.hpp"
#include "src/io/number_text.hpp"
#include "src/io/text_table.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/part_levels.hpp"

namespace abut {

namespace {

using Row = TextRow;

std::string pair_rows(const Scene& scene, const std::vector<DetectedPair>& pairs) {
    std::vector<Row> rows{{"", "parts", "status", "interface", heading("gap", scene.length_unit),
                           heading("facing", scene.length_unit), "cells", "between", "overlap area"}};
    const bool overlaps = std::any_of(pairs.begin(), pairs.end(), [](const DetectedPair& p) { return p.overlap_area > 0; });
    if (!overlaps) rows[0].pop_back();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const DetectedPair& p = pairs[k];
        const std::string gap = number_text(p.gap_min, 3) + " to " + number_text(p.gap_max, 3);
        rows.push_back({contact_number(k), p.parts[0] + " - " + p.parts[1], p.status, p.interface, gap,
                        number_text(p.length, 4), p.cells_case, p.between[0] + " - " + p.between[1]});
        if (overlaps) rows.back().push_back(p.overlap_area > 0 ? number_text(p.overlap_area, 4) : "");
    }
    return aligned(rows);
}

std::string near_miss_lines(const std::vector<DetectedPair>& pairs) {
    std::string text;
    for (const DetectedPair& p : pairs) text += "  " + p.parts[0] + " - " + p.parts[1] + ": " + p.why + "\n";
    return text.empty() ? text : "\nnear misses\n" + text;
}

}  // namespace

std::string detection_table(const Scene& scene, const Detection& detection) {
    std::string warnings;
    for (const std::string& warning : scene.warnings) warnings += "warning: " + warning + "\n";
    if (scene.parts.size() < 2) return warnings + "no contacts: there is one part only\n";
    std::string text = detection.pairs.empty() ? "no contacts: no two parts come within " +
                                                     with_unit(detection.distance, 4, scene.length_unit) + " of each other\n"
                                               : pair_rows(scene, detection.pairs);
    const std::string levels = levels_text(scene);
    if (!levels.empty()) text += "\nlevels: " + levels + "\n";
    return warnings + text + near_miss_lines(detection.near_misses);
}

}  // namespace abut
