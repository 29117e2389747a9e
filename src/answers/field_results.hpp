// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solver/recovery/recovery.hpp"
#include "src/results/result.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// The smoothed stresses of one solved part.
solver::StressField stress_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement);

/// The displacement (assembly frame) and stress (assembly axes) at a point of a cell, given in the local frame.
FieldSample sample_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                         int element, const Vec2& local);

/// The largest displacement and von Mises stress of a part, with their places, and the element and local point of that stress
/// (element -1: there is none).
struct LargestOfPart {
    struct Found {
        ValueAt value;
        int element = -1;
        Vec2 local{0, 0};
    };
    Found displacement, von_mises;
};
LargestOfPart largest_of_part(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress);

/// Sides of the patches that fields are drawn by, of the diagonal of all that is solved: a few pixels of a report's pictures.
inline constexpr double drawn_patch = 1.0 / 160;

/// The fields that are drawn of a part. patch: sides of patches are no longer than this. Where the model (model_cells: cells of
/// the grids of all parts) has few cells, they are divided into more. Fields are taken inside the part only: corners of patches
/// beyond the boundary have what is extrapolated from the nearest point of it in their cell, linearly; patches without any of
/// the part are left out.
PartField part_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                     double patch, std::size_t model_cells = 0);

}  // namespace abut
