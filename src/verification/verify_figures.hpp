// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the dissertation's chapters 4 and 5 [Grishin10] drawn anew, from its method's answers to the scenes of its
// tables: `abut verify dissertation --figures FOLDER`.
#pragma once
#include <string>
#include <vector>

#include "src/verification/verify_dissertation.hpp"

namespace abut {

/// A picture: an SVG file.
struct Figure {
    std::string file;  ///< "B_stress.svg"
    std::string svg;
};

/// What the method works on: cells and Gauss points (Figures 4.6, 4.13 to 4.25), the search for contact (4.7 to 4.9), contours
/// of weights (4.5). Throws InputError where the scene cannot be read.
std::vector<Figure> method_figures(const DissertationTable& table, const std::string& data_folder);

/// What it answers: components of stress (Figures 5.1, 5.3, 5.5, 5.10, 5.13) and of displacement (5.7, 5.8, 5.11), the deformed
/// shape 50 times as large (5.9, 5.12), the pressure beside ours and the reference (5.2, 5.4, 5.6). None where it failed.
std::vector<Figure> answer_figures(const SolvedTable& solved);

}  // namespace abut
