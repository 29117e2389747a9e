// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace abut {

/// A parameter of a scene that says how far it may be moved, in the scene's units.
struct ParameterRange {
    std::string name;
    double value = 0, least = 0, most = 0;  ///< least < most; the value is within
    std::string where;                      ///< JSON pointer
};

/// The parameters of a scene's file that have a "min" and a "max", in the file's order. Throws InputError where the file cannot
/// be read, or where a parameter is wrong.
std::vector<ParameterRange> parameter_ranges(const std::string& path);

}  // namespace abut
