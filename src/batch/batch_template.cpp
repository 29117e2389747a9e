// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_template.hpp"

#include <algorithm>
#include <cctype>

#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

bool names_any_file(const JsonValue& value) {
    if (value.kind == JsonValue::Kind::string && value.key == "file" && value.text == any_file) return true;
    return std::any_of(value.items.begin(), value.items.end(), names_any_file);
}

bool has_word(const std::string& text, const std::string& word) {
    const auto goes_on = [&](std::size_t k) {
        return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '_');
    };
    for (std::size_t k = text.find(word); k != std::string::npos; k = text.find(word, k + 1))
        if ((k == 0 || !goes_on(k - 1)) && !goes_on(k + word.size())) return true;
    return false;
}

bool names(const JsonValue& value, const std::string& parameter) {
    if (value.kind == JsonValue::Kind::string && has_word(value.text, parameter)) return true;
    return std::any_of(value.items.begin(), value.items.end(), [&](const JsonValue& item) { return names(item, parameter); });
}

/// Does anything of a scene use its k-th parameter, by itself or by one of those after it?
bool uses(const JsonValue& scene, const JsonValue& parameters, std::size_t k) {
    const std::string& parameter = parameters.items[k].key;
    const auto is_used_by = [&](const JsonValue& member) {
        return member.key != "title" && member.key != "parameters" && names(member, parameter);
    };
    if (std::any_of(scene.items.begin(), scene.items.end(), is_used_by)) return true;
    for (std::size_t j = k + 1; j < parameters.items.size(); ++j)
        if (names(parameters.items[j], parameter) && uses(scene, parameters, j)) return true;
    return false;
}

const std::string how_to_name = std::string("name the file '") + any_file +
                                "' where each job's own belongs, as in \"assembly\": {\"file\": \"" + any_file + "\", ...}";

}  // namespace

BatchTemplate read_template(const std::string& file) {
    const JsonDocument document = read_json(file);
    BatchTemplate result{file, names_any_file(document.root), {}, {}};
    if (const JsonValue* parameters = find_member(document.root, "parameters"))
        for (std::size_t k = 0; k < parameters->items.size(); ++k) {
            result.parameters.push_back(parameters->items[k].key);
            if (!uses(document.root, *parameters, k)) result.unused.push_back(parameters->items[k].key);
        }
    return result;
}

void check_template(const BatchSource& source, const BatchTemplate* batch_template) {
    std::vector<Problem> problems;
    if (!batch_template && !source.names_files)
        problems.push_back({source.parameters.empty() ? "" : source.parameters.begin()->second,
                            "the table has no column 'file'",
                            "add one, or give the scene that its parameters are for by --template"});
    if (batch_template && source.names_files && !batch_template->takes_file)
        problems.push_back({batch_template->file, "this template has no place for the files", how_to_name});
    if (batch_template && !source.names_files && batch_template->takes_file)
        problems.push_back({batch_template->file, "this template wants a file for each job, and the table names none",
                            "add the column 'file'"});
    for (const auto& [name, where] : source.parameters) {
        if (!batch_template) break;
        const auto& known = batch_template->parameters;
        if (std::find(known.begin(), known.end(), name) == known.end())
            problems.push_back({where, "the column '" + shortened(name) + "' is no parameter of " + batch_template->file,
                                nearest_name_hint(name, known)});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace abut
