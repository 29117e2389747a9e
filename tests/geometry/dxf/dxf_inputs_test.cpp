// SPDX-License-Identifier: GPL-3.0-or-later
// Real drawings: read or refused with one clear line, and counted as ezdxf (another reader) counts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include "geometry/brep/input_error.hpp"
#include "geometry/dxf/dxf.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry::dxf_inputs_test {
namespace {

const std::string inputs = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/";

/// Drawings with a fault each: what is right for them is another matter.
bool is_drawn_badly(const std::filesystem::path& path) {
    return path.string().find("/inputs/drawn/") != std::string::npos;
}

std::vector<std::string> drawings() {
    std::vector<std::string> paths;
    if (!std::filesystem::exists(inputs)) return paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(inputs))
        if ((entry.path().extension() == ".dxf" || entry.path().extension() == ".DXF") && !is_drawn_badly(entry.path()))
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

TEST(DxfInputs, AreReadOrRefusedWithOneLine) {
    using Clock = std::chrono::steady_clock;
    if (drawings().empty()) GTEST_SKIP() << "no folder of real inputs";
    int n_refused = 0;
    for (const std::string& path : drawings()) {
        const Clock::time_point begin = Clock::now();
        try {
            const Drawing drawing = read_dxf(path);
            EXPECT_FALSE(drawing.entities.empty()) << path;
            for (const SketchEntity& entity : drawing.entities) EXPECT_TRUE(is_finite(entity.curve)) << path;
        } catch (const InputError& error) {
            ++n_refused;
            EXPECT_EQ(error.problems().size(), 1u);
            EXPECT_FALSE(error.problems()[0].hint.empty());
            EXPECT_EQ(one_line(error.problems()[0]).find('\n'), std::string::npos);
        }
        EXPECT_LT(std::chrono::duration<double>(Clock::now() - begin).count(), 1) << path;
    }
    EXPECT_EQ(n_refused, 2);  // truncated.dxf, and a fragment without sections
}

/// What a command prints; empty if it fails.
std::string output_of(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {};
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    return pclose(pipe) == 0 ? text : "";
}

using Counts = std::map<std::string, int>;

/// Entities of the model space by type and file; without the files that ezdxf refuses.
std::map<std::string, Counts> counts_by_ezdxf(const std::vector<std::string>& paths) {
    const std::string script =
        "import sys, ezdxf, collections\n"
        "for path in sys.argv[1:]:\n"
        "    try: space = ezdxf.readfile(path).modelspace()\n"
        "    except Exception: continue\n"
        "    for kind, n in collections.Counter(e.dxftype() for e in space).items(): print(path, kind, n, sep=\"\\t\")\n";
    std::string command = "/usr/bin/python3 -c '" + script + "' ";
    for (const std::string& path : paths) command += "'" + path + "' ";
    std::istringstream lines(output_of(command + "2>/dev/null"));
    std::map<std::string, Counts> counts;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string path, kind, n;
        std::getline(fields, path, '\t');
        std::getline(fields, kind, '\t');
        std::getline(fields, n, '\t');
        counts[path][kind] = std::stoi(n);
    }
    return counts;
}

TEST(LongDxfInputs, AreCountedAsEzdxfCountsThem) {
    if (drawings().empty()) GTEST_SKIP() << "no folder of real inputs";
    if (output_of("/usr/bin/python3 -c 'import ezdxf; print(1)' 2>/dev/null").empty()) GTEST_SKIP() << "no ezdxf";
    const std::map<std::string, Counts> expected = counts_by_ezdxf(drawings());
    EXPECT_GT(expected.size(), 50u);
    for (const auto& [path, counts] : expected) {
        Counts read;
        try {
            for (const auto& [type, count] : read_dxf(path).counts) read[type] = count.read;
        } catch (const InputError&) { continue; }  // ezdxf mends what it takes for the beginning of a truncated file
        EXPECT_EQ(read, counts) << path;
    }
}

}  // namespace
}  // namespace abut::geometry::dxf_inputs_test
