// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/probes.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "src/io/number_text.hpp"
#include "src/results/findings.hpp"

namespace abut {

void check_probes(const Scene& scene) {
    std::vector<Problem> problems;
    for (const Probe& probe : scene.output.probes)
        for (const ScenePart& part : scene.parts) {
            if (part.name != probe.part) continue;
            double away = std::numeric_limits<double>::infinity();
            for (const geometry::Edge& e : part.part.edges)
                away = std::min(away, (point(e.curve, closest_parameter(e.curve, probe.at)) - probe.at).norm());
            const double merge = geometry::merge_length(part.part);
            if (away > merge && !contains(part.part, probe.at))
                problems.push_back({probe.where,
                                    "the probe at (" + number_text(probe.at.x(), 6) + ", " + number_text(probe.at.y(), 6) +
                                        ") lies outside part " + probe.part,
                                    "it is " + number_text(away, 3) + " away from the part's boundary"});
        }
    if (!problems.empty()) throw InputError(problems);
}

void fill_probes(const Scene& scene, const SolvedAssembly& solved, const std::vector<solver::StressField>& stress,
                 Result& result) {
    std::map<std::string, Finding> idle;  // by part
    for (const Probe& probe : scene.output.probes)
        for (std::size_t i = 0; i < scene.parts.size(); ++i) {
            if (scene.parts[i].name != probe.part) continue;
            if (solved.solver_part[i] < 0) {  // carries nothing: it stays where it is, without stress
                result.probes.push_back({probe.part, probe.at, {0, 0}, {}});
                idle[probe.part] = {0, probe.part, "the probe in part " + probe.part + " is zero: nothing acts on that part"};
                continue;
            }
            const auto k = static_cast<std::size_t>(solved.solver_part[i]);
            const PartOnGrid& g = solved.grids[k];
            const Vec2 local = g.frame.to_local(probe.at);
            const int element = element_at(g.local, g.cells, g.elements, local);
            const FieldSample s = sample_field(g, solved.solution.displacement[k], stress[k], element, local);
            result.probes.push_back({probe.part, probe.at, s.displacement, s.stress});
        }
    remark(values_of(idle), result);
}

}  // namespace abut
