// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solver/recovery.hpp"
#include "src/assembly_model.hpp"
#include "src/result.hpp"

namespace abut {

/// Smoothed stresses of one solved part.
solver::StressField stress_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement);

/// Displacement (assembly frame) and stress (assembly axes) at a point of a cell, given in the local frame.
FieldSample sample_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress,
                         int element, const Vec2& local);

/// What is drawn of a part, and its largest displacement and von Mises stress.
struct PartFieldResult {
    PartField field;
    ValueAt max_displacement, max_von_mises;
};
PartFieldResult part_field(const PartOnGrid& grid, const Eigen::VectorXd& displacement, const solver::StressField& stress);

}  // namespace abut
