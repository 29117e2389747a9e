// SPDX-License-Identifier: GPL-3.0-or-later
// The other side of reader_process.hpp: the body of a program that reads one file with another library.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "geometry/foreign/record_stream.hpp"

namespace abut::geometry {

/// The exit status of a reader that was refused memory.
inline constexpr int exit_no_memory = 3;

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// Reads the file and writes its records; what is thrown becomes the failure record.
using ReadFile = std::function<void(const std::string& file, const std::vector<std::string>& words, RecordWriter& records)>;

/// Takes the limits upon itself, and calls `read` between the first and the last record, which go to standard output; what
/// libraries print goes nowhere. Words: PROGRAM MEMORY SECONDS FILE WORDS... The process ends without destructors: those of
/// damaged objects could break what was read.
[[noreturn]] void run_reader(int argc, char** argv, const ReadFile& read);

}  // namespace abut::geometry
