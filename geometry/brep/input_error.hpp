// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace abut {

/// One thing that is wrong with what the user gave.
struct Problem {
    std::string where;  ///< file and line, JSON pointer, part or edge; may be empty
    std::string what;   ///< what is wrong, one sentence without a full stop
    std::string hint;   ///< what to do; may be empty
};

/// The user's fault. All problems found are collected before it is thrown; it is caught in apps/ only.
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Problem> problems);
    InputError(std::string where, std::string what, std::string hint = {});
    const std::vector<Problem>& problems() const { return problems_; }

private:
    std::vector<Problem> problems_;
};

/// "where: what; hint", one line, as it is printed for the user.
std::string one_line(const Problem& problem);

}  // namespace abut
