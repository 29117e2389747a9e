// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/model_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace abut {

namespace {

using FactsJson = nlohmann::ordered_json;

std::string with_digits(double value, int digits) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, value + 0.0);  // no -0
    return text.data();
}

/// As many digits as a picture has room for, and all before the point: components of a direction are seldom round.
std::string shown(double value) {
    constexpr int least = 5, most = 15;
    const int before_point = value == 0 ? 1 : 1 + static_cast<int>(std::floor(std::log10(std::abs(value) * (1 + 0.5e-5))));
    return with_digits(value, std::clamp(before_point, least, most));
}

FactsJson optional_fact(const std::optional<double>& value) {
    return value ? FactsJson(*value) : FactsJson(nullptr);
}

FactsJson material_fact(const MaterialFacts& m) {
    return {{"name", m.name},
            {"E", m.rigid ? FactsJson(nullptr) : FactsJson(m.E)},
            {"nu", m.rigid ? FactsJson(nullptr) : FactsJson(m.nu)},
            {"density", optional_fact(m.density)},
            {"expansion", optional_fact(m.expansion)},
            {"yield", optional_fact(m.yield)},
            {"rigid", m.rigid}};
}

/// Empty lists are lists, too.
template <class T, class ToJson>
FactsJson facts_list(const std::vector<T>& items, ToJson to_json) {
    FactsJson list = FactsJson::array();
    for (const T& item : items) list.push_back(to_json(item));
    return list;
}

FactsJson text_list(const std::vector<std::string>& texts) {
    return facts_list(texts, [](const std::string& text) { return FactsJson(text); });
}

FactsJson load_fact(const LoadFacts& l) {
    FactsJson value = nullptr;
    if (l.value.size() == 1) value = l.value[0];
    if (l.value.size() > 1) value = l.value;
    return {{"name", l.name}, {"kind", l.kind}, {"value", value}, {"unit", l.unit}, {"on", text_list(l.on)}};
}

}  // namespace

std::string model_json(const ModelFacts& model) {
    FactsJson j;
    j["files"] = facts_list(model.files, [](const HashedFile& f) { return FactsJson{{"file", f.file}, {"hash", f.hash}}; });
    j["units"] = {{"length", model.length_unit}, {"force", model.force_unit}};
    j["analysis"] = model.analysis;
    j["materials"] = facts_list(model.materials, material_fact);
    j["parts"] = facts_list(model.parts, [](const PartFacts& p) {
        return FactsJson{
            {"name", p.name}, {"material", p.material}, {"thickness", p.thickness}, {"default_thickness", p.default_thickness}};
    });
    j["loads"] = facts_list(model.loads, load_fact);
    j["supports"] = facts_list(model.supports, [](const SupportFacts& s) {
        return FactsJson{{"label", s.label}, {"on", text_list(s.on)}};
    });
    return j.dump(-1, ' ', false, FactsJson::error_handler_t::replace);
}

std::string fact_number(double value) {
    return with_digits(value, 8);
}

std::string load_words(const LoadFacts& load) {
    std::string words = load.kind + " ";
    std::replace(words.begin(), words.end(), '_', ' ');
    if (load.value.empty()) return words + "that varies";
    if (load.value.size() == 1) {
        words += shown(load.value[0]);
    } else {
        const double rounding = 1e-12 * std::hypot(load.value[0], load.value[1]);
        const auto component = [&](double value) { return shown(std::abs(value) > rounding ? value : 0.0); };
        words += "(" + component(load.value[0]) + ", " + component(load.value[1]) + ")";
    }
    return load.unit.empty() ? words : words + " " + load.unit;
}

std::string analysis_words(const ModelFacts& model) {
    std::string words = model.analysis;
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

}  // namespace abut
