// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plan_text.hpp"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>

namespace abut {

std::string plan_table(const std::vector<Effect>& effects) {
    std::size_t width = 0;
    for (const Effect& effect : effects) width = std::max(width, effect.name.size());
    std::string text;
    for (const Effect& effect : effects) {
        text += effect.name + std::string(width + 2 - effect.name.size(), ' ') + (effect.on ? "on   " : "off  ") + effect.why +
                "\n";
    }
    return text;
}

std::string plan_json(const std::vector<Effect>& effects) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Effect& effect : effects) list.push_back({{"name", effect.name}, {"on", effect.on}, {"why", effect.why}});
    return list.dump(2) + "\n";
}

}  // namespace abut
