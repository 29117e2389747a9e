// SPDX-License-Identifier: GPL-3.0-or-later
// What of a scene may be moved beside its loads and parameters: friction, the interference (or clearance) of contacts, and
// where parts stand.
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// One of them. Interferences are counted from what the scene says, clearances are negative ones; places from where it draws
/// the part.
struct LiveSetting {
    enum class Kind {
        friction,  ///< of all contacts that no rule gives another
        rule,      ///< interference of a rule for pairs
        pair,      ///< interference of two parts that no rule speaks of
        place      ///< of a part: x and y
    };
    Kind kind = Kind::friction;
    std::string key;                     ///< unique in the scene: "friction", "rule 1", "pair bracket, pin", "place pin"
    std::size_t rule = 0;                ///< of a rule: which, from 0
    std::array<std::string, 2> parts{};  ///< of a pair; of a place the first
    std::vector<double> value;           ///< as the scene has it
    double least = 0, most = 0;
};
/// Other values, by key: as many as the setting's own. Those that are not there are as the scene has them.
using LiveSettings = std::map<std::string, std::vector<double>>;

/// What may be moved of a scene. contacts: those that were found, of which pairs are told.
std::vector<LiveSetting> live_settings(const Scene& scene, const std::vector<ContactResult>& contacts);

/// The scene with settings as they were moved. A part takes along what is fixed to places of its own: probes, points that are
/// held, preloaded cuts, selections by place.
Scene with_settings(Scene scene, const std::vector<LiveSetting>& settings, const LiveSettings& moved);

/// The changes of a scene's text (as with_values takes them) that say the same. Throws InputError for what no key of the scene
/// can say.
std::map<std::string, std::string> settings_as_text(const std::string& text, const Scene& scene,
                                                    const std::vector<LiveSetting>& settings, const LiveSettings& moved);

}  // namespace abut
