// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of `abut contacts`.
#pragma once
#include <string>

#include "src/contact/detect.hpp"

namespace abut {

/// The parts, the detected pairs and their numbers.
std::string detection_svg(const Scene& scene, const Detection& detection);
/// The picture cells.svg has at most so many cells, on its one grid and on the split ones.
inline constexpr int most_drawn_cells = 40'000;
/// The four steps from parts to grids (geometry/interfaces/common_grid.hpp) as a picture. The cells have the smallest of the
/// sizes that `cells_case` has for the detected pairs, or a larger one with which there are no more than `most_cells`; it says
/// so then, and where a case is another than in the table. Empty with fewer than two parts or without any pair (and where
/// `common_grid` refuses, which takes a million parts).
std::string detection_cells_svg(const Scene& scene, const Detection& detection, int most_cells = most_drawn_cells);

}  // namespace abut
