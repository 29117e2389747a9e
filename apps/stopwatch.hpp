// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>

namespace abut {

/// A clock that tells the seconds of wall time since it was made.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace abut
