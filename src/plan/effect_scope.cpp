// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts and pairs of parts each effect of the plan concerns, from the scene alone.
#include <algorithm>
#include <set>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidates.hpp"
#include "src/plan/loads.hpp"
#include "src/plan/plan.hpp"
#include "src/plan/rigid_parts.hpp"
#include "src/plan/support_components.hpp"

namespace abut {

namespace {

using Pairs = std::vector<std::array<std::string, 2>>;
using IndexPair = std::array<int, 2>;

class EffectScope {
public:
    EffectScope(const Scene& scene, const ResolvedConditions& conditions) : scene_(scene), conditions_(conditions) {}

    std::vector<std::string> parts(const std::string& effect) const {
        if (effect == "contact" || effect == "friction" || effect == "bonding" || effect == "interference")
            return parts_of(pairs(effect));
        std::vector<std::string> names;
        for (std::size_t i = 0; i < scene_.parts.size(); ++i)
            if (concerns(effect, static_cast<int>(i))) names.push_back(scene_.parts[i].name);
        return names;
    }

    Pairs pairs(const std::string& effect) const {
        if (effect == "contact") return named(searched());
        if (effect == "bonding") return named(ruled([](const PairRule& r) { return r.kind == PairRule::Kind::bonded; }));
        if (effect == "friction" && scene_.contacts.friction > 0) return named(searched());
        if (effect == "friction") return named(ruled([](const PairRule& r) { return r.friction.value_or(0) > 0; }));
        if (effect != "interference") return {};
        if (scene_.contacts.overlap == "press_fit") return named(searched());
        return named(ruled([](const PairRule& r) { return r.interference != 0; }));
    }

private:
    bool concerns(const std::string& effect, int part) const {
        const ScenePart& p = scene_.parts[at(part)];
        if (effect == "elasticity") return why_rigid(scene_, part).empty();
        if (effect == "axisymmetry") return true;
        if (effect == "rigid parts") return !why_rigid(scene_, part).empty();
        if (effect == "incompressibility") return is_nearly_incompressible(scene_, scene_.materials[at(p.material)]);
        for (std::size_t k = 0; k < scene_.loads.size(); ++k)
            if (effect_of(scene_.loads[k]) == effect && loaded(part, k)) return true;
        for (std::size_t k = 0; k < scene_.supports.size(); ++k)
            if (effect_of(scene_.supports[k]) == effect && supported(part, k)) return true;
        return false;
    }

    bool loaded(int part, std::size_t load) const {
        return is_edge_load(scene_.loads[load]) ? has_portion(conditions_.loads[load], part)
                                                : acts_on_volume_of(scene_, scene_.loads[load], part);
    }

    bool supported(int part, std::size_t support) const {
        return has_portion(conditions_.supports[support], part) || scene_.supports[support].part == scene_.parts[at(part)].name;
    }

    static bool has_portion(const std::vector<EdgePortion>& portions, int part) {
        return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& p) { return p.part == part; });
    }

    /// Pairs whose boxes come within the search distance; without detection those that a rule names.
    std::vector<IndexPair> searched() const {
        if (!scene_.contacts.detect) return ruled([](const PairRule& r) { return r.kind != PairRule::Kind::ignore; });
        const SearchDistances distances(scene_);
        std::vector<IndexPair> found;
        const int n = static_cast<int>(scene_.parts.size());
        for (int i = 0; i < n; ++i)
            for (int j = i + 1; j < n; ++j)
                if (distances.within(i, j, distances.searched(i, j, 1))) found.push_back({i, j});
        return found;
    }

    template <class Wanted>
    std::vector<IndexPair> ruled(Wanted wanted) const {
        std::set<IndexPair> found;
        for (const PairRule& rule : scene_.contacts.pairs) {
            if (!wanted(rule)) continue;
            for (const EdgePortion& a : rule.on[0])
                for (const EdgePortion& b : rule.on[1])
                    if (a.part != b.part && have_common_level(scene_.parts[at(a.part)].level, scene_.parts[at(b.part)].level))
                        found.insert({std::min(a.part, b.part), std::max(a.part, b.part)});
        }
        return {found.begin(), found.end()};
    }

    Pairs named(const std::vector<IndexPair>& pairs) const {
        Pairs names;
        for (const auto& [i, j] : pairs) names.push_back({scene_.parts[at(i)].name, scene_.parts[at(j)].name});
        return names;
    }

    std::vector<std::string> parts_of(const Pairs& pairs) const {
        std::vector<std::string> names;
        for (const ScenePart& part : scene_.parts)
            if (std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) { return p[0] == part.name || p[1] == part.name; }))
                names.push_back(part.name);
        return names;
    }

    const Scene& scene_;
    const ResolvedConditions& conditions_;
};

}  // namespace

std::vector<Effect> plan_effects(const Scene& scene, const ResolvedConditions& conditions) {
    ENSURE(is_resolved(scene, conditions), "conditions are resolved for this scene");
    std::vector<Effect> effects = plan_effects(scene);
    const EffectScope scope(scene, conditions);
    for (Effect& effect : effects) {
        if (!effect.on) continue;
        effect.parts = scope.parts(effect.name);
        effect.pairs = scope.pairs(effect.name);
    }
    return effects;
}

}  // namespace abut
