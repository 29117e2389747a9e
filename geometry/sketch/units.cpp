// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>

#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

namespace {

/// Nanometres: factors between the units are then ratios of integers (but for those of US surveys), exact or rounded once. A US
/// survey foot is 1200/3937 m.
double nanometres(const std::string& unit) {
    static const std::map<std::string, double> sizes{
        {"nm", 1},
        {"um", 1e3},
        {"mm", 1e6},
        {"cm", 1e7},
        {"dm", 1e8},
        {"m", 1e9},
        {"dam", 1e10},
        {"hm", 1e11},
        {"km", 1e12},
        {"uin", 25.4},
        {"mil", 25.4e3},
        {"in", 25.4e6},
        {"ft", 304.8e6},
        {"yd", 914.4e6},
        {"mi", 1609.344e9},
        {"in_us", 100e9 / 3937},
        {"ft_us", 1200e9 / 3937},
        {"yd_us", 3600e9 / 3937},
        {"mi_us", 5280 * 1200e9 / 3937},
    };
    const auto found = sizes.find(unit);
    return found == sizes.end() ? 0.0 : found->second;
}

}  // namespace

double unit_factor(const std::string& from, const std::string& to) {
    const double numerator = nanometres(from), denominator = nanometres(to);
    return denominator == 0 ? 0.0 : numerator / denominator;
}

}  // namespace abut::geometry
