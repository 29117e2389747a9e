// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "src/plan/model_facts_of.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::model_facts_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ModelFactsOf, SayWhatTheSceneGives) {
    const std::string file = std::string(ABUT_SOURCE_DIR) + "/data/scenes/pin_bracket.json";
    const Scene scene = read_scene(file);
    const ModelFacts facts = model_facts(scene, model_sources(scene));
    ASSERT_EQ(facts.files.size(), 2u);  // the scene and its drawing
    EXPECT_EQ(facts.files[0].file, file);
    EXPECT_TRUE(facts.files[1].file.ends_with("pin_bracket_r14.dxf"));
    EXPECT_EQ(facts.files[0].hash.size(), 16u);
    EXPECT_NE(facts.files[0].hash, facts.files[1].hash);
    EXPECT_EQ(facts.analysis, "plane_stress");
    ASSERT_EQ(facts.parts.size(), 3u);
    for (const PartFacts& p : facts.parts) {
        EXPECT_EQ(p.thickness, 10);
        EXPECT_FALSE(p.default_thickness);
        EXPECT_EQ(p.material, p.name == "pin" ? "brass" : "steel");
    }
    ASSERT_EQ(facts.loads.size(), 1u);
    EXPECT_EQ(load_words(facts.loads[0]), "force (0, -20000) N");
    EXPECT_EQ(facts.loads[0].on, std::vector<std::string>{"pin"});
    ASSERT_EQ(facts.supports.size(), 3u);
    EXPECT_EQ(facts.supports[0].on, std::vector<std::string>{"base/hA16"});
    EXPECT_FALSE(facts.supports[0].at.empty());
}

TEST(ModelFactsOf, WriteLoadsInAsManyDigitsAsAPictureHasRoomFor) {
    const auto words = [](std::vector<double> value) {
        LoadFacts load;
        load.kind = "force";
        load.value = std::move(value);
        return load_words(load);
    };
    EXPECT_EQ(words({17.5423017, -57.37828}), "force (17.542, -57.378)");
    EXPECT_EQ(words({3.7e-15, 60}), "force (0, 60)");
    EXPECT_EQ(words({1234567}), "force 1234567");
    EXPECT_EQ(words({-150000.25, 0.0012345678}), "force (-150000, 0.0012346)");
    EXPECT_EQ(words({0, 0}), "force (0, 0)");
    EXPECT_EQ(words({99999.96}), "force 100000");
}

TEST(ModelFactsOf, TellThicknessesThatNobodyGave) {
    const auto defaults = [](const std::string& scene, const std::string& part) {
        const Scene read = read_scene_text(R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3}}, )" + scene +
                                               R"( "parts": [{"name": "p", )" + part +
                                               R"( "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}}],
                                               "supports": [{"on": "p/bottom", "fix": ["x", "y"]}],
                                               "loads": [{"on": "p/top", "pressure": "1 + x"}, {"part": "p", "moment": 2}, {"part": "p", "force": [-1, "-0*1"]}]})",
                                           "no_such_file.json");
        const ModelFacts facts = model_facts(read, model_sources(read));
        EXPECT_EQ(load_words(facts.loads[0]), "pressure that varies");
        EXPECT_EQ(load_words(facts.loads[1]), "moment 2");
        EXPECT_EQ(load_words(facts.loads[2]), "force (-1, 0)");
        EXPECT_TRUE(facts.files.empty());
        return facts.parts[0].default_thickness;
    };
    // without the file nobody knows whether a thickness of 1 was given
    EXPECT_TRUE(defaults("", ""));
    EXPECT_FALSE(defaults("\"thickness\": 2,", ""));
    EXPECT_FALSE(defaults("", "\"thickness\": 3,"));
}

TEST(ModelFacts, AreInResultJson) {
    ModelFacts model;
    model.analysis = "plane_strain";
    model.begun = "2026-01-31T12:00:00Z";
    model.loads = {
        {"pull", "force", {0, -1}, "N", {"pin"}}, {"", "pressure", {2}, "MPa", {"a/b"}}, {"", "traction", {}, "MPa", {"a/c"}}};
    const Json j = Json::parse(result_json(synthetic::bracket(), model));
    EXPECT_EQ(j["model"]["analysis"], "plane_strain");
    EXPECT_EQ(j["timing"]["begun"], "2026-01-31T12:00:00Z");
    EXPECT_EQ(j["model"]["loads"][0]["value"], Json::parse("[0.0, -1.0]"));
    EXPECT_EQ(j["model"]["loads"][1]["value"], 2.0);
    EXPECT_TRUE(j["model"]["loads"][2]["value"].is_null());
    EXPECT_FALSE(Json::parse(result_json(synthetic::bracket())).contains("model"));
}

}  // namespace
}  // namespace abut::model_facts_test
