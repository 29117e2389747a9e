// SPDX-License-Identifier: GPL-3.0-or-later
// The check of what a function is owed by other parts of the program.
#pragma once
#include <stdexcept>
#include <string>

namespace abut {

/// What ENSURE does where its condition does not hold.
[[noreturn]] inline void report_broken(const std::string& sentence, const char* condition, const char* file, int line) {
    throw std::logic_error(sentence + " (" + condition + ", " + file + ":" + std::to_string(line) + ")");
}

}  // namespace abut

/// Throws std::logic_error with the sentence, the condition and its place where the condition does not hold. It is never
/// switched off, so it stands where rooms meet and not in inner loops. Its failure is a bug of ours: a user's mistake is an
/// InputError, and an analysis that does not work out is a value. The sentence is made only where it is needed.
#define ENSURE(condition, sentence) \
    (static_cast<bool>(condition) ? static_cast<void>(0) : ::abut::report_broken(sentence, #condition, __FILE__, __LINE__))
