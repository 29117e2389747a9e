// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generated/estimate_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/brep/input_error.hpp"
#include "src/analysis/analysis.hpp"
#include "src/scene/read_scene.hpp"
#include "tests/verification/true_errors.hpp"

namespace abut::test {

using Json = nlohmann::json;

/// What one answer says of a quantity ("peak of a on b"), and how far it says that to be off, relative.
struct Value {
    double value = 0;
    std::optional<double> error{};
};
struct Values {
    std::map<std::string, Value> of{};
};

namespace {

struct Level {
    const char* name;
    double target;
};
constexpr std::array<Level, 3> levels{{{"draft", 0.05}, {"standard", 0.01}, {"fine", 0.002}}};
constexpr double reference_target = 0.0004;
/// Forces that statics determine are exact, and say so: no matter of estimates.
constexpr double least_truth = 1e-7;
constexpr double too_low = 2;
/// Forces below this fraction of peak times length cancel all around a part: their sum is rounding.
constexpr double cancels = 1e-3;

std::optional<double> optional_number(const Json& j, const std::string& key) {
    if (!j.is_object() || !j.contains(key) || !j[key].is_number()) return std::nullopt;
    return j[key].get<double>();
}

std::string pair_name(const Json& parts) {
    const auto a = parts[0].get<std::string>(), b = parts[1].get<std::string>();
    return a < b ? a + " on " + b : b + " on " + a;
}

/// Read from result.json, so that what an answer states in addition is seen as soon as it does. Pairs that touch in several
/// zones are left out: their zones may be told apart in one run and not in the next.
Values values_of(const Result& result) {
    const Json r = Json::parse(result_json(result));
    Values v;
    v.of["energy"] = {r["strain_energy"].get<double>(), optional_number(r["error_estimate"], "energy")};
    std::map<std::string, int> zones;
    for (const Json& c : r["contacts"])
        if (c["status"] != "open") ++zones[pair_name(c["parts"])];
    for (const Json& c : r["contacts"]) {
        const std::string name = " of " + pair_name(c["parts"]);
        if (c["status"] == "open" || zones[pair_name(c["parts"])] > 1) continue;
        const Json& e = c["errors"];
        const auto force = c["force"].get<std::array<double, 2>>();
        const double resultant = std::hypot(force[0], force[1]);
        if (resultant > cancels * c["max_pressure"]["value"].get<double>() * c["contact_length"].get<double>())
            v.of["force" + name] = {resultant, optional_number(e, "force")};
        v.of["length" + name] = {c["contact_length"].get<double>(), optional_number(e, "length")};
        if (!e.is_object() || !e["at_corner"].get<bool>())
            v.of["peak" + name] = {c["max_pressure"]["value"].get<double>(), optional_number(e, "peak")};
    }
    for (const Json& p : r["parts"]) {
        const std::string name = " of " + p["name"].get<std::string>();
        if (p["max_displacement"].is_object())
            v.of["displacement" + name] = {p["max_displacement"]["value"].get<double>(),
                                           optional_number(p["max_displacement"], "error")};
        if (p["max_von_mises"].is_object())
            v.of["von Mises" + name] = {p["max_von_mises"]["value"].get<double>(),
                                        optional_number(p["max_von_mises"], "error")};
    }
    return v;
}

std::optional<Values> run(Scene scene, double target) {
    scene.accuracy.target = target;
    AnalyzeOptions options;
    options.threads = 1;
    try {
        const Result r = analyze(scene, options);
        if (r.status == "ok") return values_of(r);
    } catch (const InputError&) {}
    return std::nullopt;
}

double share(std::vector<double> sorted, double p) {
    return sorted[static_cast<std::size_t>(std::lround(p * static_cast<double>(sorted.size() - 1)))];
}

std::string kind_of(const std::string& quantity) {
    return quantity.substr(0, quantity.find(" of "));
}

}  // namespace

void EstimateTable::compare(const std::string& name, const std::string& level, const Values& now, const Values& truth) {
    for (const auto& [quantity, exact] : truth.of) {
        const auto found = now.of.find(quantity);
        if (found == now.of.end() || exact.value == 0) continue;
        rows_.push_back({name, level, quantity, found->second.error, std::abs(found->second.value / exact.value - 1)});
    }
}

void EstimateTable::add(const std::string& name, const Scene& scene) {
    const auto truth = run(scene, reference_target);
    if (!truth) {
        ++refused_;
        return;
    }
    const Outcome reference = solved_to(scene, reference_target);
    for (const Level& level : levels) {
        const auto now = run(scene, level.target);
        if (!now) continue;
        compare(name, level.name, *now, *truth);
        const Outcome out = solved_to(scene, level.target);
        if (out.errors.empty() || !out.errors.back().contact_pressure ||
            out.passes.back().contacts.size() != reference.passes.back().contacts.size())
            continue;
        rows_.push_back({name, level.name, "pressure (L2)", out.errors.back().contact_pressure,
                         errors_against(out, reference).contact_pressure});
    }
}

void EstimateTable::add_against(const std::string& json) {
    const Json all = Json::parse(json);
    const Scene scene = read_scene_text(all["scene"].dump(), "assembly.json");
    Values truth;
    if (all.contains("energy")) truth.of["energy"] = {all["energy"].get<double>()};
    for (const Json& c : all["contacts"])
        for (const char* key : {"force", "peak", "length"})
            if (c.contains(key)) truth.of[key + std::string(" of ") + pair_name(c["parts"])] = {c[key].get<double>()};
    for (const Json& p : all.value("parts", Json::array())) {
        const std::string name = " of " + p["part"].get<std::string>();
        if (p.contains("displacement")) truth.of["displacement" + name] = {p["displacement"].get<double>()};
        if (p.contains("von_mises")) truth.of["von Mises" + name] = {p["von_mises"].get<double>()};
    }
    for (const Level& level : levels)
        if (const auto now = run(scene, level.target))
            compare(all["name"].get<std::string>(), level.name, *now, truth);
        else
            ++refused_;
}

std::string EstimateTable::rows() const {
    std::string text;
    char line[400];
    for (const Row& r : rows_) {
        std::snprintf(line, sizeof line, "%-28s %-9s %-40s truth %10.3g estimate %10.3g ratio %8.3g\n", r.scene.c_str(),
                      r.level.c_str(), r.quantity.c_str(), r.truth, r.estimate.value_or(NAN),
                      r.estimate.value_or(NAN) / r.truth);
        text += line;
    }
    return text;
}

std::string EstimateTable::summary() const {
    std::map<std::pair<std::string, std::string>, std::vector<const Row*>> groups;
    for (const Row& r : rows_) {
        groups[{kind_of(r.quantity), r.level}].push_back(&r);
        groups[{kind_of(r.quantity), "all"}].push_back(&r);
    }
    std::string text = std::to_string(refused_) +
                       " refused\n| quantity | level | n | true error, 50 %, 95 % | estimate over truth, 5 %, 50 %, 95 % | "
                       "within 2 | too low by 2 |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    char line[300];
    for (const auto& [key, rows] : groups) {
        std::vector<double> truths, ratios;
        int low = 0, within = 0;
        for (const Row* r : rows) {
            if (r->truth < least_truth) continue;
            truths.push_back(r->truth);
            if (!r->estimate) continue;
            const double ratio = *r->estimate / r->truth;
            ratios.push_back(ratio);
            low += ratio * too_low < 1;
            within += ratio * too_low >= 1 && ratio <= too_low;
        }
        if (truths.empty()) continue;
        std::sort(truths.begin(), truths.end());
        std::sort(ratios.begin(), ratios.end());
        std::snprintf(line, sizeof line, "| %s | %s | %zu | %.3g, %.3g | ", key.first.c_str(), key.second.c_str(),
                      truths.size(), share(truths, 0.5), share(truths, 0.95));
        text += line;
        if (ratios.empty()) {
            text += "none stated | | |\n";
            continue;
        }
        std::snprintf(line, sizeof line, "%.2g, %.2g, %.2g | %d of %zu | %d |\n", share(ratios, 0.05), share(ratios, 0.5),
                      share(ratios, 0.95), within, ratios.size(), low);
        text += line;
    }
    return text;
}

}  // namespace abut::test
