// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestions for misspelt names.
#pragma once
#include <string>
#include <vector>

namespace abut {

/// The number of inserted, removed, replaced or swapped neighbouring characters between two words (capitals count half).
double edit_distance(const std::string& a, const std::string& b);

/// The known name with the smallest edit distance, the first where several are equal; empty if none is known.
std::string nearest_name(const std::string& word, const std::vector<std::string>& known);

/// A hint for a misspelt name: "did you mean 'radius'? known here: center, radius"; at most 20 names are listed. The one in
/// which it stands as a word is meant before those that are spelt much like it. Empty if none is known.
std::string nearest_name_hint(const std::string& word, const std::vector<std::string>& known);

/// Names as a list: "a, b, c", at most 20 of them, then "and 7 more".
std::string listed(const std::vector<std::string>& names);

/// The text, cut after 40 characters, for quoting what the user wrote; never cut within a UTF-8 character.
std::string shortened(const std::string& text);

}  // namespace abut
