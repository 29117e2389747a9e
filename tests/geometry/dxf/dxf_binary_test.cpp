// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "geometry/brep/input_error.hpp"
#include "geometry/dxf/dxf.hpp"
#include "geometry/dxf/dxf_groups.hpp"
#include "tests/geometry/dxf/dxf_text.hpp"

namespace abut::geometry::dxf_binary_test {
namespace {

const std::string sentinel("AutoCAD Binary DXF\r\n\x1a\0", 22);
const std::string messy = std::string(ABUT_SOURCE_DIR) + "/../shared/inputs/generated/messy/";

std::string little_endian(std::uint64_t value, int n_bytes) {
    std::string bytes;
    for (int i = 0; i < n_bytes; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

std::string integer_bytes(const std::string& value, int n_bytes) {
    return little_endian(static_cast<std::uint64_t>(std::stoll(value)), n_bytes);
}

/// The value of a group as the DXF reference's table of types says; only the codes that the tests write.
std::string value_bytes(int code, const std::string& value) {
    const bool is_real = (code >= 10 && code < 60) || (code >= 140 && code < 150) || (code >= 210 && code < 240);
    if (is_real) return little_endian(std::bit_cast<std::uint64_t>(std::stod(value)), 8);
    if ((code >= 60 && code < 80) || (code >= 170 && code < 180) || code == 1070) return integer_bytes(value, 2);
    if (code >= 90 && code < 100) return integer_bytes(value, 4);
    if (code >= 160 && code < 170) return integer_bytes(value, 8);
    if (code >= 290 && code < 300) return integer_bytes(value, 1);
    if (code == 310 || code == 1004) return static_cast<char>(value.size()) + value;
    return value + std::string(1, '\0');
}

/// The same groups as binary DXF: codes of one byte (R12) or of two.
std::string as_binary(const std::string& text, bool short_codes) {
    std::istringstream lines(text);
    std::string bytes = sentinel;
    for (std::string code_line, value; std::getline(lines, code_line) && std::getline(lines, value);) {
        const int code = std::stoi(code_line);
        const auto unsigned_code = static_cast<std::uint64_t>(code);
        if (short_codes)
            bytes += code < 255 ? little_endian(unsigned_code, 1) : "\xFF" + little_endian(unsigned_code, 2);
        else
            bytes += little_endian(unsigned_code, 2);
        bytes += value_bytes(code, value);
    }
    return bytes;
}

/// What a drawing holds, but for lines of the file and what is named after them.
std::string contents(const Drawing& drawing) {
    std::ostringstream text;
    text.precision(17);
    text << drawing.unit << "\n";
    for (const SketchEntity& e : drawing.entities) {
        text << e.kind << " " << e.layer << " " << e.color << " " << e.block << " " << e.instance;
        for (const double t : {0.0, 0.3, 1.0}) text << " " << point(e.curve, t).transpose();
        text << "\n";
    }
    for (const auto& [type, count] : drawing.counts) text << type << " " << count.read << " " << count.used << "\n";
    for (const Ignored& i : drawing.ignored) text << i.what << " " << i.count << " " << i.why << "\n";
    return text.str();
}

/// With values of all types: extended data, a long integer, a flag, a picture's bytes.
std::string sample() {
    std::string text = dxf_of_every_kind();
    const std::string others = "999\na comment\n160\n-5000000000\n290\n1\n310\n\x01\x02\xFF\n1070\n-7\n1004\nabc\n1000\ntext\n";
    text.insert(text.find("0\nENDSEC", text.find("ENTITIES")), others);
    return text;
}

TEST(DxfBinary, ReadsTheSameAsAscii) {
    const Drawing ascii = read_drawing(sample());
    ASSERT_GT(ascii.entities.size(), 10u);
    for (const bool short_codes : {true, false}) {
        const Drawing binary = read_drawing(as_binary(sample(), short_codes));
        EXPECT_EQ(contents(binary), contents(ascii)) << short_codes;
        EXPECT_EQ(binary.format, "binary DXF");
        const Drawing commented = read_drawing(as_binary("999\na comment first\n" + sample(), short_codes));
        EXPECT_EQ(contents(commented), contents(ascii)) << short_codes;
    }
}

TEST(DxfBinary, NamesEntitiesByByteWithoutHandles) {
    const std::string bytes = as_binary(dxf_file(dxf_line("", "A", 0, 0, 1, 0) + dxf_line("2f", "A", 0, 0, 1, 0)), false);
    const Drawing drawing = read_drawing(bytes);
    ASSERT_EQ(drawing.entities.size(), 2u);
    const auto at = static_cast<std::size_t>(drawing.entities[0].line);
    EXPECT_EQ(bytes.substr(at, 7), std::string("\0\0LINE\0", 7));
    EXPECT_EQ(drawing.entities[0].name, "b" + std::to_string(at));
    EXPECT_EQ(drawing.entities[1].name, "h2F");
}

TEST(DxfBinary, KeepsEveryBitOfNumbers) {
    std::mt19937_64 random(5);
    std::string bytes = sentinel;
    std::vector<double> numbers;
    while (numbers.size() < 1000) {
        const std::uint64_t bits = random();
        const double number = std::bit_cast<double>(bits);
        if (!std::isfinite(number)) continue;
        numbers.push_back(number);
        bytes += little_endian(10, 2) + little_endian(bits, 8);
    }
    const dxf::Groups groups = dxf::split_groups("a.dxf", bytes);
    ASSERT_EQ(groups.groups.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        double number = 0;
        ASSERT_TRUE(dxf::parse_number(groups.groups[i].value, number));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(number), std::bit_cast<std::uint64_t>(numbers[i]));
    }
}

TEST(DxfBinary, ReadsNamesInBothEncodings) {
    for (const char* name : {"Tr\xC3\xA4ger", "Tr\xE4ger", "Tr\\U+00E4ger"})
        EXPECT_EQ(read_drawing(as_binary(dxf_file(dxf_line("1", name, 0, 0, 1, 0)), false)).entities.at(0).layer,
                  "Tr\xC3\xA4ger");
}

TEST(DxfBinary, EveryTruncationIsAnError) {
    for (const bool short_codes : {true, false}) {
        const std::string bytes = as_binary(sample(), short_codes);
        for (std::size_t n = 1; n < bytes.size(); ++n)
            EXPECT_THROW(read_drawing(bytes.substr(0, n)), InputError) << n << " of " << bytes.size();
    }
}

Problem refusal(const std::string& bytes) {
    try {
        read_drawing(bytes);
    } catch (const InputError& error) { return error.problems().at(0); }
    return {};
}

TEST(DxfBinary, SaysAtWhichByteItFails) {
    const std::string bytes = as_binary(dxf_file(dxf_line("1", "A", 0, 0, 1, 0)), false);
    const Problem truncated = refusal(bytes.substr(0, bytes.size() - 30));
    EXPECT_NE(truncated.what.find("truncated"), std::string::npos) << truncated.what;
    EXPECT_NE(truncated.where.find("test.dxf, byte "), std::string::npos) << truncated.where;
    const Problem unknown =
        refusal(sentinel + little_endian(0, 2) + "SECTION" + std::string(1, '\0') + little_endian(777, 2) + "x");
    EXPECT_NE(unknown.what.find("777"), std::string::npos) << unknown.what;
    EXPECT_EQ(unknown.where, "test.dxf, byte 32");
}

void read_damaged(const std::string& good, int n, std::mt19937& random) {
    std::string damaged = good;
    for (int k = 0; k < n; ++k) damaged[22 + random() % (damaged.size() - 22)] = static_cast<char>(random());
    try {
        for (const SketchEntity& entity : read_drawing(damaged).entities) EXPECT_TRUE(is_finite(entity.curve));
    } catch (const InputError&) {}
}

TEST(DxfBinary, SurvivesDamagedFiles) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) read_damaged(as_binary(sample(), i % 2 == 0), 3, random);
}

TEST(LongDxfBinary, SurvivesDamagedFiles) {
    std::mt19937 random(4);
    for (int i = 0; i < 10'000; ++i) read_damaged(as_binary(sample(), i % 2 == 0), 1 + i % 5, random);
}

TEST(DxfBinary, ReadsWhatOtherProgramsWrite) {
    if (!std::filesystem::exists(messy)) GTEST_SKIP() << "no folder of real inputs";
    const Drawing ascii = read_dxf(std::string(ABUT_SOURCE_DIR) + "/data/sketches/pin_bracket_r14.dxf");
    for (const char* name : {"r12_binary.dxf", "r2018_binary.dxf"}) {
        const Drawing binary = read_dxf(messy + name);
        ASSERT_EQ(binary.entities.size(), ascii.entities.size());
        for (std::size_t i = 0; i < ascii.entities.size(); ++i) {
            EXPECT_EQ(binary.entities[i].layer, ascii.entities[i].layer);
            for (const double t : {0.0, 0.4, 1.0})
                EXPECT_LE((point(binary.entities[i].curve, t) - point(ascii.entities[i].curve, t)).norm(), 1e-12 * 100);
        }
    }
}

}  // namespace
}  // namespace abut::geometry::dxf_binary_test
