// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/drawing_options.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "geometry/input_error.hpp"
#include "src/nearest_name.hpp"

namespace abut {

namespace {

const std::vector<std::string> known_units{"mm", "cm", "m", "in", "ft", "um"};

void check_no_drawing_options(const Arguments& arguments) {
    std::vector<Problem> problems;
    for (const OptionSpec& option : drawing_option_specs()) {
        if (!has(arguments, option.name)) continue;
        problems.push_back({arguments.operand, "option " + option.name + " is for drawings, and this is a scene",
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

std::string lower_case_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

}  // namespace

std::vector<OptionSpec> drawing_option_specs() {
    return {{"--units", "UNIT", "the drawing's length unit: " + listed(known_units) + " (default: as the file states)"},
            {"--tolerance", "T", "largest gap between end points that is closed (default: 2e-5 of the part's diagonal)"},
            {"--parts-by", "WAY", "what separates the drawing's parts: layer (the default)"}};
}

DrawingOptions drawing_options(const Arguments& arguments) {
    if (kind_of_file(arguments.operand) == FileKind::scene) {
        check_no_drawing_options(arguments);
        return {};
    }
    check_choice(arguments, "--units", known_units);
    check_choice(arguments, "--parts-by", {"layer"});
    return {positive_number(arguments, "--tolerance").value_or(0), value_or(arguments, "--units", "")};
}

FileKind kind_of_file(const std::string& path) {
    if (!std::filesystem::exists(path)) throw InputError(path, "there is no such file", "check the name and the folder");
    const std::string extension = lower_case_extension(path);
    if (extension == ".json") return FileKind::scene;
    if (extension == ".dxf") return FileKind::drawing;
    throw InputError(path,
                     extension.empty() ? "the name has no extension" : "files of the kind '" + extension + "' cannot be read",
                     "give a scene (.json) or a drawing (.dxf)");
}

}  // namespace abut
