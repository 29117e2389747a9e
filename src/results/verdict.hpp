// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer is worth, as the terminal, result.json, the report and batches show it.
#pragma once
#include <string>

#include "src/results/result.hpp"

namespace abut {

/// What an answer is worth, in one word.
enum class Verdict {
    reached,     ///< solved, and known as well as was asked for
    solved_but,  ///< solved, with reasons not to take it as it is
    failed,      ///< there is no answer
};

/// The verdict on a result; it follows from status and reasons alone.
Verdict verdict_of(const Result& result);
/// The word of a verdict for programs: "reached", "solved_but", "failed".
std::string verdict_word(Verdict verdict);
/// The verdict in a sentence: "Solved, but: strap at 2.75 times its yield; contact pressures known to 0.7 %".
std::string verdict_sentence(const Result& result);
/// The reasons alone, parted by semicolons; empty for none.
std::string reasons_text(const Result& result);

/// What the result has that the answer of no problem has, in words; empty where there is nothing of the kind: numbers that are
/// not finite, a strain energy below zero, forces or moments that are not balanced.
std::string impossible_in(const Result& result);

}  // namespace abut
