// SPDX-License-Identifier: GPL-3.0-or-later
// The house's rules about who may include what.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/src/reference/schema_check.hpp"

namespace layers_test {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> layers{"geometry", "solver", "src", "apps"};

/// What the files of a folder must not include from.
const std::map<std::string, std::vector<std::string>> forbidden_layers{
    {"geometry", {"solver", "src", "apps"}}, {"solver", {"geometry", "src", "apps"}}, {"src", {"apps"}}, {"apps", {}}};

/// The rooms of each floor in the order in which data flows: what is in a room may include from those before it. apps/
/// has none.
const std::map<std::string, std::vector<std::string>> rooms{
    {"geometry",
     {"curves", "brep", "csg", "sketch", "dxf", "foreign", "mesh", "step", "cells", "quadrature", "proximity", "interfaces",
      "implicit"}},
    {"solver", {"linear_algebra", "splines", "assembly", "terms", "parts", "contact", "recovery", "beam"}},
    {"src",
     {"base", "io", "scene", "results", "contact", "plan", "motion", "discretization", "solution", "answers", "analysis",
      "session", "report", "live", "inspection", "verification", "study", "batch", "reference"}}};

/// What every floor may use; it knows none of them.
const std::string common_room = "src/base/";

/// These compile slowly and need flags of their own.
const std::vector<std::string> cgal_files{"geometry/csg/exact_regions.cpp", "geometry/csg/exact_outline.cpp",
                                          "geometry/csg/clear_pieces.cpp"};

/// Headers of libraries that stay hidden in .cpp files, wherever they are installed.
const std::regex hidden_library(
    R"((.*/)?(assimp/.*|dl_[^/]*|json(_fwd)?\.hpp|cholmod[^/]*\.h|utf8\.h|xxhash\.h)|(CGAL|boost|nlohmann)/.*)");

struct Include {
    std::string target;
    int line;
};

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
    std::vector<Include> found;
    std::istringstream stream(text);
    std::string line;
    std::smatch match;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (std::regex_match(line, match, include)) found.push_back({match[1], number});
    }
    return found;
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_header(const fs::path& path) {
    return path.extension() == ".hpp" || path.extension() == ".h";
}

/// The first folder of a path: "geometry" of "geometry/brep/part.hpp".
std::string layer_of(const std::string& path) {
    return path.substr(0, path.find('/'));
}

/// The second folder of a path: "brep" of "geometry/brep/part.hpp"; empty where there is none.
std::string room_of(const std::string& path) {
    const std::size_t first = path.find('/'), second = path.find('/', first + 1);
    return second == std::string::npos ? "" : path.substr(first + 1, second - first - 1);
}

/// Its place in the order of its floor's rooms; their number where it is in none of them.
std::ptrdiff_t place_of(const std::string& path) {
    const auto floor = rooms.find(layer_of(path));
    if (floor == rooms.end()) return 0;
    return std::find(floor->second.begin(), floor->second.end(), room_of(path)) - floor->second.begin();
}

bool is_in_a_room(const std::string& path) {
    const auto floor = rooms.find(layer_of(path));
    return floor != rooms.end() && contains(floor->second, room_of(path));
}

/// Why this file must not include that; empty where it may.
std::string fault(const std::string& file, const std::string& target) {
    if (target.find("..") != std::string::npos) return "includes are written from the source folder, without '..'";
    if (target.rfind(common_room, 0) == 0) return "";
    if (target.find('/') != std::string::npos && file.rfind(common_room, 0) == 0 && contains(layers, layer_of(target)))
        return common_room + " must not know " + layer_of(target) + "/";
    if (target.find('/') != std::string::npos && contains(forbidden_layers.at(layer_of(file)), layer_of(target))) {
        return layer_of(file) + "/ must not know " + layer_of(target) + "/";
    }
    if (is_in_a_room(file) && layer_of(target) == layer_of(file) && place_of(target) > place_of(file))
        return room_of(file) + "/ comes before " + room_of(target) + "/";
    if (layer_of(target) == "CGAL" || contains(cgal_files, target))
        return contains(cgal_files, file) ? "" : "CGAL belongs into its own few files";
    if (is_header(file) && std::regex_match(target, hidden_library)) return "this library stays out of headers";
    return "";
}

/// One line per forbidden include of a file with this path (from the source folder) and text.
std::vector<std::string> faults_of(const std::string& file, const std::string& text) {
    std::vector<std::string> faults;
    for (const Include& include : includes_of(text)) {
        const std::string why = fault(file, include.target);
        if (!why.empty()) faults.push_back(file + ":" + std::to_string(include.line) + ": " + include.target + ": " + why);
    }
    return faults;
}

std::vector<std::string> source_files() {
    const fs::path root = ABUT_SOURCE_DIR;
    std::vector<std::string> files;
    for (const std::string& layer : layers) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / layer)) {
            if (is_header(entry.path()) || entry.path().extension() == ".cpp")
                files.push_back(fs::relative(entry, root).string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The types that a header's text defines, with their namespaces, which stand without indentation.
std::vector<std::string> types_of(const std::string& text) {
    static const std::regex space(R"(^namespace ([\w:]+) \{$)"),
        type(R"(^(struct|class|enum|enum class) (\w+)( final)?( : .*)? \{.*$)");
    std::vector<std::string> found;
    std::istringstream stream(text);
    std::string line, prefix;
    std::smatch match;
    while (std::getline(stream, line)) {
        if (std::regex_match(line, match, space)) prefix = match[1].str() + "::";
        if (std::regex_match(line, match, type)) found.push_back(prefix + match[2].str());
    }
    return found;
}

std::string read(const std::string& file) {
    std::ifstream stream(fs::path(ABUT_SOURCE_DIR) / file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Does the text have it, with no letter, digit or underscore on either side?
bool has_word(const std::string& text, const std::string& word) {
    const auto is_part = [&](std::size_t k) {
        return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
    };
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if (!(at > 0 && is_part(at - 1)) && !is_part(at + word.size())) return true;
    return false;
}

TEST(Layers, NoFileIncludesWhatItMustNot) {
    for (const std::string& file : source_files()) {
        for (const std::string& line : faults_of(file, read(file))) ADD_FAILURE() << line;
    }
}

/// Two of one name in one namespace are one to the linker, which takes the functions of either.
TEST(Layers, OneNameIsOneType) {
    std::map<std::string, std::string> where;
    for (const std::string& file : source_files()) {
        if (!is_header(file)) continue;
        for (const std::string& type : types_of(read(file))) {
            const auto [known, is_new] = where.emplace(type, file);
            EXPECT_TRUE(is_new) << type << " is defined in " << known->second << " and in " << file;
        }
    }
    EXPECT_GT(where.size(), 300U);
    EXPECT_TRUE(where.contains("abut::geometry::Part") && where.contains("abut::solver::SupportMethod"));
    const std::vector<std::string> both{"a::b::C", "a::b::D", "a::E"};
    EXPECT_EQ(types_of("namespace a::b {\nstruct C {\n    struct In {};\n};\nclass F;\nenum class D { x };\n}\n"
                       "namespace a {\nclass E final : public X {\n"),
              both);
}

/// Beginnings of comments of declarations that only whoever reads the declaration before understands; by line.
std::vector<int> leaning_comments(const std::string& text) {
    static const std::regex comment(R"(^\s*///.*)"), leaning(R"(^\s*/// (Of|The same|By)\b.*)");
    std::vector<int> found;
    std::istringstream stream(text);
    std::string line;
    bool goes_on = false;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (!goes_on && std::regex_match(line, leaning)) found.push_back(number);
        goes_on = std::regex_match(line, comment);
    }
    return found;
}

TEST(Layers, CommentsOfHeadersStandByThemselves) {
    for (const std::string& file : source_files()) {
        if (!is_header(file)) continue;
        for (const int line : leaning_comments(read(file)))
            ADD_FAILURE() << file << ":" << line << ": a sentence with a subject, please";
    }
    EXPECT_EQ(
        leaning_comments("/// Of a part.\nint a();\n    /// The same.\nint b();\n/// The sameness\n/// of a part.\nint c();\n"
                         "/// Whatever\n/// Of old.\nint d();  ///< by part\n/// By part.\n"),
        (std::vector<int>{1, 3, 11}));
}

/// Neither a folder more than the order of rooms knows nor one less, each with its README, which has every file.
TEST(Layers, EveryFileStandsInARoom) {
    std::map<std::string, std::set<std::string>> found;
    for (const std::string& file : source_files()) {
        if (!rooms.contains(layer_of(file))) continue;
        EXPECT_TRUE(is_in_a_room(file)) << file;
        found[layer_of(file)].insert(room_of(file));
    }
    for (const auto& [floor, names] : rooms)
        for (const std::string& room : names) {
            EXPECT_TRUE(found[floor].contains(room)) << floor << "/" << room << " is empty";
            EXPECT_FALSE(read(floor + "/" + room + "/README.md").empty()) << floor << "/" << room << " has no README.md";
        }
    for (const std::string& file : source_files()) {
        if (!is_in_a_room(file)) continue;
        const std::string readme = layer_of(file) + "/" + room_of(file) + "/README.md";
        EXPECT_TRUE(has_word(read(readme), fs::path(file).stem().string())) << readme << " has not " << file;
    }
    EXPECT_TRUE(has_word("| `a_b`, `c` |", "a_b") && has_word("`a.hpp`", "a"));
    EXPECT_FALSE(has_word("| `a_b`, `c` |", "a") || has_word("| `a_b`, `c` |", "b"));
}

TEST(Layers, TestsStandInTheRoomsThatTheyTest) {
    const fs::path tests = fs::path(ABUT_SOURCE_DIR) / "tests";
    for (const auto& [floor, names] : rooms)
        for (const fs::directory_entry& entry : fs::directory_iterator(tests / floor))
            EXPECT_TRUE(entry.is_directory() ? contains(names, entry.path().filename().string())
                                             : entry.path().filename() == "layers_test.cpp")
                << entry.path();
}

/// The keys of literature that a text cites: [Grishin10, eq 3.7; Hoellig03].
std::set<std::string> keys_in(const std::string& text) {
    static const std::regex citation(R"(\[([A-Z][^\]]{0,120})\])"), key(R"(\b[A-Z][a-z]+(19|20)?\d\d\b)");
    std::set<std::string> keys;
    const std::sregex_iterator end;
    for (std::sregex_iterator k(text.begin(), text.end(), citation); k != end; ++k) {
        const std::string cited = (*k)[1];
        for (std::sregex_iterator l(cited.begin(), cited.end(), key); l != end; ++l) keys.insert(l->str());
    }
    return keys;
}

TEST(Layers, WhatIsCitedStandsInTheLiterature) {
    std::set<std::string> cited;
    for (const std::string& file : source_files()) {
        for (const std::string& key : keys_in(read(file))) cited.insert(key);
    }
    const std::set<std::string> known = keys_in(read("data/LITERATURE.md"));
    for (const std::string& key : cited) EXPECT_TRUE(known.contains(key)) << key;
    EXPECT_GT(cited.size(), 20U);
    EXPECT_EQ(keys_in("by [Grishin10, eq 3.7; Hoellig03] x[0], [Index k], [Galin1953]"),
              (std::set<std::string>{"Galin1953", "Grishin10", "Hoellig03"}));
}

struct Told {
    std::vector<std::string> kinds;
    std::ptrdiff_t calls = 0;
};

/// The kinds in the calls of tell(findings, kind, result), and how many calls there are.
Told told_in(const std::string& text) {
    static const std::regex call(R"(\btell\()"), kind(R"rx("(\w+)",\s*result\);)rx");
    Told told;
    const std::sregex_iterator end;
    for (std::sregex_iterator k(text.begin(), text.end(), kind); k != end; ++k) told.kinds.push_back((*k)[1]);
    told.calls = std::distance(std::sregex_iterator(text.begin(), text.end(), call), end);
    return told;
}

/// Who reads reasons[].kind of result.json finds there what it means; and nothing that is never said.
TEST(Layers, TheSchemaKnowsEveryKindOfReason) {
    const schema_check::Json reason = schema_check::json_of(schema_check::schema_file("result"))["properties"]["reasons"];
    const schema_check::Json& kind = reason["items"]["properties"]["kind"];
    std::set<std::string> known, told;
    for (const auto& word : kind["enum"]) {
        known.insert(word.get<std::string>());
        EXPECT_NE(kind["description"].get<std::string>().find(" " + word.get<std::string>() + ": "), std::string::npos) << word;
    }
    for (const std::string& file : source_files()) {
        const std::string text = read(file);
        if (file == "src/results/findings.cpp" || text.find("\"src/results/findings.hpp\"") == std::string::npos) continue;
        const Told found = told_in(text);
        EXPECT_EQ(static_cast<std::ptrdiff_t>(found.kinds.size()), found.calls)
            << file << ": kinds are written where they are told";
        EXPECT_EQ(text.find("reasons.push_back"), std::string::npos) << file;
        told.insert(found.kinds.begin(), found.kinds.end());
    }
    EXPECT_EQ(told, known);
    EXPECT_EQ(told_in("tell(a, \"b\", result);\ntell({{0,\n  f(x)}},\n  \"c_d\",\n  result);\ntell(e, f, result);").kinds,
              (std::vector<std::string>{"b", "c_d"}));
}

TEST(Layers, TheCheckSeesTheFilesAndTheirIncludes) {
    const std::vector<std::string> files = source_files();
    for (const char* known : {"geometry/brep/part.hpp", "geometry/brep/part.cpp", "src/scene/scene.hpp", "apps/main.cpp"}) {
        EXPECT_TRUE(contains(files, known)) << known;
        EXPECT_FALSE(includes_of(read(known)).empty()) << known;
    }
    for (const std::string& known : cgal_files) EXPECT_TRUE(contains(files, known)) << known;
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](const std::string& f) { return layer_of(f) == "solver"; }));
}

struct Case {
    std::string file, line;
};

TEST(Layers, MadeUpBadFilesAreCaught) {
    const std::vector<Case> bad{{"geometry/a.cpp", "#include \"solver/space.hpp\""},
                                {"src/base/a.hpp", "#include \"geometry/curves/vec2.hpp\""},
                                {"src/base/a.hpp", "#include \"src/io/json_document.hpp\""},
                                {"geometry/a.cpp", "#include \"src/scene/scene.hpp\""},
                                {"geometry/a.hpp", "  #  include   \"apps/commands.hpp\""},
                                {"solver/a.cpp", "#include \"geometry/curves/vec2.hpp\""},
                                {"solver/a.cpp", "#include <src/scene/scene.hpp>"},
                                {"solver/a.hpp", "#include \"apps/commands.hpp\""},
                                {"geometry/curves/a.hpp", "#include \"geometry/brep/part.hpp\""},
                                {"solver/splines/a.cpp", "#include \"solver/contact/interface.hpp\""},
                                {"src/scene/a.cpp", "#include \"src/plan/loads.hpp\""},
                                {"src/scene/a.cpp", "#include \"src/nowhere/loads.hpp\""},
                                {"src/a.cpp", "#include \"apps/arguments.hpp\"  // why not"},
                                {"src/a.cpp", "#include \"../apps/arguments.hpp\""},
                                {"geometry/brep/part.cpp", "#include <CGAL/Polygon_2.h>"},
                                {"geometry/csg/boolean.hpp", "#include <CGAL/Polygon_2.h>"},
                                {"geometry/csg/exact_regions.hpp", "#include <CGAL/Polygon_2.h>"},
                                {"geometry/csg/csg.cpp", "#include <CGAL/Polygon_2.h>"},
                                {"geometry/csg/boolean.cpp", "#include <CGAL/Polygon_2.h>"},
                                {"src/a.hpp", "#include <nlohmann/json.hpp>"},
                                {"src/a.hpp", "#include <nlohmann/json_fwd.hpp>"},
                                {"src/a.hpp", "#include \"json.hpp\""},
                                {"geometry/a.hpp", "#include <dl_dxf.h>"},
                                {"geometry/a.hpp", "#include <dxflib/dl_creationadapter.h>"},
                                {"geometry/a.hpp", "#include <assimp/scene.h>"},
                                {"solver/a.hpp", "#include <cholmod.h>"},
                                {"src/a.hpp", "#include <utf8.h>"},
                                {"src/a.hpp", "#include <xxhash.h>"},
                                {"geometry/a.hpp", "#include <boost/geometry/index/rtree.hpp>"},
                                {"solver/a.hpp", "#include <suitesparse/cholmod.h>"}};
    for (const Case& c : bad) {
        const std::vector<std::string> faults = faults_of(c.file, "// a file\n" + c.line + "\nint a();\n");
        ASSERT_EQ(faults.size(), 1U) << c.file << " " << c.line;
        EXPECT_EQ(faults[0].rfind(c.file + ":2: ", 0), 0U) << faults[0];
    }
}

TEST(Layers, WhatIsAllowedPasses) {
    const std::vector<Case> good{{"geometry/csg/exact_regions.cpp", "#include <CGAL/Polygon_2.h>"},
                                 {"geometry/csg/boolean.cpp", "#include \"geometry/csg/exact_regions.hpp\""},
                                 {"geometry/csg/csg.cpp", "#include \"geometry/csg/boolean.hpp\""},
                                 {"geometry/dxf/dxf.cpp", "#include <dl_dxf.h>"},
                                 {"solver/a.cpp", "#include <cholmod.h>"},
                                 {"solver/beam/a.cpp", "#include \"src/base/ensure.hpp\""},
                                 {"geometry/curves/a.hpp", "#include \"src/base/ensure.hpp\""},
                                 {"solver/a.hpp", "#include \"solver/space.hpp\""},
                                 {"src/a.cpp", "#include <nlohmann/json.hpp>"},
                                 {"src/a.hpp", "#include \"geometry/brep/part.hpp\""},
                                 {"src/a.hpp", "#include \"src/io/json_document.hpp\""},
                                 {"src/plan/a.cpp", "#include \"src/scene/scene.hpp\""},
                                 {"src/plan/a.cpp", "#include \"src/plan/loads.hpp\""},
                                 {"src/scene/a.cpp", "#include \"geometry/implicit/jet.hpp\""},
                                 {"solver/beam/a.hpp", "#include \"solver/linear_algebra/blas.hpp\""},
                                 {"apps/a.cpp", "#include \"solver/space.hpp\""},
                                 {"geometry/a.cpp", "// #include \"src/scene/scene.hpp\""}};
    for (const Case& c : good) EXPECT_TRUE(faults_of(c.file, c.line).empty()) << c.file << " " << c.line;
}

}  // namespace

}  // namespace layers_test
