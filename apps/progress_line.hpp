// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// One line on standard error that each message replaces, and that is wiped at the end. Silent where standard error is no
/// terminal.
class ProgressLine {
public:
    explicit ProgressLine(bool wanted);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();

    void show(const std::string& message);
    void wipe();

private:
    bool active_;
    bool shown_ = false;
};

}  // namespace abut
