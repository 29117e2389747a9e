// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_measure.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "src/analysis/analysis.hpp"
#include "src/report/report.hpp"
#include "src/results/verdict.hpp"
#include "src/scene/read_scene.hpp"
#include "src/study/study_child.hpp"
#include "src/verification/verify.hpp"

namespace abut {

namespace {

using Clock = std::chrono::steady_clock;

/// Short runs are not repeated more often than this.
constexpr int most_repeats = 7;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Processor time of all threads of this process so far.
double processor_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Timing {
    StageSeconds stage{};
    double all = 0, processor = 0;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

template <class Get>
double median_of(const std::vector<Timing>& timings, Get get) {
    std::vector<double> values;
    for (const Timing& t : timings) values.push_back(get(t));
    return median(std::move(values));
}

/// The texts of all files, as `abut analyze` makes them.
void make_report(const Result& result) {
    std::size_t bytes = report_html(result).size() + result_json(result).size();
    for (const ContactResult& c : result.contacts) bytes += contact_csv(c).size();
    volatile std::size_t kept = bytes;  // so that nothing of it is optimised away
    (void)kept;
}

std::size_t stage_index(const std::string& name) {
    return static_cast<std::size_t>(std::find(study_stages.begin(), study_stages.end(), name) - study_stages.begin());
}

/// Reading, analysis and report, once.
Result timed_run(const StudyTask& task, Timing& timing) {
    const double processor = processor_seconds();
    const Clock::time_point begin = Clock::now();
    const Scene scene = scene_at(read_scene(task.scene_path), task);
    timing.stage[stage_index("import")] = seconds_since(begin);
    AnalyzeOptions options;
    options.threads = task.setting.threads;
    Result result = analyze(scene, options);
    for (const auto& [name, seconds] : result.stages) timing.stage[stage_index(name)] = seconds;
    const Clock::time_point reported = Clock::now();
    make_report(result);
    timing.stage[stage_index("report")] = seconds_since(reported);
    timing.all = seconds_since(begin);
    timing.processor = processor_seconds() - processor;
    const double known = std::accumulate(timing.stage.begin(), timing.stage.end(), 0.0);
    timing.stage[stage_index("other")] = std::max(0.0, timing.all - known);
    return result;
}

double solver_seconds(const Timing& t) {
    double sum = 0;
    for (const char* name : {"geometry", "assembly", "factorisation", "contact"}) sum += t.stage[stage_index(name)];
    return sum;
}

void fill_times(const std::vector<Timing>& timings, StudyRun& run) {
    run.repeats = static_cast<int>(timings.size());
    for (std::size_t s = 0; s < run.stage.size(); ++s)
        run.stage[s] = median_of(timings, [s](const Timing& t) { return t.stage[s]; });
    run.solver_seconds = median_of(timings, solver_seconds);
    run.seconds = median_of(timings, [](const Timing& t) { return t.all; });
    run.cpu_seconds = median_of(timings, [](const Timing& t) { return t.processor; });
}

void fill_run(const Result& result, StudyRun& run) {
    if (result.status != "ok") {
        run.status = StudyRun::Status::failed;
        run.message = result.message;
    }
    run.reasons = reasons_text(result);
    run.unknowns = result.unknowns + result.multipliers;
    run.multipliers = result.multipliers;
    run.cells = result.cells;
    run.passes = result.passes;
    run.estimated_error = result.contacts.empty() ? result.error_estimate.energy : result.error_estimate.contact_pressure;
}

StudyAnswer answer_of(const Result& result) {
    StudyAnswer answer;
    for (const ContactResult& c : result.contacts)
        answer.contacts.push_back(
            {c.between[0] + " " + c.between[1], c.force, c.max_pressure.value, c.profile.x, c.profile.y, c.profile.pressure});
    for (const ProbeResult& p : result.probes) answer.probes.push_back(p.displacement);
    answer.energy = result.strain_energy;
    for (const PartResult& p : result.parts) answer.stress = std::max(answer.stress, p.max_von_mises.value);
    return answer;
}

/// Relative to the known answer's size also where `verify` looks at the difference itself (degrees, shares of a load).
double known_error(const Quantity& q, double value) {
    const double error = compared(q, value).relative_error;
    return q.scale > 0 && q.reference != 0 ? error * q.scale / std::abs(q.reference) : error;
}

StudyMeasured measured_here(const StudyTask& task) {
    StudyMeasured m;
    std::vector<Timing> timings;
    Result result;
    const Clock::time_point begin = Clock::now();
    do {
        timings.emplace_back();
        result = timed_run(task, timings.back());
    } while (result.status == "ok" && timings.size() < most_repeats && seconds_since(begin) < task.repeated_seconds);
    fill_run(result, m.run);
    fill_times(timings, m.run);
    if (m.run.status == StudyRun::Status::failed) return m;
    m.answer = answer_of(result);
    for (const PartResult& p : result.parts)
        if (p.solved && !p.rigid)
            m.grids.push_back(
                {p.name, p.grid_angle, p.grid_x, p.grid_y, p.halved, p.cells_inner + p.cells_boundary + p.cells_outer});
    if (task.known)
        for (const Quantity& q : task.known->quantities) m.known_error.push_back(known_error(q, q.value({result})));
    return m;
}

/// The scene's own faults travel as what they are.
std::string text_here(const StudyTask& task) {
    try {
        return measured_text(measured_here(task));
    } catch (const InputError& error) {
        StudyMeasured m;
        m.problems = error.problems();
        return measured_text(m);
    }
}

}  // namespace

StudyMeasured measure(const StudyTask& task, double limit_seconds) {
    const ChildOutcome outcome = in_child([&] { return text_here(task); }, limit_seconds);
    StudyMeasured m;
    if (outcome.failure.empty()) m = measured_from(outcome.text);
    m.run.setting = task.setting;
    m.run.peak_bytes = outcome.peak_bytes;
    if (!m.problems.empty()) m.run.message = one_line(m.problems.front());
    if (!outcome.failure.empty()) m.run.message = outcome.failure;
    if (!m.run.message.empty()) m.run.status = StudyRun::Status::failed;
    if (outcome.out_of_time) m.run.status = StudyRun::Status::skipped;
    return m;
}

}  // namespace abut
