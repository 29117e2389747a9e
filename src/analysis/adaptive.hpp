// SPDX-License-Identifier: GPL-3.0-or-later
// Solves a scene on grids that follow its contacts.
#pragma once
#include "src/analysis/analyze_options.hpp"
#include "src/analysis/outcome.hpp"
#include "src/solution/assembly_model.hpp"

namespace abut {

/// Solves on one grid after the other, each made from the contacts that the last one found and finer towards their ends, until
/// the estimated error is below the accuracy's target. The search for candidates widens where contact reaches its end, or where
/// the displacements could close more.
Outcome solve_adaptively(const Scene& scene, const ResolvedConditions& conditions, const AnalyzeOptions& options,
                         Stopwatches& seconds);

/// A scene under the loads of one case.
struct CaseProblem {
    const Scene* scene;
    const ResolvedConditions* conditions;
};

/// Solves the cases of a scene, which differ by their loads alone: every pass is on one set of grids, fine where any case wants
/// it, and on one set of factors. By case; all are of the last pass. Steps are walked in their order, on the last grids all of
/// them; on those before, where friction remembers, the first ones, which find what grids the others want.
std::vector<Outcome> solve_cases_adaptively(const Scene& scene, const std::vector<CaseProblem>& cases,
                                            const AnalyzeOptions& options, Stopwatches& seconds);

}  // namespace abut
