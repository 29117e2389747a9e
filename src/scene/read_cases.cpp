// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/read_cases.hpp"

#include <algorithm>
#include <cctype>

#include "src/io/nearest_name.hpp"
#include "src/scene/load_cases.hpp"

namespace abut {

namespace {

std::vector<std::string> names_of_loads(const Scene& scene) {
    std::vector<std::string> names;
    for (const Load& load : scene.loads)
        if (!load.name.empty() && std::find(names.begin(), names.end(), load.name) == names.end()) names.push_back(load.name);
    return names;
}

std::vector<std::string> names_of_cases(const Scene& scene) {
    std::vector<std::string> names;
    for (const LoadCase& c : scene.cases) names.push_back(c.name);
    return names;
}

bool names_any(const Scene& scene, const std::string& name, Load::Kind kind) {
    return std::any_of(scene.loads.begin(), scene.loads.end(),
                       [&](const Load& load) { return load.name == name && load.kind == kind; });
}

void read_factor(SceneReading& reading, const JsonValue& value, const Scene& scene, LoadCase& c) {
    const std::vector<std::string> known = names_of_loads(scene);
    if (std::find(known.begin(), known.end(), value.key) == known.end())
        return report_problem(reading, value, "no load has the name '" + shortened(value.key) + "'",
                              known.empty() ? "give loads a \"name\"" : nearest_name_hint(value.key, known));
    const std::optional<double> factor = read_number(reading, value, dimension::none);
    if (!factor) return;
    if (*factor < 0 && names_any(scene, value.key, Load::Kind::preload))
        return report_problem(reading, value, "a preload pulls two sides of a cut together: its factor is negative",
                              "give a factor above 0, or leave the load out");
    if (*factor < 0 && names_any(scene, value.key, Load::Kind::spin))
        return report_problem(reading, value, "a spin cannot pull inwards: its factor is negative",
                              "the factor is of the load, which grows with the square of the speed");
    c.factors[value.key] = *factor;
}

std::optional<LoadCase> read_case(SceneReading& reading, const JsonValue& value, const Scene& scene) {
    if (!check_object(reading, value, {"name", "loads"})) return std::nullopt;
    LoadCase c;
    c.where = value.pointer;
    const auto name = required_member(reading, value, "name", read_text);
    const JsonValue* loads = required(reading, value, "loads");
    if (loads && loads->kind != JsonValue::Kind::object) {
        report_problem(reading, *loads, "expected factors by the names of loads, found " + described(*loads),
                       "write, for instance, {\"weight\": 1}");
        return std::nullopt;
    }
    if (!name || !loads) return std::nullopt;
    if (std::any_of(name->begin(), name->end(), [](char k) { return std::iscntrl(static_cast<unsigned char>(k)); })) {
        report_problem(reading, *find_member(value, "name"), "a name has no line breaks or other control characters");
        return std::nullopt;
    }
    c.name = *name;
    for (const JsonValue& item : loads->items) read_factor(reading, item, scene, c);
    return c;
}

}  // namespace

void read_cases(SceneReading& reading, const JsonValue& cases, Scene& scene) {
    const std::string one = case_word(scene);
    if (!check_list(reading, cases, 1, one + "s")) return;
    for (const JsonValue& item : cases.items) {
        std::optional<LoadCase> c = read_case(reading, item, scene);
        if (!c) continue;
        const std::vector<std::string> known = names_of_cases(scene);
        if (std::find(known.begin(), known.end(), c->name) != known.end())
            report_problem(reading, item, "another " + one + " has the name '" + shortened(c->name) + "'",
                           "give it one of its own");
        scene.cases.push_back(std::move(*c));
    }
    for (const std::string& name : names_of_loads(scene)) {
        const auto takes = [&](const LoadCase& c) {
            const auto factor = c.factors.find(name);
            return factor != c.factors.end() && factor->second != 0;
        };
        if (std::none_of(scene.cases.begin(), scene.cases.end(), takes))
            scene.warnings.push_back("the load '" + name + "' acts in no " + one);
    }
}

void check_cases_of_expectations(SceneReading& reading, const Scene& scene) {
    const std::vector<std::string> known = names_of_cases(scene);
    for (const Expectation& e : scene.expect) {
        if (std::find(known.begin(), known.end(), e.in_case) != known.end() || (known.empty() && e.in_case.empty())) continue;
        const JsonValue& at = *find_pointer(reading.root, e.where);
        if (known.empty())
            report_problem(reading, at, "the scene has no " + case_word(scene) + "s", "leave \"case\" out");
        else if (e.in_case.empty())
            report_problem(reading, at, "which " + case_word(scene) + " has this answer is not said",
                           "give \"case\", one of " + listed(known));
        else
            report_problem(reading, at, "there is no " + case_word(scene) + " '" + shortened(e.in_case) + "'",
                           nearest_name_hint(e.in_case, known));
    }
}

}  // namespace abut
