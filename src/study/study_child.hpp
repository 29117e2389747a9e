// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own: its memory can be told, and it can be ended.
#pragma once
#include <functional>
#include <string>

namespace abut {

/// What a child process gave back, or why it gave nothing.
struct ChildOutcome {
    std::string text;     ///< what the work gave; empty where it did not end well
    std::string failure;  ///< why not
    bool out_of_time = false;
    double peak_bytes = 0;  ///< largest resident size
};

/// Runs `work` in a copy of this process and gives back its text. What it throws is a failure, as is its death. Ended after so
/// many seconds. Cost: about a millisecond. The work sees this process' memory, and changes nothing in it.
ChildOutcome in_child(const std::function<std::string()>& work, double limit_seconds);

}  // namespace abut
