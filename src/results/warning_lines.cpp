// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/warning_lines.hpp"

namespace abut {

std::string warning_lines(const std::vector<std::string>& warnings) {
    std::string text;
    const std::size_t n = warnings.size(), shown = n > most_warning_lines ? most_warning_lines - 1 : n;
    for (std::size_t k = 0; k < shown; ++k) text += "warning: " + warnings[k] + "\n";
    if (shown < n) text += "warning: and " + std::to_string(n - shown) + " more, in the report and in result.json\n";
    return text;
}

}  // namespace abut
