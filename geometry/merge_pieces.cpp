// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/merge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace abut::geometry {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;
using RawLoop = std::vector<RawPiece>;

/// Cuts out what lies between two visits to the same vertex, so that every loop visits each of its vertices once.
void split_at_repeated_vertices(const RawLoop& loop, std::vector<RawLoop>& simple) {
    RawLoop open;
    std::map<int, std::size_t> position;  // of the piece in `open` that leaves the vertex
    for (const RawPiece& piece : loop) {
        const auto seen = position.find(piece.from_vertex);
        if (seen != position.end()) {
            const auto first = open.begin() + static_cast<std::ptrdiff_t>(seen->second);
            simple.emplace_back(first, open.end());
            for (auto it = first; it != open.end(); ++it) position.erase(it->from_vertex);
            open.erase(first, open.end());
        }
        position[piece.from_vertex] = open.size();
        open.push_back(piece);
    }
    simple.push_back(std::move(open));
}

/// The source's end nearest to p.
Vec2 nearest_end(const Curve& source, const Vec2& p) {
    const Vec2 a = point(source, 0), b = point(source, 1);
    return (a - p).norm() <= (b - p).norm() ? a : b;
}

/// The end of a piece beside a bridge: the source's own end, unless something else cut the piece there.
Vec2 end_without_bridge(const Vec2& p, const Curve& source, const RawPiece& bridge, double merge) {
    const Vec2 end = nearest_end(source, p);
    return (end - p).norm() <= 2 * (bridge.to - bridge.from).norm() + merge ? end : p;
}

RawLoop without_bridges(const RawLoop& loop, const std::vector<PlacedSource>& sources, double merge) {
    RawLoop kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        RawPiece piece = loop[i];
        if (piece.source == bridge_source) continue;
        const Curve& source = sources[static_cast<std::size_t>(piece.source)].curve;
        const RawPiece& before = loop[(i + loop.size() - 1) % loop.size()];
        const RawPiece& after = loop[(i + 1) % loop.size()];
        if (before.source == bridge_source) piece.from = end_without_bridge(piece.from, source, before, merge);
        if (after.source == bridge_source) piece.to = end_without_bridge(piece.to, source, after, merge);
        kept.push_back(piece);
    }
    return kept;
}

/// A run of raw pieces of one source in one direction.
struct Run {
    int source = -1, turn = 0;
    Vec2 from, to;
    bool whole = false;  ///< the run is the whole loop
};

std::vector<Run> runs_of(RawLoop loop) {
    const auto same = [](const RawPiece& a, const RawPiece& b) { return a.source == b.source && a.turn == b.turn; };
    std::size_t start = 0;  // a piece that does not go on from the one before it
    while (start < loop.size() && same(loop[start], loop[(start + loop.size() - 1) % loop.size()])) ++start;
    const bool whole = start == loop.size();
    if (!whole) std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
    std::vector<Run> runs;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (i > 0 && same(loop[i - 1], loop[i]))
            runs.back().to = loop[i].to;
        else
            runs.push_back({loop[i].source, loop[i].turn, loop[i].from, loop[i].to, whole});
    }
    return runs;
}

/// p, or the source's own end where that is the same point.
Vec2 snapped(const Vec2& p, const Curve& source, double merge) {
    const Vec2 end = nearest_end(source, p);
    return (end - p).norm() <= merge ? end : p;
}

/// The angle of p on the arc's circle: the source's own where p is one of its ends.
double angle_of(const Vec2& p, const Arc& source, double merge) {
    if ((point(source, 0) - p).norm() <= merge) return source.start;
    if ((point(source, 1) - p).norm() <= merge) return source.start + source.sweep;
    const Vec2 d = p - source.center;
    return std::atan2(d.y(), d.x());
}

Curve restored(const Run& run, const Curve& source, double merge) {
    if (run.turn == 0) return Segment{snapped(run.from, source, merge), snapped(run.to, source, merge)};
    const Arc& arc = std::get<Arc>(source);
    if (run.whole) return Arc{arc.center, arc.radius, arc.start, run.turn * two_pi};
    const double start = angle_of(run.from, arc, merge), end = angle_of(run.to, arc, merge);
    double turned = std::fmod((end - start) * run.turn, two_pi);
    if (turned <= 0) turned += two_pi;
    return Arc{arc.center, arc.radius, start, run.turn * turned};
}

bool is_sliver(const std::vector<Piece>& loop, double merge) {
    Part part;
    for (const Piece& piece : loop) part.edges.push_back({piece.curve, "", ""});
    return part.edges.empty() || std::abs(area(part)) <= merge * perimeter(part);
}

}  // namespace

std::vector<std::vector<Piece>> merge_pieces(const std::vector<std::vector<RawPiece>>& loops,
                                             const std::vector<PlacedSource>& sources) {
    Box2 box;
    std::vector<RawLoop> simple;
    for (const RawLoop& loop : loops) {
        for (const RawPiece& piece : loop) box.extend(piece.from);
        split_at_repeated_vertices(loop, simple);
    }
    if (box.empty()) return {};
    const double merge = sliver_width_fraction * (box.diagonal() + box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff());

    std::vector<std::vector<Piece>> merged;
    for (const RawLoop& raw : simple) {
        RawLoop loop = without_bridges(raw, sources, merge);
        std::erase_if(loop, [&](const RawPiece& piece) { return (piece.to - piece.from).norm() <= merge; });
        std::vector<Piece> pieces;
        for (const Run& run : runs_of(std::move(loop)))
            pieces.push_back({restored(run, sources[static_cast<std::size_t>(run.source)].curve, merge), run.source});
        if (!is_sliver(pieces, merge)) merged.push_back(std::move(pieces));
    }
    return merged;
}

}  // namespace abut::geometry
