// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curves/written_digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::geometry {

namespace {

/// A number of digits tells how well numbers are known if it is more than sizes are given with: to this fraction of all there
/// is.
constexpr double most_written_fraction = 1e-4;

double known_to(double rounding, double size) {
    return rounding <= most_written_fraction * size ? rounding : 0;
}

}  // namespace

double last_digit(const std::vector<double>& numbers) {
    constexpr int most_decimals = 6;
    constexpr std::ptrdiff_t one_in = 10;  // a line or two that were drawn besides say nothing of the others
    double scale = 1;
    for (int k = 0; k <= most_decimals && !numbers.empty(); ++k, scale *= 10) {
        const auto is_written = [&](double x) {
            constexpr double of_digit = 1e-6;
            const double scaled = std::abs(x) * scale, away = std::abs(scaled - std::round(scaled));
            return away <= of_digit + 4 * std::numeric_limits<double>::epsilon() * scaled;
        };
        const std::ptrdiff_t written = std::count_if(numbers.begin(), numbers.end(), is_written);
        if (one_in * (std::ssize(numbers) - written) <= std::ssize(numbers)) return 1 / scale;
    }
    return 0;
}

double written_rounding(const std::vector<Vec2>& points, double size) {
    std::vector<double> numbers;
    for (const Vec2& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
    return known_to(std::sqrt(0.5) * last_digit(numbers), size);
}

double written_rounding(const std::vector<double>& lengths, double size) {
    return known_to(0.5 * last_digit(lengths), size);
}

}  // namespace abut::geometry
