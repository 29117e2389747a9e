// SPDX-License-Identifier: GPL-3.0-or-later
// Contact detection alone: the pairs of parts that touch, overlap or nearly touch, from their geometry.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/interfaces/functional_interface.hpp"
#include "src/scene/scene.hpp"

namespace abut {

using geometry::FunctionalInterface;

/// A row of the table: a zone of two parts as the analysis takes it (candidates.hpp), or where no faces oppose each other a
/// place.
struct DetectedPair {
    std::array<int, 2> part{0, 0};
    std::array<std::string, 2> parts, between;
    std::array<std::vector<std::string>, 2> edges;
    std::string status;               ///< touching, gap, overlap
    std::string interface;            ///< "pin-in-hole", "flat-on-flat", ...
    double gap_min = 0, gap_max = 0;  ///< less the interference that a rule gives
    double overlap_area = 0;          ///< of both parts, in the row that is deepest
    double length = 0;                ///< of the zone along the first part; 0: no faces oppose each other
    double shared_length = 0;         ///< of edges that lie on each other wherever they face each other
    std::string cells_case;           ///< the dissertation's a-e (section 4.5.1)
    std::string why;
    FunctionalInterface functional;          ///< of all that faces each other
    std::vector<std::array<Vec2, 2>> marks;  ///< facing points, on the first and on the second part, for the picture
};

/// The table of `abut contacts`.
struct Detection {
    std::vector<DetectedPair> pairs, near_misses;  ///< pairs in the order of the analysis, places without faces last
    double distance = 0;                           ///< the largest up to which pairs were listed
};

/// Lists what comes as close as `distance`; unset: what the analysis calls shown, 2 % of the smaller part's extent (its largest
/// distance of two points, a rectangle's diagonal). Near misses to 10 %. Zones are as long as the analysis searches them at
/// first, or up to `distance` where that is more.
Detection detect_contacts(const Scene& scene, std::optional<double> distance);

/// What was detected as the text of a contacts.json, and as a table for a terminal.
std::string detection_json(const Scene& scene, const Detection& detection);
std::string detection_table(const Scene& scene, const Detection& detection);
/// Differences from an expectation file, one line each; empty: as expected. Throws InputError if the file cannot be read.
std::vector<std::string> compare_detection(const Detection& detection, const std::string& expectation_file);

}  // namespace abut
