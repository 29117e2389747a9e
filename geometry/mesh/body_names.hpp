// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <set>
#include <string>

namespace abut::geometry {

/// Unique names for the bodies of one file: `name`, further ones `name#1`, `name#2`, ...; one of several bodies of an object
/// is numbered from `name#0`; bodies without a name are `UNNAMED1`, `UNNAMED2`, ...
class BodyNames {
public:
    explicit BodyNames(std::string unnamed) : unnamed_(std::move(unnamed)) {}
    std::string next(const std::string& base, bool is_one_of_several);

private:
    std::string unnamed_;
    std::map<std::string, int> n_of_name_;
    std::set<std::string> names_;
    int n_unnamed_ = 0;
};

}  // namespace abut::geometry
