// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities of a study as short text.
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/study/study_prices.hpp"

namespace abut {

std::string duration_text(double seconds) {
    if (!(seconds < 0.9995)) return number_text(seconds, seconds < 100 ? 2 : 3) + " s";
    return number_text(1e3 * seconds, seconds < 0.0995 ? 2 : 3) + " ms";
}

std::string count_text(double count) {
    if (count < 999.5) return number_text(count, 3);
    return count < 999500 ? number_text(count / 1e3, 3) + "k" : number_text(count / 1e6, 3) + "M";
}

std::string memory_text(double bytes) {
    return bytes < 999.5e6 ? number_text(bytes / 1e6, 3) + " MB" : number_text(bytes / 1e9, 3) + " GB";
}

}  // namespace abut
