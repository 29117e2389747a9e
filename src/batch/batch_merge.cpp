// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_merge.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "src/batch/batch_difference.hpp"
#include "src/batch/job_store.hpp"

namespace abut {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t reported_conflicts = 10;

/// All folders say the same, or it is thrown.
BatchFile common_batch(const std::vector<std::string>& folders) {
    FolderBatch first{folders.front(), read_batch_file(folders.front())};
    std::vector<Problem> problems;
    for (std::size_t i = 1; i < folders.size(); ++i) {
        const std::string what = difference(first, {folders[i], read_batch_file(folders[i])});
        if (!what.empty())
            problems.push_back({folders[i], "this is another batch than " + folders.front() + ": " + what,
                                "merge the shards of one batch only, or run the one that is out of date again"});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    return std::move(first.batch);
}

/// Which folder the job is taken from; nothing where none has it.
std::optional<std::size_t> origin(const BatchFile::Job& job, const std::vector<std::string>& folders,
                                  std::vector<Problem>& problems) {
    std::optional<std::size_t> from;
    std::optional<JobRecord> first;
    for (std::size_t i = 0; i < folders.size(); ++i) {
        std::optional<JobRecord> record = stored_job(folders[i], job.name);
        if (!record || !belongs(*record, job) || (first && !is_finished(*record))) continue;
        if (first && is_finished(*first)) {
            if (first->key != record->key)
                problems.push_back({job.name, "the inputs of this job differ between " + folders[*from] + " and " + folders[i],
                                    "run the batch again where they are old"});
            continue;
        }
        from = i;
        first = std::move(record);
    }
    return from;
}

std::vector<std::optional<std::size_t>> origins(const BatchFile& batch, const std::vector<std::string>& folders) {
    std::vector<Problem> problems;
    std::vector<std::optional<std::size_t>> from;
    for (const BatchFile::Job& job : batch.jobs) from.push_back(origin(job, folders, problems));
    const std::size_t n = problems.size();
    if (n > reported_conflicts) {
        problems.resize(reported_conflicts);
        problems.push_back({"", "and " + std::to_string(n - reported_conflicts) + " more jobs", ""});
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    return from;
}

void link_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (!error) return;
    fs::copy_file(from, to, error);
    if (error) throw StoreError(to.string() + " cannot be written: " + error.message());
}

void bring(const std::string& name, const std::string& from, const JobStore& store) {
    const fs::path folder = store.begin(name);
    for (const fs::directory_entry& entry : fs::directory_iterator(job_folder(from, name)))
        link_or_copy(entry.path(), folder / entry.path().filename());
    store.finish(name);
}

}  // namespace

BatchFile merge_batches(const std::vector<std::string>& folders, const std::string& out) {
    BatchFile batch = common_batch(folders);
    const std::vector<std::optional<std::size_t>> from = origins(batch, folders);
    const JobStore store(out);
    for (std::size_t i = 0; i < batch.jobs.size(); ++i) {
        std::error_code error;
        if (from[i] && !fs::equivalent(folders[*from[i]], out, error)) bring(batch.jobs[i].name, folders[*from[i]], store);
    }
    return batch;
}

}  // namespace abut
