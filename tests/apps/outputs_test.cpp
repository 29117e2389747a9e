// SPDX-License-Identifier: GPL-3.0-or-later
// What the program writes, against the schemas that describe it: no key that a schema lacks, none that is never written.
#include <gtest/gtest.h>

#include "tests/apps/command_line.hpp"
#include "tests/src/reference/schema_check.hpp"

namespace outputs_test {
namespace {

using namespace abut_tests;
using namespace schema_check;

using Strings = std::set<std::string>;

const std::string data = std::string(ABUT_SOURCE_DIR) + "/data/";

/// Two blocks, one on the other, with what a test adds.
std::string two_blocks(const std::string& supports, const std::string& more) {
    return R"({"abut": 1, "$schema": "scene.schema.json", "materials": {"m": {"E": 1000, "nu": 0.3}},
      "parts": [{"name": "low", "material": "m", "geometry": {"rectangle": {"min": [0, 0], "max": [4, 2]}}},
                {"name": "high", "material": "m", "geometry": {"rectangle": {"min": [1, 2], "max": [3, 4]}}}],
      "loads": [{"on": "high/top", "pressure": 1}], "supports": )" +
           supports + more + "}";
}

class Outputs : public CommandLine {
protected:
    Json written(const std::string& file) const { return Json::parse(read(folder_ / file)); }
};

TEST_F(Outputs, ResultsHaveTheKeysOfTheirSchema) {
    const Json schema = json_of(schema_file("result"));
    SchemaCheck check(schema);
    write("bonded.json", two_blocks(R"([{"on": "low/bottom", "spring": {"normal": 1000, "tangential": 1000}}])",
                                    R"(, "contacts": {"pairs": [{"between": ["low/top", "high/bottom"], "kind": "bonded"}]},
                                        "accuracy": {"cell_size": 1}, "output": {"probes": [{"part": "low", "at": [2, 1]}]})"));
    write("structure.json", two_blocks(R"([{"on": "low/bottom", "fix": ["x", "y"]}])",
                                       R"(, "accuracy": {"level": "draft", "dirichlet": "solution_structure"})"));
    write("loose.json",
          two_blocks(R"([{"on": "low/bottom", "fix": ["y"]}])", R"(, "accuracy": {"target": 1e-4, "cell_size": 1})"));
    write("moving.json", two_blocks(R"([{"on": "low/left", "fix": ["x"]}])", ""));
    write("written.json", two_blocks(R"([{"on": "low/bottom", "fix": ["x", "y"]}, {"on": "high/left", "fix": ["x"]}])",
                                     R"(, "accuracy": {"method": "dissertation", "cell_size": 0.5})"));
    for (const std::string& scene :
         {std::string("written.json"), data + "scenes/pin_bracket.json", data + "scenes/case_b.json",
          data + "scenes/clevis.json", data + "scenes/bolted_flange.json", data + "verification/shrink_fit_rz.json",
          data + "verification/heated_pin.json", data + "verification/lever_on_stop.json", std::string("bonded.json"),
          std::string("structure.json"), std::string("loose.json"), std::string("moving.json")}) {
        abut({"analyze", scene, "-o", "out", "--quiet"});
        EXPECT_EQ(in_lines(check.faults(written("out/result.json"))), "") << scene;
        fs::remove_all(folder_ / "out");
    }
    abut({"analyze", data + "scenes/clamped_strip.json", "-o", "out", "--quiet"});
    EXPECT_EQ(in_lines(check.faults(written("out/case_2/result.json"))), "") << "steps, friction";
    EXPECT_EQ(in_lines(check.never_met()), "") << "described, but not written by any of these";
    EXPECT_EQ(
        in_lines(check.faults(Json::parse(abut({"analyze", "--plan", "--json", "bonded.json"}).output), "/properties/effects")),
        "");
}

TEST_F(Outputs, ContactsInspectionsAndVerificationsDoSo) {
    const Json contacts = json_of(schema_file("contacts")), inspect = json_of(schema_file("inspect")),
               verify = json_of(schema_file("verify"));
    SchemaCheck of_contacts(contacts), of_inspect(inspect), of_verify(verify);
    for (const char* scene : {"scenes/pin_bracket.json", "scenes/clevis.json"}) {
        abut({"contacts", data + scene});
        EXPECT_EQ(in_lines(of_contacts.faults(written("out/contacts.json"))), "") << scene;
    }
    EXPECT_EQ(in_lines(of_contacts.never_met()), "");
    write("open.dxf",
          "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1\n21\n0\n0\nTEXT\n8\nA\n1\nhello\n0\nENDSEC\n0\nEOF\n");
    for (const std::string& file :
         {data + "sketches/pin_bracket_r14.dxf", data + "scenes/clevis.json", std::string("open.dxf")})
        EXPECT_EQ(in_lines(of_inspect.faults(Json::parse(abut({"inspect", "--json", file}).output))), "") << file;
    EXPECT_EQ(in_lines(of_verify.faults(Json::parse(abut({"verify", "--json", "E2-quadratic"}).output))), "");
    EXPECT_EQ(in_lines(of_verify.never_met()), "");
}

/// It is read, not written: what the reader names as known are the keys of the schema.
TEST_F(Outputs, ExpectedPairsHaveTheKeysOfTheirSchema) {
    write("expected.json", R"({"no_such_key": 1, "pairs": [{"parts": ["bracket", "pin"], "no_such_key": 1}]})");
    const Outcome run = abut({"contacts", data + "scenes/pin_bracket.json", "--expect", "expected.json"});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(any_line_has(run.errors, {"expected.json", "known here: abut, pairs"})) << joined(run.errors);
    EXPECT_TRUE(any_line_has(run.errors, {"expected.json", "known here: parts, status, interface"})) << joined(run.errors);
    Strings keys;
    for_each_object(json_of(schema_file("expect")), "", [&](const std::string&, const Json& object) {
        for (const auto& [key, value] : object["properties"].items()) keys.insert(key);
    });
    EXPECT_EQ(keys, (Strings{"abut", "pairs", "parts", "status", "interface"}));
}

TEST_F(Outputs, BatchesAndStudiesDoSo) {
    const Json batch = json_of(schema_file("batch")), study = json_of(schema_file("study"));
    SchemaCheck of_batch(batch), of_study(study);
    write("expected.csv", "file,part_1,part_2\nhalf,bracket,pin\n");
    abut({"batch", data + "batch/loads.csv", "--template", data + "batch/pin_pushed_down.json", "--quiet"});
    abut({"batch", data + "batch/loads.csv", "--template", data + "batch/pin_pushed_down.json", "--only", "contacts",
          "--expect", "expected.csv", "-o", "compared", "--quiet"});
    for (const char* folder : {"out", "compared"}) {
        EXPECT_EQ(in_lines(of_batch.faults(written(std::string(folder) + "/jobs/half/job.json"), "/properties/job")), "");
        EXPECT_EQ(in_lines(of_batch.faults(written(std::string(folder) + "/summary.json"), "/properties/summary")), "");
        EXPECT_EQ(in_lines(of_batch.faults(written(std::string(folder) + "/batch.json"), "/properties/batch")), "");
    }
    abut({"study", data + "scenes/case_b.json", "--budget", "2", "--quiet", "-o", "study"});
    EXPECT_EQ(in_lines(of_study.faults(written("study/study.json"))), "");
}

/// The names of the header's columns.
std::vector<std::string> columns(const std::string& text) {
    std::vector<std::string> names(1);
    bool quoted = false;
    for (const char c : text.substr(0, text.find('\n'))) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) names.emplace_back();
        if (c != '"' && (c != ',' || quoted)) names.back() += c;
    }
    return names;
}

/// Those of a table in csv.schema.json.
std::vector<std::string> described(const std::string& file) {
    std::vector<std::string> names;
    const Json schema = json_of(schema_file("csv"));
    for (const auto& [key, value] : schema["properties"][file]["properties"].items()) names.push_back(key);
    return names;
}

TEST_F(Outputs, TablesHaveTheColumnsOfTheirSchema) {
    abut({"batch", data + "batch/loads.csv", "--template", data + "batch/pin_pushed_down.json", "--quiet"});
    std::vector<std::string> frictionless = described("contact");
    std::erase_if(frictionless, [](const std::string& name) { return name == "shear" || name == "slip" || name == "state"; });
    EXPECT_EQ(columns(read(folder_ / "out/jobs/half/contact_1.csv")), frictionless);
    abut({"analyze", data + "scenes/clamped_strip.json", "-o", "strip", "--quiet"});
    EXPECT_EQ(columns(read(folder_ / "strip/case_2/contact_1.csv")), described("contact"));
    std::vector<std::string> summary = described("summary");
    std::erase_if(summary,
                  [](const std::string& name) { return name.starts_with("expected") || name.starts_with("detected"); });
    summary.insert(summary.end() - 1, "P");
    EXPECT_EQ(columns(read(folder_ / "out/summary.csv")), summary);

    abut({"analyze", data + "scenes/pin_bracket_cases.json", "--accuracy", "draft", "--quiet", "-o", "cases"});
    EXPECT_EQ(columns(read(folder_ / "cases/envelope.csv")), described("envelope"));

    abut({"study", data + "scenes/case_b.json", "--budget", "2", "--quiet", "-o", "study"});
    std::vector<std::string> study = columns(read(folder_ / "study/study.csv"));
    EXPECT_GT(std::erase_if(study, [](const std::string& name) { return name.starts_with("error of "); }), 0U);
    EXPECT_EQ(study, described("study"));
}

TEST_F(Outputs, TheCheckNoticesKeysThatAreUnknownOrMissingAndOtherTypes) {
    write("scene.json", SceneText{}.text());
    abut({"analyze", "scene.json", "--quiet"});
    const Json schema = json_of(schema_file("result")), result = written("out/result.json");
    const auto faults = [&](const std::function<void(Json&)>& change) {
        Json changed = result;
        change(changed);
        return SchemaCheck(schema).faults(changed).size();
    };
    EXPECT_EQ(faults([](Json&) {}), 0U);
    EXPECT_EQ(faults([](Json& j) { j["new_key"] = 1; }), 1U);
    EXPECT_EQ(faults([](Json& j) { j["parts"][0]["cells"]["new_key"] = 1; }), 1U);
    EXPECT_EQ(faults([](Json& j) { j["mobility"]["under_load"]["parts"][0]["new_key"] = 1; }), 1U);
    EXPECT_EQ(faults([](Json& j) { j["parts"][0].erase("area"); }), 1U);
    EXPECT_EQ(faults([](Json& j) { j["unknowns"] = "many"; }), 1U);
    EXPECT_EQ(faults([](Json& j) { j["verdict"] = "perfect"; }), 1U);
    EXPECT_FALSE(SchemaCheck(schema).never_met().empty());
}

}  // namespace
}  // namespace outputs_test
