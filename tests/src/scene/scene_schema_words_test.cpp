// SPDX-License-Identifier: GPL-3.0-or-later
// Keys whose value is one of a list: the schema of scenes, the reader and the command line know the same words.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "src/scene/read_drawing.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "src/scene/scene_words.hpp"

namespace abut::scene_schema_words_test {
namespace {

using Json = nlohmann::json;
using Strings = std::set<std::string>;

const std::string data = std::string(ABUT_SOURCE_DIR) + "/data/";

Json schema() {
    return Json::parse(std::ifstream(data + "schema/scene.schema.json"));
}

/// Every "enum" of the schema, by its place.
void collect(const Json& node, const std::string& place, std::map<std::string, Strings>& found) {
    if (node.is_object() && node.contains("enum")) {
        for (const Json& word : node["enum"]) found[place].insert(word.get<std::string>());
        return;
    }
    if (!node.is_structured()) return;
    for (const auto& [key, item] : node.items()) collect(item, place + "/" + key, found);
}

/// The place of the value in a scene, as a JSON pointer.
const std::map<std::string, std::string> places{
    {"/properties/motion", "/motion"},
    {"/properties/analysis", "/analysis"},
    {"/$defs/place/properties/mirror", "/parts/0/place/mirror"},
    {"/$defs/section/properties/axis", "/parts/1/geometry/mesh/section/axis"},
    {"/$defs/geometry/properties/place/properties/mirror", "/parts/0/geometry/place/mirror"},
    {"/$defs/assembly/properties/parts_by", "/assembly/parts_by"},
    {"/$defs/support/properties/fix/items", "/supports/0/fix/0"},
    {"/$defs/contacts/properties/formulation", "/contacts/formulation"},
    {"/$defs/contacts/properties/overlap", "/contacts/overlap"},
    {"/$defs/contacts/properties/pairs/items/properties/kind", "/contacts/pairs/0/kind"},
    {"/$defs/accuracy/properties/level", "/accuracy/level"},
    {"/$defs/accuracy/properties/basis", "/accuracy/basis"},
    {"/$defs/accuracy/properties/dirichlet", "/accuracy/dirichlet"},
    {"/$defs/accuracy/properties/solver", "/accuracy/solver"},
    {"/$defs/accuracy/properties/method", "/accuracy/method"},
    {"/$defs/accuracy/properties/weights", "/accuracy/weights"},
    {"/$defs/output/properties/formats/items", "/output/formats/0"}};

/// A scene that has all these places, so that the one of `pointer` can be set.
Json scene_with(const std::string& pointer, const std::string& word) {
    Json scene = Json::parse(R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0}},
      "parts": [{"name": "p", "material": "m", "place": {}, "geometry": {"place": {"of": {"rectangle": {"min": [50, 0], "max": [51, 1]}}}}},
                {"name": "q", "material": "m", "geometry": {"mesh": {"file": "MESH", "section": {"axis": "z", "at": 1}}}}],
      "assembly": {"file": "DRAWING", "material": "m"},
      "supports": [{"on": "p/left", "fix": ["x"]}],
      "contacts": {"pairs": [{"between": ["p/left", "p/right"]}]}, "accuracy": {}, "output": {"formats": ["json"]}})");
    scene["assembly"]["file"] = data + "sketches/pin_bracket_r14.dxf";
    if (pointer.starts_with("/parts/1"))
        scene["parts"][1]["geometry"]["mesh"]["file"] = "no_such.stl";  // its axis is read before the file
    else
        scene["parts"].erase(1);
    if (!pointer.starts_with("/assembly")) scene.erase("assembly");
    if (pointer == "/accuracy/weights") scene["accuracy"]["dirichlet"] = "solution_structure";  // theirs
    scene[Json::json_pointer(pointer)] = word;
    return scene;
}

/// What the reader says at that place; empty: it takes the word.
std::string fault(const std::string& pointer, const std::string& word) {
    try {
        read_scene_text(scene_with(pointer, word).dump(), "s.json");
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems())
            if (problem.where.ends_with(" " + pointer)) return problem.what + "; " + problem.hint;
    }
    return "";
}

/// The words that a message "expected one of "a", "b", found ..." offers.
Strings offered(const std::string& message) {
    static const std::regex quoted("\"([a-z_]+)\"");
    const std::string list = message.substr(0, message.find(", found"));
    Strings words;
    for (std::sregex_iterator word(list.begin(), list.end(), quoted), end; word != end; ++word) words.insert((*word)[1]);
    return words;
}

TEST(SceneSchemaWords, TheReaderTakesThoseOfTheSchemaAndNoOthers) {
    std::map<std::string, Strings> found;
    collect(schema(), "", found);
    EXPECT_EQ(found.size(), places.size());
    for (const auto& [place, words] : found) {
        SCOPED_TRACE(place);
        ASSERT_TRUE(places.contains(place)) << "a list that this test does not know: give the place in a scene";
        const std::string& pointer = places.at(place);
        for (const std::string& word : words) EXPECT_EQ(fault(pointer, word), "") << word;
        const std::string refusal = fault(pointer, "nonsense");
        EXPECT_NE(refusal.find("expected one of"), std::string::npos) << refusal;
        EXPECT_EQ(offered(refusal), words);
    }
}

TEST(SceneSchemaWords, OptionsOfTheCommandLineTakeTheSame) {
    std::map<std::string, Strings> found;
    collect(schema(), "", found);
    const auto set_of = [](const std::vector<std::string>& words) { return Strings(words.begin(), words.end()); };
    EXPECT_EQ(found.at("/$defs/assembly/properties/parts_by"), set_of(parts_by_words()));
    EXPECT_EQ(found.at("/$defs/accuracy/properties/level"), set_of(accuracy_levels()));
    for (const std::string& word : parts_by_words()) EXPECT_TRUE(parts_by_of(word)) << word;
    EXPECT_FALSE(parts_by_of("component"));
}

}  // namespace
}  // namespace abut::scene_schema_words_test
