// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "src/io/whole_file.hpp"

namespace abut {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t example_width = 110;

/// In one line, with blanks as people write them.
std::string spaced(const Json& j) {
    if (!j.is_structured()) return j.dump();
    std::string text;
    for (const auto& [key, value] : j.items())
        text += (text.empty() ? "" : ", ") + (j.is_object() ? Json(key).dump() + ": " : "") + spaced(value);
    return j.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// In one line where it fits, else with a line for each member.
std::string example_text(const Json& j) {
    const std::string line = spaced(j);
    if (line.size() <= example_width || !j.is_object()) return line;
    std::string text;
    for (const auto& [key, value] : j.items())
        text += (text.empty() ? "  " : ",\n  ") + Json(key).dump() + ": " + spaced(value);
    return "{\n" + text + "\n}";
}

std::string listed_words(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

std::string type_word(const std::string& type) {
    static const std::map<std::string, std::string> words{
        {"string", "text"}, {"integer", "whole number"}, {"boolean", "true or false"}};
    const auto found = words.find(type);
    return found == words.end() ? type : found->second;
}

/// Walks through a schema in the order in which keys are written there.
class Walk {
public:
    explicit Walk(const Json& schema) : schema_(schema) {}

    std::vector<ReferenceEntry> entries() && {
        visit(schema_, "", "", false, true);
        return std::move(entries_);
    }

private:
    /// What a node stands for: the node itself, or what its "$ref" leads to in the end.
    const Json& resolved(const Json& node) const {
        const auto ref = node.find("$ref");
        return ref == node.end() ? node : resolved(schema_.at(Json::json_pointer(ref->get<std::string>().substr(1))));
    }

    /// A word about a node: its own, else that of what it refers to.
    const Json* word(const Json& node, const char* key) const {
        if (node.contains(key)) return &node.at(key);
        const auto ref = node.find("$ref");
        return ref == node.end() ? nullptr : word(schema_.at(Json::json_pointer(ref->get<std::string>().substr(1))), key);
    }

    std::string text(const Json& node, const char* key) const {
        const Json* found = word(node, key);
        return found ? found->get<std::string>() : "";
    }

    /// Its own, or those of something that it may be.
    const Json* examples_of(const Json& node) const {
        const Json* examples = word(node, "examples");
        const Json& n = resolved(node);
        if (n.contains("anyOf"))
            for (const Json& branch : n["anyOf"])
                if (!examples) examples = examples_of(branch);
        return examples;
    }

    std::string type_of(const Json& node) const {
        if (&node != &schema_ && word(node, "title") && !word(node, "properties")) return text(node, "title");
        const Json& n = resolved(node);
        std::vector<std::string> words;
        if (n.contains("const")) return n["const"].dump();
        if (n.contains("enum")) {
            for (const Json& value : n["enum"]) words.push_back(value.dump());
        } else if (n.contains("anyOf") && !n.contains("type")) {
            for (const Json& branch : n["anyOf"]) words.push_back(type_of(branch));
        } else if (n.contains("type") && n["type"].is_array()) {
            for (const Json& type : n["type"]) words.push_back(type_word(type.get<std::string>()));
        } else if (n.contains("items")) {
            const std::string type = type_of(n["items"]);
            return is_plain(type) ? "list of " + type + "s" : "list, each " + type;
        } else if (n.contains("additionalProperties") && n["additionalProperties"].is_object() && !n.contains("properties")) {
            const std::string type = type_of(n["additionalProperties"]);
            return (is_plain(type) ? type + "s" : "each " + type) + " by name";
        } else {
            words.push_back(type_word(n.value("type", "anything")));
        }
        return listed_words(words);
    }

    /// Has it a plural in s?
    static bool is_plain(const std::string& type) {
        return type == "text" || type == "number" || type == "whole number" || type == "object";
    }

    /// What a key may be: its default, its only value, or the first of its words.
    const Json* value_of(const Json& node) const {
        if (const Json* standard = word(node, "default")) return standard;
        const Json& n = resolved(node);
        if (n.contains("const")) return &n["const"];
        return n.contains("enum") ? &n["enum"].front() : nullptr;
    }

    /// The first example of the object around a key that has it; else the key with a value that it may have; else an
    /// example of the list's items; else the last one of the object around.
    std::string example_around(const std::string& key, const Json& node) const {
        if (around_)
            for (const Json& example : *around_)
                if (example.is_object() && example.contains(key)) return example_text(example);
        if (const Json* value = value_of(node)) {
            Json with_value;
            with_value[key] = *value;
            return example_text(with_value);
        }
        const Json& n = resolved(node);
        const Json* items = n.contains("items") ? examples_of(n["items"]) : nullptr;
        if (!items && !around_) return "";
        return example_text(items ? items->back() : around_->back());
    }

    void visit(const Json& node, const std::string& path, const std::string& parent, bool required, bool is_key) {
        ReferenceEntry entry;
        entry.path = path;
        entry.parent = parent;
        entry.title = !path.empty() && resolved(node).contains("properties") ? text(node, "title") : "";
        entry.type = type_of(node);
        entry.meaning = text(node, "description");
        entry.required = required;
        entry.is_key = is_key;
        static const std::string mark = " Unit: ";
        if (const std::size_t at = entry.meaning.rfind(mark); at != std::string::npos) {
            entry.unit = entry.meaning.substr(at + mark.size(), entry.meaning.size() - at - mark.size() - 1);
            entry.meaning.resize(at);
        }
        if (const Json* standard = word(node, "default")) entry.standard = spaced(*standard);
        if (const Json* examples = examples_of(node)) entry.example = example_text(examples->back());
        if (is_key && entry.example.empty()) entry.example_around = example_around(path.substr(path.rfind('.') + 1), node);
        const std::size_t place = entries_.size();
        entries_.push_back(std::move(entry));
        const Json* const outside = around_;
        if (const Json* examples = examples_of(node)) around_ = examples;
        const std::string same_as = visit_below(node, path, path);
        around_ = outside;
        entries_[place].same_as = same_as;
    }

    /// What a node of the entry `owner` holds. Gives the path at which that stands already, if it does.
    std::string visit_below(const Json& node, const std::string& path, const std::string& owner) {
        const Json& n = resolved(node);
        std::string same_as;
        const auto note = [&](const std::string& other) {
            if (other != owner && !other.empty()) same_as = other;
        };
        if (n.contains("properties")) {
            const auto [known, is_new] = place_of_.emplace(&n, path);
            if (!is_new) return known->second;
            visit_keys(n, path);
        }
        if (n.contains("anyOf"))
            for (const Json& branch : n["anyOf"]) note(visit_below(branch, path, owner));
        if (n.contains("items")) note(visit_items(n["items"], owner, path + "[]"));
        const std::string free_name = path.empty() ? "*" : path + ".*";
        if (n.contains("patternProperties"))
            for (const auto& [pattern, value] : n["patternProperties"].items()) visit_items(value, owner, free_name);
        if (n.contains("additionalProperties") && n["additionalProperties"].is_object())
            note(visit_items(n["additionalProperties"], owner, free_name));
        return same_as;
    }

    void visit_keys(const Json& n, const std::string& path) {
        const Json required = n.value("required", Json::array());
        for (const auto& [key, value] : n["properties"].items())
            visit(value, path.empty() ? key : path + "." + key, path,
                  std::find(required.begin(), required.end(), Json(key)) != required.end(), true);
    }

    /// Items that are objects have an entry of their own, and so have values with free names that are described; other ones are
    /// told by the type of the whole.
    std::string visit_items(const Json& items, const std::string& owner, const std::string& path) {
        const Json& n = resolved(items);
        if (const std::string known = known_place(n); !known.empty()) return known;
        const bool has_keys = holds_keys(n);
        if (!has_keys && !items.contains("description")) return visit_below(items, path, owner);
        visit(items, path, owner, false, !has_keys);
        return "";
    }

    bool holds_keys(const Json& n) const {
        if (n.contains("properties")) return true;
        if (!n.contains("anyOf")) return false;
        return std::any_of(n["anyOf"].begin(), n["anyOf"].end(), [&](const Json& b) { return holds_keys(resolved(b)); });
    }

    /// Where the keys of an object, or of one that it may be, are listed already.
    std::string known_place(const Json& n) const {
        if (const auto known = place_of_.find(&n); known != place_of_.end()) return known->second;
        if (n.contains("anyOf"))
            for (const Json& branch : n["anyOf"])
                if (const std::string known = known_place(resolved(branch)); !known.empty()) return known;
        return "";
    }

    const Json& schema_;
    std::vector<ReferenceEntry> entries_;
    const Json* around_ = nullptr;                 ///< examples of the object whose keys are visited, or of one around it
    std::map<const Json*, std::string> place_of_;  ///< where an object's keys are listed
};

}  // namespace

const std::vector<std::string>& reference_names() {
    static const std::vector<std::string> names{"scene", "result", "cases", "contacts", "expect",
                                                "csv",   "study",  "batch", "inspect",  "verify"};
    return names;
}

ReferencePage reference_page(const std::string& name, const std::string& schema) {
    const Json json = Json::parse(schema, nullptr, false);
    if (!json.is_object()) throw InputError(name + ".schema.json", "this is no schema", "take it from abut's sources");
    return {name, json.value("title", name), Walk(json).entries()};
}

std::vector<ReferencePage> read_reference(const std::string& folder) {
    std::vector<ReferencePage> pages;
    for (const std::string& name : reference_names())
        pages.push_back(reference_page(name, read_whole_file(folder + "/" + name + ".schema.json")));
    return pages;
}

std::string full_name(const ReferencePage& page, const ReferenceEntry& entry) {
    return entry.path.empty() ? page.title : page.name + "." + entry.path;
}

std::vector<const ReferenceEntry*> keys_of(const ReferencePage& page, const ReferenceEntry& entry) {
    std::vector<const ReferenceEntry*> keys;
    for (const ReferenceEntry& e : page.entries)
        if (e.is_key && &e != &entry && e.parent == entry.path && !e.path.empty()) keys.push_back(&e);
    for (const ReferenceEntry& e : page.entries)
        if (keys.empty() && !e.is_key && e.parent == entry.path) return keys_of(page, e);
    return keys;
}

}  // namespace abut
