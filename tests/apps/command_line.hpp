// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program from outside, in a folder of the test's own.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace abut_tests {

namespace fs = std::filesystem;

struct Outcome {
    int status = -1;
    std::string output;
    std::vector<std::string> errors;  ///< lines of standard error
};

inline std::string read(const fs::path& path) {
    std::ifstream stream(path);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

inline std::string quoted(const std::string& word) {
    return "'" + std::regex_replace(word, std::regex("'"), R"('\'')") + "'";
}

inline std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Each test works in a folder of its own.
class CommandLine : public ::testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "abut_command_line_XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    Outcome abut(const std::vector<std::string>& words) const {
        std::string command = "cd " + quoted(folder_.string()) + " && " + quoted(ABUT_BINARY);
        for (const std::string& word : words) command += " " + quoted(word);
        const int code = std::system((command + " >stdout.txt 2>stderr.txt </dev/null").c_str());
        return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, read(folder_ / "stdout.txt"), lines_of(read(folder_ / "stderr.txt"))};
    }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

    /// Wrong usage or input: status 2, nothing on standard output, and `count` lines that begin with the program's name.
    void expect_refused(const Outcome& run, std::size_t count) const {
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.output, "");
        EXPECT_EQ(run.errors.size(), count) << joined(run.errors);
        for (const std::string& line : run.errors) EXPECT_EQ(line.rfind("abut: ", 0), 0U) << line;
    }

    fs::path folder_;
};

inline void expect_words(const std::string& line, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(line.find(word), std::string::npos) << "'" << word << "' is missing in: " << line;
}

/// Is there one line that holds all the words?
inline bool any_line_has(const std::vector<std::string>& lines, const std::vector<std::string>& words) {
    for (const std::string& line : lines) {
        bool all = true;
        for (const std::string& word : words) all = all && line.find(word) != std::string::npos;
        if (all) return true;
    }
    return false;
}

/// A block that stands on the ground, with holes for the one thing that a test makes wrong.
struct SceneText {
    std::string geometry = R"({"rectangle": {"min": [0, 0], "max": [10, 10]}})";
    std::string material = R"({"E": 210000, "nu": 0.3})";
    std::string used_material = "steel";
    std::string supports = R"([{"on": "block/bottom", "fix": ["x", "y"]}])";
    std::string loads = R"([{"on": "block/top", "pressure": 1}])";
    std::string more;

    std::string text() const {
        return "{\n  \"abut\": 1,\n  \"accuracy\": {\"level\": \"draft\"},\n  \"materials\": {\"steel\": " + material + "},\n" +
               "  \"parts\": [{\"name\": \"block\", \"material\": \"" + used_material + "\",\n    \"geometry\": " + geometry +
               "}],\n" + "  \"supports\": " + supports + ",\n  \"loads\": " + loads + more + "\n}\n";
    }
};

}  // namespace abut_tests
