// SPDX-License-Identifier: GPL-3.0-or-later
// Other values in a JSON text, whose comments, order and blanks stay as they are.
#pragma once
#include <map>
#include <string>

namespace abut {

/// The text with other values at some JSON pointers (whole values, as JSON text). The text must be one that parse_json reads
/// without problems; a pointer to a key that its object does not have adds it as the last one, "LIST/-" adds to the end of a
/// list (one or more values with commas between), other pointers that the text does not have are left out; none may stand for
/// what lies in the value of another.
std::string with_values(const std::string& text, const std::map<std::string, std::string>& value_at);

}  // namespace abut
