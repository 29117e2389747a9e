// SPDX-License-Identifier: GPL-3.0-or-later
// What a user lets an analysis take: time, memory or both.
#pragma once
#include <optional>
#include <string>

namespace abut {

/// Bounds; unset: none of the user's.
struct Budget {
    std::optional<double> seconds;  ///< of the way over grids
    std::optional<double> bytes;    ///< at its peak
    bool is_given() const { return seconds || bytes; }
};

/// Reads "30 s", "2 GB", "5 min, 500 MB": s, min or h, and MB or GB, each kind once. Throws InputError, where left empty.
Budget parse_budget(const std::string& text);

}  // namespace abut
