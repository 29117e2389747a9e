// SPDX-License-Identifier: GPL-3.0-or-later
// A batch that is about to run, for the commands that run one.
#pragma once
#include <optional>
#include <string>

#include "apps/batch_job.hpp"
#include "src/batch/batch_run.hpp"
#include "src/batch/batch_template.hpp"

namespace abut {

/// Everything that the command line says.
struct BatchCall {
    BatchSource source;
    std::optional<BatchTemplate> scene_template;
    JobSettings job;
    BatchRun run;
    std::string out;
};

/// Takes workers, limits, --force and what answers depend on from the command line; call.job must be there. Throws InputError.
void set_run_options(const Arguments& arguments, BatchCall& call);

/// Runs the batch, writes its summary, prints what it came to, and gives the exit status. name: of the source, for titles.
/// Throws InputError where nothing can be written.
int do_batch(BatchCall& call, const std::string& name, bool quiet);

}  // namespace abut
