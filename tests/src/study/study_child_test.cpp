// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_child.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "geometry/foreign/reader_main.hpp"

namespace abut::study_child_test {
namespace {

constexpr double enough = 60;  // seconds

TEST(StudyChild, GivesBackTheTextWhateverItHolds) {
    std::string text;
    for (int k = 0; k < 3000000; ++k) text += static_cast<char>(k * 7 % 256);  // far more than a pipe holds, zeros and all
    const ChildOutcome outcome = in_child([&] { return text; }, enough);
    EXPECT_EQ(outcome.failure, "");
    EXPECT_FALSE(outcome.out_of_time);
    EXPECT_TRUE(outcome.text == text);
    EXPECT_EQ(in_child([] { return std::string(); }, enough).failure, "");
}

TEST(StudyChild, ChangesNothingHere) {
    int touched = 0;
    in_child([&] { return std::to_string(++touched); }, enough);
    EXPECT_EQ(touched, 0);
}

TEST(StudyChild, SaysWhatWasThrown) {
    const ChildOutcome outcome = in_child([]() -> std::string { throw std::runtime_error("no grid"); }, enough);
    EXPECT_EQ(outcome.failure, "no grid");
    EXPECT_EQ(outcome.text, "");
}

TEST(StudyChild, OutlivesItsChildsDeath) {
    const ChildOutcome killed = in_child([]() -> std::string { ::_exit(0); }, enough);
    EXPECT_EQ(killed.failure, "ended without an answer");
    const ChildOutcome ended = in_child(
        []() -> std::string {
            ::raise(SIGKILL);
            return "never";
        },
        enough);
    EXPECT_NE(ended.failure.find("ended by the system"), std::string::npos);
    EXPECT_EQ(ended.text, "");
}

TEST(StudyChild, EndsWhatTakesTooLong) {
    const ChildOutcome outcome = in_child(
        [] {
            for (;;) ::sleep(1);
            return std::string();
        },
        0.05);
    EXPECT_TRUE(outcome.out_of_time);
    EXPECT_NE(outcome.failure, "");
    EXPECT_EQ(outcome.text, "");
}

TEST(StudyChild, TellsThePeakOfTheChildAlone) {
    if (geometry::is_sanitized) GTEST_SKIP() << "shadow memory is a child's, too";
    constexpr std::size_t megabytes = 200;
    const auto fill = [](std::size_t bytes) {
        const std::vector<char> memory(bytes, 1);
        return std::to_string(memory[bytes / 2]);
    };
    const double little = in_child([&] { return fill(1); }, enough).peak_bytes;
    const double much = in_child([&] { return fill(megabytes << 20); }, enough).peak_bytes;
    EXPECT_GT(little, 0);
    EXPECT_NEAR(much - little, static_cast<double>(megabytes << 20), 0.05 * static_cast<double>(megabytes << 20));
    EXPECT_LT(in_child([&] { return fill(1); }, enough).peak_bytes, little + 5e6);  // the large one left no trace
}

}  // namespace
}  // namespace abut::study_child_test
