// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/shared_grids.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/brep/congruence.hpp"
#include "solver/linear_algebra/parallel_for.hpp"
#include "src/base/index.hpp"
#include "src/discretization/discretize.hpp"
#include "src/plan/loads.hpp"
#include "src/plan/rigid_parts.hpp"
#include "src/scene/dissertation_method.hpp"

namespace abut {

namespace {

/// Of what a cell costs, what is spent once for all that share it: its functions, stiffness and factor (half of 6 x 6 discs in
/// a box; the other half are rows of contact, displacements and stresses).
constexpr double share_of_making = 0.5;

bool has_portion(const std::vector<EdgePortion>& portions, int part) {
    return std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& p) { return p.part == part; });
}

/// Does anything but contact have a say in the part's stiffness, or in its displacement without loads?
bool is_one_of_its_kind(const Scene& scene, const ResolvedConditions& conditions, int part) {
    for (std::size_t k = 0; k < scene.supports.size(); ++k)
        if (scene.supports[k].part == scene.parts[at(part)].name || has_portion(conditions.supports[k], part)) return true;
    const std::vector<Load>& loads = scene.loads_of_all_cases.empty() ? scene.loads : scene.loads_of_all_cases;
    return std::any_of(loads.begin(), loads.end(), [&](const Load& load) {
        return (load.kind == Load::Kind::temperature || load.kind == Load::Kind::preload) &&
               acts_on_volume_of(scene, load, part);
    });
}

bool may_share(const Scene& scene) {
    const Accuracy& a = scene.accuracy;
    return scene.analysis != Analysis::axisymmetric && !is_by_dissertation(scene) && a.grids.empty() && a.refine.empty() &&
           !a.cell_size;
}

/// What the copy wants, where its model is.
void append_wanted(const CopiedPart& copy, const std::vector<WantedSize>& wanted, std::vector<WantedSize>& all) {
    for (WantedSize w : wanted) {
        for (Vec2& x : w.points) x = copy.from.to_global(copy.to.to_local(x));
        all.push_back(std::move(w));
    }
}

/// A model with its copies.
struct Family {
    std::vector<int> members;  ///< scene parts, the model first
    std::vector<WantedSize> wanted{};
};

}  // namespace

std::map<int, CopiedPart> copied_parts(const Scene& scene, const ResolvedConditions& conditions,
                                       const std::vector<bool>& parts) {
    std::map<int, CopiedPart> copies;
    if (!may_share(scene)) return copies;
    std::vector<int> models;
    for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
        if (!parts[at(i)] || is_one_of_its_kind(scene, conditions, i) || !why_rigid(scene, i).empty()) continue;
        const ScenePart& part = scene.parts[at(i)];
        const auto is_like = [&](int m) {
            const ScenePart& model = scene.parts[at(m)];
            if (model.material != part.material || model.thickness != part.thickness) return false;
            const std::optional<geometry::Similarity> map = geometry::congruence(model.part, part.part);
            if (map) copies[i] = {m, frame_for(model.part, 0), frame_for(part.part, std::atan2(map->s, map->c))};
            return map.has_value();
        };
        if (std::none_of(models.begin(), models.end(), is_like)) models.push_back(i);
    }
    return copies;
}

Effect shared_grids_effect(const Scene& scene, const std::map<int, int>& model_of) {
    Effect effect;
    effect.name = "shared grids";
    effect.on = !model_of.empty();
    effect.items = static_cast<long>(model_of.size());
    std::map<int, int> copies;  // by model
    for (const auto& [part, model] : model_of) ++copies[model];
    std::string models;
    for (const auto& [model, n] : copies)
        models += (models.empty() ? "" : ", ") + scene.parts[at(model)].name + " (" + std::to_string(n) + ")";
    for (int i = 0; i < static_cast<int>(scene.parts.size()); ++i)
        if (model_of.contains(i) || copies.contains(i)) effect.parts.push_back(scene.parts[at(i)].name);
    effect.why = effect.on ? "copies have grid, stiffness and factor of their model: those of " + models
                           : "no part is a copy of another that wants the same cells";
    return effect;
}

Effect shared_grids_effect(const Scene& scene, const ResolvedConditions& conditions) {
    std::map<int, int> model_of;
    for (const auto& [part, copy] : copied_parts(scene, conditions, std::vector<bool>(scene.parts.size(), true)))
        model_of[part] = copy.model;
    Effect effect = shared_grids_effect(scene, model_of);
    effect.items = 0;
    if (effect.on) effect.why += ", where they want the same cells";
    return effect;
}

std::vector<DesignedGrid> design_grids(const Scene& scene, const ResolvedConditions& conditions, const std::vector<bool>& parts,
                                       const WantedSizes& wanted, double coarseness, int threads) {
    std::vector<DesignedGrid> designed;
    std::vector<int> place(parts.size(), -1);
    for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
        if (!parts[at(i)]) continue;
        place[at(i)] = static_cast<int>(designed.size());
        designed.push_back({i});
        designed.back().wanted = wanted[at(i)];
    }
    const auto design = [&](DesignedGrid& d) {
        if (why_rigid(scene, d.part).empty()) d.grid = grid_of_part(scene, d.part, d.wanted, coarseness, 1);
    };
    solver::parallel_for(static_cast<int>(designed.size()), threads, [&](int k) { design(designed[at(k)]); });
    const std::map<int, CopiedPart> copies = copied_parts(scene, conditions, parts);
    std::map<int, Family> families;  // by model
    for (const auto& [part, copy] : copies) {
        Family& family = families[copy.model];
        if (family.members.empty()) {
            family.members = {copy.model};
            family.wanted = wanted[at(copy.model)];
        }
        family.members.push_back(part);
        append_wanted(copy, wanted[at(part)], family.wanted);
    }
    for (const auto& [model, family] : families) {
        DesignedGrid common{model};
        common.wanted = family.wanted;
        design(common);
        double apart = 0;
        for (const int part : family.members) apart += designed[at(place[at(part)])].grid.grid.n_cells();
        const double together = share_of_making + (1 - share_of_making) * static_cast<double>(family.members.size());
        if (common.grid.limited || together * common.grid.grid.n_cells() >= apart) continue;
        for (const int part : family.members)
            if (part != model) designed[at(place[at(part)])] = {part, model, copies.at(part).to};
        designed[at(place[at(model)])] = std::move(common);
    }
    return designed;
}

}  // namespace abut
