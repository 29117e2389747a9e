// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/batch/batch_run.hpp"
#include "src/batch/batch_summary.hpp"

namespace abut {

/// What is known at the end of a batch besides its jobs.
struct BatchCircumstances {
    double seconds = 0;
    bool quiet = false;
    int signal = 0;  ///< that ended it; 0: none
};

/// Writes the summary, prints what it came to, and gives the exit status: 0, 1 where a job of OUT did not end well
/// or the template was edited meanwhile, 2 where
/// nothing could be written, 128 + the signal where one came.
int end_batch(const std::string& out, const BatchFile& batch, const BatchEnd& end, const BatchCircumstances& circumstances);

/// Prints the jobs that OUT has from another batch on standard error, and what to do about them; nothing where there are none.
void print_stale(const BatchSummary& summary, const std::string& what_to_do);

/// Prints the first of the jobs that did not end well on standard error.
void print_failures(const BatchSummary& summary);

}  // namespace abut
