// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plan/plan.hpp"

#include <algorithm>

#include "src/io/number_text.hpp"
#include "src/plan/axisymmetric.hpp"
#include "src/plan/loads.hpp"
#include "src/plan/rigid_parts.hpp"

namespace abut {

namespace {

bool has_load(const Scene& scene, Load::Kind kind) {
    return std::any_of(scene.loads.begin(), scene.loads.end(), [&](const Load& l) { return l.kind == kind; });
}

/// The first rigid part's reason stands for all.
std::string why_any_rigid(const Scene& scene) {
    for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i)
        if (const std::string why = why_rigid(scene, i); !why.empty())
            return "a part moves as one body: " + why + " (" + scene.parts[static_cast<std::size_t>(i)].name + ")";
    return "";
}

Effect effect(const std::string& name, bool on, const std::string& why_on, const std::string& why_off) {
    Effect e;
    e.name = name;
    e.on = on;
    e.why = on ? why_on : why_off;
    return e;
}

/// Which parts the axis goes through: they are held there by the program.
std::string why_axisymmetric(const Scene& scene) {
    std::string parts;
    for (const ScenePart& part : scene.parts)
        if (touches_axis(part.part)) parts += (parts.empty() ? "" : ", ") + part.name;
    const std::string why = "x is the radius, y the axis; hoops stretch by u_x / x";
    return parts.empty() ? why : why + "; u_x = 0 is held on the axis of " + parts;
}

std::string kinematics_of(Analysis analysis) {
    if (analysis == Analysis::axisymmetric) return "around an axis";
    return analysis == Analysis::plane_strain ? "plane strain" : "plane stress";
}

}  // namespace

bool is_nearly_incompressible(const Scene& scene, const Material& material) {
    return scene.analysis != Analysis::plane_stress && material.nu >= projection_from;
}

std::vector<Effect> plan_effects(const Scene& scene) {
    const bool incompressible = std::any_of(scene.parts.begin(), scene.parts.end(), [&](const ScenePart& part) {
        return is_nearly_incompressible(scene, scene.materials[static_cast<std::size_t>(part.material)]);
    });
    const bool interference = std::any_of(scene.contacts.pairs.begin(), scene.contacts.pairs.end(),
                                          [](const PairRule& r) { return r.interference != 0; });
    const bool bonded = std::any_of(scene.contacts.pairs.begin(), scene.contacts.pairs.end(),
                                    [](const PairRule& r) { return r.kind == PairRule::Kind::bonded; });
    const bool edges = std::any_of(scene.loads.begin(), scene.loads.end(), is_edge_load);
    const bool contact = searches_contacts(scene);
    const bool friction =
        contact && (scene.contacts.friction > 0 || std::any_of(scene.contacts.pairs.begin(), scene.contacts.pairs.end(),
                                                               [](const PairRule& r) { return r.friction.value_or(0) > 0; }));
    const std::string rigid = why_any_rigid(scene);
    std::vector<Effect> effects{
        effect("elasticity", true, kinematics_of(scene.analysis) + ", small displacements", ""),
        effect("contact", contact, "several parts; every pair is searched",
               "only one part, or detection is off and no pair is given"),
        effect("rigid parts", !rigid.empty(), rigid,
               scene.analysis == Analysis::axisymmetric
                   ? "not around an axis"
                   : "no material \"rigid\", and no part stiffer than its neighbours by 1e6 that its own loads do not deform"),
        effect("edge loads", edges, "a pressure, traction, force or moment on edges", "no load on an edge"),
        effect("body force",
               has_load(scene, Load::Kind::body_force) || has_load(scene, Load::Kind::part_force) ||
                   has_load(scene, Load::Kind::part_moment),
               "a force per volume, or a force or moment on a whole part", "no body force"),
        effect("gravity", has_load(scene, Load::Kind::gravity), "gravity is given", "no gravity"),
        effect("rigid supports", has_support(scene, Support::Kind::rigid), "a part is held by its mean motion",
               "no rigid support"),
        effect("held points", has_support(scene, Support::Kind::points), "a part is held at points", "no point is held"),
        effect("interference", interference || scene.contacts.overlap == "press_fit",
               "an interference or drawn overlap closes gaps", "no interference"),
        effect("bonding", bonded, "a pair of edges is bonded", "no bonded pair"),
        effect("friction", friction, "faces that can touch have friction", contact ? "friction is 0" : "no pair can touch"),
        effect("springs", has_support(scene, Support::Kind::spring), "edges rest on springs", "no spring support"),
        effect("temperature", has_load(scene, Load::Kind::temperature), "a part is warmer or colder than when it was drawn",
               "no temperature load"),
        effect("preload", has_load(scene, Load::Kind::preload),
               "a part is tightened before the other loads act: its shortening is found from the force across the cut",
               "no preload"),
        effect("spin", has_load(scene, Load::Kind::spin), "a part turns: centrifugal force", "no spin load"),
        effect("incompressibility", incompressible,
               "a part that is not in plane stress has a Poisson's ratio of " + number_text(projection_from, 2) +
                   " or more: its volume strain is projected onto splines of one degree less",
               scene.analysis != Analysis::plane_stress ? "every Poisson's ratio is below " + number_text(projection_from, 2)
                                                        : "not plane strain"),
    };
    if (scene.analysis == Analysis::axisymmetric) effects.push_back(effect("axisymmetry", true, why_axisymmetric(scene), ""));
    return effects;
}

std::vector<bool> parts_to_solve(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<std::pair<int, int>>& touching,
                                 const std::vector<std::pair<int, int>>& closing) {
    std::vector<bool> solve(scene.parts.size());
    for (std::size_t i = 0; i < solve.size(); ++i) solve[i] = is_driven(scene, conditions, static_cast<int>(i));
    for (const auto& [a, b] : closing) solve[static_cast<std::size_t>(a)] = solve[static_cast<std::size_t>(b)] = true;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, b] : touching)
            if (solve[static_cast<std::size_t>(a)] != solve[static_cast<std::size_t>(b)]) {
                solve[static_cast<std::size_t>(a)] = solve[static_cast<std::size_t>(b)] = true;
                changed = true;
            }
    }
    return solve;
}

}  // namespace abut
