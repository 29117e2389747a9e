// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/csg_names.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace abut::geometry {

namespace {

/// A piece and where it lies on its source.
struct PlacedPiece {
    Piece piece;
    bool along = true;
    double begin = 0;
    std::pair<int, double> rank() const { return {piece.source, begin}; }
};

using PieceLoop = std::vector<PlacedPiece>;

PieceLoop place(const std::vector<PlacedSource>& sources, const std::vector<Piece>& loop) {
    PieceLoop placed;
    for (const Piece& piece : loop) {
        const PlacedSource& source = sources[static_cast<std::size_t>(piece.source)];
        const double first = std::min(piece.t_begin, piece.t_end);
        placed.push_back({piece, piece.t_begin < piece.t_end, source.begin + length(source.curve, 0, first)});
    }
    const auto first = std::min_element(placed.begin(), placed.end(),
                                        [](const PlacedPiece& a, const PlacedPiece& b) { return a.rank() < b.rank(); });
    std::rotate(placed.begin(), first, placed.end());
    return placed;
}

bool is_hole(const PieceLoop& loop) {
    Part part;
    for (const PlacedPiece& p : loop) part.edges.push_back({p.piece.curve, "", ""});
    return area(part) < 0;
}

std::vector<PieceLoop> in_lasting_order(const std::vector<PlacedSource>& sources,
                                        const std::vector<std::vector<Piece>>& loops) {
    using Ranked = std::tuple<bool, std::pair<int, double>, PieceLoop>;
    std::vector<Ranked> ranked;
    for (const auto& loop : loops) {
        PieceLoop placed = place(sources, loop);
        const bool hole = is_hole(placed);
        const auto rank = placed.front().rank();
        ranked.emplace_back(hole, rank, std::move(placed));
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
        return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    std::vector<PieceLoop> ordered;
    for (Ranked& r : ranked) ordered.push_back(std::move(std::get<2>(r)));
    return ordered;
}

/// The full name of each source that is left in the part: with the primitive's place where the name alone is not unique.
std::map<int, std::string> source_names(const std::vector<PlacedSource>& sources, const std::vector<PieceLoop>& loops) {
    std::map<int, std::string> names;
    for (const PieceLoop& loop : loops)
        for (const PlacedPiece& p : loop) {
            const PlacedSource& source = sources[static_cast<std::size_t>(p.piece.source)];
            names[p.piece.source] = source.prefix.empty() ? source.name : source.prefix + "/" + source.name;
        }
    std::map<std::string, int> count;
    for (const auto& [source, name] : names) ++count[name];
    for (auto& [source, name] : names)
        if (count[name] > 1) name = std::to_string(sources[static_cast<std::size_t>(source)].primitive) + "/" + name;
    return names;
}

/// The pieces' places along each source, ascending.
std::map<int, std::vector<double>> begins_by_source(const std::vector<PieceLoop>& loops) {
    std::map<int, std::vector<double>> begins;
    for (const PieceLoop& loop : loops)
        for (const PlacedPiece& p : loop) begins[p.piece.source].push_back(p.begin);
    for (auto& [source, list] : begins) std::sort(list.begin(), list.end());
    return begins;
}

}  // namespace

std::vector<PlacedSource> placed_sources(const std::vector<Primitive>& primitives) {
    std::vector<PlacedSource> sources;
    for (std::size_t k = 0; k < primitives.size(); ++k)
        for (const SourceEdge& edge : primitives[k].edges)
            sources.push_back({placed(edge.curve, primitives[k].moves), edge.name, primitives[k].name, static_cast<int>(k),
                               edge.begin * scale_of(primitives[k].moves)});
    return sources;
}

Part named_part(const std::vector<PlacedSource>& sources, const std::vector<std::vector<Piece>>& loops) {
    const std::vector<PieceLoop> ordered = in_lasting_order(sources, loops);
    const auto names = source_names(sources, ordered);
    const auto begins = begins_by_source(ordered);
    Part part;
    for (const PieceLoop& pieces : ordered) {
        Loop loop;
        for (const PlacedPiece& p : pieces) {
            const std::vector<double>& all = begins.at(p.piece.source);
            const std::string& source = names.at(p.piece.source);
            const auto number = std::lower_bound(all.begin(), all.end(), p.begin) - all.begin();
            loop.edges.push_back(static_cast<int>(part.edges.size()));
            part.edges.push_back(
                {p.piece.curve, all.size() == 1 ? source : source + "#" + std::to_string(number), source, p.along, p.begin});
        }
        part.loops.push_back(std::move(loop));
    }
    return part;
}

}  // namespace abut::geometry
