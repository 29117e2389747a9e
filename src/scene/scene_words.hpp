// SPDX-License-Identifier: GPL-3.0-or-later
// Words that scenes and the command line share.
#pragma once
#include <string>
#include <vector>

namespace abut {

/// What "parts_by" and --parts-by may say (parts_by_of in src/scene/read_drawing.hpp).
inline const std::vector<std::string>& parts_by_words() {
    static const std::vector<std::string> words{"auto", "layer", "block", "loop", "color", "node"};
    return words;
}

/// What "level" of "accuracy" and --accuracy may say; the latter takes numbers, too.
inline const std::vector<std::string>& accuracy_levels() {
    static const std::vector<std::string> levels{"draft", "standard", "fine"};
    return levels;
}

}  // namespace abut
