// SPDX-License-Identifier: GPL-3.0-or-later
// The schemas say what every key is; that of scenes has the keys, defaults and scenes of the reader.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>

#include "geometry/brep/input_error.hpp"
#include "src/reference/reference.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/reference/schema_check.hpp"

namespace abut::schemas_test {
namespace {

using namespace schema_check;
using Strings = std::set<std::string>;

std::vector<ReferencePage> reference() {
    return read_reference(std::string(ABUT_SOURCE_DIR) + "/data/schema");
}

TEST(Schemas, EveryKeyIsDescribedInEachOfThem) {
    Strings files, names;
    for (const auto& file : std::filesystem::directory_iterator(std::string(ABUT_SOURCE_DIR) + "/data/schema"))
        if (file.path().extension() == ".json") files.insert(file.path().string());
    for (const std::string& name : reference_names()) names.insert(schema_file(name));
    EXPECT_EQ(files, names) << "every schema is a page of the reference";
    for (const std::string& file : files) EXPECT_EQ(in_lines(undescribed(json_of(file))), "") << file;
}

TEST(Schemas, AKeyWithoutADescriptionIsNoticed) {
    Json schema = json_of(schema_file("scene"));
    schema["$defs"]["load"]["properties"]["pressure"].erase("description");
    schema["properties"]["title"]["description"] = "";
    schema["$defs"]["contacts"]["properties"]["pairs"]["items"]["properties"]["kind"].erase("description");
    EXPECT_EQ(undescribed(schema).size(), 3U) << in_lines(undescribed(schema));
}

TEST(Schemas, MeaningsAreSentencesNumbersHaveUnitsAndObjectsExamples) {
    for (const ReferencePage& page : reference())
        for (const ReferenceEntry& entry : page.entries) {
            SCOPED_TRACE(full_name(page, entry));
            EXPECT_TRUE(entry.meaning.ends_with(".") || entry.meaning.ends_with("...")) << entry.meaning;
            EXPECT_EQ(entry.meaning.find("Unit:"), std::string::npos) << "the unit is the last sentence";
            const bool is_number = entry.type.starts_with("number") || entry.type.starts_with("[");
            if (is_number && entry.type != "numbers by name") { EXPECT_NE(entry.unit, ""); }
            const bool lists_keys = std::any_of(page.entries.begin(), page.entries.end(), [&](const ReferenceEntry& e) {
                return e.is_key && e.parent == entry.path && e.path.find('*') == std::string::npos;
            });
            if (lists_keys && !entry.path.empty()) { EXPECT_NE(entry.example, ""); }
        }
}

/// "type, unit, default and an example: `abut help loads.force`" says the README.
TEST(Schemas, KeysHaveExamplesOfTheirOwnOrOfTheObjectAroundThem) {
    for (const ReferencePage& page : reference())
        for (const ReferenceEntry& entry : page.entries) {
            if (!entry.is_key || entry.path.empty()) continue;
            const bool has_items = std::any_of(page.entries.begin(), page.entries.end(), [&](const ReferenceEntry& e) {
                return !e.is_key && e.parent == entry.path && !e.example.empty();
            });
            EXPECT_FALSE(entry.example.empty() && entry.example_around.empty() && !has_items) << full_name(page, entry);
            if (page.name == "scene" && entry.parent == "loads[]" && entry.example.empty()) {
                EXPECT_NE(entry.example_around.find('"' + entry.path.substr(8) + "\": "), std::string::npos) << entry.path;
            }
        }
}

TEST(Schemas, ExamplesHaveNoOtherKeys) {
    for (const std::string& name : reference_names()) {
        const Json schema = json_of(schema_file(name));
        for_each_object(schema, "", [&](const std::string& place, const Json& object) {
            SchemaCheck check(schema);
            for (const Json& example : object.value("examples", Json::array()))
                EXPECT_EQ(in_lines(check.faults(example, place)), "") << name << place << " " << example;
        });
    }
}

TEST(Schemas, ScenesOfTheProjectHaveNoOtherKeys) {
    const Json schema = json_of(schema_file("scene"));
    SchemaCheck check(schema);
    int n = 0;
    for (const char* folder : {"scenes", "verification", "batch"})
        for (const auto& file : std::filesystem::directory_iterator(std::string(ABUT_SOURCE_DIR) + "/data/" + folder)) {
            if (file.path().extension() != ".json") continue;
            ++n;
            EXPECT_EQ(in_lines(check.faults(json_of(file.path().string()))), "") << file.path();
        }
    EXPECT_GT(n, 40);
}

/// A scene that has every object of the format. It need not make sense as a whole.
const char* const every_object =
    R"({"abut": 1, "units": {"length": "mm"}, "parameters": {"R": 1, "S": {"value": 1, "min": 0, "max": 2}}, "materials": {"m": {"E": 1, "nu": 0}},
  "parts": [
    {"name": "a", "material": "m", "place": {"rotate": 0}, "geometry": {"union": [
      {"rectangle": {"min": [0, 0], "max": [1, 1]}}, {"circle": {"center": [0, 0], "radius": 1}},
      {"ellipse": {"center": [0, 0], "radii": [1, 2]}}, {"slot": {"from": [0, 0], "to": [1, 0], "radius": 1}},
      {"intersection": [{"half_plane": {"point": [0, 0], "normal": [1, 0]}}, {"circle": {"center": [0, 0], "radius": 1}}]},
      {"place": {"of": {"circle": {"center": [0, 0], "radius": 1}}}}]}},
    {"name": "b", "material": "m", "geometry": {"loops": [[{"line": {"from": [0, 0], "to": [1, 0]}},
      {"arc": {"from": [1, 0], "to": [0, 1], "center": [0, 0]}}, {"elliptic_arc": {"center": [0, 0], "radii": [1, 1], "start": 0, "end": 90}},
      {"bezier": {"points": [[0, 0], [1, 1]]}}, {"nurbs": {"degree": 1, "knots": [0, 0, 1, 1], "points": [[0, 0], [1, 1]]}}]]}},
    {"name": "c", "material": "m", "geometry": {"dxf": {"file": "none.dxf"}}},
    {"name": "d", "material": "m", "geometry": {"mesh": {"file": "none.stl", "section": {"axis": "z"}}}},
    {"name": "e", "material": "m", "array": {"count": 2, "step": [1, 0]}, "geometry": {"step": {"file": "none.step", "section": {"axis": "z"}}}}],
  "assembly": {"file": "none.dxf", "parts": {"LAYER": {"material": "m"}}},
  "supports": [{"on": {"part": "a", "near": [0, 0]}, "displacement": {"x": 0}}, {"part": "a", "rigid": {"rotation": 0}},
    {"on": "a/*", "spring": {"normal": 1}}],
  "loads": [{"part": "a", "spin": {"about": [0, 0], "omega": 1}},
    {"part": "a", "preload": {"across": [[0, 0], [1, 1]], "force": 1}}],
  "contacts": {"pairs": [{"between": ["a/*", "b/*"]}]},
  "accuracy": {"refine": [{"near": [0, 0], "radius": 1, "cell_size": 1}],
               "grids": {"a": {"cells": [2, 2], "refine": [{"from": [0, 0], "to": [1, 1]}]}}},
  "output": {"probes": [{"part": "a", "at": [0, 0]}]},
  "cases": [{"name": "one", "loads": {}}],
  "expect": [{"quantity": "strain_energy", "value": 1, "tolerance": 1, "case": "one"}]})";

/// The keys that the reader knows in the object at this place.
Strings keys_of_the_reader(const std::string& place) {
    Json scene = Json::parse(every_object);
    scene[Json::json_pointer(place)]["no_such_key"] = 1;
    try {
        read_scene_text(scene.dump(), "s.json");
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) {
            if (!problem.where.ends_with(place + "/no_such_key")) continue;
            Strings keys;
            const std::string known = problem.hint.substr(problem.hint.find("known here: ") + 12);
            static const std::regex word("[^, ]+");
            for (std::sregex_iterator key(known.begin(), known.end(), word), end; key != end; ++key) keys.insert(key->str());
            return keys;
        }
    }
    return {};
}

TEST(Schemas, TheReaderTakesTheKeysOfTheSchemaAndNoOthers) {
    const Json schema = json_of(schema_file("scene"));
    std::map<const Json*, std::string> place_of;
    SchemaCheck check(schema);
    check.on_object = [&](const std::string& place, const Json& object) { place_of.emplace(&object, place); };
    EXPECT_EQ(in_lines(check.faults(Json::parse(every_object))), "");
    for_each_object(schema, "", [&](const std::string& in_schema, const Json& object) {
        SCOPED_TRACE(in_schema);
        ASSERT_TRUE(place_of.contains(&object)) << "the scene above lacks this object";
        Strings keys;
        for (const auto& [key, value] : object["properties"].items()) keys.insert(key);
        EXPECT_EQ(keys_of_the_reader(place_of.at(&object)), keys);
    });
}

TEST(Schemas, DefaultsAreTheReaders) {
    const Json schema = json_of(schema_file("scene"));
    const auto standard = [&](const std::string& key) -> const Json& {
        return schema.at(Json::json_pointer(key + "/default"));
    };
    const Scene scene;
    const ContactOptions contacts;
    const Accuracy accuracy;
    EXPECT_EQ(scene.analysis == Analysis::plane_stress, standard("/properties/analysis") == "plane_stress");
    EXPECT_EQ(ScenePart{}.thickness, standard("/properties/thickness"));
    EXPECT_EQ(Selector{}.within, standard("/$defs/selector/anyOf/1/properties/within"));
    EXPECT_EQ(contacts.detect, standard("/$defs/contacts/properties/detect"));
    EXPECT_EQ(Json(contacts.overlap), standard("/$defs/contacts/properties/overlap"));
    EXPECT_EQ(PenaltyOptions{}.factor, standard("/$defs/contacts/properties/penalty"));
    EXPECT_EQ(Json(accuracy.level), standard("/$defs/accuracy/properties/level"));
    EXPECT_EQ(accuracy.degree, standard("/$defs/accuracy/properties/degree"));
    EXPECT_EQ(Json(accuracy.basis), standard("/$defs/accuracy/properties/basis"));
    EXPECT_EQ(Json(accuracy.dirichlet), standard("/$defs/accuracy/properties/dirichlet"));
    EXPECT_EQ(Json(Output{}.formats), standard("/$defs/output/properties/formats"));
}

}  // namespace
}  // namespace abut::schemas_test
