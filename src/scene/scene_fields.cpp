// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/scene_fields.hpp"

#include <algorithm>
#include <cmath>

#include "src/io/nearest_name.hpp"

namespace abut {

namespace {

using Kind = JsonValue::Kind;

bool has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string quoted_list(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
    return text;
}

/// Parses an expression; a fault of it, or of its unit, is reported at the place of the value. factor_of gives what the
/// expression's unit stands for in the scene, or throws InputError.
template <class FactorOf>
std::optional<ExpressionWithUnit> read_expression(SceneReading& reading, const JsonValue& value, bool field,
                                                  FactorOf factor_of) {
    if (value.kind == Kind::number) return ExpressionWithUnit{Expression(value.number), "", {}, false};
    if (value.kind != Kind::string) {
        report_problem(reading, value, "expected a number, found " + described(value),
                       "write a number or an expression like \"2*R+gap\"");
        return std::nullopt;
    }
    try {
        ExpressionWithUnit parsed = parse_expression_with_unit(value.text, reading.parameters, field);
        if (parsed.unit.empty()) return parsed;
        for (const std::string& name : parsed.names)
            if (reading.dimensions.contains(name))
                throw InputError("", "'" + shortened(value.text) + "' ends in a unit, and so does its parameter '" + name + "'",
                                 "take one of the two away: parameters with a unit are in the scene's units already");
        parsed.value = parsed.value.times(factor_of(parsed.unit));
        if (!std::isfinite(parsed.value.constant()))
            throw InputError("", "'" + shortened(value.text) + "' is too large to be represented", "");
        return parsed;
    } catch (const InputError& error) {
        for (const Problem& problem : error.problems()) report_problem(reading, value, problem.what, problem.hint);
        return std::nullopt;
    }
}

/// An expression of this dimension.
std::optional<Expression> read_quantity(SceneReading& reading, const JsonValue& value, const Dimension& dimension, bool field) {
    const auto parsed = read_expression(reading, value, field,
                                        [&](const std::string& unit) { return unit_factor(unit, dimension, reading.units); });
    if (!parsed) return std::nullopt;
    if (!parsed->is_name) return parsed->value;
    const auto known = reading.dimensions.find(parsed->names[0]);
    if (known == reading.dimensions.end() || !known->second || *known->second == dimension) return parsed->value;
    report_problem(reading, value, "the parameter '" + known->first + "' is " + dimension_text(*known->second),
                   "what is needed here is " + dimension_text(dimension));
    return std::nullopt;
}

std::optional<ExpressionWithUnit> read_any(SceneReading& reading, const JsonValue& value, std::optional<Dimension>& dimension) {
    return read_expression(reading, value, false, [&](const std::string& unit) {
        return unit_factor_of_any(unit, reading.units, dimension.emplace());
    });
}

bool check_pair(SceneReading& reading, const JsonValue& value) {
    if (value.kind == Kind::array && value.items.size() == 2) return true;
    report_problem(reading, value, "expected two numbers [x, y], found " + described(value));
    return false;
}

}  // namespace

void report_problem(SceneReading& reading, const JsonValue& at, const std::string& what, const std::string& hint) {
    reading.problems.push_back({place_of(reading.file, at), what, hint});
}

bool check_object(SceneReading& reading, const JsonValue& value, const Words& keys) {
    if (value.kind != Kind::object) {
        report_problem(reading, value, "expected an object, found " + described(value), "its keys are " + listed(keys));
        return false;
    }
    for (const JsonValue& item : value.items) {
        if (has(keys, item.key)) continue;
        report_problem(reading, item, "unknown key '" + shortened(item.key) + "'", nearest_name_hint(item.key, keys));
    }
    return true;
}

bool check_list(SceneReading& reading, const JsonValue& value, std::size_t least, const std::string& of_what) {
    if (value.kind != Kind::array) {
        report_problem(reading, value, "expected a list of " + of_what + ", found " + described(value));
        return false;
    }
    if (value.items.size() >= least) return true;
    report_problem(reading, value,
                   value.items.empty() ? "this list of " + of_what + " is empty"
                                       : "this list has " + std::to_string(value.items.size()) + " " + of_what,
                   "give at least " + std::to_string(least));
    return false;
}

const JsonValue* required(SceneReading& reading, const JsonValue& object, std::string_view key) {
    const JsonValue* value = find_member(object, key);
    if (!value) report_problem(reading, object, "the key '" + std::string(key) + "' is missing");
    return value;
}

const JsonValue* exactly_one(SceneReading& reading, const JsonValue& object, const std::vector<std::string>& keys) {
    const JsonValue* found = nullptr;
    for (const JsonValue& item : object.items) {
        if (!has(keys, item.key)) continue;
        if (found) {
            report_problem(reading, item, "'" + item.key + "' cannot be combined with '" + found->key + "'",
                           "make two entries of it");
            return nullptr;
        }
        found = &item;
    }
    if (!found) report_problem(reading, object, "nothing says what this is", "give one of the keys " + listed(keys));
    return found;
}

std::optional<double> read_number(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    const std::optional<Expression> expression = read_quantity(reading, value, dimension, false);
    return expression ? std::optional(expression->constant()) : std::nullopt;
}

std::optional<double> read_of_any_dimension(SceneReading& reading, const JsonValue& value) {
    std::optional<Dimension> dimension;
    const auto parsed = read_any(reading, value, dimension);
    return parsed ? std::optional(parsed->value.constant()) : std::nullopt;
}

std::optional<double> read_parameter(SceneReading& reading, const JsonValue& value) {
    std::optional<Dimension> dimension;
    const auto parsed = read_any(reading, value, dimension);
    if (!parsed) return std::nullopt;
    bool of_quantities = dimension.has_value();
    for (const std::string& name : parsed->names) of_quantities |= reading.dimensions.contains(name);
    if (parsed->is_name && of_quantities) dimension = reading.dimensions.at(parsed->names[0]);
    if (of_quantities) reading.dimensions[value.key] = dimension;
    return parsed->value.constant();
}

std::optional<double> read_positive(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    const std::optional<double> number = read_number(reading, value, dimension);
    if (!number || *number > 0) return number;
    report_problem(reading, value, (value.key.empty() ? "this" : "'" + value.key + "'") + " must be greater than 0");
    return std::nullopt;
}

std::optional<int> read_integer(SceneReading& reading, const JsonValue& value, int least, int most) {
    const std::optional<double> number = read_number(reading, value, dimension::none);
    if (!number) return std::nullopt;
    if (*number >= least && *number <= most && *number == std::floor(*number)) return static_cast<int>(*number);
    report_problem(reading, value, "expected a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return std::nullopt;
}

std::optional<bool> read_flag(SceneReading& reading, const JsonValue& value) {
    if (value.kind == Kind::boolean) return value.boolean;
    report_problem(reading, value, "expected true or false, found " + described(value));
    return std::nullopt;
}

std::optional<std::string> read_text(SceneReading& reading, const JsonValue& value) {
    const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == 127; };
    if (value.kind != Kind::string)
        report_problem(reading, value, "expected a text, found " + described(value));
    else if (value.text.empty())
        report_problem(reading, value, "this text is empty");
    else if (std::any_of(value.text.begin(), value.text.end(), is_control))
        report_problem(reading, value, "this text holds a control character, which files and tables cannot show",
                       "write it in one line without tabs");
    else
        return value.text;
    return std::nullopt;
}

std::optional<std::string> read_word(SceneReading& reading, const JsonValue& value, const Words& words) {
    const std::string word = value.kind == Kind::string ? value.text : "";
    if (has(words, word)) return word;
    report_problem(reading, value, "expected one of " + quoted_list(words) + ", found " + described(value),
                   word.empty() ? "" : "did you mean \"" + nearest_name(word, words) + "\"?");
    return std::nullopt;
}

std::optional<Vec2> read_vector(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    if (!check_pair(reading, value)) return std::nullopt;
    const std::optional<double> x = read_number(reading, value.items[0], dimension),
                                y = read_number(reading, value.items[1], dimension);
    if (!x || !y) return std::nullopt;
    return Vec2(*x, *y);
}

std::optional<Vec2> read_direction(SceneReading& reading, const JsonValue& value) {
    const std::optional<Vec2> vector = read_vector(reading, value, dimension::none);
    if (!vector || !vector->isZero(0)) return vector;
    report_problem(reading, value, "a direction cannot be [0, 0]");
    return std::nullopt;
}

std::optional<Expression> read_field(SceneReading& reading, const JsonValue& value, const Dimension& dimension) {
    return read_quantity(reading, value, dimension, true);
}

std::optional<std::array<Expression, 2>> read_vector_field(SceneReading& reading, const JsonValue& value,
                                                           const Dimension& dimension) {
    if (!check_pair(reading, value)) return std::nullopt;
    const std::optional<Expression> x = read_field(reading, value.items[0], dimension),
                                    y = read_field(reading, value.items[1], dimension);
    if (!x || !y) return std::nullopt;
    return std::array<Expression, 2>{*x, *y};
}

bool check_part_name(SceneReading& reading, const JsonValue& at, const std::string& name) {
    if (has(reading.part_names, name)) return true;
    // A part whose own entry is faulty may be the one that is meant: no second complaint about it.
    if (reading.all_parts_named) {
        report_problem(reading, at, "there is no part '" + shortened(name) + "'", nearest_name_hint(name, reading.part_names));
    }
    return false;
}

std::optional<std::string> read_part_name(SceneReading& reading, const JsonValue& value) {
    const std::optional<std::string> name = read_text(reading, value);
    return name && check_part_name(reading, value, *name) ? name : std::nullopt;
}

}  // namespace abut
