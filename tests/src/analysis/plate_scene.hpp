// SPDX-License-Identifier: GPL-3.0-or-later
// A plate with a hole and what tests of the plan add to it.
#pragma once
#include <string>

#include "src/scene/read_scene.hpp"
#include "src/scene/scene.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut {

/// A plate held at its bottom and pressed on its top, and what a test adds to it.
struct Variation {
    std::string more_parts = {}, more_loads = {}, more_supports = {}, contacts = {};
    std::string hold = R"({"on": "plate/bottom", "fix": ["x", "y"]})";
    bool plate_last = false;
};

inline std::string scene_text(const Variation& v) {
    const std::string plate =
        R"({"name": "plate", "material": "m", "geometry": {"difference": [{"rectangle": {"min": [0, 0], "max": [4, 2]}},
                                                                          {"circle": {"center": [2.1, 0.9], "radius": 0.4}}]}})";
    const std::string parts =
        v.more_parts.empty() ? plate : (v.plate_last ? v.more_parts + ", " + plate : plate + ", " + v.more_parts);
    return R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3, "density": 1e-3}}, "parts": [)" + parts +
           R"(], "supports": [)" + v.hold + v.more_supports + R"(], "loads": [{"on": "plate/top", "pressure": "10 + x"})" +
           v.more_loads + "]" + (v.contacts.empty() ? "" : R"(, "contacts": )" + v.contacts) +
           R"(, "output": {"probes": [{"part": "plate", "at": [1, 1.5]}, {"part": "plate", "at": [2.1, 1.4]}]}})";
}

/// Too far from the plate to be found, or lying on it.
inline const std::string far_block =
    R"({"name": "block", "material": "m", "geometry": {"rectangle": {"min": [100, 0], "max": [101, 1]}}})";
inline const std::string next_block =
    R"({"name": "block", "material": "m", "geometry": {"rectangle": {"min": [4, 0], "max": [5, 1]}}})";
inline const std::string hold_block = R"(, {"on": "block/right", "fix": ["x", "y"]})";

inline Scene scene_of(const Variation& v) {
    const TemporaryFolder folder;
    return read_scene(folder.write("scene.json", scene_text(v)));
}

}  // namespace abut
