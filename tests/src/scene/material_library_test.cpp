// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of the library in scenes, and E that looks as if it were in other units.
#include "src/scene/material_library.hpp"

#include <gtest/gtest.h>

#include <set>

#include "geometry/brep/input_error.hpp"
#include "src/scene/read_materials.hpp"
#include "src/scene/read_scene.hpp"

namespace abut::material_library_test {

namespace {

Scene scene_of(const std::string& units, const std::string& materials, const std::string& used) {
    return read_scene_text(R"({"abut": 1, "units": )" + units + R"(, "materials": )" + materials +
                               R"(, "parts": [{"name": "a", "material": "rigid", "geometry": {"circle": {"center": [0, 0],
                               "radius": 1}}}, {"name": "b", "material": ")" +
                               used + R"(", "geometry": {"circle": {"center": [5, 0], "radius": 1}}}]})",
                           "scene.json");
}

const std::string mm_N = R"({"length": "mm", "force": "N"})";

std::string fault(const std::string& units, const std::string& materials, const std::string& used) {
    try {
        scene_of(units, materials, used);
    } catch (const InputError& error) { return error.what(); }
    return "no error";
}

}  // namespace

TEST(MaterialLibrary, DensitiesAndGravitiesInOtherUnitsAreTold) {
    const auto scene = [](const std::string& density, const std::string& gravity) {
        return read_scene_text(
                   R"({"abut": 1, "units": {"length": "mm", "force": "N"}, "materials": {"m": {"E": 210000, "nu": 0.3, "density": )" +
                       density +
                       R"(}}, "parts": [{"name": "p", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}}],
                                "supports": [{"on": "p/bottom", "fix": ["x", "y"]}], "loads": [{"gravity": [0, )" +
                       gravity + "]}]}",
                   "scene.json")
            .warnings;
    };
    EXPECT_TRUE(scene("7.85e-9", "-9810").empty());
    EXPECT_TRUE(scene("\"7850 kg/m^3\"", "\"-9.81 m/s^2\"").empty());
    ASSERT_EQ(scene("7850", "-9810").size(), 1U);
    EXPECT_NE(scene("7850", "-9810")[0].find("density"), std::string::npos);
    ASSERT_EQ(scene("7.85e-9", "-9.81").size(), 1U);
    EXPECT_NE(scene("7.85e-9", "-9.81")[0].find("gravity"), std::string::npos);
}

TEST(MaterialLibrary, has_what_it_says) {
    std::set<std::string> names;
    for (const std::string& name : library_material_names()) {
        SCOPED_TRACE(name);
        EXPECT_TRUE(names.insert(name).second);
        const Material m = material_from_library(name, {"m", "N"});
        EXPECT_TRUE(m.E > 1e9 && m.E < 3e11 && m.nu > 0.2 && m.nu < 0.4 && m.density > 1000 && m.density < 9000);
        EXPECT_TRUE(m.expansion && *m.expansion > 5e-6 && *m.expansion < 2e-4);
        EXPECT_TRUE(!m.yield || (*m.yield > 5e7 && *m.yield < 1e9));
        EXPECT_EQ(implausible_stiffness(m, {"m", "N"}), "");
        EXPECT_EQ(implausible_density(m, {"m", "N"}), "");
        const JsonValue& entry = *library_material(name);
        for (const char* key : {"E", "nu", "density", "expansion", "yield"}) {
            const JsonValue* source = find_member(*find_member(entry, "sources"), key);
            EXPECT_EQ(find_member(entry, key) != nullptr, source && !source->text.empty()) << key;
        }
    }
    for (const char* name :
         {"steel", "aluminium", "stainless steel", "cast iron", "titanium", "brass", "bronze", "POM", "PEEK"})
        EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_EQ(library_material("unobtainium"), nullptr);
}

TEST(MaterialLibrary, gives_scenes_what_they_do_not_define) {
    const Scene scene = scene_of(mm_N, "{}", "steel");
    ASSERT_EQ(scene.materials.size(), 2u);
    const Material& steel = scene.materials[static_cast<std::size_t>(scene.parts[1].material)];
    EXPECT_EQ(steel.name, "steel");
    EXPECT_EQ(steel.E, 210000);
    EXPECT_DOUBLE_EQ(steel.density, 7.85e-9);
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_NE(scene.notes[0].find("material steel from the library, structural steel S235JR"), std::string::npos);
    EXPECT_NE(scene.notes[0].find("E = 210 GPa, nu = 0.3 (EN 1993-1-1, 3.2.6), density = 7850 kg/m^3 (EN 1991-1-1, A.4)"),
              std::string::npos)
        << scene.notes[0];
    EXPECT_TRUE(scene.materials[static_cast<std::size_t>(scene.parts[0].material)].rigid);
}

TEST(MaterialLibrary, leaves_the_scenes_own_materials_alone) {
    const Scene scene = scene_of(mm_N, R"({"steel": {"E": 200000, "nu": 0.25}})", "steel");
    EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.parts[1].material)].E, 200000);
    EXPECT_TRUE(scene.notes.empty());
}

TEST(MaterialLibrary, says_what_it_misses) {
    EXPECT_NE(
        fault("{}", "{}", "steel").find("/parts/1/material: the scene defines no material 'steel', and the library's needs"),
        std::string::npos);
    EXPECT_NE(fault(mm_N, "{}", "aluminum alloy").find("there is no material 'aluminum alloy'"), std::string::npos);
    EXPECT_NE(fault(mm_N, "{}", "brasss").find("did you mean 'brass'?"), std::string::npos);
    EXPECT_THROW(material_from_library("unobtainium", {"mm", "N"}), InputError);
}

TEST(Stiffness, in_other_units_than_the_scenes_is_told) {
    const Scene pascals = scene_of(mm_N, R"({"m": {"E": 2.1e11, "nu": 0.3}})", "m");
    ASSERT_EQ(pascals.warnings.size(), 1u);
    EXPECT_EQ(
        pascals.warnings[0],
        "material m: E = 2.1e+11 is 2.1e+08 GPa in the scene's units (mm, N), and materials have 0.0001 to 1200 GPa: check "
        "E, or write it with its unit (\"210 GPa\")");
    EXPECT_EQ(scene_of(mm_N, R"({"m": {"E": 0.05, "nu": 0.3}})", "m").warnings.size(), 1u);
    EXPECT_TRUE(scene_of(mm_N, R"({"m": {"E": 0.1, "nu": 0.3}})", "m").warnings.empty());
    EXPECT_TRUE(scene_of(mm_N, R"({"m": {"E": 1.2e6, "nu": 0.3}})", "m").warnings.empty());
    EXPECT_EQ(scene_of(R"({"length": "m", "force": "N"})", R"({"m": {"E": 210, "nu": 0.3}})", "m").warnings.size(), 1u);
    EXPECT_TRUE(scene_of("{}", R"({"m": {"E": 1e20, "nu": 0.3}})", "m").warnings.empty());
}

}  // namespace abut::material_library_test
