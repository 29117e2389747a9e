// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/held_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"
#include "src/contact/search_distances.hpp"
#include "src/plan/support_components.hpp"
#include "src/scene/scene.hpp"

namespace abut {

namespace {

using geometry::ChainPoint;
using geometry::FacingPair;

constexpr int zone_samples = 64;  // along a zone, and along a stretch of contact
/// A single direction that is this near to the normal holds it (cosine of 1 degree).
constexpr double along_normal = 0.99985;

/// Pairs that touch as drawn: of a zone that does, those that are as close as it comes.
void append_drawn(const Scene& scene, const Candidate& c, std::vector<FacingPair>& touching) {
    const geometry::Part &first = part_of(scene, c.first), &second = part_of(scene, c.second);
    const double rounding = touching_length(first, second);
    if (c.zone.gap_min - c.closing() > rounding) return;
    std::vector<FacingPair> pairs;
    double guess = c.zone.begin2, closest = c.zone.gap_max;
    for (int k = 0; k < zone_samples; ++k) {
        const double s1 = c.zone.begin1 + (c.zone.end1 - c.zone.begin1) * (k + 0.5) / zone_samples;
        const FacingPair pair = pair_from_first(first, second, c.zone, s1, guess);
        if (!pair.found) continue;
        guess = pair.s2;
        closest = std::min(closest, pair.gap);
        pairs.push_back(pair);
    }
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(touching),
                 [&](const FacingPair& p) { return p.gap <= closest + rounding; });
}

void append_pressed(const Scene& scene, const ContactInterface& contact, const std::vector<PressedStretch>& stretches,
                    std::vector<FacingPair>& touching) {
    for (const PressedStretch& stretch : stretches)
        for (int k = 0; k < zone_samples; ++k) {
            const FacingPair pair =
                pair_at(scene, contact, stretch.begin + (stretch.end - stretch.begin) * (k + 0.5) / zone_samples);
            if (pair.found) touching.push_back(pair);
        }
}

/// Does the support leave the boundary no motion along its normal?
bool holds_normal(const Support& support, const Vec2& normal) {
    const std::vector<HeldComponent> held = components_of(support);
    return held.size() > 1 || std::any_of(held.begin(), held.end(), [&](const HeldComponent& h) {
               return !h.direction || std::abs(h.direction->dot(normal)) >= along_normal;
           });
}

bool holds_there(const Support& support, const std::vector<EdgePortion>& portions, int part, const ChainPoint& p) {
    return holds_normal(support, p.normal) && std::any_of(portions.begin(), portions.end(), [&](const EdgePortion& e) {
               return e.part == part && e.edge == p.edge && p.t > e.t0 && p.t < e.t1;
           });
}

/// The support that holds all of a portion along x and y; -1: none.
int holder_of(const Scene& scene, const ResolvedConditions& conditions, const EdgePortion& portion) {
    const double rounding = 1e-9 * (portion.t1 - portion.t0);
    for (std::size_t s = 0; s < scene.supports.size(); ++s)
        if (components_of(scene.supports[s]).size() > 1 &&
            std::any_of(conditions.supports[s].begin(), conditions.supports[s].end(), [&](const EdgePortion& held) {
                return held.part == portion.part && held.edge == portion.edge && held.t0 <= portion.t0 + rounding &&
                       held.t1 >= portion.t1 - rounding;
            }))
            return static_cast<int>(s);
    return -1;
}

}  // namespace

void warn_of_held_loads(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result) {
    for (std::size_t i = 0; i < scene.loads.size(); ++i) {
        const std::vector<EdgePortion>& loaded = conditions.loads[i];
        if (loaded.empty()) continue;
        const int grid = out.solved.solver_part[at(loaded.front().part)];
        if (grid < 0 || out.solved.grids[at(grid)].is_rigid) continue;
        const int holder = holder_of(scene, conditions, loaded.front());
        if (std::any_of(loaded.begin(), loaded.end(),
                        [&](const EdgePortion& p) { return holder_of(scene, conditions, p) < 0; }))
            continue;
        result.warnings.push_back("load " + std::to_string(i + 1) + " acts where support " + std::to_string(holder + 1) + " (" +
                                  support_label(scene, holder) + ") holds part " + scene.parts[at(loaded.front().part)].name +
                                  ": it goes into the support and strains nothing; load or hold another edge");
    }
}

void warn_of_held_contacts(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result) {
    const SolvedAssembly& solved = out.solved;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const Candidate& c = out.candidates[k];
        if (c.bonded || solved.interface_of[k] < 0) continue;
        std::vector<FacingPair> touching;
        append_drawn(scene, c, touching);
        append_pressed(scene, solved.contacts[k], solved.stretches[k], touching);
        for (const auto& [part, other] : {std::pair(c.first, c.second), std::pair(c.second, c.first)})
            for (std::size_t s = 0; s < scene.supports.size(); ++s) {
                if (solved.grids[at(solved.solver_part[at(part)])].is_rigid) continue;
                const auto is_held = [&, of = part](const FacingPair& p) {
                    return holds_there(scene.supports[s], conditions.supports[s], of, of == c.first ? p.on1 : p.on2);
                };
                if (std::none_of(touching.begin(), touching.end(), is_held)) continue;
                const std::string text = "support " + std::to_string(s + 1) + " (" + support_label(scene, static_cast<int>(s)) +
                                         ") holds part " + scene.parts[at(part)].name + " where " +
                                         scene.parts[at(other)].name +
                                         " touches it: what presses there goes into the support, not through the part; hold "
                                         "another edge, or make the part \"rigid\"";
                if (std::find(result.warnings.begin(), result.warnings.end(), text) == result.warnings.end())
                    result.warnings.push_back(text);
            }
    }
}

}  // namespace abut
