// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

namespace abut {

struct AnalyzeOptions {
    std::function<void(const std::string&)> progress{};  ///< told what is being done; may be empty
    /// The most threads; 0: one for each processor. The answer is the same for any number.
    int threads = 0;
};

}  // namespace abut
