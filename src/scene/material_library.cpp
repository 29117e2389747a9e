// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/material_library.hpp"

namespace abut {

namespace {

const JsonValue& library() {
    static const JsonDocument document = parse_json(material_library_text(), "materials.json");
    return document.root;
}

std::vector<std::string> aliases_of(const JsonValue& material) {
    std::vector<std::string> names;
    if (const JsonValue* aliases = find_member(material, "aliases"))
        for (const JsonValue& alias : aliases->items) names.push_back(alias.text);
    return names;
}

}  // namespace

const JsonValue* library_material(const std::string& name) {
    for (const JsonValue& material : library().items) {
        if (material.key == name) return &material;
        for (const std::string& alias : aliases_of(material))
            if (alias == name) return &material;
    }
    return nullptr;
}

std::vector<std::string> library_material_names() {
    std::vector<std::string> names;
    for (const JsonValue& material : library().items)
        for (const std::string& alias : aliases_of(material)) names.push_back(alias);
    for (const JsonValue& material : library().items) names.push_back(material.key);
    return names;
}

}  // namespace abut
