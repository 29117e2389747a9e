// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <string>

#include "src/scene/scene.hpp"

namespace abut {

/// Reads and checks a scene; evaluates its geometry and imports. Throws InputError with every problem found, each with the
/// file, the line and the JSON pointer.
Scene read_scene(const std::string& path);
/// Reads a scene with other values for some of its parameters. One that the scene does not have is a problem, too.
Scene read_scene(const std::string& path, const std::map<std::string, double>& parameters);
/// Reads a template with other values for some of its parameters: `file` is what its imports mean by the file name `any_file`;
/// relative to the working folder.
Scene read_scene(const std::string& path, const std::map<std::string, double>& parameters, const std::string& file);
/// The file name in a scene that stands for any file: the scene is a template.
inline constexpr const char* any_file = "*";
/// Reads a scene from its text; `file` is its name in messages, and the files that it imports are relative to that one's
/// folder.
Scene read_scene_text(const std::string& text, const std::string& file);

}  // namespace abut
