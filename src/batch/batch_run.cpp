// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch/batch_run.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <utility>

#include "geometry/brep/input_error.hpp"
#include "src/io/write_file.hpp"
#include "src/results/result.hpp"

namespace abut {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int patience = 200;                        // milliseconds between looks at `interrupted` and the clock
constexpr int most_attempts = 3;                     // at a job whose files are written while it runs
constexpr char record_mark = 'r', fault_mark = '!';  // what a worker sends begins with: job.json, or why nothing can be written

/// All that a job reads, as it is now.
struct JobInputs {
    std::string request, key;
    std::vector<InputFile> files;
};

JobInputs inputs_of(const BatchJob& job, const BatchRequest& request) {
    JobInputs inputs{{}, {}, template_files(request)};
    inputs.request = job_request(request, inputs.files, job);
    const std::vector<InputFile> own = job.file.empty() ? std::vector<InputFile>{} : input_files(job.file);
    inputs.key = job_key({{"request", inputs.request}}, own);
    inputs.files.insert(inputs.files.end(), own.begin(), own.end());
    return inputs;
}

/// One line however many problems there are.
std::string text_of(const std::vector<Problem>& problems) {
    const std::string first = one_line(problems.front());
    const std::size_t more = problems.size() - 1;
    return more == 0 ? first : first + " (and " + std::to_string(more) + (more == 1 ? " more problem)" : " more problems)");
}

JobRecord broken(const BatchJob& job, const std::string& why, const std::string& request) {
    JobRecord record;
    record.status = JobRecord::Status::broken;
    record.message = (job.file.empty() ? job.name : job.file) + ": " + why;
    record.request = request;
    return record;
}

JobRecord refused(const BatchJob& job, const std::vector<Problem>& problems) {
    JobRecord record;
    record.status = JobRecord::Status::refused;
    record.message = text_of(problems);
    if (!job.where.empty()) record.message += " [" + job.where + "]";
    return record;
}

std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Puts the record into the folder that was begun, and that in its place. Gives the text of job.json.
std::string store(const JobStore& place, const BatchJob& job, JobRecord record) {
    const std::string folder = place.begun(job.name);
    record.name = job.name;
    record.file = job.file;
    record.parameters = job.parameters;
    record.files = files_in(folder);
    record.sizes.clear();
    for (const std::string& file : record.files) record.sizes.push_back(std::filesystem::file_size(folder + "/" + file));
    const std::string text = job_json(record);
    try {
        write_file(folder, "job.json", text);
    } catch (const InputError& error) { throw StoreError(error.what()); }
    place.finish(job.name);
    return text;
}

JobRecord work_of(const BatchJob& job, const BatchRun& run, const std::string& folder) {
    try {
        return run.work(job, folder);
    } catch (const InputError& error) { return refused(job, error.problems()); }
}

/// A record whose key is that of what was read: where a file was written meanwhile the work is done again.
JobRecord consistent_work(const JobStore& place, const BatchJob& job, const BatchRun& run) {
    JobInputs inputs;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        const std::string folder = place.begin(job.name);
        inputs = inputs_of(job, run.request);
        JobRecord record = work_of(job, run, folder);
        record.key = inputs.key;
        record.request = inputs.request;
        if (are_unchanged(inputs.files)) return record;
    }
    place.begin(job.name);
    return broken(job, "it, or a file that it reads, was written whenever this job ran; the same command again does it",
                  inputs.request);
}

/// A worker's whole life.
std::string do_job(const JobStore& place, const BatchJob& job, const BatchRun& run) {
    const Clock::time_point start = Clock::now();
    try {
        JobRecord record = consistent_work(place, job, run);
        record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return record_mark + store(place, job, std::move(record));
    } catch (const StoreError& error) { return fault_mark + std::string(error.what()); }
}

class Walk {
public:
    Walk(const std::vector<BatchJob>& jobs, const std::string& out, const BatchRun& run)
        : jobs_(jobs), out_(out), run_(run), store_(out) {
        for (std::size_t i = 0; i < jobs.size(); ++i)
            if (is_in(run.shard, i)) mine_.push_back(i);
        end_.progress.total = mine_.size();
        const std::vector<InputFile> files = template_files(run.request);
        for (const std::size_t i : mine_) requests_[i] = job_request(run.request, files, jobs[i]);
    }

    BatchEnd go() {
        while (!is_over()) {
            while (next_ < mine_.size() && pool_.running() < run_.workers && !is_stopped()) begin(mine_[next_++]);
            if (pool_.running() == 0) continue;
            if (const auto ended = pool_.wait(patience)) take(*ended);
            tell(nullptr, false);
        }
        pool_.kill_all();
        return end_;
    }

private:
    bool is_stopped() {
        if (run_.interrupted && run_.interrupted()) end_.interrupted = true;
        return end_.interrupted || !end_.write_fault.empty();
    }

    bool is_over() {
        if (is_stopped()) return end_.interrupted || pool_.running() == 0;
        return next_ >= mine_.size() && pool_.running() == 0;
    }

    void tell(const JobRecord* last, bool kept) {
        end_.progress.last = last;
        end_.progress.last_kept = kept;
        if (run_.progress) run_.progress(end_.progress);
        end_.progress.last = nullptr;
    }

    void count(std::size_t job, const JobRecord& record, bool kept) {
        ++end_.progress.done;
        end_.edited += is_finished(record) && record.request != requests_.at(job);
        end_.progress.kept += kept;
        end_.progress.not_ok += !ended_well(record);
        tell(&record, kept);
    }

    void begin(std::size_t index) {
        const BatchJob& job = jobs_[index];
        if (!run_.force) {
            const std::optional<JobRecord> known = stored_job(out_, job.name);
            if (known && is_finished(*known) && known->key == inputs_of(job, run_.request).key)
                return count(index, *known, true);
        }
        const std::string fault = pool_.start(
            index, [&] { return do_job(store_, job, run_); }, run_.limits);
        if (!fault.empty()) bury(index, fault);
    }

    void take(const WorkerEnd& ended) {
        if (!ended.death.empty()) {
            if (!is_stopped()) bury(ended.job, ended.death);
        } else if (ended.text.front() == fault_mark) {
            end_.write_fault = ended.text.substr(1);
        } else if (const auto record = parse_job_json(ended.text.substr(1))) {
            count(ended.job, *record, false);
        }
    }

    /// The record of a job that cannot speak for itself any more.
    void bury(std::size_t index, const std::string& death) {
        const BatchJob& job = jobs_[index];
        JobRecord record = broken(job, death, requests_.at(index));
        try {
            store_.begin(job.name);
            store(store_, job, record);
            record.name = job.name;
            count(index, record, false);
        } catch (const StoreError& error) { end_.write_fault = error.what(); }
    }

    const std::vector<BatchJob>& jobs_;
    const std::string& out_;
    const BatchRun& run_;
    JobStore store_;
    WorkerPool pool_;  // after the store: workers end before their folders go
    std::vector<std::size_t> mine_;
    std::map<std::size_t, std::string> requests_;  // of mine, with the template as it was in the beginning
    std::size_t next_ = 0;
    BatchEnd end_;
};

}  // namespace

BatchEnd run_batch(const std::vector<BatchJob>& jobs, const std::string& out, const BatchRun& run) {
    return Walk(jobs, out, run).go();
}

}  // namespace abut
