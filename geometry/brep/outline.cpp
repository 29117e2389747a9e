// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/outline.hpp"

#include <algorithm>
#include <array>

#include "geometry/brep/monotone.hpp"

namespace abut::geometry {

namespace {

Part outline_of(const Part& part, const Loop& loop) {
    Part outline;
    outline.loops.emplace_back();
    for (const int e : loop.edges) {
        outline.loops.front().edges.push_back(static_cast<int>(outline.edges.size()));
        outline.edges.push_back(part.edges[static_cast<std::size_t>(e)]);
    }
    return outline;
}

}  // namespace

Part outer_outline(const Part& part) {
    return outline_of(part, part.loops.front());
}

int count_pieces(const Part& part) {
    return static_cast<int>(std::count_if(part.loops.begin(), part.loops.end(),
                                          [&](const Loop& loop) { return area(outline_of(part, loop)) > 0; }));
}

bool lies_in_outline(const Part& inner, const Part& outer) {
    if (!bounding_box(inner).is_within(bounding_box(outer), 0)) return false;
    const std::vector<MonotonePiece> pieces = monotone_pieces(outer_outline(outer));
    constexpr std::array places{0.0, 0.5};
    return std::all_of(inner.edges.begin(), inner.edges.end(), [&](const Edge& edge) {
        return std::all_of(places.begin(), places.end(), [&](double t) { return contains(pieces, point(edge.curve, t)); });
    });
}

}  // namespace abut::geometry
