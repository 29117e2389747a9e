// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene's accuracy asks for, in numbers.
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

inline constexpr double draft_target = 0.05, standard_target = 0.01, fine_target = 0.002;
/// The range of errors that can be aimed at.
inline constexpr double least_target = 1e-5, most_target = 0.5;
inline bool is_target(double error) {
    return error >= least_target && error <= most_target;
}

/// The estimated relative error to reach: of contact pressures (L2), or of stress (energy norm) where there is no contact.
/// Levels: draft 5 %, standard 1 %, fine 0.2 %.
double target_of(const Accuracy& accuracy);

/// The factor on the sizes that the shape of the parts asks for. 1 at standard; without contact 1.8 at draft, 0.55 at fine;
/// with contact, whose grids are refined by what they show, 1.3 and 0.8 to begin with.
double coarseness_of(const Accuracy& accuracy, bool has_contact);

/// Are all grids given, so that there is nothing to adapt?
bool grids_are_fixed(const Scene& scene);

}  // namespace abut
