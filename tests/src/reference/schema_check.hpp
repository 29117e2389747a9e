// SPDX-License-Identifier: GPL-3.0-or-later
// Schemas against what they describe: keys without a description, values with keys that a schema lacks.
#pragma once
#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace schema_check {

using Json = nlohmann::ordered_json;

inline std::string schema_file(const std::string& name) {
    return std::string(ABUT_SOURCE_DIR) + "/data/schema/" + name + ".schema.json";
}

/// Comments are allowed, as in scenes.
inline Json json_of(const std::string& file) {
    return Json::parse(std::ifstream(file), nullptr, true, true);
}

/// Every object of a schema that lists keys, by its place; what it holds by example is none.
inline void for_each_object(const Json& node, const std::string& place,
                            const std::function<void(const std::string&, const Json&)>& take) {
    if (node.is_object() && node.contains("properties")) take(place, node);
    if (!node.is_structured()) return;
    for (const auto& [key, value] : node.items())
        if (key != "examples" && key != "default") for_each_object(value, place + "/" + key, take);
}

/// Places of keys without a description, neither of their own nor where they refer to.
inline std::vector<std::string> undescribed(const Json& schema) {
    std::vector<std::string> places;
    const std::function<bool(const Json&)> described = [&](const Json& node) {
        if (node.contains("description")) return !node["description"].get<std::string>().empty();
        return node.contains("$ref") && described(schema.at(Json::json_pointer(node["$ref"].get<std::string>().substr(1))));
    };
    for_each_object(schema, "", [&](const std::string& place, const Json& object) {
        for (const auto& [key, value] : object["properties"].items())
            if (!described(value)) places.push_back(place + "/" + key);
    });
    return places;
}

/// Compares a value with a schema: its keys, types and words; nothing else that a schema may ask for.
class SchemaCheck {
public:
    explicit SchemaCheck(const Json& schema) : schema_(schema) {}

    /// One line for each fault. `part`: of the schema, which describes the value.
    std::vector<std::string> faults(const Json& value, const std::string& part = "") {
        return faults_of(schema_.at(Json::json_pointer(part)), value, "");
    }

    /// Keys of the schema that no value had so far.
    std::vector<std::string> never_met() const {
        std::vector<std::string> names;
        for_each_object(schema_, "", [&](const std::string& place, const Json& object) {
            for (const auto& [key, value] : object["properties"].items())
                if (!met_.contains(&value)) names.push_back(place + "/" + key);
        });
        return names;
    }

    /// Told of every object that has keys, with its place in the value, as a JSON pointer.
    std::function<void(const std::string&, const Json&)> on_object = [](const std::string&, const Json&) {};

private:
    using Faults = std::vector<std::string>;

    static bool has_type(const Json& value, const std::string& type) {
        if (type == "integer") return value.is_number_integer();
        if (type == "number") return value.is_number();
        return type == (value.is_boolean() ? "boolean" : value.type_name());
    }

    Faults faults_of(const Json& node, const Json& value, const std::string& at) {
        if (node.contains("$ref"))
            return faults_of(schema_.at(Json::json_pointer(node["$ref"].get<std::string>().substr(1))), value, at);
        if (node.contains("const") && node["const"] != value) return {at + " is not " + node["const"].dump()};
        if (node.contains("enum") && std::find(node["enum"].begin(), node["enum"].end(), value) == node["enum"].end())
            return {at + " is none of " + node["enum"].dump()};
        if (node.contains("type") && !is_of_type(node["type"], value)) return {at + " is no " + node["type"].dump()};
        if (node.contains("anyOf") && !node["anyOf"][0].contains("required")) return any_of(node["anyOf"], value, at);
        if (value.is_array() && node.contains("items")) return items(node["items"], value, at);
        if (value.is_object() && node.contains("type")) return keys(node, value, at);
        return {};
    }

    static bool is_of_type(const Json& types, const Json& value) {
        if (!types.is_array()) return has_type(value, types.get<std::string>());
        return std::any_of(types.begin(), types.end(), [&](const Json& t) { return has_type(value, t.get<std::string>()); });
    }

    /// The faults of the branch that fits best.
    Faults any_of(const Json& branches, const Json& value, const std::string& at) {
        Faults least = faults_of(branches[0], value, at);
        for (const Json& branch : branches)
            if (Faults found = faults_of(branch, value, at);
                found.size() < least.size() || (found.size() == least.size() && value.is_object()))
                least = std::move(found);
        return least;
    }

    Faults items(const Json& node, const Json& value, const std::string& at) {
        Faults all;
        for (std::size_t i = 0; i < value.size(); ++i)
            for (std::string& fault : faults_of(node, value[i], at + "/" + std::to_string(i))) all.push_back(std::move(fault));
        return all;
    }

    Faults keys(const Json& node, const Json& value, const std::string& at) {
        Faults all;
        if (node.contains("properties")) on_object(at, node);
        for (const auto& [key, member] : value.items()) {
            const std::string place = at + "/" + key;
            if (node.contains("properties") && node["properties"].contains(key)) {
                met_.insert(&node["properties"][key]);
                for (std::string& fault : faults_of(node["properties"][key], member, place)) all.push_back(std::move(fault));
            } else if (const Json* named = by_pattern(node, key)) {
                for (std::string& fault : faults_of(*named, member, place)) all.push_back(std::move(fault));
            } else if (node.contains("additionalProperties") && node["additionalProperties"].is_object()) {
                for (std::string& fault : faults_of(node["additionalProperties"], member, place))
                    all.push_back(std::move(fault));
            } else {
                all.push_back(place + " is unknown");
            }
        }
        for (const Json& key : node.value("required", Json::array()))
            if (!value.contains(key.get<std::string>())) all.push_back(at + "/" + key.get<std::string>() + " is missing");
        return all;
    }

    /// The schema of a key that one of an object's patterns names; nullptr: none does.
    static const Json* by_pattern(const Json& node, const std::string& key) {
        if (!node.contains("patternProperties")) return nullptr;
        for (const auto& [pattern, named] : node["patternProperties"].items())
            if (std::regex_search(key, std::regex(pattern))) return &named;
        return nullptr;
    }

    const Json& schema_;
    std::set<const Json*> met_;
};

/// As one text, for messages.
inline std::string in_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

}  // namespace schema_check
