// SPDX-License-Identifier: GPL-3.0-or-later
// The method as the dissertation wrote it [Grishin10, chapter 4], as the choices of a scene: normalised splines (eqs 4.1, B.1),
// supports by u = w Phi + phi with R-functions as weights (sections 3.2.1, 4.3), transformed Gauss points (eq 4.18), the
// contact search on one grid (section 4.5.1), penalty contact along the first part's normal (section 4.5.2), one solution on
// grids that do not adapt.
#pragma once
#include "src/scene/scene.hpp"

namespace abut {

/// Does the scene ask for the dissertation's method?
inline bool is_by_dissertation(const Scene& scene) {
    return scene.accuracy.method == "dissertation";
}

/// Makes the scene one of the dissertation's method: what of it other keys choose, too, is set (basis, dirichlet, weights but
/// for those that the scene gives, penalty contact with the scene's own factor and length). Grids stay.
void take_dissertation_method(Scene& scene);

}  // namespace abut
