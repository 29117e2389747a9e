// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/effect_answers.hpp"

#include <algorithm>
#include <map>

#include "src/discretization/shared_grids.hpp"

namespace abut {

namespace {

/// Pairs of parts that were found to face each other, in the contacts' order, each once.
std::vector<std::array<std::string, 2>> pairs_of(const Result& result, const std::string& kind) {
    std::vector<std::array<std::string, 2>> pairs;
    for (const ContactResult& c : result.contacts)
        if (c.kind == kind && std::find(pairs.begin(), pairs.end(), c.parts) == pairs.end()) pairs.push_back(c.parts);
    return pairs;
}

void take_parts_of_pairs(const Result& result, Effect& e) {
    e.parts.clear();
    for (const PartResult& part : result.parts)
        if (std::any_of(e.pairs.begin(), e.pairs.end(), [&](const auto& p) { return p[0] == part.name || p[1] == part.name; }))
            e.parts.push_back(part.name);
}

/// A part that is not solved takes no part in any effect.
void leave_out_idle_parts(const Result& result, Effect& e) {
    for (const PartResult& part : result.parts)
        if (!part.solved) std::erase(e.parts, part.name);
}

}  // namespace

void fill_effects(const Scene& scene, const Outcome& out, double seconds, Result& result) {
    std::map<int, int> model_of;
    for (const PartOnGrid& g : out.solved.grids)
        if (g.model >= 0) model_of[g.part] = g.model;
    result.effects.push_back(shared_grids_effect(scene, model_of));
    for (Effect& e : result.effects) {
        if (const auto use = out.uses.find(e.name); use != out.uses.end()) {
            e.seconds = use->second.seconds;
            e.items = use->second.items;
            e.share = seconds > 0 ? e.seconds / seconds : 0;
        }
        if (e.name == "contact" || e.name == "bonding") {
            e.pairs = pairs_of(result, e.name == "contact" ? "contact" : "bonded");
            take_parts_of_pairs(result, e);
        }
        leave_out_idle_parts(result, e);
    }
}

}  // namespace abut
