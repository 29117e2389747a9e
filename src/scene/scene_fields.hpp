// SPDX-License-Identifier: GPL-3.0-or-later
// Typed, checked access to the fields of a scene file. A wrong field is noted with its place and read as "absent"; reading goes
// on, so that the user gets all problems at once.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/curves/vec2.hpp"
#include "src/io/json_document.hpp"
#include "src/scene/expression.hpp"
#include "src/scene/parameter_range.hpp"
#include "src/scene/unit.hpp"

namespace abut {

using geometry::Vec2;

/// What the readers of all sections share while one scene is read.
struct SceneReading {
    std::string file;  ///< as given
    JsonValue root;
    std::map<std::string, double> parameters;  ///< those read so far, in the scene's units
    std::vector<Problem> problems;
    std::vector<std::string> part_names;       ///< filled by the parts and the assembly
    bool all_parts_named = true;               ///< false where names are missing because their part could not be read
    std::map<std::string, double> replaced{};  ///< parameters whose values are given from outside
    SceneUnits units{};                        ///< those that the scene names
    /// Parameters that have a unit, by themselves or by those they are made of; the dimension where it is known.
    std::map<std::string, std::optional<Dimension>> dimensions{};
    std::string given_file{};              ///< what a template's file name `any_file` stands for; empty: nothing
    std::vector<ParameterRange> ranges{};  ///< of the parameters that have one
};

/// Notes a problem at the place of a value.
void report_problem(SceneReading& reading, const JsonValue& at, const std::string& what, const std::string& hint = {});

/// Keys or words of the format.
using Words = std::vector<std::string>;

/// Is it an object? Reports where not, and reports every key in it that is unknown.
bool check_object(SceneReading& reading, const JsonValue& value, const Words& keys);
/// Is it a list with at least `least` items? Reports where not.
bool check_list(SceneReading& reading, const JsonValue& value, std::size_t least, const std::string& of_what);
/// The member with this key; reports where it is missing.
const JsonValue* required(SceneReading& reading, const JsonValue& object, std::string_view key);
/// Which one of the keys does the object have? Reports and returns nullptr unless it is exactly one.
const JsonValue* exactly_one(SceneReading& reading, const JsonValue& object, const std::vector<std::string>& keys);

/// Reads a number or an expression of the parameters; finite. A text may end in a unit of the dimension, and is then converted
/// into the scene's units; so in all functions with a dimension below.
std::optional<double> read_number(SceneReading& reading, const JsonValue& value, const Dimension& dimension);
std::optional<double> read_positive(SceneReading& reading, const JsonValue& value, const Dimension& dimension);
/// Reads a number of whatever dimension.
std::optional<double> read_of_any_dimension(SceneReading& reading, const JsonValue& value);
/// Reads a parameter's value: a number of any dimension, which is noted in `reading` where a unit tells it.
std::optional<double> read_parameter(SceneReading& reading, const JsonValue& value);
/// Reads a whole number within [least, most].
std::optional<int> read_integer(SceneReading& reading, const JsonValue& value, int least, int most);
std::optional<bool> read_flag(SceneReading& reading, const JsonValue& value);
/// Reads a text that is not empty.
std::optional<std::string> read_text(SceneReading& reading, const JsonValue& value);
/// Reads a text that is one of the words.
std::optional<std::string> read_word(SceneReading& reading, const JsonValue& value, const Words& words);
/// Reads a vector: [x, y].
std::optional<Vec2> read_vector(SceneReading& reading, const JsonValue& value, const Dimension& dimension);
/// Reads a direction: [x, y], not both zero.
std::optional<Vec2> read_direction(SceneReading& reading, const JsonValue& value);
/// Reads a number or an expression of the parameters and of x, y.
std::optional<Expression> read_field(SceneReading& reading, const JsonValue& value, const Dimension& dimension);
/// Reads a vector of expressions of the parameters and of x, y: [e, e].
std::optional<std::array<Expression, 2>> read_vector_field(SceneReading& reading, const JsonValue& value,
                                                           const Dimension& dimension);
/// Is there a part of this name? Reports at `at` where not.
bool check_part_name(SceneReading& reading, const JsonValue& at, const std::string& name);
/// Reads the name of a part of the scene.
std::optional<std::string> read_part_name(SceneReading& reading, const JsonValue& value);

/// The member's value by one of the functions above and what it takes besides (a dimension), or the default where the member is
/// absent or wrong.
template <class T, class Read, class... More>
T member_or(SceneReading& reading, const JsonValue& object, std::string_view key, T default_value, Read read,
            const More&... more) {
    const JsonValue* value = find_member(object, key);
    if (!value) return default_value;
    const auto result = read(reading, *value, more...);
    return result ? T(*result) : default_value;
}

/// The member's value, nothing where it is wrong; reports where it is missing.
template <class Read, class... More>
auto required_member(SceneReading& reading, const JsonValue& object, std::string_view key, Read read, const More&... more)
    -> decltype(read(reading, object, more...)) {
    const JsonValue* value = required(reading, object, key);
    if (!value) return std::nullopt;
    return read(reading, *value, more...);
}

}  // namespace abut
