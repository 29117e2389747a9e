// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/batch_end.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

#include "apps/batch_progress.hpp"
#include "apps/commands.hpp"
#include "apps/output_folder.hpp"
#include "apps/print_text.hpp"

namespace abut {

namespace {

constexpr std::size_t most_failures = 20;  // lines; the summary has all of them
constexpr int signal_status = 128;         // as shells have it

void print_totals(const std::string& out, const BatchSummary& summary, const BatchEnd& end, double seconds) {
    const std::size_t fresh = end.progress.done - end.progress.kept;
    std::cout << summary.jobs.size() << " jobs: " << count_text(summary);
    if (!summary.missing.empty()) std::cout << "; " << summary.missing.size() << " are not done";
    std::cout << "\n"
              << fresh << " done now in " << time_text(seconds) << " (" << rate_text(static_cast<double>(fresh), seconds)
              << "), " << end.progress.kept << " kept from before\n";
    if (summary.expectation) std::cout << expectation_text(*summary.expectation) << "\n";
    std::cout << "index: " << path_in(out, "index.html") << std::endl;
}

}  // namespace

void print_failures(const BatchSummary& summary) {
    struct Alike {
        std::string first, text;
        int jobs = 0;
    };
    std::vector<Alike> failures;  // jobs that fail alike are one
    for (const JobRecord& job : summary.jobs) {
        if (ended_well(job)) continue;
        const std::string text = status_word(job.status) + ": " + one_line_text(job.message);
        const auto known = std::find_if(failures.begin(), failures.end(), [&](const Alike& f) { return f.text == text; });
        (known == failures.end() ? failures.emplace_back(Alike{job.name, text}) : *known).jobs += 1;
    }
    int left = 0;
    for (std::size_t k = 0; k < failures.size(); ++k) {
        const Alike& f = failures[k];
        if (k >= most_failures) {
            left += f.jobs;
            continue;
        }
        std::cerr << "abut: " << f.first << (f.jobs > 1 ? " and " + std::to_string(f.jobs - 1) + " more" : "") << ": " << f.text
                  << "\n";
    }
    if (left > 0) std::cerr << "abut: and " << left << " more jobs; summary.csv has all of them\n";
}

void print_stale(const BatchSummary& summary, const std::string& what_to_do) {
    const std::size_t n = summary.stale.size();
    if (n == 0) return;
    std::cerr << "abut: " << n << (n == 1 ? " job is" : " jobs are")
              << " there from another batch, with another template, other "
              << "options or parameters, and not counted; the first of them is " << summary.stale.front() << "; " << what_to_do
              << "\n";
}

int end_batch(const std::string& out, const BatchFile& batch, const BatchEnd& end, const BatchCircumstances& circumstances) {
    if (!end.write_fault.empty())
        std::cerr << "abut: " << one_line_text(end.write_fault)
                  << "; free the place and run the same command again: what is finished is kept" << std::endl;
    const BatchSummary summary = summarize(out, batch);
    write_summary(out, batch, summary);
    if (!circumstances.quiet) print_totals(out, summary, end, circumstances.seconds);
    print_failures(summary);
    if (end.edited > 0)
        std::cerr
            << "abut: " << end.edited << (end.edited == 1 ? " job was" : " jobs were")
            << " done with a template, or files that it imports, edited after the batch had begun; the same command again "
               "does the others with it, too\n";
    else if (!end.interrupted && end.write_fault.empty())
        print_stale(summary, "run their shards again");
    if (end.interrupted) {
        std::cerr << "abut: stopped; the same command again goes on from here\n";
        return signal_status + circumstances.signal;
    }
    if (!end.write_fault.empty()) return exit_wrong_input;
    return all_well(summary) && end.edited == 0 ? exit_done : exit_failed;
}

}  // namespace abut
