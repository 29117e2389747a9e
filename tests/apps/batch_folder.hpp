// SPDX-License-Identifier: GPL-3.0-or-later
// Small drawings, a template for them, and the answers of a batch without its times.
#pragma once
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/apps/command_line.hpp"

namespace abut_tests {

/// A block with a smaller one on it, the higher the larger `k` is; R12 as small as it gets.
inline std::string two_blocks(int k) {
    std::string text = "0\nSECTION\n2\nENTITIES\n";
    const auto box = [&](const char* layer, double x0, double y0, double x1, double y1) {
        const double x[] = {x0, x1, x1, x0, x0}, y[] = {y0, y0, y1, y1, y0};
        for (int i = 0; i < 4; ++i)
            text += std::string("0\nLINE\n8\n") + layer + "\n10\n" + std::to_string(x[i]) + "\n20\n" + std::to_string(y[i]) +
                    "\n11\n" + std::to_string(x[i + 1]) + "\n21\n" + std::to_string(y[i + 1]) + "\n";
    };
    box("BODY", -10, 0, 10, 8);
    box("PIN", -3, 8, 3, 11 + 0.1 * k);
    return text + "0\nENDSEC\n0\nEOF\n";
}

inline constexpr const char* block_template =
    R"({"abut": 1, "parameters": {"P": 50}, "materials": {"steel": {"E": 1000, "nu": 0.3}},
  "assembly": {"file": "*", "parts_by": "layer", "material": "steel"},
  "supports": [{"on": {"part": "BODY", "facing": [0, -1]}, "fix": ["x", "y"]}, {"part": "PIN", "rigid": {"translation": [0, null], "rotation": 0}}],
  "loads": [{"part": "PIN", "force": [0, "-P"]}], "accuracy": {"cell_size": 2}, "output": {"formats": ["json", "csv"]}})";

class BatchCommand : public CommandLine {
protected:
    /// in/s0.dxf, in/s1.dxf, ..., and template.json
    void write_sketches(int n) const {
        fs::create_directories(folder_ / "in");
        for (int k = 0; k < n; ++k) write("in/s" + std::to_string(k) + ".dxf", two_blocks(k));
        write("template.json", block_template);
    }

    nlohmann::json result(const std::string& out, const std::string& job) const {
        return nlohmann::json::parse(read(folder_ / out / "jobs" / job / "result.json"));
    }

    /// Every file below OUT but pages, without times.
    std::map<std::string, std::string> answers_of(const std::string& out) const {
        static const std::regex last_column(",[^,\n]*\n");
        std::map<std::string, std::string> answers;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / out)) {
            const std::string name = entry.path().lexically_relative(folder_ / out).string(), ending = entry.path().extension();
            if (!entry.is_regular_file() || ending == ".html") continue;
            const std::string text = read(entry.path());
            answers[name] = ending == ".json"       ? without_times(nlohmann::json::parse(text)).dump(1)
                            : name == "summary.csv" ? std::regex_replace(text, last_column, "\n")
                                                    : text;
        }
        return answers;
    }

    static nlohmann::json without_times(nlohmann::json json) {
        if (json.is_object())
            for (const char* key : {"seconds", "timing", "sizes"}) json.erase(key);
        if (json.is_structured())
            for (auto& item : json) item = without_times(item);
        return json;
    }
};

}  // namespace abut_tests
