// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of a study as CSV and as JSON.
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/io/csv_field.hpp"
#include "src/study/study_prices.hpp"

namespace abut {

namespace {

using OrderedJson = nlohmann::ordered_json;

std::string kind_text(StudySetting::Kind kind) {
    if (kind == StudySetting::Kind::level) return "level";
    return kind == StudySetting::Kind::graded ? "graded" : "equal";
}

std::string status_text(const StudyRun& run) {
    if (run.status == StudyRun::Status::ok) return run.reasons.empty() ? "ok" : "solved_but";
    return run.status == StudyRun::Status::failed ? "failed" : "skipped";
}

std::string csv_line(const StudyRun& r) {
    const StudySetting& s = r.setting;
    std::string line = kind_text(s.kind) + "," + csv_field(s.level) + "," + std::to_string(s.degree) + "," + s.basis + "," +
                       csv_field(s.size) + "," + status_text(r) + "," + std::to_string(r.repeats) + "," +
                       std::to_string(r.unknowns) + "," + std::to_string(r.multipliers);
    for (int n : r.cells) line += "," + std::to_string(n);
    line += "," + csv_field(r.solver_seconds) + "," + csv_field(r.seconds) + "," + csv_field(r.cpu_seconds);
    for (double seconds : r.stage) line += "," + csv_field(seconds);
    line += "," + csv_field(r.peak_bytes) + "," + (r.estimated_error ? csv_field(*r.estimated_error) : "");
    for (double error : r.error) line += "," + csv_field(error);
    return line + "," + csv_field(r.message) + "\n";
}

OrderedJson number(double value) {
    return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson optional_number(const std::optional<double>& value) {
    return value ? number(*value) : OrderedJson(nullptr);
}

OrderedJson setting_json(const StudySetting& s) {
    return {{"kind", kind_text(s.kind)}, {"level", s.level}, {"degree", s.degree}, {"basis", s.basis}, {"size", s.size}};
}

OrderedJson passes_json(const StudyRun& r) {
    OrderedJson list = OrderedJson::array();
    for (const PassSummary& p : r.passes)
        list.push_back({{"unknowns", p.unknowns},
                        {"multipliers", p.multipliers},
                        {"seconds", p.seconds},
                        {"estimated_error", optional_number(p.estimated_error)}});
    return list;
}

OrderedJson run_json(const StudyRun& r) {
    OrderedJson stages = OrderedJson::object(), errors = OrderedJson::array();
    for (std::size_t s = 0; s < study_stages.size(); ++s) stages[study_stages[s]] = r.stage[s];
    for (double error : r.error) errors.push_back(number(error));
    return {{"setting", setting_json(r.setting)},
            {"status", status_text(r)},
            {"message", r.message},
            {"reasons", r.reasons},
            {"repeats", r.repeats},
            {"unknowns", r.unknowns},
            {"multipliers", r.multipliers},
            {"cells", {{"inner", r.cells[0]}, {"boundary", r.cells[1]}, {"outer", r.cells[2]}}},
            {"solver_seconds", r.solver_seconds},
            {"seconds", r.seconds},
            {"cpu_seconds", r.cpu_seconds},
            {"stages", stages},
            {"peak_bytes", r.peak_bytes > 0 ? OrderedJson(r.peak_bytes) : OrderedJson(nullptr)},
            {"estimated_error", optional_number(r.estimated_error)},
            {"passes", passes_json(r)},
            {"errors", errors}};
}

OrderedJson run_index(const std::optional<std::size_t>& run) {
    return run ? OrderedJson(*run) : OrderedJson(nullptr);
}

OrderedJson prices_json(const Study& study, std::size_t measure) {
    OrderedJson cheapest = OrderedJson::array(), halving = OrderedJson::array();
    for (const CheapestSetting& c : cheapest_settings(study, measure))
        cheapest.push_back({{"error", c.error}, {"level_run", run_index(c.level)}, {"grid_run", run_index(c.grid)}});
    for (const PriceOfHalving& p : prices_of_halving(study, measure))
        halving.push_back({{"family", p.family}, {"factor", p.factor}, {"errors", {p.first_error, p.last_error}}});
    return {{"cheapest", cheapest}, {"halving_the_error", halving}};
}

OrderedJson measure_json(const Study& study, std::size_t k) {
    OrderedJson json{{"quantity", study.measures[k].what}, {"held_by_all", study.measures[k].held}};
    if (!study.measures[k].held) json.update(prices_json(study, k));
    return json;
}

}  // namespace

std::string study_csv(const Study& study) {
    std::string text =
        "kind,level,degree,basis,size,status,repeats,unknowns,multipliers,cells_inner,cells_boundary,cells_outer,solver_"
        "seconds,"
        "seconds,cpu_seconds";
    for (const char* stage : study_stages) text += "," + std::string(stage);
    text += ",peak_bytes,estimated_error";
    for (const StudyMeasure& m : study.measures) text += "," + csv_field("error of " + m.what);
    text += ",message\n";
    for (const StudyRun& run : study.runs) text += csv_line(run);
    return text;
}

std::string study_json(const Study& study) {
    OrderedJson measures = OrderedJson::array(), runs = OrderedJson::array();
    for (std::size_t k = 0; k < study.measures.size(); ++k) measures.push_back(measure_json(study, k));
    for (const StudyRun& run : study.runs) runs.push_back(run_json(run));
    const OrderedJson all{{"title", study.title},
                          {"scene", study.file},
                          {"reference", study.reference},
                          {"reference_run", study.reference_run ? OrderedJson(*study.reference_run) : OrderedJson(nullptr)},
                          {"budget_seconds", study.budget},
                          {"seconds", study.seconds},
                          {"notes", study.notes},
                          {"measures", measures},
                          {"runs", runs}};
    return all.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace abut
