// SPDX-License-Identifier: GPL-3.0-or-later
// One good scene, and what must be said about each way of spoiling it.
#include <gtest/gtest.h>

#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::bad_input_test {

namespace {

const std::string good = R"({ "abut": 1,
  "parameters": {"R": 1},
  "materials": {"steel": {"E": 1000, "nu": 0.3}},
  "parts": [
    {"name": "block", "material": "steel", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]}}},
    {"name": "disc", "material": "steel", "geometry": {"circle": {"center": [1, 2], "radius": "R"}}}
  ],
  "supports": [{"on": "block/bottom", "fix": ["x", "y"]}],
  "loads": [{"on": {"part": "disc", "facing": [0, 1], "within": 20}, "pressure": "1+x"}],
  "contacts": {"pairs": [{"between": ["block/top", "disc/circle"], "interference": 0.01}]},
  "accuracy": {"degree": 2, "grids": {"block": {"x": [0, 1, 2], "y": [0, 1], "angle": 0}}},
  "output": {"probes": [{"part": "disc", "at": [1, 2]}], "formats": ["json"]}
})";

/// The scene with the first `from` in it replaced.
std::string spoilt(const std::string& from, const std::string& to) {
    const std::size_t at = good.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return std::string(good).replace(at == std::string::npos ? 0 : at, from.size(), to);
}

std::vector<Problem> problems_of(const std::string& text) {
    const TemporaryFolder folder;
    try {
        read_scene(folder.write("s.json", text));
    } catch (const InputError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& p : problems) p.where = p.where.substr(std::min(p.where.size(), folder.path("").size()));
        return problems;
    }
    return {};
}

struct Case {
    std::string from, to;
    std::string problem;  ///< beginning of the one line that must be printed
};

void expect_one_problem(const Case& c) {
    const std::vector<Problem> problems = problems_of(spoilt(c.from, c.to));
    ASSERT_EQ(problems.size(), 1u) << c.to << "\n" << (problems.empty() ? "no problem" : InputError(problems).what());
    EXPECT_EQ(one_line(problems[0]).substr(0, c.problem.size()), c.problem) << c.to;
}

}  // namespace

TEST(BadInput, the_good_scene_is_good) {
    EXPECT_TRUE(problems_of(good).empty());
}

TEST(BadInput, misspelt_keys_and_words) {
    for (const Case& c : std::vector<Case>{
             {"\"loads\"", "\"laods\"", "s.json:9 /laods: unknown key 'laods'; did you mean 'loads'?"},
             {"\"radius\": \"R\"", "\"radius\": \"R\", \"centre\": 1",
              "s.json:6 /parts/1/geometry/circle/centre: unknown key 'centre'; did you mean 'center'?"},
             {"\"circle\":", "\"cirle\":", "s.json:6 /parts/1/geometry/cirle: unknown key 'cirle'; did you mean 'circle'?"},
             {"\"fix\"", "\"fixed\"", "s.json:8 /supports/0/fixed: unknown key 'fixed'; did you mean 'fix'?"},
             {"\"fix\": [\"x\", \"y\"]", "\"fix\": [\"x\", \"z\"]",
              "s.json:8 /supports/0/fix/1: expected one of \"x\", \"y\", found the text 'z'"},
             {"\"abut\": 1,", "\"abut\": 1, \"analysis\": \"planestrain\",",
              "s.json:1 /analysis: expected one of \"plane_stress\", \"plane_strain\", \"axisymmetric\", found the text "
              "'planestrain'; did you "
              "mean \"plane_strain\"?"},
             {"\"R\": 1", "\"R\": 1, \"R\": 2", "s.json:2 /parameters/R: the key 'R' is given twice"},
             {"\"name\": \"disc\"", "\"name\": \"di\\u0000sc\"", "s.json:6 /parts/1/name: this text holds a control character"},
         }) {
        expect_one_problem(c);
    }
}

TEST(BadInput, missing_keys) {
    for (const Case& c : std::vector<Case>{
             {"\"abut\": 1,", "", "s.json:1: the key 'abut' is missing"},
             {"\"abut\": 1,", "\"abut\": 2,", "s.json:1 /abut: this format version is not known"},
             {", \"radius\": \"R\"", "", "s.json:6 /parts/1/geometry/circle: the key 'radius' is missing"},
             {"\"material\": \"steel\", ", "", "s.json:5 /parts/0: the key 'material' is missing"},
             {", \"nu\": 0.3", "", "s.json:3 /materials/steel: the key 'nu' is missing"},
             {"\"on\": \"block/bottom\", ", "", "s.json:8 /supports/0: the key 'on' is missing"},
             {", \"fix\": [\"x\", \"y\"]", "",
              "s.json:8 /supports/0: nothing says what this is; give one of the keys fix, displacement"},
         }) {
        expect_one_problem(c);
    }
}

TEST(BadInput, numbers_out_of_range) {
    for (const Case& c : std::vector<Case>{
             {"\"E\": 1000", "\"E\": 0", "s.json:3 /materials/steel/E: 'E' must be greater than 0"},
             {"\"nu\": 0.3", "\"nu\": 0.51", "s.json:3 /materials/steel/nu: Poisson's ratio"},
             {"\"nu\": 0.3", "\"nu\": -1", "s.json:3 /materials/steel/nu: Poisson's ratio"},
             {"\"nu\": 0.3", "\"nu\": 0.3, \"density\": -1",
              "s.json:3 /materials/steel/density: 'density' must not be negative"},
             {"\"radius\": \"R\"", "\"radius\": \"-R\"",
              "s.json:6 /parts/1/geometry/circle/radius: 'radius' must be greater than 0"},
             {"\"radius\": \"R\"", "\"radius\": \"1/(R-1)\"",
              "s.json:6 /parts/1/geometry/circle/radius: in the expression '1/(R-1)', column 2: the result is not"},
             {"\"radius\": \"R\"", "\"radius\": \"x\"",
              "s.json:6 /parts/1/geometry/circle/radius: in the expression 'x', column 1: 'x' may be used only"},
             {"\"max\": [2, 1]", "\"max\": [2, 0]", "s.json:5 /parts/0/geometry/rectangle: the rectangle has no area"},
             {"\"max\": [2, 1]", "\"max\": [2, 1, 0]",
              "s.json:5 /parts/0/geometry/rectangle/max: expected two numbers [x, y], found a list of 3"},
             {"\"within\": 20", "\"within\": 200", "s.json:9 /loads/0/on/within: 'within' must lie between 0 and 180"},
             {"\"facing\": [0, 1]", "\"facing\": [0, 0]", "s.json:9 /loads/0/on/facing: a direction cannot be [0, 0]"},
             {"\"degree\": 2", "\"degree\": 7", "s.json:11 /accuracy/degree: expected a whole number from 1 to 6"},
             {"\"degree\": 2", "\"degree\": 1.5", "s.json:11 /accuracy/degree: expected a whole number from 1 to 6"},
             {"\"x\": [0, 1, 2]", "\"x\": [0, 2, 2]",
              "s.json:11 /accuracy/grids/block/x/2: the knots are not in ascending order"},
             {"\"x\": [0, 1, 2], \"y\": [0, 1]", "\"cells\": [0, 3]",
              "s.json:11 /accuracy/grids/block/cells/0: expected a whole number from 1 to"},
             {"\"y\": [0, 1], \"angle\"",
              "\"y\": [0, 1], \"refine\": [{\"from\": [0, 0], \"to\": [1, 1], \"levels\": 30}], \"angle\"",
              "s.json:11 /accuracy/grids/block/refine/0/levels: expected a whole number from 1 to 20"},
             {"\"y\": [0, 1], \"angle\"", "\"y\": [0, 1], \"refine\": [{\"from\": [0, 0]}], \"angle\"",
              "s.json:11 /accuracy/grids/block/refine/0: the key 'to' is missing"},
             {"\"y\": [0, 1]", "\"cells\": [2, 3]",
              "s.json:11 /accuracy/grids/block/cells: 'cells' cannot be combined with knots"},
             {"\"degree\": 2", "\"cell_size\": 0", "s.json:11 /accuracy/cell_size: 'cell_size' must be greater than 0"},
             {"\"abut\": 1,", "\"abut\": 1, \"thickness\": 0,", "s.json:1 /thickness: 'thickness' must be greater than 0"},
         }) {
        expect_one_problem(c);
    }
    const std::string incompressible = spoilt("\"nu\": 0.3", "\"nu\": 0.5");
    EXPECT_TRUE(problems_of(incompressible).empty());
    EXPECT_EQ(problems_of(std::string(incompressible).insert(1, "\"analysis\": \"plane_strain\",")).size(), 1u);
}

TEST(BadInput, names_of_nothing) {
    for (const Case& c : std::vector<Case>{
             {"\"material\": \"steel\"", "\"material\": \"stel\"",
              "s.json:5 /parts/0/material: there is no material 'stel'; did you mean 'steel'? known here: steel"},
             {"block/bottom", "block/botom",
              "s.json:8 /supports/0/on: no edge matches 'block/botom'; did you mean 'block/bottom'?"},
             {"block/bottom", "blok/bottom", "s.json:8 /supports/0/on: there is no part 'blok'; did you mean 'block'?"},
             {"disc/circle", "disc/hole", "s.json:10 /contacts/pairs/0/between/1: no edge matches 'disc/hole'"},
             {"{\"part\": \"disc\", \"facing\"", "{\"part\": \"disk\", \"facing\"",
              "s.json:9 /loads/0/on/part: there is no part 'disk'; did you mean 'disc'?"},
             {"{\"part\": \"disc\", \"at\"", "{\"part\": \"disk\", \"at\"",
              "s.json:12 /output/probes/0/part: there is no part 'disk'"},
             {"\"grids\": {\"block\"", "\"grids\": {\"bloc\"", "s.json:11 /accuracy/grids/bloc: there is no part 'bloc'"},
             {"\"name\": \"disc\"", "\"name\": \"block\"", "s.json:6 /parts/1: there are two parts with the name 'block'"},
         }) {
        const std::vector<Problem> problems = problems_of(spoilt(c.from, c.to));
        ASSERT_FALSE(problems.empty()) << c.to;
        EXPECT_EQ(one_line(problems[0]).substr(0, c.problem.size()), c.problem) << c.to;
    }
}

TEST(BadInput, part_names_and_parameters) {
    for (const char* name : {"a/b", "a#1", "a*"}) {
        const auto problems = problems_of(spoilt("\"name\": \"block\"", "\"name\": \"" + std::string(name) + "\""));
        ASSERT_EQ(problems.size(), 1u) << name;  // nothing is said about what refers to the part
        EXPECT_EQ(problems[0].where, "s.json:5 /parts/0/name");
    }
    expect_one_problem(
        {"\"R\": 1", "\"R\": \"Q\"", "s.json:2 /parameters/R: in the expression 'Q', column 1: unknown name 'Q'"});
    expect_one_problem(
        {"\"R\": 1", "\"R\": 1, \"pi\": 3", "s.json:2 /parameters/pi: 'pi' has a meaning in expressions already"});
    expect_one_problem(
        {"\"abut\": 1,", "\"abut\": 1, \"symmetry\": \"auto\",",
         "s.json:1 /symmetry: every part is solved as drawn: no half of a symmetric scene is solved alone any more"});
    expect_one_problem({"\"abut\": 1,", "\"abut\": 1, \"simmetry\": 1,", "s.json:1 /simmetry: unknown key 'simmetry'"});
    expect_one_problem({"\"R\": 1", "\"R\": 1, \"2a\": 3", "s.json:2 /parameters/2a: '2a' cannot name a parameter"});
}

TEST(BadInput, entries_that_do_not_fit_together) {
    for (const Case& c : std::vector<Case>{
             {"\"fix\": [", "\"roller\": true, \"fix\": [", "s.json:8 /supports/0/fix: 'fix' cannot be combined with 'roller'"},
             {"\"fix\": [\"x\", \"y\"]", "\"fix\": []", "s.json:8 /supports/0/fix: this list of \"x\" and \"y\" is empty"},
             {"\"fix\": [\"x\", \"y\"]", "\"symmetry\": false", "s.json:8 /supports/0/symmetry: 'symmetry' can only be true"},
             {"\"fix\": [\"x\", \"y\"]", "\"spring\": {\"normal\": -1}",
              "s.json:8 /supports/0/spring/normal: a spring's stiffness must not be negative"},
             {"\"fix\": [\"x\", \"y\"]", "\"spring\": {}", "s.json:8 /supports/0/spring: the spring has no stiffness"},
             {"\"fix\": [", "\"at\": [[0, 0]], \"fix\": [",
              "s.json:8 /supports/0/on: 'on' does not go with 'at'; name the 'part'"},
             {"\"fix\": [\"x\", \"y\"]", "\"displacement\": {}",
              "s.json:8 /supports/0/displacement: no component is prescribed"},
             {"\"fix\": [\"x\", \"y\"]", "\"rigid\": {\"rotation\": 0}",
              "s.json:8 /supports/0/on: 'on' does not go with 'rigid'; name the 'part'"},
             {"\"on\": \"block/bottom\", \"fix\": [\"x\", \"y\"]", "\"part\": \"block\", \"rigid\": {\"rotation\": null}",
              "s.json:8 /supports/0/rigid: this leaves the part free"},
             {"\"pressure\": \"1+x\"", "\"gravity\": [0, -1]", "s.json:9 /loads/0/on: 'on' does not go with 'gravity'"},
             {"\"pressure\": \"1+x\"", "\"force\": [\"x\", 0]", "s.json:9 /loads/0/force/0: in the expression 'x'"},
             {R"("on": {"part": "disc", "facing": [0, 1], "within": 20}, "pressure": "1+x")",
              R"("part": "disc", "at": [1, 2], "force": [0, -1])",
              "s.json:9 /loads/0/at: a force at a point of a part is not there yet"},
             {"\"degree\": 2", "\"target\": 2", "s.json:11 /accuracy/target: a relative error to aim at is from 1e-05 to 0.5"},
             {"\"degree\": 2", "\"target\": 1e-6",
              "s.json:11 /accuracy/target: a relative error to aim at is from 1e-05 to 0.5"},
             {"\"degree\": 2", "\"target\": -0.01",
              "s.json:11 /accuracy/target: a relative error to aim at is from 1e-05 to 0.5"},
             {"\"degree\": 2", "\"budget\": \"2 apples\"",
              "s.json:11 /accuracy/budget: '2 apples' is no bound on time or memory"},
             {"\"degree\": 2", "\"target\": \"fine\"", "s.json:11 /accuracy/target"},
             {"\"degree\": 2", "\"level\": \"fine\", \"target\": 0.01",
              "s.json:11 /accuracy/target: 'target' stands for a level of its own"},
             {"\"facing\": [0, 1],", "\"near\": [0, 1],", "s.json:9 /loads/0/on/within: 'within' belongs to 'facing'"},
             {"\"between\": [\"block/top\", \"disc/circle\"]", "\"between\": [\"block/top\"]",
              "s.json:10 /contacts/pairs/0/between: expected two selections"},
         }) {
        expect_one_problem(c);
    }
}

TEST(BadInput, geometry) {
    const std::string rectangle = "\"rectangle\": {\"min\": [0, 0], \"max\": [2, 1]}";
    for (const Case& c : std::vector<Case>{
             {rectangle, "\"polygon\": [[0, 0], [2, 0]]", "s.json:5 /parts/0/geometry/polygon: this list has 2 points"},
             {rectangle, "\"union\": []", "s.json:5 /parts/0/geometry/union: this list of geometry nodes is empty"},
             {rectangle, "\"name\": \"a\"", "s.json:5 /parts/0/geometry: nothing says what this is"},
             {rectangle, "\"name\": \"a*\", " + rectangle,
              "s.json:5 /parts/0/geometry/name: the name 'a*' contains '#' or '*'"},
             {rectangle,
              "\"loops\": [[{\"arc\": {\"from\": [1, 0], \"to\": [0, 1.00001], \"center\": [0, 0], \"ccw\": true}}]]",
              "s.json:5 /parts/0/geometry/loops/0/0/arc: the arc's ends lie at different distances"},
             {rectangle, "\"loops\": [[{\"arc\": {\"from\": [0, 0], \"via\": [1, 1], \"to\": [3, 3]}}]]",
              "s.json:5 /parts/0/geometry/loops/0/0/arc: the three points of the arc lie on one line"},
             {rectangle, "\"loops\": [[{\"line\": {\"from\": [0, 0], \"to\": [0, 0]}}]]",
              "s.json:5 /parts/0/geometry/loops/0/0/line: the line begins where it ends"},
             {rectangle,
              "\"loops\": [[{\"line\": {\"from\": [0, 0], \"to\": [1, 0]}, \"name\": \"e1\"}, {\"line\": {\"from\": [1, 0], "
              "\"to\": [0, 0]}}]]",
              "s.json:5 /parts/0/geometry/loops/0/1: two edges have the name 'e1'"},
             {rectangle, "\"half_plane\": {\"point\": [0, 0], \"normal\": [0, 1]}",
              "s.json:5 /parts/0/geometry/half_plane: the part is unbounded"},
             {rectangle, "\"dxf\": {\"file\": \"nowhere.dxf\"}", "s.json:5 /parts/0/geometry/dxf/file: "},
         }) {
        expect_one_problem(c);
    }
}

TEST(BadInput, all_problems_are_collected_up_to_twenty) {
    // As long as the text it replaces: places in the good scene are places in this one.
    const std::string three = spoilt("\"E\": 1000", "\"E\": -100").replace(good.find("\"nu\""), 4, "\"mu\"");
    EXPECT_EQ(problems_of(three).size(), 3u);  // E, the unknown key, the missing nu
    std::string many = "{\"abut\": 1, \"parts\": [";
    for (int i = 0; i < 30; ++i) many += "{},";
    many.back() = ']';
    const auto problems = problems_of(many + "}");
    ASSERT_EQ(problems.size(), 21u);
    EXPECT_EQ(problems.back().what, "and 70 more problems");  // 30 parts lack a name, a material, a geometry
}

TEST(BadInput, syntax_errors_have_line_and_column) {
    expect_one_problem({"\"R\": 1}", "\"R\": }", "s.json:2:23: expected a value, found '}'"});
    expect_one_problem({good, "[]", "s.json:1: expected an object, found a list of 0"});
    expect_one_problem({good, "", "s.json:1:1: expected a value, but the file ends"});
}

// Deleting any one character must never do worse than an InputError.
TEST(BadInput, survives_deleted_characters) {
    const TemporaryFolder folder;
    int n_bad = 0;
    for (std::size_t i = 0; i < good.size(); i += 3) {
        std::string text = good;
        text.erase(i, 1);
        try {
            read_scene(folder.write("s.json", text));
        } catch (const InputError& error) {
            ++n_bad;
            EXPECT_NE(std::string(error.what()).find("s.json"), std::string::npos);
        }
    }
    EXPECT_GT(n_bad, 150);
}

}  // namespace abut::bad_input_test
