// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_drafting.hpp"

#include <algorithm>

#include "geometry/sketch/drafting_callouts.hpp"
#include "geometry/sketch/drafting_sheet.hpp"

namespace abut::geometry {

namespace {

/// One warning for each kind of what was set aside.
std::vector<SketchProblem> told(const DraftingSearch& search) {
    std::vector<SketchProblem> warnings;
    for (const char* kind : {drafting_kinds.frame, drafting_kinds.table, drafting_kinds.sheet, drafting_kinds.balloon,
                             drafting_kinds.leader, drafting_kinds.dot}) {
        constexpr std::size_t most_names = 6;
        std::size_t n = 0;
        std::string names;
        const SketchEntity* first = nullptr;
        for (std::size_t i = 0; i < search.drawing.entities.size(); ++i) {
            if (search.kind[i] != kind) continue;
            if (!first) first = &search.drawing.entities[i];
            if (n++ < most_names) names += (names.empty() ? "" : ", ") + search.drawing.entities[i].name;
        }
        if (!first) continue;
        warnings.push_back({std::to_string(n) + (n == 1 ? " entity on layer " : " entities, the first on layer ") +
                                first->layer + ", set aside as " + kind + ": " + names + (n > most_names ? ", ..." : ""),
                            point(first->curve, 0.5), first->name, first->line,
                            "--keep-drafting (in a scene \"keep_drafting\": true) takes such things for parts"});
    }
    return warnings;
}

/// Is all that is drawn balloons and what belongs to them? Then they are what is drawn.
bool is_all_callouts(const DraftingSearch& search) {
    const auto is_of_sheet = [](const char* kind) {
        return kind == drafting_kinds.frame || kind == drafting_kinds.table || kind == drafting_kinds.sheet;
    };
    return std::all_of(search.is_out.begin(), search.is_out.end(), [](bool out) { return out; }) &&
           std::none_of(search.kind.begin(), search.kind.end(), is_of_sheet);
}

}  // namespace

DraftingFound find_drafting(const Drawing& drawing, const SketchOptions& options) {
    if (drawing.entities.empty()) return {};
    DraftingSearch search = drafting_search(drawing, options);
    Callouts callouts(search);
    callouts.find();
    const std::vector<SketchProblem> doubts = find_sheet(search);
    callouts.find();
    DraftingFound found;
    if (is_all_callouts(search)) search.kind.assign(search.kind.size(), nullptr);
    for (const char* kind : search.kind) found.is_drafting.push_back(kind != nullptr);
    if (std::find(found.is_drafting.begin(), found.is_drafting.end(), true) == found.is_drafting.end())
        found.mended = std::move(search.mended);
    found.warnings = told(search);
    found.warnings.insert(found.warnings.end(), doubts.begin(), doubts.end());
    return found;
}

}  // namespace abut::geometry
