// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace abut::fuzz {

/// libFuzzer keeps the input that led to an abort.
inline void trap_on(const std::string& fault) {
    if (fault.empty()) return;
    std::fprintf(stderr, "fault: %s\n", fault.c_str());
    std::abort();
}

}  // namespace abut::fuzz
