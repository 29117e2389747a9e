// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with a unit: conversion into the scene's units, and every way to get a unit wrong.
#include "src/scene/unit.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "geometry/brep/input_error.hpp"
#include "geometry/sketch/sketch.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::unit_test {

namespace {

const SceneUnits mm_N{"mm", "N"}, m_N{"m", "N"}, in_lbf{"in", "lbf"};

constexpr const char* block = R"("geometry": {"rectangle": {"min": [0, 0], "max": ["20 mm", "1 cm"]}})";

/// A scene of one block; more: further keys of the scene, each with a comma behind it.
std::string scene_text(const std::string& more, const std::string& E = "\"210 GPa\"") {
    return R"({"abut": 1, "units": {"length": "mm", "force": "N"}, )" + more + R"("materials": {"steel": {"E": )" + E +
           R"(, "nu": 0.3, "density": "7850 kg/m^3", "expansion": "1.2e-5 1/K", "yield": "0.25 GPa"}},
        "parts": [{"name": "block", "material": "steel", "thickness": "0.5 cm", )" +
           block + "}]}";
}

std::string fault(const std::string& text) {
    try {
        read_scene_text(text, "scene.json");
    } catch (const InputError& error) { return error.what(); }
    return "no error";
}

void expect_fault(const std::string& text, const std::string& part) {
    const std::string found = fault(text);
    EXPECT_NE(found.find(part), std::string::npos) << found;
}

}  // namespace

TEST(Unit, converts_into_the_units_of_the_scene) {
    EXPECT_EQ(unit_factor("mm", dimension::length, mm_N), 1);
    EXPECT_EQ(unit_factor("cm", dimension::length, mm_N), 10);
    EXPECT_EQ(unit_factor("mm", dimension::length, m_N), 1e-3);
    EXPECT_EQ(unit_factor("kN", dimension::force, mm_N), 1000);
    EXPECT_EQ(unit_factor("GPa", dimension::stress, mm_N), 1000);
    EXPECT_EQ(unit_factor("N/mm^2", dimension::stress, m_N), 1e6);
    EXPECT_EQ(unit_factor("psi", dimension::stress, in_lbf), 1);
    EXPECT_DOUBLE_EQ(unit_factor("psi", dimension::stress, mm_N), 6894.757293168361e-6);  // NIST SP 811, B.9
    EXPECT_EQ(unit_factor("N/mm^3", dimension::body_force, m_N), 1e9);
    EXPECT_EQ(unit_factor("m/s^2", dimension::acceleration, mm_N), 1000);
    EXPECT_EQ(unit_factor("1/K", dimension::expansion, mm_N), 1);
    EXPECT_DOUBLE_EQ(unit_factor("rad", dimension::angle, mm_N), 180 / std::numbers::pi);
    EXPECT_EQ(unit_factor("°", dimension::angle, mm_N), 1);
    EXPECT_DOUBLE_EQ(unit_factor("rpm", dimension::angular_speed, mm_N), std::numbers::pi / 30);
}

// The lengths that drawings may state.
TEST(Unit, knows_every_length_unit_of_drawings) {
    for (const char* name : {"nm", "um", "mm", "cm", "dm", "m", "dam", "hm", "km", "uin", "mil", "in", "ft", "yd", "mi",
                             "in_us", "ft_us", "yd_us", "mi_us"})
        EXPECT_DOUBLE_EQ(unit_factor(name, dimension::length, mm_N), geometry::unit_factor(name, "mm")) << name;
}

// A table of abut batch gives numbers in the scene's units; what the parameter is stays the template's to say.
TEST(Unit, of_a_parameter_stays_when_its_value_is_replaced) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("scene.json", scene_text(R"("parameters": {"F": "5 N"}, "thickness": "F",)"));
    for (const std::map<std::string, double>& given : {std::map<std::string, double>{}, {{"F", 5.0}}}) {
        try {
            read_scene(scene, given);
            ADD_FAILURE() << "a force for a thickness";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("'F' is a force"), std::string::npos) << error.what();
        }
    }
}

// Mass is force time^2 per length: t with mm and N, kg with m and N, 386.09 lb with in and lbf.
TEST(Unit, converts_masses_by_forces) {
    EXPECT_EQ(unit_factor("kg/m^3", dimension::density, mm_N), 1e-12);
    EXPECT_EQ(unit_factor("g/cm^3", dimension::density, mm_N), 1e-9);
    EXPECT_EQ(unit_factor("t/mm^3", dimension::density, mm_N), 1);
    EXPECT_EQ(unit_factor("N*s^2/mm^4", dimension::density, mm_N), 1);
    EXPECT_EQ(unit_factor("N s^2/mm^4", dimension::density, mm_N), 1);
    EXPECT_EQ(unit_factor("kg/m^3", dimension::density, m_N), 1);
    EXPECT_DOUBLE_EQ(unit_factor("lb/in^3", dimension::density, in_lbf), 0.0254 / 9.80665);
}

TEST(Unit, stands_behind_numbers_of_scenes) {
    const Scene scene = read_scene_text(scene_text(R"json("parameters": {"p": "2 bar", "q": "3*p"},
        "supports": [{"part": "block", "rigid": {"translation": ["1 um", null], "rotation": "0.1 rad"}}],
        "loads": [{"on": "block/top", "pressure": "q*(1 - x/20)"}, {"on": "block/top", "pressure": "(1 + x) MPa"},
                  {"on": "block/top", "force": ["-20 kN", 0]}, {"gravity": [0, "-9.81 m/s^2"]},
                  {"part": "block", "spin": {"about": ["1 cm", 0], "omega": "3000 rpm"}}],
        )json"),
                                        "scene.json");
    const Material& steel = scene.materials[0];
    EXPECT_EQ(steel.E, 210000);
    EXPECT_DOUBLE_EQ(steel.density, 7.85e-9);
    EXPECT_EQ(steel.expansion, 1.2e-5);
    EXPECT_EQ(steel.yield, 250);
    EXPECT_EQ(scene.parts[0].thickness, 5);
    EXPECT_EQ(area(scene.parts[0].part), 200);
    EXPECT_DOUBLE_EQ(*scene.supports[0].rigid_x, 1e-3);
    EXPECT_DOUBLE_EQ(*scene.supports[0].rigid_rotation, 0.1);
    EXPECT_DOUBLE_EQ(scene.loads[0].value[0](10, 0), 0.3);
    EXPECT_DOUBLE_EQ(scene.loads[1].value[0](2, 0), 3);
    EXPECT_EQ(scene.loads[2].value[0].constant(), -20000);
    EXPECT_EQ(scene.loads[3].value[1].constant(), -9810);
    EXPECT_EQ(scene.loads[4].about.x(), 10);
    EXPECT_DOUBLE_EQ(scene.loads[4].omega, 100 * std::numbers::pi);
}

TEST(Unit, says_what_is_wrong_where_it_stands) {
    expect_fault(scene_text("", "\"210 GPaa\""),
                 "/materials/steel/E: unknown unit 'GPaa'; did you mean 'GPa'? a product is written 2*x");
    expect_fault(scene_text("", "\"210 kN\""), "'kN' is the unit of a force (N, kN, lbf); what is needed here is a stress");
    expect_fault(scene_text("", "\"210 N/mm^2 + 1\""), "'N/mm^2 + 1' is no unit");
    expect_fault(scene_text("", "\"210 N/\""), "'N/' is no unit");
    expect_fault(scene_text("", "\"210 1/2\""), "'1/2' is no unit");
    expect_fault(scene_text("\"parameters\": {\"t\": 1}, ", "\"210 t\""), "expected an operator, found 't'");
    expect_fault(scene_text("\"parameters\": {\"e\": \"1 MPa\", \"f\": \"2*e\"}, ", "\"f GPa\""),
                 "ends in a unit, and so does its parameter 'f'");
    expect_fault(scene_text("\"parameters\": {\"e\": \"1 mm\"}, ", "\"e\""), "the parameter 'e' is a length");
    expect_fault(scene_text("\"parameters\": {\"e\": \"1 mm\"}, ", "\"-e\""), "the parameter 'e' is a length");
    expect_fault(scene_text("\"accuracy\": {\"target\": \"0.01 mm\"}, "), "what is needed here is a plain number");
    expect_fault(scene_text("", "\"1e300 GPa*GPa*GPa\""), "is the unit of some other quantity");
    std::string bare = scene_text("");
    bare.replace(bare.find(R"("units")"), std::string(R"("units": {"length": "mm", "force": "N"},)").size(), "");
    expect_fault(bare, "'GPa' needs to know which unit of length the scene's numbers are in; give the scene its \"units\"");
    expect_fault(R"({"abut": 1, "units": {"length": "furlong", "force": "N"}, "thickness": "1 mm", "parts": []})",
                 "'mm' cannot be converted into the scene's unit of length, 'furlong'");
}

// Angles, times and temperatures are the same in all scenes.
TEST(Unit, needs_no_units_of_the_scene_for_angles_and_temperatures) {
    EXPECT_EQ(unit_factor("deg", dimension::angle, {}), 1);
    EXPECT_EQ(unit_factor("K", dimension::temperature, {}), 1);
    EXPECT_THROW(unit_factor("mm", dimension::length, {}), InputError);
}

}  // namespace abut::unit_test
