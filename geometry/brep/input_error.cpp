// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/input_error.hpp"

#include <utility>

namespace abut {

namespace {
std::string joined(const std::vector<Problem>& problems) {
    std::string text;
    for (const Problem& p : problems) text += (text.empty() ? "" : "\n") + one_line(p);
    return text;
}
}  // namespace

std::string one_line(const Problem& problem) {
    std::string text = problem.where.empty() ? problem.what : problem.where + ": " + problem.what;
    if (!problem.hint.empty()) text += "; " + problem.hint;
    return text;
}

InputError::InputError(std::vector<Problem> problems) : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

InputError::InputError(std::string where, std::string what, std::string hint)
    : InputError(std::vector<Problem>{{std::move(where), std::move(what), std::move(hint)}}) {}

}  // namespace abut
