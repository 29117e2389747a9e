// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/batch_run.hpp"
#include "src/batch_summary.hpp"

namespace abut {

struct BatchCircumstances {
    double seconds = 0;
    bool quiet = false;
    int signal = 0;  ///< that ended it; 0: none
};

/// Writes the summary, prints what it came to, and gives the exit status: 0, 1 where a job of OUT did not end well, 2 where
/// nothing could be written, 128 + the signal where one came.
int end_batch(const std::string& out, const BatchFile& batch, const BatchEnd& end, const BatchCircumstances& circumstances);

/// The jobs that did not end well, on standard error, the first ones of them.
void print_failures(const BatchSummary& summary);

}  // namespace abut
