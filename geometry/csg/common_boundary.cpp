// SPDX-License-Identifier: GPL-3.0-or-later
// 1. Pieces of both outlines whose boxes come together are intersected: by intervals where these tell, else exactly.
// 2. Each outline is cut there. Between two cuts it is inside the other, outside, or runs along it (which 1 tells).
// 3. One place of each stretch is asked for the other's winding number, exactly.
#include "geometry/csg/common_boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/csg/exact_outline.hpp"
#include "geometry/curves/arc_spline.hpp"
#include "geometry/curves/curve_polish.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// Where a piece is cut, as a share of its chord and as a parameter of its edge.
struct PieceCut {
    double share, t;
};
/// A stretch of a piece, by shares, along the other outline.
struct PieceAlong {
    double begin, end;
    bool is_same_way;
};
struct CutPiece {
    std::vector<PieceCut> cuts;
    std::vector<PieceAlong> along;
};

struct CutOutline {
    const Part* part;
    Outline outline;
    std::vector<CutPiece> pieces;
};

CutOutline uncut(const Part& part, const Part& other, double tolerance) {
    CutOutline made{&part, fine_outline(part, tolerance, bounding_box(other)), {}};
    made.pieces.resize(made.outline.pieces.size());
    return made;
}

bool has_arc_spline(const Curve& curve) {
    return !std::holds_alternative<Segment>(curve) && !std::holds_alternative<Arc>(curve);
}

/// The parameter of the piece's edge at a point of the piece.
double parameter_at(const CutOutline& of, const OutlinePiece& piece, const Vec2& p) {
    const double share = std::clamp(share_of(piece, p), 0.0, 1.0);
    return nearby_closest_parameter(of.part->edges[at(piece.edge)].curve, p, piece.t0 + share * (piece.t1 - piece.t0));
}

void cut(CutOutline& outline, std::size_t i, const Vec2& p, double t) {
    outline.pieces[i].cuts.push_back({share_of(outline.outline.pieces[i].piece, p), t});
}

/// Where two curves cross, near where their arc splines do. Where they nearly touch the cut stays there.
std::optional<ParameterPair> true_crossing(const Curve& a, const Curve& b, const ParameterPair& start, double tolerance) {
    const auto found = polished_crossing(a, b, start);
    if (!found) return {};
    const double sine = std::abs(cross(unit_tangent(a, found->a), unit_tangent(b, found->b)));
    const double moved = (point(a, found->a) - point(a, start.a)).norm();
    if (sine < most_arc_kink || moved * sine > 4 * tolerance) return {};
    return found;
}

/// Cuts both pieces where they have something in common.
void cut_both(CutOutline& a, std::size_t i, CutOutline& b, std::size_t j, const std::vector<CommonOfPieces>& all_common,
              double tolerance) {
    const OutlinePiece &first = a.outline.pieces[i].piece, &second = b.outline.pieces[j].piece;
    const Curve &curve1 = a.part->edges[at(first.edge)].curve, &curve2 = b.part->edges[at(second.edge)].curve;
    const bool is_approximate = has_arc_spline(curve1) || has_arc_spline(curve2);
    for (const CommonOfPieces& common : all_common) {
        for (const Vec2& p : {common.begin, common.end}) {
            ParameterPair t{parameter_at(a, first, p), parameter_at(b, second, p)};
            if (is_approximate && !common.is_stretch) t = true_crossing(curve1, curve2, t, tolerance).value_or(t);
            cut(a, i, p, t.a);
            cut(b, j, p, t.b);
        }
        if (!common.is_stretch) continue;
        const bool is_same_way =
            first.turn == 0 ? (first.to - first.from).dot(second.to - second.from) > 0 : first.turn == second.turn;
        const auto add = [&](CutOutline& to, std::size_t k) {
            const OutlinePiece& piece = to.outline.pieces[k].piece;
            const double begin = share_of(piece, common.begin), end = share_of(piece, common.end);
            to.pieces[k].along.push_back({std::min(begin, end), std::max(begin, end), is_same_way});
        };
        add(a, i);
        add(b, j);
    }
}

void cut_each_other(CutOutline& a, CutOutline& b, double tolerance) {
    const std::vector<HulledPiece>&first = a.outline.pieces, &second = b.outline.pieces;
    PieceMeetings meetings(a.outline, b.outline);
    for (std::size_t i = 0; i < first.size(); ++i)
        for (const int found : b.outline.tree.near(first[i].box, 0)) {
            const std::size_t j = at(found);
            const bool have_hulls = !first[i].hull.empty() && !second[j].hull.empty();
            if (!have_hulls || !clearly_meet_at_corners_only(first[i], second[j])) {
                cut_both(a, i, b, j, meetings.of(i, j), tolerance);
                continue;
            }
            for (const Vec2& p : shared_corners(first[i].piece, second[j].piece)) {
                cut(a, i, p, p == first[i].piece.from ? first[i].piece.t0 : first[i].piece.t1);
                cut(b, j, p, p == second[j].piece.from ? second[j].piece.t0 : second[j].piece.t1);
            }
        }
}

/// What is left of a piece between cuts.
struct Remnant {
    std::size_t piece;
    PieceCut begin, end;
    bool begins_stretch;
    const PieceAlong* along;  ///< null: inside or outside
};

/// The outline's pieces between their cuts, but those shorter than rounding.
std::vector<Remnant> remnants_of(CutOutline& outline) {
    std::vector<Remnant> remnants;
    for (std::size_t loop = 0; loop + 1 < outline.outline.begin_of_loop.size(); ++loop) {
        bool begins = true;
        for (std::size_t i = outline.outline.begin_of_loop[loop]; i < outline.outline.begin_of_loop[loop + 1]; ++i) {
            const OutlinePiece& piece = outline.outline.pieces[i].piece;
            CutPiece& its = outline.pieces[i];
            const double largest = std::max(piece.from.cwiseAbs().maxCoeff(), piece.to.cwiseAbs().maxCoeff());
            const double rounding = 64 * std::numeric_limits<double>::epsilon() * largest / (piece.to - piece.from).norm();
            std::sort(its.cuts.begin(), its.cuts.end(), [](const PieceCut& a, const PieceCut& b) { return a.share < b.share; });
            its.cuts.push_back({1, piece.t1});
            PieceCut begin{0, piece.t0};
            for (std::size_t k = 0; k < its.cuts.size(); ++k) {
                const bool is_whole_end = k + 1 == its.cuts.size();
                if (its.cuts[k].share - begin.share > rounding) {
                    const double middle = 0.5 * (begin.share + its.cuts[k].share);
                    const auto along = std::find_if(its.along.begin(), its.along.end(), [&](const PieceAlong& stretch) {
                        return stretch.begin < middle && middle < stretch.end;
                    });
                    remnants.push_back({i, begin, its.cuts[k], begins, along == its.along.end() ? nullptr : &*along});
                    begins = false;
                    begin = its.cuts[k];
                }
                begins = begins || !is_whole_end;
            }
        }
    }
    return remnants;
}

/// Of each stretch between cuts: is it inside the other outline? Asked in the middle of its longest piece, one that is not cut
/// if there is any: those have a middle in doubles.
std::vector<char> are_inside(const CutOutline& of, const std::vector<Remnant>& remnants, const Outline& other) {
    std::vector<PlaceOnPiece> places;
    std::vector<std::size_t> stretch_of;
    std::pair<bool, double> best;
    for (const Remnant& r : remnants) {
        const OutlinePiece& piece = of.outline.pieces[r.piece].piece;
        const double share = r.end.share - r.begin.share;
        const std::pair found{share == 1, share * (piece.to - piece.from).norm()};
        const bool begins = r.begins_stretch || r.along;
        if (begins) places.emplace_back();
        if (begins || found > best) {
            best = found;
            places.back() = {piece, 0.5 * (r.begin.share + r.end.share)};
        }
        stretch_of.push_back(places.size() - 1);
    }
    const std::vector<int> windings = windings_around(other, places);
    std::vector<char> inside;
    for (const std::size_t k : stretch_of) inside.push_back(windings[k] > 0);
    return inside;
}

}  // namespace

std::vector<BoundaryStretch> common_boundary(const Part& part1, const Part& part2, double tolerance) {
    ENSURE(tolerance >= 0, "curves are followed by arcs within a distance");
    std::array<CutOutline, 2> cut{uncut(part1, part2, tolerance), uncut(part2, part1, tolerance)};
    cut_each_other(cut[0], cut[1], tolerance);
    std::vector<BoundaryStretch> found;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<Remnant> remnants = remnants_of(cut[k]);
        const std::vector<char> inside = are_inside(cut[k], remnants, cut[1 - k].outline);
        for (std::size_t r = 0; r < remnants.size(); ++r) {
            const PieceAlong* along = remnants[r].along;
            if (along ? !(along->is_same_way && k == 0) : !inside[r]) continue;
            const int part = static_cast<int>(k), edge = cut[k].outline.pieces[remnants[r].piece].piece.edge;
            const double t0 = remnants[r].begin.t, t1 = remnants[r].end.t;
            if (!found.empty() && found.back().part == part && found.back().edge == edge && found.back().t1 == t0)
                found.back().t1 = t1;
            else
                found.push_back({part, edge, t0, t1});
        }
    }
    return found;
}

}  // namespace abut::geometry
