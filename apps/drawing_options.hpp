// SPDX-License-Identifier: GPL-3.0-or-later
// The options --units, --tolerance, --parts-by, --section, --only-layer and so on, which stand for a scene's keys where a
// command is given a bare drawing or mesh.
#pragma once
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "src/scene/read_drawing.hpp"

namespace abut {

std::vector<OptionSpec> drawing_option_specs();
/// --strict, of the commands that read drawings: see refuse_guesses (drawing_problems.hpp).
OptionSpec strict_option_spec();

/// Reads the options of a command whose operand is a scene, drawing or mesh. Throws InputError where a value is wrong, or where
/// the options are given beside a scene, which states them itself.
ImportOptions drawing_options(const Arguments& arguments);
/// Reads the options without a look at the operand. Throws InputError where a value is wrong.
ImportOptions import_options(const Arguments& arguments);

enum class FileKind { scene, drawing };  ///< meshes count as drawings
/// The kind of a file by its extension, in either case. Throws InputError where the file is missing, or of a kind that cannot
/// be read.
FileKind kind_of_file(const std::string& path);

}  // namespace abut
