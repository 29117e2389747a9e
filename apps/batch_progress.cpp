// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/batch_progress.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

#include "apps/print_text.hpp"
#include "src/io/number_text.hpp"

namespace abut {

namespace {

constexpr double renewal = 0.1;  // seconds between renewals of the line

std::string plural(int n, const std::string& noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

}  // namespace

BatchProgressText::BatchProgressText(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), line_(!quiet) {}

void BatchProgressText::show(const BatchProgress& progress) {
    if (quiet_) return;
    if (!terminal_) {
        if (progress.last) std::cout << job_line(*progress.last, progress.last_kept) << std::endl;
        return;
    }
    const double seconds = watch_.seconds();
    if (seconds < shown_at_ + renewal && progress.done < progress.total) return;
    shown_at_ = seconds;
    const auto fresh = static_cast<double>(progress.done - progress.kept),
               left = static_cast<double>(progress.total - progress.done);
    std::string text = std::to_string(progress.done) + " of " + std::to_string(progress.total) + " done, " +
                       std::to_string(progress.not_ok) + " not ok";
    if (fresh > 0) text += ", " + rate_text(fresh, seconds) + ", " + time_text(left * seconds / fresh) + " left";
    line_.show(text);
}

std::string rate_text(double jobs, double seconds) {
    return number_text(seconds > 0 ? jobs / seconds : 0, 3) + " jobs/s";
}

std::string time_text(double seconds) {
    constexpr double minute = 60, hour = 3600;
    if (seconds < 2 * minute) return number_text(seconds, seconds < 10 ? 2 : 3) + " s";
    if (seconds < 2 * hour) return number_text(std::round(seconds / minute), 3) + " min";
    return number_text(std::floor(seconds / hour), 9) + " h " + number_text(std::floor(std::fmod(seconds, hour) / minute), 2) +
           " min";
}

std::string job_line(const JobRecord& record, bool kept) {
    std::string text = status_word(record.status) + " " + record.name + ":";
    if (!record.message.empty()) text += " " + one_line_text(record.message);
    if (ended_well(record)) {
        text += record.message.empty() ? "" : ";";
        text += " " + plural(record.parts.value_or(0), "part") + ", " + plural(record.pairs.value_or(0), "pair");
        if (record.max_pressure) text += ", peak pressure " + number_text(*record.max_pressure, 4);
        if (record.error_estimate)
            text += std::string(record.max_pressure ? ", contact pressures" : ", stresses") + " known to " +
                    number_text(100 * *record.error_estimate, 2) + " %";
        if (!record.warnings.empty()) text += ", " + plural(static_cast<int>(record.warnings.size()), "warning");
    }
    return text + (kept ? ", kept" : ", " + number_text(record.seconds, 2) + " s");
}

}  // namespace abut
