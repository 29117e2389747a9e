// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_numbers.hpp"

#include <cmath>

namespace abut::geometry::dxf {

void Numbers::fail(const std::string& wrong) {
    if (wrong_.empty()) wrong_ = wrong;
}

double Numbers::of(const Group& group) {
    double number = 0;
    const bool is_number = parse_number(group.value, number);
    if (is_number && std::abs(number) <= largest_coordinate) return number;
    fail("group " + std::to_string(group.code) + " is '" + std::string(group.value.substr(0, 40)) + "', which is no " +
         (is_number ? "sensible size" : "number"));
    return 0;
}

double Numbers::operator()(int code) {
    if (const Group* group = record_.find(code)) return of(*group);
    fail("group " + std::to_string(code) + " is missing");
    return 0;
}

double Numbers::operator()(int code, double missing) {
    const Group* group = record_.find(code);
    return group ? of(*group) : missing;
}

}  // namespace abut::geometry::dxf
