// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/merge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/csg/necks.hpp"
#include "geometry/csg/run_junctions.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

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

/// Area and length of the boundary as it is restored so far.
struct Extent {
    double area = 0, length = 0;
};

Extent extent(const std::vector<Run>& loop, const RunContext& context) {
    Part part;
    for (const Run& run : loop) part.edges.push_back({restored(run, context.curve(run), context.lengths).curve, "", ""});
    return part.edges.empty() ? Extent{} : Extent{std::abs(geometry::area(part)), perimeter(part)};
}

/// Largest distance of the loop's arcs from its sources.
double arc_tolerance_of(const std::vector<Run>& loop, const RunContext& context) {
    double largest = 0;
    for (const Run& run : loop) largest = std::max(largest, context.tolerance(run));
    return largest;
}

/// Of the result, whose box is given, and of its sources.
MergeLengths merge_lengths(const Box2& box, const std::vector<PlacedSource>& sources) {
    Box2 all = box;
    for (const PlacedSource& source : sources) all.extend(bounding_box(source.curve));
    const double farthest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
    return {sliver_width_fraction * (box.diagonal() + farthest), merge_fraction * box.diagonal(),
            merge_fraction * all.diagonal()};
}

void report_sliver(const std::vector<Run>& loop, const Extent& size, const RunContext& context, MergedBoundary& result) {
    const double width = size.area / size.length;
    if (size.length > context.lengths.merge && width > context.lengths.rounding)
        result.repairs.push_back(
            {"sliver beside '" + context.name(loop.front().source) + "' left out", loop.front().from.at, width});
}

void add_restored(const std::vector<Run>& loop, const RunContext& context, MergedBoundary& result) {
    const Extent size = extent(loop, context);
    if (size.area <= context.lengths.rounding * size.length) return;
    std::vector<Piece> pieces;
    for (const Run& run : loop) pieces.push_back(restored(run, context.curve(run), context.lengths));
    result.loops.push_back(std::move(pieces));
}

/// Restores one loop, unless it is a sliver.
void add_loop(std::vector<Run> loop, const RunContext& context, MergedBoundary& result) {
    const double arcs = arc_tolerance_of(loop, context);
    const Extent raw = extent(loop, context);
    if (raw.area <= std::max(2 * arcs, context.lengths.rounding) * raw.length) {
        if (arcs > 0 && raw.area > context.lengths.rounding * raw.length) result.uncertain = true;
        return report_sliver(loop, raw, context, result);
    }
    std::vector<GeometryProblem> unsolved;
    std::vector<Repair> repairs;
    solve_junctions(loop, context, unsolved);
    if (unsolved.empty()) {
        remove_tiny(loop, context, repairs);
        check_directions(loop, context, unsolved);
        check_gaps(loop, context, unsolved);
    }
    if (!unsolved.empty()) {
        result.uncertain = true;
        result.unsolved.insert(result.unsolved.end(), unsolved.begin(), unsolved.end());
        return;
    }
    result.repairs.insert(result.repairs.end(), repairs.begin(), repairs.end());
    for (const std::vector<Run>& simple : cut_necks(std::move(loop), context)) add_restored(simple, context, result);
}

/// A loop that is left with pieces of one source either goes all the way round it, or is the rounding of a corner whose other
/// pieces were rounding too: their chords tell.
bool turns_back(const RawLoop& loop, const std::vector<PlacedSource>& sources) {
    double chords = 0;
    for (const RawPiece& piece : loop) {
        if (piece.source != loop.front().source) return false;
        chords += (piece.to - piece.from).norm();
    }
    return chords < bounding_box(sources[static_cast<std::size_t>(loop.front().source)].curve).diagonal();
}

}  // namespace

MergedBoundary merge_pieces(const std::vector<std::vector<RawPiece>>& loops, const std::vector<PlacedSource>& sources,
                            const std::vector<double>& arc_tolerance) {
    ENSURE(arc_tolerance.size() == sources.size(), "every source has the tolerance of its arcs");
    MergedBoundary result;
    Box2 box;
    std::vector<RawLoop> simple;
    for (const RawLoop& loop : loops) {
        for (const RawPiece& piece : loop) box.extend(piece.from);
        split_at_repeated_vertices(loop, simple);
    }
    if (box.empty()) return result;
    const RunContext context{sources, arc_tolerance, merge_lengths(box, sources)};
    for (const RawLoop& raw : simple) {
        RawLoop loop = without_bridges(raw, sources, context.lengths.rounding);
        std::erase_if(loop, [&](const RawPiece& piece) { return (piece.to - piece.from).norm() <= context.lengths.rounding; });
        if (!loop.empty() && !turns_back(loop, sources))
            add_loop(runs_of(std::move(loop), sources, context.lengths.rounding), context, result);
    }
    return result;
}

}  // namespace abut::geometry
