// SPDX-License-Identifier: GPL-3.0-or-later
// Facets and splines that stand for arcs become arcs, unless one asks for the drawing as it is.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/brep/input_error.hpp"
#include "src/scene/read_drawing.hpp"
#include "src/scene/read_scene.hpp"
#include "src/scene/read_sketch.hpp"
#include "src/scene/scene.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"
#include "tests/src/io/temporary_folder.hpp"

namespace abut::keep_facets_test {
namespace {

constexpr int n_facets = 48;

Vec2 corner(int k) {
    const double angle = 2 * std::numbers::pi * k / n_facets;
    return 10 * Vec2(std::cos(angle), std::sin(angle));
}

/// A disc drawn as lines.
std::string facetted_disc() {
    std::string lines;
    for (int k = 0; k < n_facets; ++k) {
        const Vec2 a = corner(k), b = corner(k + 1);
        lines += geometry::dxf_line(std::to_string(k + 16), "DISC", a.x(), a.y(), b.x(), b.y());
    }
    return geometry::dxf_file(lines);
}

/// The same as a prism of height 2.
std::string facetted_prism() {
    std::ostringstream text;
    text.precision(17);
    for (int z : {0, 2})
        for (int k = 0; k < n_facets; ++k) text << "v " << corner(k).x() << " " << corner(k).y() << " " << z << "\n";
    const auto face = [&](int a, int b, int c) { text << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n"; };
    for (int k = 0; k < n_facets; ++k) {
        const int next = (k + 1) % n_facets;
        face(k, next, n_facets + next);
        face(k, n_facets + next, n_facets + k);
        if (k == 0 || next == 0) continue;
        face(0, next, k);
        face(n_facets, n_facets + k, n_facets + next);
    }
    return text.str();
}

std::size_t edges_of(const std::string& path, bool recognise_arcs) {
    ImportOptions options;
    options.recognise_arcs = recognise_arcs;
    const SketchReading reading = read_sketch(path, options);
    EXPECT_EQ(reading.scene.parts.size(), 1U) << path;
    return reading.scene.parts.empty() ? 0 : reading.scene.parts[0].part.edges.size();
}

std::string scene_with(const std::string& geometry) {
    return R"({"abut": 1, "materials": {"m": {"E": 1, "nu": 0.3}}, )" + geometry + "}";
}

std::size_t edges_of_scene(const TemporaryFolder& folder, const std::string& geometry) {
    const Scene scene = read_scene(folder.write("scene.json", scene_with(geometry)));
    EXPECT_EQ(scene.parts.size(), 1U) << geometry;
    return scene.parts.empty() ? 0 : scene.parts[0].part.edges.size();
}

}  // namespace

TEST(KeepFacets, OfDrawingsAndMeshes) {
    const TemporaryFolder folder;
    for (const std::string& path : {folder.write("disc.dxf", facetted_disc()), folder.write("disc.obj", facetted_prism())}) {
        EXPECT_LE(edges_of(path, true), 2U) << path;
        EXPECT_EQ(edges_of(path, false), static_cast<std::size_t>(n_facets)) << path;
    }
}

TEST(KeepFacets, IsAKeyOfScenes) {
    const TemporaryFolder folder;
    folder.write("disc.dxf", facetted_disc());
    folder.write("disc.obj", facetted_prism());
    for (const char* node : {R"({"dxf": {"file": "disc.dxf")", R"({"mesh": {"file": "disc.obj")"}) {
        const std::string part = R"("parts": [{"name": "disc", "material": "m", "geometry": )" + std::string(node);
        EXPECT_LE(edges_of_scene(folder, part + "}}}]"), 2U);
        EXPECT_EQ(edges_of_scene(folder, part + R"(, "recognise_arcs": false}}}])"), static_cast<std::size_t>(n_facets));
    }
    const std::string assembly = R"("assembly": {"file": "disc.dxf", "material": "m")";
    EXPECT_LE(edges_of_scene(folder, assembly + "}"), 2U);
    EXPECT_EQ(edges_of_scene(folder, assembly + R"(, "recognise_arcs": false})"), static_cast<std::size_t>(n_facets));
}

TEST(KeepFacets, TakesTrueOrFalseOnly) {
    const TemporaryFolder folder;
    folder.write("disc.dxf", facetted_disc());
    const std::string path =
        folder.write("scene.json", scene_with(R"("assembly": {"file": "disc.dxf", "material": "m", "recognise_arcs": "no"})"));
    try {
        read_scene(path);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("/assembly/recognise_arcs"), std::string::npos) << error.what();
    }
}

}  // namespace abut::keep_facets_test
