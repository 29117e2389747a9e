// SPDX-License-Identifier: GPL-3.0-or-later
// Which key is meant, and what is said of it.
#include "src/reference/reference_search.hpp"

#include <gtest/gtest.h>

#include "geometry/brep/input_error.hpp"
#include "src/reference/reference_text.hpp"

namespace abut::reference_search_test {
namespace {

ReferencePage small_page() {
    return reference_page("scene", R"({"title": "scene", "description": "A file.", "type": "object", "properties": {
      "loads": {"type": "array", "items": {"$ref": "#/$defs/load"}, "default": [], "description": "The loads."},
      "materials": {"type": "object", "description": "By name.", "additionalProperties": {"type": "object", "description": "One.",
        "properties": {"E": {"type": "number", "description": "Young's modulus. It is above 0. Unit: force per length^2."}}}},
      "shape": {"$ref": "#/$defs/shape"}},
      "$defs": {"load": {"type": "object", "description": "A load.", "required": ["force"], "examples": [{"force": 1}], "properties": {
          "force": {"type": ["number", "null"], "default": 1, "description": "Its force. Unit: force."},
          "kind": {"enum": ["a", "b|c"], "description": "Its kind."}}},
        "shape": {"type": "object", "description": "A shape.", "properties": {
          "union": {"type": "array", "items": {"$ref": "#/$defs/shape"}, "description": "Shapes."},
          "kind": {"type": "string", "description": "Its kind."}}}}})");
}

std::vector<std::string> names(const std::vector<ReferencePage>& pages, const std::string& words) {
    std::vector<std::string> list;
    for (const FoundEntry& found : find_keys(pages, words)) list.push_back(full_name(*found.page, *found.entry));
    return list;
}

using List = std::vector<std::string>;

TEST(Reference, ListsObjectsBeforeTheirKeysAndEachObjectOnce) {
    List paths;
    const ReferencePage page = small_page();
    for (const ReferenceEntry& entry : page.entries) paths.push_back(entry.path);
    EXPECT_EQ(paths, (List{"", "loads", "loads[]", "loads[].force", "loads[].kind", "materials", "materials.*", "materials.*.E",
                           "shape", "shape.union", "shape.kind"}));
    const ReferenceEntry& force = page.entries[3];
    EXPECT_EQ(force.type, "number or null");
    EXPECT_EQ(force.meaning, "Its force.");
    EXPECT_EQ(force.unit, "force");
    EXPECT_EQ(force.standard, "1");
    EXPECT_TRUE(force.required);
    EXPECT_EQ(page.entries[1].type, "list of objects");
    EXPECT_EQ(page.entries[9].same_as, "shape");
    EXPECT_EQ(keys_of(page, page.entries[1]).size(), 2U);
}

TEST(Reference, FindsKeysByPathEndAndWords) {
    const std::vector<ReferencePage> pages{small_page()};
    for (const char* words : {"loads.force", "loads[].force", "scene.loads.force", "force", "scene.force"})
        EXPECT_EQ(names(pages, words), List{"scene.loads[].force"}) << words;
    for (const char* words : {"materials.E", "materials.steel.E", "scene.materials.*.E", "E"})
        EXPECT_EQ(names(pages, words), List{"scene.materials.*.E"}) << words;
    EXPECT_EQ(names(pages, "loads"), List{"scene.loads"});
    EXPECT_EQ(names(pages, "kind"), (List{"scene.loads[].kind", "scene.shape.kind"}));
    EXPECT_EQ(names(pages, "shape.union.union.kind"), List{"scene.shape.kind"}) << "a shape in a shape";
    EXPECT_EQ(names(pages, "scene"), List{"scene"});
    for (const char* words : {"", ".", "[]", "forces", "loads.E", "other.force"})
        EXPECT_EQ(names(pages, words), List{}) << words;
    EXPECT_NE(nearest_key_hint(pages, "loads.forse", {}).find("'loads.force'"), std::string::npos);
}

TEST(Reference, AnEntrySaysAllThatTheSchemaSays) {
    const ReferencePage page = small_page();
    const std::string force = entry_text(page, page.entries[3]), loads = entry_text(page, page.entries[1]);
    for (const char* words :
         {"scene.loads[].force", "number or null", "unit      force", "required", "default   1", "Its force."})
        EXPECT_NE(force.find(words), std::string::npos) << words << " is missing in\n" << force;
    for (const char* words : {"The loads.", "A load.", "{\"force\": 1}", "kind", "Its kind."})
        EXPECT_NE(loads.find(words), std::string::npos) << words << " is missing in\n" << loads;
    EXPECT_EQ(first_sentence("One. Two."), "One.");
    EXPECT_EQ(first_sentence("One."), "One.");
}

TEST(Reference, PagesAndManPageKeepWhatHasAMeaningThere) {
    const std::string pages = reference_markdown({small_page()}), man = reference_roff({small_page()});
    EXPECT_NE(pages.find("| `loads[].kind` | \"a\" or \"b\\|c\" |"), std::string::npos) << pages;
    EXPECT_NE(pages.find("`materials.*.E`"), std::string::npos);
    EXPECT_NE(man.find(".B materials.*.E"), std::string::npos) << man;
    EXPECT_EQ(roff_escaped(".a-b\n'c\\"), "\\&.a\\-b\n\\&\\(aqc\\e");
}

TEST(Reference, AFileThatIsNoSchemaIsAFaultOfTheInput) {
    EXPECT_THROW(reference_page("scene", "{"), InputError);
    EXPECT_THROW(read_reference("/no/such/folder"), InputError);
}

}  // namespace
}  // namespace abut::reference_search_test
