// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/dissertation_limits.hpp"

#include "src/plan/rigid_parts.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

void append_dissertation_problems(const Scene& scene, std::vector<Problem>& problems) {
    if (!is_by_dissertation(scene)) return;
    const auto refuse = [&](const std::string& where, const std::string& what) {
        problems.push_back({where, "the dissertation's method has no formulation for " + what,
                            "take it out of the scene, or accuracy.method out"});
    };
    if (scene.analysis == Analysis::axisymmetric) refuse("/analysis", "parts around an axis");
    for (const Support& s : scene.supports) {
        if (s.kind == Support::Kind::spring) refuse(s.where, "edges on springs");
        if (s.kind == Support::Kind::rigid) refuse(s.where, "parts held by their mean motion");
    }
    for (const Load& load : scene.loads)
        if (load.kind == Load::Kind::temperature || load.kind == Load::Kind::preload)
            refuse(load.where, load.kind == Load::Kind::preload ? "preloads" : "temperatures");
    for (const PairRule& rule : scene.contacts.pairs)
        if (rule.kind == PairRule::Kind::bonded) refuse(rule.where, "bonded edges");
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (const std::string why = why_rigid(scene, static_cast<int>(i)); !why.empty())
            refuse(scene.parts[i].where, "parts that move as one body, and " + scene.parts[i].name + " is one: " + why);
}

}  // namespace abut
