// SPDX-License-Identifier: GPL-3.0-or-later
// Names of records.
#pragma once
#include <charconv>
#include <cstdint>
#include <string>
#include <unordered_set>

#include "geometry/dxf/dxf_prepass.hpp"

namespace abut::geometry::dxf {

/// Gives each record a name that no other has: the handle, or the place where there is none or the file gives it twice.
class Names {
public:
    explicit Names(bool is_binary) : place_letter_(is_binary ? "b" : "l") {}

    std::string of(const Record& record) {
        const std::string handle = upper_case(record.text(5));
        std::uint64_t number = 0;
        const char* end = handle.data() + handle.size();
        const auto [ptr, error] = std::from_chars(handle.data(), end, number, 16);
        const bool is_usable = !handle.empty() && error == std::errc() && ptr == end;
        return is_usable && handles_.insert(number).second ? "h" + handle : place_letter_ + std::to_string(record.line);
    }

private:
    std::string place_letter_;
    std::unordered_set<std::uint64_t> handles_;
};

}  // namespace abut::geometry::dxf
