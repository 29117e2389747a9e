// SPDX-License-Identifier: GPL-3.0-or-later
// A scene to begin with, for a drawing or mesh: `abut init`.
#pragma once
#include <optional>
#include <string>

#include "src/contact/detect.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// What the user of `abut init` chose.
struct StarterChoice {
    std::string material = "steel";
    std::optional<double> thickness{};  ///< in the scene's unit; unset: 1, to be checked
    std::string folder{};               ///< where the scene will stand; empty: not known
    bool is_pointed_at = false;         ///< supports and loads come by pointing at them: there are none yet
};

/// The text of a scene that imports the file as `options` read it, with its parts and, in comments, their edges and the
/// contacts found between them. A support and a load stand there with a text in place of their edges that says what to fill in,
/// and an edge of the model as an example: until that is done, reading the scene gives an error for each of the two that
/// repeats the text. The material is the library's, with its numbers where the units of the file are not the scene's. Throws
/// InputError where the library has none of that name.
std::string starter_scene(const SketchReading& reading, const ImportOptions& options, const Detection& contacts,
                          const StarterChoice& choice = {});

}  // namespace abut
