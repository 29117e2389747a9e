// SPDX-License-Identifier: GPL-3.0-or-later
// Files that other libraries read, in a process of its own for each file: whatever a file does to such a library (a crash, a
// loop without end, all the memory there is) costs that process, and one sentence.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/foreign/record_stream.hpp"

namespace abut::geometry {

/// A program that reads files of some kind with another library, and what it may take.
struct ForeignReader {
    std::string program;  ///< its name, "abut-read-mesh"
    std::string library;  ///< for messages: "assimp"
    std::string hint;     ///< what to do with a file that it cannot bear
    std::string absence;  ///< what to do where there is no such program
    // What files within the program's limits were seen to take, several times over.
    std::uint64_t memory_bytes = 0;  ///< whatever the size of the file
    std::uint64_t memory_per_byte = 0;
    double seconds = 0;  ///< of processor time, whatever the size of the file
    double seconds_per_megabyte = 0;
};

/// Memory and time of one file.
struct ReaderLimits {
    std::uint64_t memory_bytes = 0;  ///< of its address space
    unsigned processor_seconds = 0;
    unsigned idle_seconds = 0;  ///< by the clock, until it hands the next thing over
};
ReaderLimits limits_of(const ForeignReader& reader, std::uintmax_t file_bytes);

/// The path of a program that reads files: in ../libexec/abut beside the running program, else where it was built; empty where
/// it is in neither.
std::string reader_path(const std::string& program);

/// A reader at work on one file. It is ended with this object.
class ReaderProcess {
public:
    /// Starts it: PROGRAM MEMORY SECONDS FILE WORDS... Throws InputError where there is no such program.
    ReaderProcess(const ForeignReader& reader, const std::string& file, const std::vector<std::string>& words);
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    /// What it hands over. Its functions throw InputError, in one sentence, where the process ends before it has handed over
    /// what is asked for, or takes more than its limits.
    RecordReader& records() { return records_; }

private:
    void receive(char* bytes, std::size_t n);
    void fill();
    [[noreturn]] void fail();
    [[noreturn]] void refuse(const std::string& what) const;
    int end();

    ForeignReader reader_;
    std::string file_, path_;
    ReaderLimits limits_;
    int process_ = -1, pipe_ = -1;
    std::string buffer_;
    std::size_t taken_ = 0;
    RecordReader records_;
};

}  // namespace abut::geometry
