// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/benchmark_scenes.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "src/scene/read_scene.hpp"

namespace abut::benchmarks {

Scene scene_file(const std::string& path) {
    return read_scene(std::string(ABUT_SOURCE_DIR) + "/" + path);
}

Scene scene_text(const std::string& json) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("abut_benchmark_" + std::to_string(::getpid()) + ".json");
    std::ofstream(path) << json;
    Scene scene = read_scene(path.string());
    std::filesystem::remove(path);
    return scene;
}

Scene plate_with_hole() {
    return scene_text(R"({"abut": 1, "materials": {"m": {"E": 1e5, "nu": 0.3}}, "parts": [{"name": "plate", "material": "m",
        "geometry": {"difference": [{"rectangle": {"min": [-1, -1], "max": [1, 1]}}, {"circle": {"center": [0.1, 0], "radius": 0.5}}]}}],
        "supports": [{"part": "plate", "rigid": {"translation": [0, 0], "rotation": 0}}]})");
}

geometry::Grid plate_grid(int n) {
    constexpr double beyond = 0.37;  // of a cell, on every side of the plate
    const double h = 2 / (n - 2 * beyond);
    geometry::Grid grid;
    for (int k = 0; k <= n; ++k) grid.x.push_back(-1 - beyond * h + k * h);
    grid.y = grid.x;
    return grid;
}

PartOnGrid plate_on_grid(const Scene& plate, int n, int degree) {
    return discretize(plate, 0, frame_for(plate.parts[0].part, 0), plate_grid(n), {degree, degree});
}

}  // namespace abut::benchmarks
