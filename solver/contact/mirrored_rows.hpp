// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a mirror symmetric assembly folded onto the parts that are solved (fold.hpp).
#pragma once
#include <array>
#include <vector>

#include "solver/contact/assembly_rows.hpp"

namespace abut::solver {

/// Row and sign that a row becomes: its mirror image's multiplier is the sign times its own.
struct RowImage {
    int row;
    double sign;
};
struct RowImages {
    std::vector<RowImage> image;              ///< by row
    std::array<int, 2> lonely_parts{-1, -1};  ///< first not negative: rows of it, and of the second, have no mirror image
};

/// Found by what rows do to displacement fields and to their mirror images, so that nothing has to be known of how interfaces
/// run. Cost: a few products with the rows.
RowImages row_images(const AssemblyProblem& problem, const Rows& rows);

struct FoldedRows {
    AssemblyRows all;          ///< on leaders and on parts that are their own images
    std::vector<int> folded;   ///< by row of the whole: its row; -1: its multiplier is zero
    std::vector<double> sign;  ///< by row of the whole
    std::vector<char> kept;    ///< by row of the whole: the first of its kind
};
/// Mirrored rows added up. Of rows that have a mirror image.
FoldedRows fold_rows(const AssemblyProblem& problem, const AssemblyRows& whole, const std::vector<RowImage>& image);

}  // namespace abut::solver
