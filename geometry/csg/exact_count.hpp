// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>

namespace abut::geometry {

/// How many closed boundaries have gone through exact arithmetic in this process, in whatever thread: those that exact_outline
/// was given to look at and those that exact_regions made. Tests see by it that none went by.
inline std::atomic<long>& n_exact_loops() {
    static std::atomic<long> n{0};
    return n;
}

}  // namespace abut::geometry
