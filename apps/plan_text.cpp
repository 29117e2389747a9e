// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plan_text.hpp"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

namespace abut {

namespace {

constexpr std::size_t named = 6;  // of parts or pairs; the JSON has them all

/// ": a, b, c" or ": a - b, c - d".
std::string reach_text(const Effect& effect) {
    std::vector<std::string> names = effect.parts;
    if (!effect.pairs.empty()) {
        names.clear();
        for (const auto& pair : effect.pairs) names.push_back(pair[0] + " - " + pair[1]);
    }
    std::string text;
    for (std::size_t k = 0; k < std::min(named, names.size()); ++k) text += (k == 0 ? ": " : ", ") + names[k];
    return names.size() > named ? text + ", and " + std::to_string(names.size() - named) + " more" : text;
}

}  // namespace

std::string plan_table(const std::vector<Effect>& effects) {
    std::size_t width = 0;
    for (const Effect& effect : effects) width = std::max(width, effect.name.size());
    std::string text;
    for (const Effect& effect : effects) {
        text += effect.name + std::string(width + 2 - effect.name.size(), ' ') + (effect.on ? "on   " : "off  ") + effect.why +
                reach_text(effect) + "\n";
    }
    return text;
}

std::string plan_json(const std::vector<Effect>& effects) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Effect& e : effects)
        list.push_back({{"name", e.name}, {"on", e.on}, {"why", e.why}, {"parts", e.parts}, {"pairs", e.pairs}});
    return list.dump(2) + "\n";
}

}  // namespace abut
