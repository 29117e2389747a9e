// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/left_out_parts.hpp"

#include <algorithm>

#include "geometry/brep/input_error.hpp"
#include "src/contact/candidates.hpp"
#include "src/plan/plan.hpp"

namespace abut {

Effect left_out_effect(const Scene& scene, const ResolvedConditions& conditions) {
    Effect effect;
    effect.name = "parts left out";
    try {
        const std::vector<Candidate> candidates = find_candidates(scene, 1);
        const std::vector<bool> solved =
            parts_to_solve(scene, conditions, touching_pairs(candidates), closing_pairs(scene, candidates));
        for (std::size_t i = 0; i < solved.size(); ++i)
            if (!solved[i]) effect.parts.push_back(scene.parts[i].name);
        effect.on = !effect.parts.empty();
        effect.why = effect.on ? "not analysed: they carry no load, and no face of them touches a part that does"
                               : "every part carries a load, or touches one that does";
    } catch (const InputError& error) {
        effect.why = "not known, since contacts cannot be searched: " + one_line(error.problems().front());
    }
    return effect;
}

std::vector<std::string> left_out_parts(const Result& result) {
    std::vector<std::string> names;
    for (const PartResult& part : result.parts)
        if (!part.solved) names.push_back(part.name);
    return names.size() == result.parts.size() ? std::vector<std::string>{} : names;
}

std::string left_out_text(const std::vector<std::string>& parts) {
    if (parts.empty()) return "";
    std::string names;
    for (const std::string& part : parts) names += (names.empty() ? "" : ", ") + part;
    return parts.size() == 1
               ? "part " + names + " is not analysed: it carries no load, and no face of it touches a part that does"
               : "parts " + names + " are not analysed: they carry no load, and no face of them touches a part that does";
}

}  // namespace abut
