// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace abut {

/// More than a terminal should show: the first of them, and how many more there are.
inline constexpr std::size_t most_warning_lines = 7;

/// Warnings for a terminal, a line each, at most so many.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace abut
