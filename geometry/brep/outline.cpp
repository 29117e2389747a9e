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

std::vector<int> pieces_of_edges(const Part& part) {
    std::vector<int> piece(part.edges.size(), -1);
    std::vector<Part> outlines;
    const auto set = [&](const Loop& loop, std::size_t number) {
        for (const int e : loop.edges) piece[static_cast<std::size_t>(e)] = static_cast<int>(number);
    };
    for (const Loop& loop : part.loops)
        if (Part outline = outline_of(part, loop); area(outline) > 0) {
            set(loop, outlines.size());
            outlines.push_back(std::move(outline));
        }
    for (const Loop& loop : part.loops) {
        const auto first = static_cast<std::size_t>(loop.edges.front());
        if (piece[first] >= 0) continue;
        for (std::size_t k = 0; k < outlines.size(); ++k)
            if (contains(outlines[k], point(part.edges[first].curve, 0.5))) set(loop, k);
    }
    return piece;
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
