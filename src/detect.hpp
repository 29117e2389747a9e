// SPDX-License-Identifier: GPL-3.0-or-later
// Contact detection alone: the pairs of parts that touch, overlap or nearly touch, from their geometry.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "src/functional_interface.hpp"
#include "src/scene.hpp"

namespace abut {

/// Pairs are listed up to this distance, as a fraction of the smaller part's extent.
inline constexpr double default_distance_fraction = 0.02;

struct DetectedPair {
    std::array<int, 2> part{0, 0};
    std::array<std::string, 2> parts, between;
    std::array<std::vector<std::string>, 2> edges;
    std::string status;     ///< touching, gap, overlap
    std::string interface;  ///< "pin-in-hole", "flat-on-flat", ...
    double gap_min = 0, gap_max = 0;
    double overlap_area = 0;
    double length = 0;         ///< of the facing boundary within the search distance
    double shared_length = 0;  ///< of edges that lie on each other wherever they face each other
    std::string cells_case;    ///< the dissertation's a-e (section 4.5.1)
    std::string why;
    FunctionalInterface functional;          ///< of all that faces each other
    std::vector<std::array<Vec2, 2>> marks;  ///< facing points, on the first and on the second part, for the picture
};

struct Detection {
    std::vector<DetectedPair> pairs, near_misses;
    double distance = 0;  ///< the largest search distance that was used
};

/// distance unset: 2 % of the smaller part's extent (its largest distance of two points, a rectangle's diagonal), near misses
/// to 10 %.
Detection detect_contacts(const Scene& scene, std::optional<double> distance);

std::string detection_json(const Scene& scene, const Detection& detection);
std::string detection_table(const Scene& scene, const Detection& detection);
std::string detection_svg(const Scene& scene, const Detection& detection);
/// The picture cells.svg has at most so many cells, on its one grid and on the split ones.
inline constexpr int most_drawn_cells = 40'000;
/// The four steps from parts to grids (geometry/common_grid.hpp) as a picture. The cells have the smallest of the sizes that
/// `cells_case` has for the detected pairs, or a larger one with which there are no more than `most_cells`; it says so then,
/// and where a case is another than in the table. Empty with fewer than two parts or without any pair (and where `common_grid`
/// refuses, which takes a million parts).
std::string detection_cells_svg(const Scene& scene, const Detection& detection, int most_cells = most_drawn_cells);
/// Differences from an expectation file, one line each; empty: as expected. Throws InputError if the file cannot be read.
std::vector<std::string> compare_detection(const Detection& detection, const std::string& expectation_file);

}  // namespace abut
