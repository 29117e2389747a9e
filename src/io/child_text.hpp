// SPDX-License-Identifier: GPL-3.0-or-later
// What a copy of this process sends back through a pipe.
#pragma once
#include <functional>
#include <string>

namespace abut::child {

/// The first byte that a child sends; what `done` begins it ends, too.
inline constexpr char done = '+', thrown = '-';

/// In the child: sends what the work gives or throws, and ends the process without destructors.
[[noreturn]] void work_and_end(const std::function<std::string()>& work, int pipe) noexcept;

}  // namespace abut::child
