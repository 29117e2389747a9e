// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/batch_run.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "geometry/input_error.hpp"
#include "src/csv_field.hpp"
#include "src/result.hpp"

namespace abut {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int patience = 200;                        // milliseconds between looks at `interrupted` and the clock
constexpr char record_mark = 'r', fault_mark = '!';  // what a worker sends begins with: job.json, or why nothing can be written

std::string key_of(const BatchJob& job, const BatchRun& run) {
    std::map<std::string, std::string> settings = run.settings;
    for (const auto& [name, value] : job.parameters) settings["/" + name] = csv_field(value);
    if (run.own_settings) settings["job"] = run.own_settings(job);
    std::vector<InputFile> inputs = run.inputs;
    if (!job.file.empty()) {
        const std::vector<InputFile> own = input_files(job.file);
        inputs.insert(inputs.end(), own.begin(), own.end());
    }
    return job_key(settings, inputs);
}

/// One line however many problems there are.
std::string text_of(const std::vector<Problem>& problems) {
    const std::string first = one_line(problems.front());
    const std::size_t more = problems.size() - 1;
    return more == 0 ? first : first + " (and " + std::to_string(more) + (more == 1 ? " more problem)" : " more problems)");
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

/// Puts the record into its folder, and the folder in its place. Gives the text of job.json.
std::string store(const JobStore& place, const BatchJob& job, const std::string& folder, JobRecord record) {
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

/// A worker's whole life.
std::string do_job(const JobStore& place, const BatchJob& job, const BatchRun& run) {
    const Clock::time_point start = Clock::now();
    try {
        const std::string folder = place.begin(job.name);
        JobRecord record;
        const std::string key = key_of(job, run);  // of what is about to be read: an edit from here on is computed next time
        try {
            record = run.work(job, folder);
        } catch (const InputError& error) { record = refused(job, error.problems()); }
        record.key = key;
        record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return record_mark + store(place, job, folder, std::move(record));
    } catch (const StoreError& error) { return fault_mark + std::string(error.what()); }
}

class Walk {
public:
    Walk(const std::vector<BatchJob>& jobs, const std::string& out, const BatchRun& run)
        : jobs_(jobs), out_(out), run_(run), store_(out) {
        for (std::size_t i = 0; i < jobs.size(); ++i)
            if (is_in(run.shard, i)) mine_.push_back(i);
        end_.progress.total = mine_.size();
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

    void count(const JobRecord& record, bool kept) {
        ++end_.progress.done;
        end_.progress.kept += kept;
        end_.progress.not_ok += record.status != JobRecord::Status::ok;
        tell(&record, kept);
    }

    void begin(std::size_t index) {
        const BatchJob& job = jobs_[index];
        if (!run_.force) {
            const std::optional<JobRecord> known = stored_job(out_, job.name);
            if (known && is_finished(*known) && known->key == key_of(job, run_)) return count(*known, true);
        }
        const std::string fault = pool_.start(
            index, [&] { return do_job(store_, job, run_); }, run_.limits);
        if (!fault.empty()) bury(job, fault);
    }

    void take(const WorkerEnd& ended) {
        const BatchJob& job = jobs_[ended.job];
        if (!ended.death.empty()) {
            if (!is_stopped()) bury(job, ended.death);
        } else if (ended.text.front() == fault_mark) {
            end_.write_fault = ended.text.substr(1);
        } else if (const auto record = parse_job_json(ended.text.substr(1))) {
            count(*record, false);
        }
    }

    /// The record of a job that cannot speak for itself any more.
    void bury(const BatchJob& job, const std::string& death) {
        JobRecord record;
        record.status = JobRecord::Status::broken;
        record.message = (job.file.empty() ? job.name : job.file) + ": " + death;
        try {
            store(store_, job, store_.begin(job.name), record);
            record.name = job.name;
            count(record, false);
        } catch (const StoreError& error) { end_.write_fault = error.what(); }
    }

    const std::vector<BatchJob>& jobs_;
    const std::string& out_;
    const BatchRun& run_;
    JobStore store_;
    WorkerPool pool_;  // after the store: workers end before their folders go
    std::vector<std::size_t> mine_;
    std::size_t next_ = 0;
    BatchEnd end_;
};

}  // namespace

BatchEnd run_batch(const std::vector<BatchJob>& jobs, const std::string& out, const BatchRun& run) {
    return Walk(jobs, out, run).go();
}

}  // namespace abut
