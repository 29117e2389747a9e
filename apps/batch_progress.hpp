// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "apps/progress_line.hpp"
#include "apps/stopwatch.hpp"
#include "src/batch/batch_run.hpp"

namespace abut {

/// The progress of a batch in text: on a terminal one line that is renewed (done, not ok, rate, time left), else a line for
/// each job on standard output. Jobs kept from an earlier run do not count for the rate.
class BatchProgressText {
public:
    explicit BatchProgressText(bool quiet);
    void show(const BatchProgress& progress);

private:
    bool quiet_, terminal_;
    ProgressLine line_;
    Stopwatch watch_;
    double shown_at_ = -1;
};

/// A rate and a time in words: "12.3 jobs/s", "4.1 s", "2 h 05 min".
std::string rate_text(double jobs, double seconds);
std::string time_text(double seconds);

/// A job's line: "ok pin.dxf: 3 parts, 2 pairs, peak 193 N/mm^2, 0.12 s".
std::string job_line(const JobRecord& record, bool kept);

}  // namespace abut
