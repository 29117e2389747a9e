// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>

#include "geometry/sketch.hpp"

namespace abut::geometry {

namespace {

/// Nanometres: all factors between the units are then ratios of integers, exact or rounded once.
double nanometres(const std::string& unit) {
    static const std::map<std::string, double> sizes{{"um", 1e3},    {"mm", 1e6},     {"cm", 1e7},     {"m", 1e9},
                                                     {"in", 25.4e6}, {"ft", 304.8e6}, {"mil", 25.4e3}, {"dm", 1e8},
                                                     {"km", 1e12},   {"yd", 914.4e6}};
    const auto found = sizes.find(unit);
    return found == sizes.end() ? 0.0 : found->second;
}

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
    const double numerator = nanometres(from), denominator = nanometres(to);
    return denominator == 0 ? 0.0 : numerator / denominator;
}

}  // namespace abut::geometry
