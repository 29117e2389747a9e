// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/packed_field.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>

#include "src/report/page_data.hpp"
#include "tests/src/results/synthetic_result.hpp"

namespace abut::packed_field_test {
namespace {

using report::PackedField;

/// As src/report/web/data.js reads them.
std::vector<std::int64_t> integers(const std::string& text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (char c : text) {
        if (c == '=') break;
        group = group << 6 | static_cast<std::uint32_t>(letters.find(c));
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(group >> bits & 0xff));
    }
    std::vector<std::int64_t> list;
    std::uint64_t value = 0;
    int shift = 0;
    for (std::uint8_t byte : bytes) {
        value |= static_cast<std::uint64_t>(byte & 127) << shift;
        shift += 7;
        if (byte > 127) continue;
        list.push_back(value % 2 ? -static_cast<std::int64_t>(value / 2) - 1 : static_cast<std::int64_t>(value / 2));
        value = 0;
        shift = 0;
    }
    return list;
}

struct Sample {
    Vec2 at;
    std::array<double, 6> value;
};

std::vector<Sample> samples(const PackedField& field, const std::string& packed) {
    const std::vector<std::int64_t> differences = integers(packed);
    std::array<std::int64_t, 8> now{};
    std::vector<Sample> list;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        now[i % 8] += differences[i];
        if (i % 8 != 7) continue;
        Sample s{field.origin + field.step * Vec2(static_cast<double>(now[0]), static_cast<double>(now[1])), {}};
        for (std::size_t c = 0; c < 6; ++c)
            s.value[c] = now[2 + c] == -32768 ? std::numeric_limits<double>::quiet_NaN()
                                              : static_cast<double>(now[2 + c]) / 32767 * field.scale[c];
        list.push_back(s);
    }
    return list;
}

std::array<double, 6> components(const FieldSample& s) {
    return {s.displacement.x(), s.displacement.y(), s.stress.xx, s.stress.yy, s.stress.xy, s.stress.zz};
}

TEST(PackedField, PatchesHaveTheirSamplesToSixteenBits) {
    const Result r = synthetic::bracket();
    const PartField& field = r.fields[0];
    const PackedField packed = report::packed_field(field, r.geometry[0]);
    const std::vector<Sample> list = samples(packed, packed.samples);
    const std::vector<std::int64_t> patches = integers(packed.patches);
    ASSERT_EQ(patches.size(), 4 * field.patches.size());
    std::int64_t first = 0;
    for (std::size_t p = 0; p < field.patches.size(); ++p) {
        first += patches[4 * p];
        for (std::size_t i = 0; i < 4; ++i) {
            const auto k = static_cast<std::size_t>(i == 0 ? first : first + patches[4 * p + i]);
            ASSERT_LT(k, list.size());
            const FieldSample& exact = field.samples[static_cast<std::size_t>(field.patches[p].corner[i])];
            EXPECT_LT((list[k].at - exact.at).norm(), 1e-6 * 128);
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_NEAR(list[k].value[c], components(exact)[c], 2 * packed.scale[c] / 32767);
        }
    }
    for (std::size_t k = 0; k < list.size(); ++k)
        EXPECT_EQ(k < packed.n_inside, geometry::contains(r.geometry[0], list[k].at)) << list[k].at.transpose();
}

TEST(PackedField, NeighboursShareSamplesButNotAcrossASlot) {
    geometry::Part part = synthetic::rectangle("p", {0, 0}, {2, 1});
    PartField field;
    const auto add_cell = [&](double x, double stress) {
        const int k = static_cast<int>(field.samples.size());
        for (const Vec2& at : {Vec2(x, 0), Vec2(x + 1, 0), Vec2(x + 1, 1), Vec2(x, 1)})
            field.samples.push_back({at, {0, 0}, {stress, 0, 0, 0}});
        field.patches.push_back({{k, k + 1, k + 2, k + 3}});
    };
    add_cell(0, 1);
    add_cell(1, 1);
    PackedField packed = report::packed_field(field, part);
    EXPECT_EQ(samples(packed, packed.samples).size(), 6u);
    field.samples[4].stress.xx = field.samples[7].stress.xx = -1;
    packed = report::packed_field(field, part);
    EXPECT_EQ(samples(packed, packed.samples).size(), 8u);
}

TEST(PackedField, WhatIsNotFiniteStaysSoAndPartsWithoutFieldHaveTheirOutline) {
    Result r = synthetic::bracket();
    r.fields[1].samples[0].stress.xx = std::numeric_limits<double>::infinity();
    r.fields[1].samples[0].displacement.x() = std::numeric_limits<double>::quiet_NaN();
    const PackedField packed = report::packed_field(r.fields[1], r.geometry[1]);
    int broken = 0;
    for (const Sample& s : samples(packed, packed.samples)) broken += std::isnan(s.value[0]) && std::isnan(s.value[2]);
    EXPECT_EQ(broken, 1);
    const PackedField bare = report::packed_field({}, r.geometry[0]);
    EXPECT_EQ(bare.samples, "");
    ASSERT_EQ(bare.loop_sizes.size(), 2u);
    const std::vector<Sample> outline = samples(bare, bare.loops);
    EXPECT_EQ(outline.size(), bare.loop_sizes[0] + bare.loop_sizes[1]);
    EXPECT_EQ(bare.loop_sizes[0], 4u);
    for (std::size_t i = 4; i < outline.size(); ++i) EXPECT_NEAR((outline[i].at - Vec2(0, 60)).norm(), 20, 1e-4);
}

TEST(PageData, HoldsNothingThatEndsAScriptAndTheNumbersOfTheResult) {
    Result r = synthetic::bracket();
    r.parts[0].name = "</script><b>&";
    r.parts[0].max_von_mises.value = 0.1 + 0.2;
    const std::string text = report::page_data(r, {});
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(text.find('&'), std::string::npos);
    EXPECT_NE(text.find("0.30000000000000004"), std::string::npos);
}

}  // namespace
}  // namespace abut::packed_field_test
