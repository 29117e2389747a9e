// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/progress_line.hpp"

#include <unistd.h>

#include <iostream>

namespace abut {

namespace {
constexpr const char* clear_line = "\r\033[K";
constexpr std::size_t longest_message = 78;  // a wrapped line could not be wiped
}  // namespace

ProgressLine::ProgressLine(bool wanted) : active_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    wipe();
}

void ProgressLine::show(const std::string& message) {
    if (!active_) return;
    std::cerr << clear_line << message.substr(0, longest_message) << std::flush;
    shown_ = true;
}

void ProgressLine::wipe() {
    if (shown_) std::cerr << clear_line << std::flush;
    shown_ = false;
}

}  // namespace abut
