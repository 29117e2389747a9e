// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/shared_grids.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "src/discretization/discretize.hpp"
#include "src/results/result.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/scene_answers.hpp"

namespace abut::shared_grids_test {
namespace {

/// Four triangles that each other's turn about the origin takes on, and what else is given.
Scene triangles(const std::string& more = "", const std::string& load = "") {
    return read_scene_text(
        R"({"abut": 1, "materials": {"m": {"E": 1000, "nu": 0.3, "expansion": 1e-5}, "n": {"E": 1000, "nu": 0.3}},
        "parts": [{"name": "t", "material": "m", "geometry": {"polygon": [[2, 0], [4, 0], [2, 1]]},
                   "array": {"count": 4, "about": [0, 0]}}],
        "loads": [{"part": "t[1]", "force": [0, 1]})" +
            load + "]" + more + "}",
        "s.json");
}

std::map<int, CopiedPart> copies_of(const Scene& scene) {
    return copied_parts(scene, resolve_conditions(scene), std::vector<bool>(scene.parts.size(), true));
}

WantedSizes nothing_wanted(const Scene& scene) {
    return WantedSizes(scene.parts.size());
}

std::vector<DesignedGrid> designed(const Scene& scene, const WantedSizes& wanted) {
    return design_grids(scene, resolve_conditions(scene), std::vector<bool>(scene.parts.size(), true), wanted, 1, 1);
}

}  // namespace

TEST(SharedGrids, CopiesHaveTheSameLocalCoordinates) {
    const Scene scene = triangles();
    const std::map<int, CopiedPart> copies = copies_of(scene);
    ASSERT_EQ(copies.size(), 3u);
    for (const auto& [part, copy] : copies) {
        EXPECT_EQ(copy.model, 0);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT((copy.to.to_local(point(scene.parts[static_cast<std::size_t>(part)].part.edges[k].curve, 0.25)) -
                       copy.from.to_local(point(scene.parts[0].part.edges[k].curve, 0.25)))
                          .norm(),
                      1e-14);
    }
}

TEST(SharedGrids, WhatIsHeldWarmOrOnGivenGridsHasItsOwn) {
    EXPECT_EQ(copies_of(triangles(R"(, "supports": [{"on": "t[2]/e1", "fix": ["x"]}])")).size(), 2u);
    EXPECT_EQ(copies_of(triangles("", R"(, {"part": "t[3]", "temperature": 5})")).size(), 2u);
    EXPECT_EQ(copies_of(triangles(R"(, "accuracy": {"cell_size": 0.1})")).size(), 0u);
    EXPECT_EQ(copies_of(triangles(R"(, "accuracy": {"refine": [{"near": [2, 0], "radius": 0.1, "cell_size": 0.01}]})")).size(),
              0u);
    Scene scene = triangles();
    scene.parts[1].material = 1;
    scene.parts[2].thickness = 2;
    EXPECT_EQ(copies_of(scene).size(), 1u);
}

/// What any of them wants the common grid has, at that place of the part.
TEST(SharedGrids, TheCommonGridHasWhatAnyCopyWants) {
    const Scene scene = triangles();
    WantedSizes wanted = nothing_wanted(scene);
    const std::map<int, CopiedPart> copies = copies_of(scene);
    const Vec2 corner(4, 0), there = copies.at(2).to.to_global(copies.at(2).from.to_local(corner));
    EXPECT_LT((there - Vec2(-4, 0)).norm(), 1e-14);
    wanted[2].push_back({{there}, 0.02, size_growth});
    for (std::size_t k : {0u, 1u, 3u})
        wanted[k].push_back(
            {{k == 0 ? corner : copies.at(static_cast<int>(k)).to.to_global(copies.at(2).from.to_local(corner))},
             0.04,
             size_growth});
    const std::vector<DesignedGrid> grids = designed(scene, wanted);
    ASSERT_EQ(grids.size(), 4u);
    EXPECT_EQ(grids[0].model, -1);
    for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(grids[k].model, 0);
    double largest = 0;
    const Vec2 local = grids[0].grid.frame.to_local(corner);
    grids[0].grid.grid.for_cells_in(
        {local, local}, [&](int cell) { largest = std::max(largest, grids[0].grid.grid.box(cell).size().maxCoeff()); });
    EXPECT_LE(largest, 0.02 * (1 + size_growth));  // up to where the cell ends
    EXPECT_GT(largest, 0.005);
}

TEST(SharedGrids, CopiesThatWantOtherCellsHaveTheirOwn) {
    const Scene scene = triangles();
    WantedSizes wanted = nothing_wanted(scene);
    const std::map<int, CopiedPart> copies = copies_of(scene);
    const std::array<Vec2, 4> places{Vec2(4, 0), Vec2(2, 0), Vec2(2, 1), Vec2(3, 0)};
    for (int k = 0; k < 4; ++k) {
        const Vec2 place = places[static_cast<std::size_t>(k)];
        wanted[static_cast<std::size_t>(k)].push_back(
            {{k == 0 ? place : copies.at(k).to.to_global(copies.at(k).from.to_local(place))}, 1e-4, size_growth});
    }
    for (const DesignedGrid& grid : designed(scene, wanted)) EXPECT_EQ(grid.model, -1);
}

/// The same chain with a material of its own, of the same numbers, for every part: none is a copy then.
TEST(SharedGrids, AnswersAreThoseOfGridsApart) {
    Scene chain = read_scene(ABUT_SOURCE_DIR "/data/scenes/chain.json");
    AnalyzeOptions one, two;
    one.threads = 1;
    two.threads = 2;
    const Result shared = analyze(chain, one), on_two_threads = analyze(chain, two);
    ASSERT_EQ(shared.status, "ok");
    const auto row =
        std::find_if(shared.effects.begin(), shared.effects.end(), [](const Effect& e) { return e.name == "shared grids"; });
    ASSERT_NE(row, shared.effects.end());
    EXPECT_TRUE(row->on);
    EXPECT_GE(row->items, 4);
    const Material steel = chain.materials[0];
    for (ScenePart& part : chain.parts) {
        part.material = static_cast<int>(chain.materials.size());
        chain.materials.push_back(steel);
        chain.materials.back().name += std::to_string(chain.materials.size());
    }
    const Result apart = analyze(chain, one);
    ASSERT_EQ(apart.status, "ok");
    EXPECT_GT(apart.solver.factorizations, shared.solver.factorizations);
    for (const Effect& e : apart.effects) EXPECT_FALSE(e.name == "shared grids" && e.on);
    ASSERT_EQ(apart.contacts.size(), shared.contacts.size());
    double most_force = 0, most_pressure = 0;
    for (const ContactResult& c : apart.contacts) {
        most_force = std::max(most_force, c.force.norm());
        most_pressure = std::max(most_pressure, c.max_pressure.value);
    }
    for (std::size_t k = 0; k < apart.contacts.size(); ++k) {
        EXPECT_LT((apart.contacts[k].force - shared.contacts[k].force).norm(), 1e-9 * most_force);
        EXPECT_NEAR(apart.contacts[k].max_pressure.value, shared.contacts[k].max_pressure.value, 0.01 * most_pressure);
        EXPECT_EQ(on_two_threads.contacts[k].max_pressure.value, shared.contacts[k].max_pressure.value);
    }
    for (std::size_t k = 0; k < shared.parts.size(); ++k)
        EXPECT_EQ(on_two_threads.parts[k].max_von_mises.value, shared.parts[k].max_von_mises.value);
}

}  // namespace abut::shared_grids_test
