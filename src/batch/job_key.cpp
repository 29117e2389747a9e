// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/job_key.hpp"

#include <algorithm>
#include <filesystem>

#include "src/io/json_document.hpp"
#include "src/io/whole_file.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

std::string hash_of(const std::optional<std::string>& bytes) {
    return bytes ? content_hash(*bytes) : "missing";
}

InputFile hashed(const std::string& path) {
    const FileStamp stamp = file_stamp(path);
    const bool was_recent = is_recent(stamp);
    return {path, hash_of(whole_file(path)), stamp, was_recent};
}

bool names_a_file(const JsonValue& value) {
    if (value.kind != JsonValue::Kind::string || value.text.empty() || value.text == any_file) return false;
    return value.key == "file" || (value.key == "uri" && !value.text.starts_with("data:"));
}

void collect_names(const JsonValue& value, std::vector<std::string>& names) {
    if (names_a_file(value) && std::find(names.begin(), names.end(), value.text) == names.end()) names.push_back(value.text);
    for (const JsonValue& item : value.items) collect_names(item, names);
}

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    try {
        collect_names(parse_json(text, "").root, names);
    } catch (const InputError&) {  // the job itself will say so
    }
    return names;
}

}  // namespace

std::vector<InputFile> input_files(const std::string& file) {
    const FileStamp stamp = file_stamp(file);
    const bool was_recent = is_recent(stamp);
    const std::optional<std::string> bytes = whole_file(file);
    std::vector<InputFile> files{{file, hash_of(bytes), stamp, was_recent}};
    const std::string ending = ending_of(file);
    if (!bytes || (ending != ".json" && ending != ".gltf")) return files;
    for (const std::string& name : names_in(*bytes)) {
        const std::string path = (fs::path(file).parent_path() / name).string();
        const std::vector<InputFile> more =
            ending_of(name) == ".gltf" ? input_files(path) : std::vector<InputFile>{hashed(path)};
        files.insert(files.end(), more.begin(), more.end());
    }
    return files;
}

bool are_unchanged(const std::vector<InputFile>& inputs) {
    return std::all_of(inputs.begin(), inputs.end(), [](const InputFile& input) {
        if (file_stamp(input.path) != input.stamp) return false;
        return !input.was_recent || hash_of(whole_file(input.path)) == input.hash;
    });
}

std::string job_key(const std::map<std::string, std::string>& settings, const std::vector<InputFile>& inputs) {
    std::string all;
    const auto add = [&](const std::string& text) { all += std::to_string(text.size()) + ":" + text; };
    for (const auto& [name, value] : settings) {
        add(name);
        add(value);
    }
    for (const InputFile& input : inputs) add(input.hash);
    return content_hash(all);
}

}  // namespace abut
