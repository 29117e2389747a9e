// SPDX-License-Identifier: GPL-3.0-or-later
// Verification: problems whose answers are known, solved through their scene files and compared.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/verification/verify_problem.hpp"

namespace abut {

/// One quantity of one problem, compared.
struct VerifyRow {
    std::string name;      ///< of the problem
    std::string quantity;  ///< in words
    double value = 0;      ///< NaN: the analysis failed
    double reference = 0;
    double relative_error = 0;
    std::optional<double> tolerance;  ///< unset: recorded, not judged
    bool pass = false;
    int unknowns = 0;     ///< of the problem's largest run
    double seconds = 0;   ///< of all its runs, reading included
    std::string failure;  ///< why there is no value
};

/// All problems, in the order of their names' groups; names are unique.
const std::vector<VerifyProblem>& verify_problems();

/// The problems of a name or of a group ("E4", "E4-quarter"); all for no names. Throws InputError for each name that is
/// neither, with the nearest one.
std::vector<VerifyProblem> chosen_problems(const std::vector<std::string>& names);

/// Solves a problem and compares; scenes are looked for below data_folder. Throws InputError where a scene cannot be read; an
/// analysis that fails gives rows that do not pass.
std::vector<VerifyRow> verify(const VerifyProblem& problem, const std::string& data_folder);

/// The scene of one analysis, as the run has it. Throws InputError where it cannot be read.
Scene scene_of_run(const VerifyRun& run, const std::string& data_folder);
/// Runs one analysis; its status may be "failed". Throws InputError where the scene cannot be read.
Result answer_of(const VerifyRun& run, const std::string& data_folder);

/// Runs one analysis of a scene with cases or steps: an answer of each. Throws InputError where the scene cannot be read.
Answers answers_of(const VerifyRun& run, const std::string& data_folder);

/// The verdict on one value; name, unknowns and seconds are left to be filled in.
VerifyRow compared(const Quantity& quantity, double value);

/// The texts that `abut verify` prints, also with --json and with --list.
std::string verify_table(const std::vector<VerifyRow>& rows);
std::string verify_json(const std::vector<VerifyRow>& rows);
std::string verify_list(const std::vector<VerifyProblem>& problems);

}  // namespace abut
