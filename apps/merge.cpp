// SPDX-License-Identifier: GPL-3.0-or-later
// abut merge: the shards of a batch in one folder.
#include <iostream>

#include "apps/batch_end.hpp"
#include "apps/commands.hpp"
#include "apps/output_folder.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_merge.hpp"
#include "src/batch/batch_summary.hpp"
#include "src/batch/job_store.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"

namespace abut {

namespace {

BatchSummary merged(const Arguments& arguments, const std::string& out) {
    try {
        const BatchFile batch = merge_batches(arguments.operands, out);
        write_file(out, "batch.json", batch_json(batch));
        BatchSummary summary = summarize(out, batch);
        write_summary(out, batch, summary);
        return summary;
    } catch (const StoreError& error) { throw InputError("", error.what(), "free the place or choose another folder with -o"); }
}

}  // namespace

CommandSpec merge_spec() {
    CommandSpec spec{"merge", "OUT...", "Puts the shards of a batch together: jobs and summary.", {}, {}};
    spec.options = {{"-o", "OUT", "folder to bring them into (default: the first)"},
                    {"--quiet", "", "print nothing but errors"}};
    spec.notes =
        "With one OUT into which all shards wrote, it renews the summary. Shards of different batches, and jobs whose inputs "
        "differ, are\n"
        "refused. The exit status is 1 if a job is missing or did not end well.\n";
    spec.operands = Operands::any;
    return spec;
}

int merge_command(const Arguments& arguments) {
    if (arguments.operands.empty()) throw InputError("merge", "no OUT given", "write abut merge OUT...");
    const std::string out = value_or(arguments, "-o", arguments.operands.front());
    for (const std::string& folder : arguments.operands) read_batch_file(folder);
    prepare_output_folder(out);
    const BatchSummary summary = merged(arguments, out);
    if (!has(arguments, "--quiet")) {
        std::cout << summary.jobs.size() << " jobs: " << count_text(summary) << "\n";
        if (summary.expectation) std::cout << expectation_text(*summary.expectation) << "\n";
        std::cout << "index: " << path_in(out, "index.html") << std::endl;
    }
    print_failures(summary);
    print_stale(summary, "run their shards again");
    if (!summary.missing.empty())
        std::cerr << "abut: " << summary.missing.size() << " jobs are not done, the first of them " << summary.missing.front()
                  << "; run their shards\n";
    return all_well(summary) && summary.missing.empty() ? exit_done : exit_failed;
}

}  // namespace abut
