// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/source_portions.hpp"

#include <variant>

namespace abut::geometry {

namespace {

void append_portions(const Curve& curve, int source, const CarrierRun& run, std::vector<SourcePortion>& portions) {
    SourcePortion portion;
    portion.source = source;
    if (const auto* arc = std::get_if<Arc>(&curve)) portion.turn = arc->sweep > 0 ? 1 : -1;
    if (const auto* line = std::get_if<Segment>(&curve)) portion.way = line->to - line->from;
    if (run.carrier < 0) portions.push_back(portion);
    for (std::size_t i = 0; run.carrier >= 0 && i + 1 < run.t.size(); ++i) {
        portion.t0 = run.t[i];
        portion.t1 = run.t[i + 1];
        portion.way = point(curve, portion.t1) - point(curve, portion.t0);
        portions.push_back(portion);
    }
}

}  // namespace

SourcePortions number_portions(const std::vector<PlacedSource>& sources, const Carriers& carriers) {
    SourcePortions result;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        result.first.push_back(static_cast<int>(result.portions.size()));
        append_portions(sources[s].curve, static_cast<int>(s), carriers.of_source[s], result.portions);
    }
    return result;
}

}  // namespace abut::geometry
