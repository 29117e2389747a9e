// SPDX-License-Identifier: GPL-3.0-or-later
// The program's commands and options from outside: exit status, files, and what it says about wrong usage.
#include "tests/apps/command_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/io/build_id.hpp"

namespace {

using namespace abut_tests;

TEST_F(CommandLine, TellsItsVersionAndHelp) {
    const Outcome version = abut({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.output, "abut " + abut::program_build() + "\n");

    const Outcome help = abut({"--help"});
    EXPECT_EQ(help.status, 0);
    expect_words(help.output, {"analyze", "contacts", "inspect", "study", "--help", "--version"});
    EXPECT_TRUE(help.errors.empty());
}

TEST_F(CommandLine, VersionIsTheProjects) {
    const std::string project = read(fs::path(ABUT_SOURCE_DIR) / "CMakeLists.txt");
    const std::string build = abut::program_build();
    EXPECT_NE(project.find("project(abut VERSION " + build.substr(0, build.find('+')) + " "), std::string::npos);
}

TEST_F(CommandLine, HelpOfACommandListsItsOptionsWhateverElseIsGiven) {
    const Outcome analyze = abut({"analyze", "missing.json", "--wrong", "--help"});
    EXPECT_EQ(analyze.status, 0);
    expect_words(analyze.output, {"SCENE", "-o DIR", "--accuracy A", "--plan", "--json", "--quiet"});
    expect_words(abut({"contacts", "-h"}).output,
                 {"FILE", "-o DIR", "--distance", "--expect", "--units", "--tolerance", "--parts-by"});
    expect_words(abut({"inspect", "-h"}).output, {"FILE", "-o DIR", "--json", "--units", "--tolerance", "--parts-by"});
    expect_words(abut({"study", "-h"}).output, {"SCENE", "-o DIR", "--budget TIME", "--threads N", "--json", "--quiet"});
}

TEST_F(CommandLine, RefusesMissingAndUnknownCommands) {
    Outcome run = abut({});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"no command", "abut --help"});

    run = abut({"analyse", "a.json"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"'analyse'", "did you mean 'analyze'"});
}

TEST_F(CommandLine, SuggestsTheNearestOption) {
    const Outcome run = abut({"analyze", "a.json", "--acuracy", "draft"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"analyze", "--acuracy", "did you mean '--accuracy'"});
}

TEST_F(CommandLine, CollectsAllThatIsWrongWithTheWords) {
    const Outcome run = abut({"analyze", "--json=1", "--quiet", "--quiet", "-o"});
    expect_refused(run, 4);
    EXPECT_TRUE(any_line_has(run.errors, {"--json", "no value"}));
    EXPECT_TRUE(any_line_has(run.errors, {"--quiet", "twice"}));
    EXPECT_TRUE(any_line_has(run.errors, {"-o", "needs a value", "-o DIR"}));
    EXPECT_TRUE(any_line_has(run.errors, {"no SCENE"}));
}

TEST_F(CommandLine, RefusesWrongValuesOfOptions) {
    write("scene.json", SceneText{}.text());
    expect_words(joined(abut({"analyze", "scene.json", "--accuracy", "rough"}).errors),
                 {"--accuracy", "'rough'", "draft, standard, fine"});
    for (const char* error : {"0", "-0.01", "1e-6", "0.6", "1%", "0.01x", "nan"})
        expect_words(joined(abut({"analyze", "scene.json", "--accuracy", error}).errors), {"--accuracy", "1e-05", "0.5"});
    expect_refused(abut({"contacts", "scene.json", "--distance", "-1"}), 1);
    expect_refused(abut({"contacts", "scene.json", "--distance", "1mm"}), 1);
    expect_refused(abut({"contacts", "scene.json", "--units", "mm"}), 1);
    write("empty.dxf", "");
    expect_refused(abut({"inspect", "empty.dxf", "--units", "parsec"}), 1);
    expect_refused(abut({"inspect", "empty.dxf", "--parts-by", "block"}), 1);
}

TEST_F(CommandLine, RefusesFilesThatAreNotThereOrOfAnotherKind) {
    for (const char* command : {"analyze", "contacts", "inspect"}) {
        const Outcome run = abut({command, "missing.json"});
        expect_refused(run, 1);
        expect_words(joined(run.errors), {"missing.json"});
    }
    write("part.iges", "S      1");
    const Outcome run = abut({"contacts", "part.iges"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"part.iges", ".json", ".dxf", ".step"});
    write("part.step", "ISO-10303-21;");
    expect_refused(abut({"contacts", "part.step"}), 1);
    write("empty.dxf", "");
    expect_refused(abut({"contacts", "empty.dxf"}), 1);
    const Outcome drawing = abut({"analyze", "empty.dxf"});
    expect_refused(drawing, 1);
    expect_words(joined(drawing.errors), {"empty.dxf", "not a scene", "abut init FILE > scene.json", "abut inspect FILE"});
}

TEST_F(CommandLine, RefusesAnOutputFolderThatIsAFile) {
    write("scene.json", SceneText{}.text());
    write("taken", "");
    const Outcome run = abut({"analyze", "scene.json", "-o", "taken"});
    expect_refused(run, 1);
    expect_words(joined(run.errors), {"taken", "-o"});
    EXPECT_EQ(read(folder_ / "taken"), "");
}

TEST_F(CommandLine, AnalyzesASceneAndWritesItsFiles) {
    write("scene.json", SceneText{}.text());
    const Outcome run = abut({"analyze", "scene.json", "-o", "results/here"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    EXPECT_TRUE(run.errors.empty()) << joined(run.errors);  // no progress where there is no terminal
    expect_words(run.output, {"results/here/report.html"});
    expect_words(read(folder_ / "results/here/result.json"), {"\"status\": \"ok\"", "\"import\"", "\"output\"", "\"total\""});
    EXPECT_TRUE(fs::exists(folder_ / "results/here/report.html"));
}

TEST_F(CommandLine, QuietPrintsNothingAndJsonTheResult) {
    write("scene.json", SceneText{}.text());
    const Outcome quiet = abut({"analyze", "scene.json", "--quiet"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.output + joined(quiet.errors), "");
    EXPECT_TRUE(fs::exists(folder_ / "out/result.json"));  // the default folder

    const Outcome json = abut({"analyze", "scene.json", "--json"});
    EXPECT_EQ(json.output, read(folder_ / "out/result.json"));
}

TEST_F(CommandLine, StrictTakesReservationsForAFailure) {
    SceneText scene;
    scene.supports = R"([{"on": "block/bottom", "symmetry": true}, {"on": "block/left", "symmetry": true}])";
    write("reached.json", scene.text());
    scene.material = R"({"E": 210000, "nu": 0.3, "yield": 0.4})";
    write("but.json", scene.text());
    scene.supports = R"([{"on": "block/bottom", "fix": ["x"]}])";
    write("failed.json", scene.text());
    for (const auto& [file, verdict, status, strict] :
         {std::tuple("reached", "reached", 0, 0), {"but", "solved_but", 0, 1}, {"failed", "failed", 1, 1}}) {
        const std::string name = std::string(file) + ".json";
        const Outcome run = abut({"analyze", name});
        EXPECT_EQ(run.status, status) << name << joined(run.errors);
        EXPECT_EQ(run.errors.size(), static_cast<std::size_t>(status)) << joined(run.errors);
        expect_words(read(folder_ / "out/result.json"), {std::string("\"verdict\": \"") + verdict + "\""});
        const Outcome strictly = abut({"analyze", name, "--strict", "--quiet"});
        EXPECT_EQ(strictly.status, strict) << name;
        EXPECT_EQ(strictly.errors.size(), static_cast<std::size_t>(strict)) << joined(strictly.errors);
    }
    EXPECT_TRUE(any_line_has(lines_of(abut({"analyze", "reached.json"}).output), {"Solved, accuracy reached"}));
    const Outcome but = abut({"analyze", "but.json", "--strict"});
    EXPECT_TRUE(any_line_has(lines_of(but.output), {"Solved, but: block at 2.5 times its yield"})) << but.output;
    EXPECT_EQ(but.errors, (std::vector<std::string>{"abut: but.json: solved, but: block at 2.5 times its yield"}));
}

TEST_F(CommandLine, AccuracyIsALevelOrAnError) {
    write("scene.json", SceneText{}.text());
    for (const auto& [accuracy, target] : {std::pair{"draft", "0.05"}, {"0.003", "0.003"}}) {
        const Outcome run = abut({"analyze", "scene.json", "--accuracy", accuracy});
        EXPECT_EQ(run.status, 0) << joined(run.errors);
        expect_words(read(folder_ / "out/result.json"), {"\"accuracy\"", std::string("\"target\": ") + target, "\"passes\""});
    }
}

TEST_F(CommandLine, PlanComputesAndWritesNothing) {
    write("scene.json", SceneText{}.text());
    const Outcome run = abut({"analyze", "scene.json", "--plan"});
    EXPECT_EQ(run.status, 0) << joined(run.errors);
    expect_words(run.output, {" on ", " off "});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(CommandLine, RemovesContactFilesOfAnEarlierRun) {
    write("scene.json", SceneText{}.text());
    fs::create_directory(folder_ / "out");
    for (const char* name : {"out/contact_1.csv", "out/contact_12.csv", "out/contact_notes.csv", "out/contact_notes.svg"})
        write(name, "old");
    EXPECT_EQ(abut({"analyze", "scene.json"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/contact_12.csv"));
    EXPECT_TRUE(fs::exists(folder_ / "out/contact_notes.svg"));
    EXPECT_FALSE(fs::exists(folder_ / "out/contact_1.csv"));
    EXPECT_TRUE(fs::exists(folder_ / "out/contact_notes.csv"));
}

/// Whatever is written of the next result, that of the one before does not stay beside it.
TEST_F(CommandLine, RemovesTheResultOfAnEarlierRun) {
    write("scene.json", SceneText{}.text());
    EXPECT_EQ(abut({"analyze", "scene.json"}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / "out/result.json"));
    std::string only_tables = SceneText{}.text();
    only_tables.insert(only_tables.rfind('}'), R"(, "output": {"formats": ["csv"]})");
    write("scene.json", only_tables);
    EXPECT_EQ(abut({"analyze", "scene.json"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/result.json"));
    EXPECT_FALSE(fs::exists(folder_ / "out/report.html"));
}

const std::string sketch = std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf";

TEST_F(CommandLine, ContactsListsTheContactsOfADrawingAndWritesThem) {
    const Outcome run = abut({"contacts", sketch, "-o", "found"});
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(run.errors.empty()) << joined(run.errors);
    expect_words(run.output, {"bracket", "pin", "base"});
    expect_words(read(folder_ / "found/contacts.json"), {"\"pairs\"", "\"near_misses\"", "bracket/hA14"});
    expect_words(read(folder_ / "found/contacts.svg"), {"<svg"});
    expect_words(read(folder_ / "found/cells.svg"), {"<svg", "bracket - pin: case a"});
}

TEST_F(CommandLine, ContactsWithoutAPairLeavesNoPictureOfCells) {
    write("scene.json", SceneText{}.text());  // one part
    fs::create_directory(folder_ / "found");
    write("found/cells.svg", "old");
    EXPECT_EQ(abut({"contacts", "scene.json", "-o", "found"}).status, 0);
    EXPECT_TRUE(fs::exists(folder_ / "found/contacts.svg"));
    EXPECT_FALSE(fs::exists(folder_ / "found/cells.svg"));
}

TEST_F(CommandLine, ContactsComparesWithAnExpectation) {
    write("same.json", R"({"pairs": [["bracket", "pin"], ["base", "bracket"]]})");
    const Outcome same = abut({"contacts", sketch, "--expect", "same.json"});
    EXPECT_EQ(same.status, 0) << joined(same.errors);

    write("other.json", R"({"pairs": [["bracket", "pin"], ["base", "pin"]]})");
    const Outcome other = abut({"contacts", sketch, "--expect", "other.json"});
    EXPECT_EQ(other.status, 1);
    EXPECT_EQ(other.output, same.output);
    EXPECT_EQ(other.errors.size(), 2U) << joined(other.errors);  // one pair is missing, one was not expected
    for (const std::string& line : other.errors) expect_words(line, {"abut: other.json: ", "base"});

    const Outcome unreadable = abut({"contacts", sketch, "--expect", "missing.json"});
    EXPECT_EQ(unreadable.status, 2);
    expect_words(joined(unreadable.errors), {"missing.json"});
}

TEST_F(CommandLine, InspectPrintsATableOrJsonAndDrawsAPicture) {
    const Outcome table = abut({"inspect", sketch});
    EXPECT_EQ(table.status, 0) << joined(table.errors);
    expect_words(table.output, {"bracket", "hA14", "LINE"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));

    const Outcome json = abut({"inspect", sketch, "--json", "-o", "picture"});
    EXPECT_EQ(json.status, 0) << joined(json.errors);
    expect_words(json.output.substr(0, 1), {"{"});
    expect_words(json.output, {"\"parts\"", "\"problems\""});
    expect_words(read(folder_ / "picture/inspect.svg"), {"<svg"});
}

/// Two lines that meet in one point and enclose nothing.
TEST_F(CommandLine, AnOpenDrawingIsShownByInspectAndRefusedByContacts) {
    const auto line = [](const std::string& ends) { return "0\nLINE\n8\nPLATE\n" + ends; };
    write("open.dxf", "0\nSECTION\n2\nENTITIES\n" + line("10\n0\n20\n0\n11\n10\n21\n0\n") +
                          line("10\n10\n20\n0\n11\n10\n21\n5\n") + "0\nENDSEC\n0\nEOF\n");
    const Outcome shown = abut({"inspect", "open.dxf"});
    EXPECT_EQ(shown.status, 2);
    expect_words(shown.output, {"LINE"});
    ASSERT_FALSE(shown.errors.empty());
    for (const std::string& error : shown.errors) expect_words(error, {"abut: open.dxf:", "; "});

    const Outcome refused = abut({"contacts", "open.dxf"});
    expect_refused(refused, shown.errors.size());
    EXPECT_EQ(refused.errors, shown.errors);
}

}  // namespace
