// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/source_portions.hpp"

#include <variant>

#include "src/base/ensure.hpp"

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
    ENSURE(carriers.of_source.size() == sources.size(), "it is known of every source where it lies on carriers");
    SourcePortions result;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        result.first.push_back(static_cast<int>(result.portions.size()));
        append_portions(sources[s].curve, static_cast<int>(s), carriers.of_source[s], result.portions);
    }
    return result;
}

RawPiece raw_piece(const std::vector<SourcePortion>& portions, int number, const Vec2& from, const Vec2& to, int turn) {
    RawPiece piece;
    piece.from = from;
    piece.to = to;
    piece.source = number;
    if (number == bridge_source || number == far_source) return piece;
    const SourcePortion& portion = portions[static_cast<std::size_t>(number)];
    piece.source = portion.source;
    piece.t0 = portion.t0;
    piece.t1 = portion.t1;
    piece.along = turn == 0 || portion.turn == 0 ? (to - from).dot(portion.way) > 0 : turn == portion.turn;
    return piece;
}

}  // namespace abut::geometry
