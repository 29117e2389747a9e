// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a record, with what is wrong with them.
#pragma once
#include <string>

#include "geometry/curves/vec2.hpp"
#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// Coordinates beyond this are damage, not drawing: their squares would eat all digits of anything else.
inline constexpr double largest_coordinate = 1e12;

/// Takes numbers out of groups; the first fault is kept, and whatever is read after it means nothing.
class Numbers {
public:
    explicit Numbers(const Record& record) : record_(record) {}

    double of(const Group& group);
    /// The number of the first group with the code; without such a group a fault, or `missing` where that is given.
    double operator()(int code);
    double operator()(int code, double missing);
    Vec2 point(int x_code) { return {(*this)(x_code), (*this)(x_code + 10)}; }

    void fail(const std::string& wrong);
    bool is_good() const { return wrong_.empty(); }
    /// "group 21 is missing"; empty if nothing is wrong.
    const std::string& wrong() const { return wrong_; }

private:
    const Record& record_;
    std::string wrong_;
};

}  // namespace abut::geometry::dxf
