// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/mobility.hpp"

#include "src/answers/motion_text.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidate_faces.hpp"
#include "src/plan/support_wrenches.hpp"

namespace abut {

namespace {

using geometry::Connection;
using geometry::ScrewScale;

struct Joint {
    std::array<int, 2> part;
    std::vector<Screw> wrenches;  ///< on the first
};

std::vector<std::string> words_of(const std::vector<Screw>& twists, const ScrewScale& scale) {
    std::vector<std::string> words;
    for (const Screw& t : twists) words.push_back(motion_words(t, scale));
    return words;
}

MobilityResult mobility_of(const Scene& scene, const ResolvedConditions& conditions, const std::vector<Joint>& joints) {
    const ScrewScale scale = screw_scale(scene);
    const std::vector<std::vector<Screw>> held = support_wrenches(scene, conditions);
    std::vector<Connection> connections;
    for (std::size_t i = 0; i < held.size(); ++i)
        for (const Screw& w : held[i]) connections.push_back({static_cast<int>(i), -1, w});
    for (const Joint& joint : joints)
        for (const Screw& w : joint.wrenches) connections.push_back({joint.part[0], joint.part[1], w});
    const geometry::Mobility found = geometry::mobility(static_cast<int>(scene.parts.size()), connections, scale);
    MobilityResult result{found.degrees_of_freedom, found.gruebler, found.redundant, {}};
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        result.parts.push_back({scene.parts[i].name, wrench_space(held[i], scale), twist_space(held[i], scale),
                                words_of(twist_space(held[i], scale), scale), found.free[i], words_of(found.free[i], scale)});
    return result;
}

}  // namespace

MobilityResult mobility_as_drawn(const Scene& scene, const ResolvedConditions& conditions,
                                 const std::vector<Candidate>& candidates) {
    std::vector<Joint> joints;
    for (const Candidate& c : candidates)
        if (c.shown && c.first != c.second) joints.push_back({{c.first, c.second}, faces_of(scene, c).functional.wrenches});
    return mobility_of(scene, conditions, joints);
}

MobilityResult mobility_under_load(const Scene& scene, const ResolvedConditions& conditions,
                                   const std::vector<ContactResult>& contacts) {
    std::vector<Joint> joints;
    for (const ContactResult& c : contacts)
        if (c.functional && c.status != "open" && c.part[0] != c.part[1]) joints.push_back({c.part, c.functional->wrenches});
    return mobility_of(scene, conditions, joints);
}

}  // namespace abut
