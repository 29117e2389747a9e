// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/idle_holds.hpp"

#include <set>
#include <string>
#include <vector>

#include "src/base/index.hpp"
#include "src/results/findings.hpp"
#include "src/scene/scene.hpp"

namespace abut {

void note_idle_holds(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    if (!result.under_load || has_friction(scene.contacts)) return;
    std::set<std::string> told, loaded;
    for (const solver::PartMotion& m : solved.solution.neutral)
        told.insert(scene.parts[at(solved.grids[at(m.part)].part)].name);
    for (const ContactResult& c : result.contacts)
        if (c.status != "open")
            for (int i : c.part) loaded.insert(scene.parts[at(i)].name);
    std::vector<std::string> motions;
    for (const PartMobility& part : result.under_load->parts)
        if (!part.motions.empty() && loaded.contains(part.part) && !told.contains(part.part))
            motions.push_back(part.part + " " + part.motions.front());
    if (!motions.empty())
        result.notes.push_back("under these loads only contacts that carry nothing hold: " + first_few(motions));
}

}  // namespace abut
