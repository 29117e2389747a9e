// SPDX-License-Identifier: GPL-3.0-or-later
// cells.svg, read back: what is drawn is what the grid holds.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <regex>

#include "geometry/brep/extent.hpp"
#include "geometry/interfaces/common_grid.hpp"
#include "src/contact/detect.hpp"
#include "src/inspection/cell_sheet.hpp"
#include "src/inspection/detect_pictures.hpp"
#include "src/report/boxes_apart.hpp"
#include "tests/src/io/xml_fault.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::cells_picture_test {
namespace {

using abut_tests::fault_of_xml;
using geometry::CellClass;
using geometry::CommonGrid;
using geometry::Part;
using synthetic::rectangle;

Part disc(const Vec2& center, double radius) {
    Part part;
    part.loops = {{{0}}};
    part.edges.push_back({geometry::Arc{center, radius, 0, 2 * std::numbers::pi}, "circle", "circle"});
    return part;
}

Scene scene_of(const std::vector<std::pair<std::string, Part>>& parts) {
    Scene scene;
    scene.length_unit = "mm";
    scene.title = "cells";
    for (const auto& [name, part] : parts) {
        scene.parts.push_back({name, part, -1, 1, ""});
        scene.parts.back().part.name = name;
    }
    return scene;
}

/// A roller between two plates, the upper one not straight above.
Scene roller() {
    return scene_of({{"base", rectangle("base", {0, 0}, {40, 6.3})},
                     {"roller", disc({17, 11.3}, 5)},
                     {"top", rectangle("top", {9, 16.35}, {31, 20})}});
}

std::string picture_of(const Scene& scene, int most_cells = most_drawn_cells) {
    return detection_cells_svg(scene, detect_contacts(scene, {}), most_cells);
}

/// The same grid as the picture's, made from its definition.
CommonGrid grid_of(const Scene& scene) {
    double size = std::numeric_limits<double>::infinity();
    std::vector<const Part*> parts;
    for (const ScenePart& p : scene.parts) {
        size = std::min(size, extent(p.part));
        parts.push_back(&p.part);
    }
    return common_grid(parts, geometry::case_cell_fraction * size);
}

// ---- reading back ----

/// The text from one mark to the next.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from);
    if (begin == std::string::npos) return {};
    return text.substr(begin + from.size(), text.find(to, begin + from.size()) - begin - from.size());
}

/// Data of the paths of a class, in order.
std::vector<std::string> paths_of(const std::string& svg, const std::string& css) {
    std::vector<std::string> data;
    const std::string ends = "\" class=\"" + css + "\"";
    for (std::size_t at = svg.find(ends); at != std::string::npos; at = svg.find(ends, at + 1)) {
        const std::size_t begin = svg.rfind(" d=\"", at) + 4;
        data.push_back(svg.substr(begin, at - begin));
    }
    return data;
}

struct Rect {
    double x0, y0, x1, y1;
};
std::vector<Rect> rectangles_of(const std::string& data) {
    std::vector<Rect> rectangles;
    static const std::regex rectangle("M([0-9.]+) ([0-9.]+)H([0-9.]+)V([0-9.]+)H([0-9.]+)Z");
    for (std::sregex_iterator it(data.begin(), data.end(), rectangle), end; it != end; ++it) {
        EXPECT_EQ((*it)[1], (*it)[5]);
        rectangles.push_back({std::stod((*it)[1]), std::stod((*it)[4]), std::stod((*it)[3]), std::stod((*it)[2])});
    }
    return rectangles;
}

/// The box of a grid's lines.
Rect frame_of(const std::string& lines) {
    static const std::regex upright("M([0-9.]+) ([0-9.]+)V([0-9.]+)");
    Rect frame{1e9, 1e9, -1e9, -1e9};
    for (std::sregex_iterator it(lines.begin(), lines.end(), upright), end; it != end; ++it) {
        frame.x0 = std::min(frame.x0, std::stod((*it)[1]));
        frame.x1 = std::max(frame.x1, std::stod((*it)[1]));
        frame.y0 = std::stod((*it)[3]);
        frame.y1 = std::stod((*it)[2]);
    }
    return frame;
}

/// Cells in the rectangles of a class, cells being so many pixels wide.
int cells_in(const std::string& svg, const std::string& css, double pixels) {
    double n = 0;
    for (const std::string& data : paths_of(svg, css))
        for (const Rect& r : rectangles_of(data)) {
            EXPECT_NEAR(r.y1 - r.y0, pixels, 0.03);
            n += std::round((r.x1 - r.x0) / pixels);
        }
    return static_cast<int>(n);
}

std::map<std::string, int> counts_of(const Sheet& sheet) {
    std::map<std::string, int> counts;
    for (const ShadeStyle& style : shade_styles)
        counts[style.name] = static_cast<int>(std::count(sheet.shade.begin(), sheet.shade.end(), style.shade));
    return counts;
}

// ---- what is drawn ----

TEST(CellsPicture, SheetsHoldTheClassesAndContactCellsOfTheGrid) {
    const CommonGrid common = grid_of(roller());
    const Sheet all = common_sheet(common);
    for (int row = 0; row < common.grid.rows; ++row)
        for (int column = 0; column < common.grid.columns; ++column) {
            Shade expected = Shade::outer;
            for (std::size_t p = 0; p < common.parts.size(); ++p) {
                const CellClass c = common.parts[p].at(column, row);
                if (c == CellClass::boundary) expected = Shade::boundary;
                if (c == CellClass::inner && expected == Shade::outer) expected = Shade::inner;
            }
            for (const geometry::ContactCells& contact : common.contacts)
                for (const std::vector<int>& cells : contact.its_case.cells)
                    if (std::count(cells.begin(), cells.end(), row * common.grid.columns + column)) expected = Shade::contact;
            EXPECT_EQ(all.shade[all.box.index(column, row)], expected) << column << " " << row;
        }
    for (const auto& [name, n] : counts_of(all)) EXPECT_GT(n, 0) << name;
}

TEST(CellsPicture, RectanglesAgreeWithTheGrid) {
    const Scene scene = roller();
    const CommonGrid common = grid_of(scene);
    const std::string svg = picture_of(scene);
    EXPECT_EQ(fault_of_xml(svg), "");

    const std::string left = between(svg, "<g class=\"common\">", "</g>");
    const Rect frame = frame_of(paths_of(left, "line")[0]);
    const double pixels = (frame.x1 - frame.x0) / common.grid.columns;
    EXPECT_NEAR((frame.y1 - frame.y0) / common.grid.rows, pixels, 0.01);
    for (const auto& [name, n] : counts_of(common_sheet(common))) {
        EXPECT_EQ(cells_in(left, name, pixels), n) << name;
        EXPECT_NE(svg.find(">" + std::to_string(n) + " " + name + " cells<"), std::string::npos) << name;
    }
}

TEST(CellsPicture, SplitGridsAreDrawnWholeAndApart) {
    const Scene scene = roller();
    const CommonGrid common = grid_of(scene);
    const std::string right = between(picture_of(scene), "<g class=\"split\">", "</g>");
    const std::vector<std::string> lines = paths_of(right, "line");
    ASSERT_EQ(lines.size(), scene.parts.size());
    std::vector<Rect> frames;
    std::map<std::string, int> expected;
    for (std::size_t p = 0; p < lines.size(); ++p) {
        frames.push_back(frame_of(lines[p]));
        for (const auto& [name, n] : counts_of(split_sheet(common, p))) expected[name] += n;
    }
    const double pixels = (frames[0].x1 - frames[0].x0) / common.split[0].columns;
    for (std::size_t p = 0; p < frames.size(); ++p) {
        EXPECT_NEAR(frames[p].x1 - frames[p].x0, pixels * common.split[p].columns, 0.03);
        EXPECT_NEAR(frames[p].y1 - frames[p].y0, pixels * common.split[p].rows, 0.03);
        for (std::size_t q = 0; q < p; ++q) {
            const Rect &a = frames[p], &b = frames[q];
            EXPECT_TRUE(a.x1 < b.x0 || b.x1 < a.x0 || a.y1 < b.y0 || b.y1 < a.y0) << p << " " << q;
        }
    }
    for (const auto& [name, n] : expected) EXPECT_EQ(cells_in(right, name, pixels), n) << name;
    EXPECT_GT(expected["contact"], 0);
    for (const ScenePart& part : scene.parts) EXPECT_NE(right.find("class=\"name\""), std::string::npos) << part.name;
}

TEST(CellsPicture, NamesAreEscaped) {
    Scene scene = roller();
    scene.parts[1].name = "a<b & \"c\">";
    scene.title = "1 < 2 & 3";
    const std::string svg = picture_of(scene);
    EXPECT_EQ(fault_of_xml(svg), "");
    EXPECT_EQ(svg.find("a<b"), std::string::npos);
    EXPECT_NE(svg.find("base - a&lt;b &amp; "), std::string::npos);
    EXPECT_NE(svg.find("<title>Cells of 1 &lt; 2 &amp; 3</title>"), std::string::npos);
}

TEST(CellsPicture, SaysWhenTheCellsAreLargerThanThoseOfTheDetection) {
    const Scene scene = roller();
    EXPECT_EQ(picture_of(scene).find("larger than"), std::string::npos);
    for (const int most : {3, 50, 300}) {
        const std::string svg = picture_of(scene, most);
        EXPECT_NE(svg.find("larger than"), std::string::npos) << most;
        const std::string size = between(svg, "one grid of ", " cells");
        const auto times = size.find(" x ");
        ASSERT_NE(times, std::string::npos);
        const int n = std::stoi(size) * std::stoi(size.substr(times + 3));
        EXPECT_LE(n, most);
        EXPECT_GE(n, most / 3);
    }
}

/// Wide blocks a wide gap apart come together on large cells, but not on those that two small blocks call for.
TEST(CellsPicture, SaysWhereACaseIsAnotherThanInTheTable) {
    const Scene scene = scene_of({{"left", rectangle("left", {0, 0}, {50, 50})},
                                  {"right", rectangle("right", {51, 0}, {100, 50})},
                                  {"chip", rectangle("chip", {10, 50}, {14, 54})}});
    const std::string svg = picture_of(scene);
    EXPECT_NE(svg.find("left - right: case e, no cells come together (case a on the grid of this pair alone"),
              std::string::npos);
    EXPECT_EQ(between(svg, "left - chip: ", "<").find("grid of this pair"), std::string::npos);
}

TEST(CellsPicture, ListsPartsThatComeTogetherWithoutBeingAPair) {
    const Scene scene = scene_of({{"left", rectangle("left", {0, 0}, {10, 10})},
                                  {"right", rectangle("right", {10, 0}, {20, 10})},
                                  {"near", rectangle("near", {0, 10.5}, {10, 20})}});
    const Detection found = detect_contacts(scene, {});
    ASSERT_EQ(found.pairs.size(), 1u);
    const std::string svg = detection_cells_svg(scene, found);
    EXPECT_NE(between(svg, "left - near: case ", "</text>").find("near miss"), std::string::npos);
}

TEST(CellsPicture, IsNoneWithoutPairs) {
    EXPECT_EQ(picture_of(scene_of({})), "");
    EXPECT_EQ(picture_of(scene_of({{"alone", disc({0, 0}, 1)}})), "");
    EXPECT_EQ(picture_of(scene_of({{"here", disc({0, 0}, 1)}, {"there", disc({9, 0}, 1)}})), "");
}

// ---- boxes apart ----

TEST(BoxesApart, EndApartWithTheLargestInPlace) {
    std::mt19937 random(4711);
    std::uniform_real_distribution<double> place(0, 10), size(0.1, 6);
    for (int run = 0; run < 200; ++run) {
        std::vector<Box2> boxes;
        const std::size_t n = 1 + random() % 12;
        const bool concentric = random() % 4 == 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 at = concentric ? Vec2(5, 5) : Vec2(place(random), place(random));
            const Vec2 half = 0.5 * Vec2(size(random), size(random));
            boxes.push_back({at - half, at + half});
        }
        boxes.emplace_back();  // a part without cells
        const double gap = 0.4;
        const std::vector<Vec2> shifts = shifts_apart(boxes, gap);
        ASSERT_EQ(shifts.size(), boxes.size());
        EXPECT_EQ(shifts.back(), Vec2(0, 0));
        std::size_t largest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (boxes[i].size().prod() > boxes[largest].size().prod()) largest = i;
            EXPECT_EQ(shifts[i].cwiseAbs().minCoeff(), 0);  // along an axis
            for (std::size_t k = 0; k < i; ++k) {
                const Box2 a{boxes[i].min + shifts[i], boxes[i].max + shifts[i]};
                const Box2 b{boxes[k].min + shifts[k], boxes[k].max + shifts[k]};
                EXPECT_FALSE(a.overlaps(b, 0.49 * gap)) << run;
            }
        }
        EXPECT_EQ(shifts[largest], Vec2(0, 0));
    }
}

TEST(BoxesApart, WhatIsApartStays) {
    const std::vector<Box2> boxes{{{0, 0}, {1, 1}}, {{2, 0}, {3, 1}}, {{0, 2}, {1, 3}}};
    for (const Vec2& shift : shifts_apart(boxes, 0.5)) EXPECT_EQ(shift, Vec2(0, 0));
    EXPECT_EQ(shifts_apart({{{0, 0}, {4, 4}}, {{1, 3}, {2, 5}}}, 1)[1], Vec2(0, 2));  // upwards is the shortest way
}

}  // namespace
}  // namespace abut::cells_picture_test
