// SPDX-License-Identifier: GPL-3.0-or-later
// Studies made up from formulas.
#pragma once
#include <cmath>
#include <limits>

#include "src/study/study.hpp"

namespace abut::synthetic {

inline StudyRun run(const StudySetting& setting, int unknowns, double seconds, double error) {
    StudyRun r;
    r.setting = setting;
    r.repeats = 3;
    r.unknowns = unknowns;
    r.solver_seconds = seconds;
    r.seconds = 2 * seconds;
    r.stage.fill(seconds / 4);
    r.peak_bytes = 1e7 + 1e3 * unknowns;
    r.error = {error, error / 2};
    return r;
}

inline StudyRun run_without_answer(const StudySetting& setting, StudyRun::Status status, const std::string& message) {
    StudyRun r;
    r.setting = setting;
    r.status = status;
    r.message = message;
    r.error.assign(2, std::numeric_limits<double>::quiet_NaN());
    return r;
}

/// Errors fall like 1 / unknowns, seconds grow like their power `growth`; degrees 1 and 2 alike, degree 2 three times as good;
/// three levels; one run that failed and one that was left out, with words that a page must not take for markup.
inline Study study(double growth) {
    using Kind = StudySetting::Kind;
    Study s;
    s.title = "A <made up> study & more";
    s.file = "made/up.json";
    s.reference = "a formula";
    s.measures = {{"pressure, \"L2\""}, {"largest pressure"}};
    int unknowns = 1000;
    for (const char* level : {"draft", "standard", "fine"}) {
        s.runs.push_back(
            run({Kind::level, level, 2, "web", 1, 1}, unknowns, 3e-6 * std::pow(unknowns, growth), 5.0 / unknowns));
        unknowns *= 2;
    }
    for (int degree : {1, 2})
        for (int n = 500; n <= 16000; n *= 2)
            s.runs.push_back(run({Kind::graded, "", degree, "web", std::sqrt(2000.0 / n), 1}, n, 1e-6 * std::pow(n, growth),
                                 (degree == 1 ? 15.0 : 5.0) / n));
    s.runs.push_back(
        run_without_answer({Kind::graded, "", 3, "normalized", 1, 1}, StudyRun::Status::failed, "a pivot < 0 & \"so on\""));
    s.runs.push_back(
        run_without_answer({Kind::graded, "", 4, "web", 0.5, 1}, StudyRun::Status::skipped, "it would take 80 s, too long"));
    s.budget = 60;
    return s;
}

}  // namespace abut::synthetic
