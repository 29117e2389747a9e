// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_output.hpp"

#include <algorithm>

namespace abut {

namespace {

std::optional<Probe> read_probe(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"part", "at"})) return std::nullopt;
    const auto part = required_member(reading, value, "part", read_part_name);
    const auto at = required_member(reading, value, "at", read_vector, dimension::length);
    if (!part || !at) return std::nullopt;
    return Probe{*part, *at, value.pointer};
}

std::vector<std::string> read_formats(SceneReading& reading, const JsonValue& value) {
    std::vector<std::string> formats;
    if (!check_list(reading, value, 1, "formats")) return formats;
    for (const JsonValue& item : value.items) {
        const auto format = read_word(reading, item, {"json", "csv", "html", "vtu", "svg", "png"});
        if (format && std::find(formats.begin(), formats.end(), *format) == formats.end()) formats.push_back(*format);
    }
    return formats;
}

std::optional<Expectation> read_expectation(SceneReading& reading, const JsonValue& value) {
    if (!check_object(reading, value, {"quantity", "value", "tolerance", "source", "case"})) return std::nullopt;
    const auto quantity = required_member(reading, value, "quantity", read_text);
    const auto known = required_member(reading, value, "value", read_of_any_dimension);
    const auto tolerance = required_member(reading, value, "tolerance", read_positive, dimension::none);
    const std::string source = member_or(reading, value, "source", std::string(), read_text);
    const std::string in_case = member_or(reading, value, "case", std::string(), read_text);
    if (!quantity || !known || !tolerance) return std::nullopt;
    return Expectation{*quantity, *known, *tolerance, source, in_case, value.pointer};
}

}  // namespace

Output read_output(SceneReading& reading, const JsonValue& output) {
    Output result;
    if (!check_object(reading, output, {"probes", "formats"})) return result;
    if (const JsonValue* formats = find_member(output, "formats")) result.formats = read_formats(reading, *formats);
    const JsonValue* probes = find_member(output, "probes");
    if (!probes || !check_list(reading, *probes, 0, "probes")) return result;
    for (const JsonValue& item : probes->items) {
        if (const auto probe = read_probe(reading, item)) result.probes.push_back(*probe);
    }
    return result;
}

std::vector<Expectation> read_expectations(SceneReading& reading, const JsonValue& expect) {
    std::vector<Expectation> result;
    if (!check_list(reading, expect, 1, "known answers")) return result;
    for (const JsonValue& item : expect.items) {
        if (const auto expectation = read_expectation(reading, item)) result.push_back(*expectation);
    }
    return result;
}

}  // namespace abut
