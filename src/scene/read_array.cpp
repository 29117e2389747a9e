// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_array.hpp"

namespace abut {

namespace {

constexpr int most_copies = 10000;
constexpr double whole_circle = 360;  // degrees

}  // namespace

std::vector<geometry::Placed> read_array(SceneReading& reading, const JsonValue& array) {
    const std::size_t before = reading.problems.size();
    if (!check_object(reading, array, {"count", "step", "about", "angle"})) return {};
    const auto count = required_member(reading, array, "count", read_integer, 1, most_copies);
    const JsonValue *way = exactly_one(reading, array, {"step", "about"}), *angle = find_member(array, "angle");
    const auto at = way ? read_vector(reading, *way, dimension::length) : std::nullopt;
    const bool is_around = way && way->key == "about";
    if (way && angle && !is_around)
        report_problem(reading, *angle, "copies along a 'step' are not turned", "give 'about' in place of 'step'");
    const double turn = member_or(reading, array, "angle", whole_circle / count.value_or(1), read_number, dimension::angle);
    std::vector<geometry::Placed> copies;
    if (!count || !at || reading.problems.size() > before) return copies;
    for (int k = 0; k < *count; ++k) {
        copies.emplace_back();
        if (is_around) {
            copies.back().about = *at;
            copies.back().rotate = k * turn;
        } else {
            copies.back().translate = k * *at;
        }
    }
    return copies;
}

}  // namespace abut
