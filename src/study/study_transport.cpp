// SPDX-License-Identifier: GPL-3.0-or-later
// What a run's process sends back, as JSON: every double comes back bit for bit.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "src/study/study_measure.hpp"

namespace abut {

namespace {

using Json = nlohmann::json;

/// JSON has no word for what is not a number.
Json sent_number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double number_of(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (double v : values) list.push_back(sent_number(v));
    return list;
}

std::vector<double> numbers_of(const Json& json) {
    std::vector<double> values;
    for (const Json& v : json) values.push_back(number_of(v));
    return values;
}

Json point(const Vec2& v) {
    return numbers({v.x(), v.y()});
}

Vec2 point_of(const Json& json) {
    return {number_of(json[0]), number_of(json[1])};
}

Json sent_optional(const std::optional<double>& value) {
    return value ? sent_number(*value) : Json(nullptr);
}

std::optional<double> optional_number_of(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Json pass_json(const PassSummary& p) {
    return {{"unknowns", p.unknowns},
            {"multipliers", p.multipliers},
            {"seconds", p.seconds},
            {"estimated_error", sent_optional(p.estimated_error)}};
}

PassSummary pass_of(const Json& json) {
    return {json["unknowns"], json["multipliers"], json["seconds"], optional_number_of(json["estimated_error"])};
}

Json sent_run(const StudyRun& r) {
    Json passes = Json::array();
    for (const PassSummary& p : r.passes) passes.push_back(pass_json(p));
    return {{"failed", r.status == StudyRun::Status::failed},
            {"message", r.message},
            {"reasons", r.reasons},
            {"repeats", r.repeats},
            {"unknowns", r.unknowns},
            {"multipliers", r.multipliers},
            {"cells", r.cells},
            {"stage", r.stage},
            {"solver_seconds", r.solver_seconds},
            {"seconds", r.seconds},
            {"cpu_seconds", r.cpu_seconds},
            {"estimated_error", sent_optional(r.estimated_error)},
            {"passes", passes}};
}

StudyRun run_of(const Json& json) {
    StudyRun r;
    r.status = json["failed"] ? StudyRun::Status::failed : StudyRun::Status::ok;
    r.message = json["message"];
    r.reasons = json["reasons"];
    r.repeats = json["repeats"];
    r.unknowns = json["unknowns"];
    r.multipliers = json["multipliers"];
    r.cells = json["cells"].get<std::array<int, 3>>();
    r.stage = json["stage"].get<StageSeconds>();
    r.solver_seconds = json["solver_seconds"];
    r.seconds = json["seconds"];
    r.cpu_seconds = json["cpu_seconds"];
    r.estimated_error = optional_number_of(json["estimated_error"]);
    for (const Json& p : json["passes"]) r.passes.push_back(pass_of(p));
    return r;
}

Json answer_json(const StudyAnswer& answer) {
    Json contacts = Json::array(), probes = Json::array();
    for (const StudyAnswer::Contact& c : answer.contacts)
        contacts.push_back({{"between", c.between},
                            {"force", point(c.force)},
                            {"peak", sent_number(c.peak)},
                            {"x", numbers(c.x)},
                            {"y", numbers(c.y)},
                            {"pressure", numbers(c.pressure)}});
    for (const Vec2& u : answer.probes) probes.push_back(point(u));
    return {{"contacts", contacts},
            {"probes", probes},
            {"energy", sent_number(answer.energy)},
            {"stress", sent_number(answer.stress)}};
}

StudyAnswer answer_of(const Json& json) {
    StudyAnswer answer;
    for (const Json& c : json["contacts"])
        answer.contacts.push_back({c["between"], point_of(c["force"]), number_of(c["peak"]), numbers_of(c["x"]),
                                   numbers_of(c["y"]), numbers_of(c["pressure"])});
    for (const Json& u : json["probes"]) answer.probes.push_back(point_of(u));
    answer.energy = number_of(json["energy"]);
    answer.stress = number_of(json["stress"]);
    return answer;
}

Json problem_json(const Problem& p) {
    return {{"where", p.where}, {"what", p.what}, {"hint", p.hint}};
}

Json grid_json(const StudyGrid& g) {
    Json halved = Json::array();
    for (const PartResult::Halved& h : g.halved) halved.push_back({h.low.x(), h.low.y(), h.high.x(), h.high.y(), h.levels});
    return {{"part", g.part},    {"angle", g.angle}, {"x", numbers(g.x)},
            {"y", numbers(g.y)}, {"halved", halved}, {"n_cells", g.n_cells}};
}

}  // namespace

std::string measured_text(const StudyMeasured& m) {
    Json problems = Json::array(), grids = Json::array();
    for (const Problem& p : m.problems) problems.push_back(problem_json(p));
    for (const StudyGrid& g : m.grids) grids.push_back(grid_json(g));
    const Json all{{"run", sent_run(m.run)},
                   {"problems", problems},
                   {"known_error", numbers(m.known_error)},
                   {"answer", answer_json(m.answer)},
                   {"grids", grids}};
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

StudyMeasured measured_from(const std::string& text) {
    const Json json = Json::parse(text);
    StudyMeasured m;
    m.run = run_of(json["run"]);
    for (const Json& p : json["problems"]) m.problems.push_back({p["where"], p["what"], p["hint"]});
    m.known_error = numbers_of(json["known_error"]);
    m.answer = answer_of(json["answer"]);
    for (const Json& g : json["grids"]) {
        m.grids.push_back({g["part"], g["angle"], numbers_of(g["x"]), numbers_of(g["y"]), {}, g["n_cells"]});
        for (const Json& h : g["halved"])
            m.grids.back().halved.push_back(
                {{h[0].get<double>(), h[1].get<double>()}, {h[2].get<double>(), h[3].get<double>()}, h[4]});
    }
    return m;
}

}  // namespace abut
