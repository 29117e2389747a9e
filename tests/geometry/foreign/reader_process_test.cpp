// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/reader_process.hpp"

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "geometry/brep/input_error.hpp"
#include "geometry/foreign/reader_main.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::reader_process_test {
namespace {

/// Of little memory, so that the test takes little of it.
const ForeignReader misbehaving{"abut-read-badly", "badlib", "give another file", "build it", 256 << 20, 4, 10, 0};

/// The text that the reader hands over of a file that says `how`.
std::string read(const std::string& how, const ForeignReader& reader = misbehaving, const std::string& word = "a word") {
    const TemporaryFile file("a.bad", how + "\n");
    ReaderProcess process(reader, file.path(), {word});
    RecordReader& records = process.records();
    EXPECT_EQ(records.kind(), begin_record);
    std::string text;
    for (char kind = records.kind(); kind != end_record; kind = records.kind()) text += records.text();
    return text;
}

std::string refusal(const std::string& how, const ForeignReader& reader = misbehaving) {
    try {
        read(how, reader);
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 1u);
        EXPECT_NE(error.problems().front().where.find("a.bad"), std::string::npos);
        EXPECT_FALSE(error.problems().front().hint.empty());
        return one_line(error.problems().front());
    }
    return "";
}

void expect_refusal(const std::string& how, const std::string& words, const ForeignReader& reader = misbehaving) {
    const std::string said = refusal(how, reader);
    EXPECT_NE(said.find(words), std::string::npos) << how << ": " << said;
}

int n_open_files() {
    int n = 0;
    DIR* folder = ::opendir("/proc/self/fd");
    while (::readdir(folder) != nullptr) ++n;
    ::closedir(folder);
    return n;
}

TEST(ReaderProcess, HandsOverWhatWasRead) {
    EXPECT_EQ(read("behave"), "a word");
    EXPECT_EQ(read("talk"), "a word") << "what libraries print is not among the records";
    const std::string long_word(100000, 'x');  // more than a pipe holds
    EXPECT_EQ(read("behave", misbehaving, long_word), long_word);
}

TEST(ReaderProcess, AReaderThatBreaksIsOneSentence) {
    expect_refusal("crash", "badlib, which reads files of this kind, broke down at this one (Aborted); give another file");
    expect_refusal("late", "broke down");
    ForeignReader hasty = misbehaving;
    hasty.seconds = 1;
    expect_refusal("loop", "comes to no end with this one in 1 s", hasty);
    if (!is_sanitized) expect_refusal("eat", "needs more memory for this one than it may have, 256 MB at most");
    expect_refusal("garble", "answered nonsense");
    expect_refusal("leave", "does not run");
    expect_refusal("throw", "a library's own words");
    expect_refusal("refuse", "the file is no good; make a better one");
}

TEST(ReaderProcess, OneThatSleepsIsNotWaitedForForEver) {
    const auto begin = std::chrono::steady_clock::now();
    ForeignReader impatient = misbehaving;
    impatient.seconds = 0;  // no processor time to speak of, and none by the clock
    EXPECT_NE(refusal("sleep", impatient).find("said nothing of this one for"), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(ReaderProcess, AMissingProgramIsSaid) {
    ForeignReader missing = misbehaving;
    missing.program = "abut-read-nothing";
    EXPECT_NE(refusal("behave", missing).find("abut-read-nothing"), std::string::npos);
}

TEST(ReaderProcess, NothingIsLeftOfIt) {
    refusal("crash");
    const int before = n_open_files();
    for (const char* how : {"behave", "crash", "garble", "refuse"}) {
        try {
            read(how);
        } catch (const InputError&) {}
    }
    {
        const TemporaryFile file("a.bad", "sleep\n");
        const ReaderProcess unread(misbehaving, file.path(), {});
    }
    EXPECT_EQ(n_open_files(), before);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
}

TEST(ReaderProcess, ManyReadAtOnce) {
    std::vector<std::thread> threads;
    std::array<std::string, 8> texts;
    for (std::size_t k = 0; k < texts.size(); ++k)
        threads.emplace_back([&texts, k] {
            ReaderProcess process(misbehaving, "/dev/null", {std::to_string(k)});
            process.records().kind();
            process.records().kind();
            texts[k] = process.records().text();
        });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t k = 0; k < texts.size(); ++k) EXPECT_EQ(texts[k], std::to_string(k));
}

TEST(ReaderProcess, LimitsGrowWithTheFile) {
    const ForeignReader reader{"p", "l", "h", "a", 1 << 20, 3, 10, 0.5};
    const ReaderLimits small = limits_of(reader, 0), large = limits_of(reader, 100 << 20);
    EXPECT_EQ(small.memory_bytes, 1u << 20);
    EXPECT_EQ(small.processor_seconds, 10u);
    EXPECT_EQ(large.memory_bytes, 301u << 20);
    EXPECT_EQ(large.processor_seconds, 60u);
    EXPECT_GT(large.idle_seconds, large.processor_seconds);
}

}  // namespace
}  // namespace abut::geometry::reader_process_test
