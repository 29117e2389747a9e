// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/drawing_options.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/scene_words.hpp"

namespace abut {

namespace {

const std::vector<std::string> known_units{"mm", "cm", "m", "in", "ft", "um"};

void check_no_drawing_options(const Arguments& arguments) {
    std::vector<Problem> problems;
    for (const OptionSpec& option : drawing_option_specs()) {
        if (!has(arguments, option.name)) continue;
        problems.push_back({arguments.operand,
                            "option " + option.name + " is for drawings, solids and meshes, and this is a scene",
                            "set it in the scene instead, and leave the option out"});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
}

void check_choice(const Arguments& arguments, const std::string& name, const std::vector<std::string>& known) {
    if (!has(arguments, name)) return;
    const std::string value = arguments.options.at(name);
    if (std::find(known.begin(), known.end(), value) != known.end()) return;
    throw InputError(name, "'" + shortened(value) + "' is not supported", "use " + listed(known));
}

/// "Thin,Border*"
std::vector<std::string> listed_names(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (end > begin) names.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

/// "z", or "z=5".
void read_section(const std::string& text, ImportOptions& options) {
    const std::size_t equals = text.find('=');
    const std::string axis = text.substr(0, equals);
    const std::optional<double> at = equals == std::string::npos ? std::nullopt : to_number(text.substr(equals + 1));
    const std::size_t index = std::string("xyz").find(axis);
    if (axis.size() != 1 || index == std::string::npos || (equals != std::string::npos && !at))
        throw InputError("--section", "'" + shortened(text) + "' is no plane", "write an axis, or an axis and a place: z=5");
    options.section.axis = static_cast<int>(index);
    options.section.at = at;
}

}  // namespace

std::vector<OptionSpec> drawing_option_specs() {
    return {{"--units", "UNIT", "the file's length unit: " + listed(known_units) + " (default: as the file states)"},
            {"--tolerance", "T", "largest gap between end points that is closed (default: 2e-5 of the part's diagonal)"},
            {"--parts-by", "WAY", "what separates the parts: " + listed(parts_by_words()) + " (default: auto)"},
            {"--section", "PLANE",
             "where solids or a mesh are cut: an axis and a place, z=5 (default: the middle of the thinnest direction)"},
            {"--only-layer", "NAMES", "read these layers only, whatever they are called: names with * and ?, commas between"},
            {"--ignore-layer", "NAMES", "leave these layers out: names with * and ?, commas between"},
            {"--leave-open", "", "outlines that nearly close are set aside like other open lines (default: they are errors)"},
            {"--keep-drafting", "", "frames, title blocks and balloons are parts like others (default: they are set aside)"},
            {"--block-outline", "NAMES",
             "of these blocks the outline around everything is one part: names with * and ?, commas between"},
            {"--keep-facets", "", "facets stay lines and splines splines (default: those that are arcs become arcs)"}};
}

OptionSpec strict_option_spec() {
    return {"--strict", "", "what is left out, merged or guessed of a drawing is an error (default: a warning)"};
}

ImportOptions drawing_options(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene) {
        check_no_drawing_options(arguments);
        return {};
    }
    return import_options(arguments);
}

ImportOptions import_options(const Arguments& arguments) {
    check_choice(arguments, "--units", known_units);
    check_choice(arguments, "--parts-by", parts_by_words());
    ImportOptions options;
    options.tolerance = positive_number(arguments, "--tolerance").value_or(0);
    options.units = value_or(arguments, "--units", "");
    options.parts_by = *parts_by_of(value_or(arguments, "--parts-by", "auto"));
    options.recognise_arcs = !has(arguments, "--keep-facets");
    options.layers = {listed_names(value_or(arguments, "--only-layer", "")),
                      listed_names(value_or(arguments, "--ignore-layer", ""))};
    options.leave_open = has(arguments, "--leave-open");
    options.keep_drafting = has(arguments, "--keep-drafting");
    options.block_outline = listed_names(value_or(arguments, "--block-outline", ""));
    if (has(arguments, "--section")) read_section(arguments.options.at("--section"), options);
    return options;
}

FileKind kind_of_file(const std::string& path) {
    if (!std::filesystem::exists(path)) throw InputError(path, "there is no such file", "check the name and the folder");
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".json") return FileKind::scene;
    if (is_importable(path)) return FileKind::drawing;
    throw InputError(path,
                     extension.empty() ? "the name has no extension" : "files of the kind '" + extension + "' cannot be read",
                     "give a scene (.json), " + importable_kinds());
}

}  // namespace abut
