// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/step/step_records.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry::step_records_test {
namespace {

std::string written() {
    std::string bytes;
    RecordWriter writer([&bytes](std::string_view portion) { bytes += portion; });
    StepRecords records(writer);
    writer.kind(begin_record);
    records.unit("in");
    records.plane("x = 3");
    records.body("plate");
    records.curve(Segment{{0, 1}, {2, 3}});
    records.curve(Arc{{1, 2}, 3, 0.5, -1});
    records.curve(EllipticArc{{1, 2}, {3, 0}, {0, 2}, 0.5, 1});
    records.curve(Nurbs{2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 1}, {2, 0}}, {1, 0.5, 1}});
    records.missed_body("lid", "it is elsewhere");
    records.repair({"something was guessed", {4, 5}, 6});
    records.ignore("surface of lid", "bounds no solid");
    records.problem("something is wrong", "plate", "do something");
    writer.kind(end_record);
    writer.flush();
    return bytes;
}

Drawing read(const std::string& bytes) {
    std::size_t at = 0;
    RecordReader reader("a.step", [&](char* to, std::size_t n) {
        if (n > bytes.size() - at) throw InputError("a.step", "it ends too early");
        std::memcpy(to, bytes.data() + at, n);
        at += n;
    });
    Drawing drawing;
    read_step_records(reader, drawing);
    return drawing;
}

TEST(StepRecords, ArriveAsTheyWere) {
    const Drawing drawing = read(written());
    EXPECT_EQ(drawing.unit, "in");
    EXPECT_EQ(drawing.cut_at, "x = 3");
    ASSERT_EQ(drawing.entities.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(drawing.entities[k].layer, "plate");
        EXPECT_EQ(drawing.entities[k].name, "e" + std::to_string(k));
        EXPECT_EQ(drawing.entities[k].curve.index(), k);
    }
    EXPECT_EQ(std::get<Segment>(drawing.entities[0].curve).to, Vec2(2, 3));
    EXPECT_EQ(std::get<Arc>(drawing.entities[1].curve).sweep, -1);
    EXPECT_EQ(std::get<EllipticArc>(drawing.entities[2].curve).b, Vec2(0, 2));
    EXPECT_TRUE(std::get<Spline>(drawing.entities[3].curve).shape->rational);
    EXPECT_EQ(drawing.counts.at("solid").read, 2);
    EXPECT_EQ(drawing.counts.at("solid").used, 1);
    EXPECT_EQ(drawing.counts.at("solid").ignored, 1);
    ASSERT_EQ(drawing.repairs.size(), 1u);
    EXPECT_EQ(drawing.repairs[0].size, 6);
    ASSERT_EQ(drawing.ignored.size(), 2u);
    ASSERT_EQ(drawing.problems.size(), 1u);
    EXPECT_EQ(drawing.problems[0].entity, "plate");
}

TEST(StepRecords, WhatWasOverwrittenIsRefusedOrFinite) {
    const std::string whole = written();
    for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_THROW(read(whole.substr(0, n)), InputError) << n;
    std::mt19937 random(5);
    int n_refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = whole;
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        try {
            for (const SketchEntity& entity : read(bytes).entities) EXPECT_TRUE(is_finite(entity.curve));
        } catch (const InputError&) { ++n_refused; }
    }
    EXPECT_GT(n_refused, 100);
}

}  // namespace
}  // namespace abut::geometry::step_records_test
