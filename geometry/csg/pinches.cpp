// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/csg/pinches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/brep/closest_points.hpp"
#include "geometry/brep/edge_tree.hpp"
#include "geometry/csg/boundary_runs.hpp"
#include "geometry/csg/junction.hpp"

namespace abut::geometry {

namespace {

/// All pieces in a row.
struct Work {
    std::vector<Piece> pieces;
    std::vector<int> loop;     ///< by piece
    std::vector<int> first;    ///< by loop, and the number of pieces at the end
    std::vector<double> area;  ///< by loop
    double merge = 0;

    std::size_t n_loops() const { return first.size() - 1; }
    int after(int piece) const {
        const auto l = static_cast<std::size_t>(loop[static_cast<std::size_t>(piece)]);
        return piece + 1 == first[l + 1] ? first[l] : piece + 1;
    }
    const Curve& curve(int piece) const { return pieces[static_cast<std::size_t>(piece)].curve; }
};

Part part_of(const std::vector<Piece>& pieces) {
    Part part;
    for (const Piece& piece : pieces) part.edges.push_back({piece.curve, "", ""});
    return part;
}

Work in_a_row(const std::vector<std::vector<Piece>>& loops) {
    Work work;
    for (const std::vector<Piece>& loop : loops) {
        work.first.push_back(static_cast<int>(work.pieces.size()));
        work.area.push_back(area(part_of(loop)));
        work.pieces.insert(work.pieces.end(), loop.begin(), loop.end());
        work.loop.resize(work.pieces.size(), static_cast<int>(work.first.size()) - 1);
    }
    work.first.push_back(static_cast<int>(work.pieces.size()));
    work.merge = merge_length(part_of(work.pieces));
    return work;
}

/// A place on the boundary: at parameter t < 1 of a piece's curve.
struct Place {
    int piece = -1;
    double t = 0;
};

struct Touch {
    Place a, b;
    int loop_a = -1, loop_b = -1;
    Vec2 at{0, 0};
};

/// Ends within the merge length are the piece's, or the next one's, begin.
Place place_at(const Work& work, int piece, double t) {
    const Curve& curve = work.curve(piece);
    const Vec2 p = point(curve, t);
    if ((point(curve, 1) - p).norm() <= work.merge && t > 0.5) return {work.after(piece), 0};
    if ((point(curve, 0) - p).norm() <= work.merge) return {piece, 0};
    return {piece, t};
}

/// Closest points of curves that cross by a rounding are known to its root only: the touching point lies between the crossings.
void polish(ClosestPoints& pair, const Curve& a, const Curve& b, double merge) {
    const auto touch = find_touching(a, pair.t1, b, pair.t2, {0, merge});
    if (!touch) return;
    const double t1 = std::clamp(touch->ta, 0.0, 1.0), t2 = std::clamp(touch->tb, 0.0, 1.0);
    if ((point(a, t1) - point(b, t2)).norm() > merge) return;
    pair.t1 = t1;
    pair.t2 = t2;
    pair.x1 = touch->xa;
}

std::vector<Touch> find_touches(const Work& work) {
    const EdgeTree tree(part_of(work.pieces));
    std::vector<Touch> touches;
    for (int e = 0; e < static_cast<int>(work.pieces.size()); ++e)
        for (const int o : tree.near(bounding_box(work.curve(e)), work.merge)) {
            if (o <= e || work.after(e) == o || work.after(o) == e) continue;
            ClosestPoints pair = closest_points(work.curve(e), work.curve(o));
            if (pair.distance > work.merge) continue;
            polish(pair, work.curve(e), work.curve(o), work.merge);
            const Touch touch{place_at(work, e, pair.t1), place_at(work, o, pair.t2), work.loop[static_cast<std::size_t>(e)],
                              work.loop[static_cast<std::size_t>(o)], pair.x1};
            const bool is_known = std::any_of(touches.begin(), touches.end(), [&](const Touch& t) {
                return t.loop_a == touch.loop_a && t.loop_b == touch.loop_b && (t.at - touch.at).norm() <= 4 * work.merge;
            });
            if (!is_known) touches.push_back(touch);
        }
    return touches;
}

/// Some of the points may lie where the edge touches the loop.
bool mostly_inside(const Part& loop, const Curve& edge) {
    int n_inside = 0;
    for (const double t : {0.28, 0.53, 0.81})
        if (contains(loop, point(edge, t))) ++n_inside;
    return n_inside >= 2;
}

/// The outer loop of each loop's region: the smallest around it, for outer loops themselves.
std::vector<int> regions(const Work& work) {
    std::vector<int> region(work.n_loops());
    std::iota(region.begin(), region.end(), 0);
    std::vector<Part> outer(work.n_loops());
    for (std::size_t l = 0; l < outer.size(); ++l)
        if (work.area[l] > 0)
            outer[l] = part_of({work.pieces.begin() + work.first[l], work.pieces.begin() + work.first[l + 1]});
    for (std::size_t h = 0; h < outer.size(); ++h) {
        if (work.area[h] > 0) continue;
        const Curve& edge = work.curve(work.first[h]);
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t o = 0; o < outer.size(); ++o)
            if (work.area[o] > 0 && work.area[o] < smallest && mostly_inside(outer[o], edge)) {
                smallest = work.area[o];
                region[h] = static_cast<int>(o);
            }
    }
    return region;
}

/// Are the touch's loops joined by the others already?
bool is_in_a_ring(const std::vector<Touch>& touches, std::size_t k, std::size_t n_loops) {
    std::vector<int> group(n_loops);
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](int l) {
        while (group[static_cast<std::size_t>(l)] != l) l = group[static_cast<std::size_t>(l)];
        return l;
    };
    for (std::size_t i = 0; i < touches.size(); ++i)
        if (i != k) group[static_cast<std::size_t>(root(touches[i].loop_a))] = root(touches[i].loop_b);
    return root(touches[k].loop_a) == root(touches[k].loop_b);
}

/// Those touches where the loops change over to each other.
std::vector<Touch> cutting(const Work& work, std::vector<Touch> touches) {
    const std::vector<int> region = regions(work);
    std::erase_if(touches, [&](const Touch& t) {
        return region[static_cast<std::size_t>(t.loop_a)] != region[static_cast<std::size_t>(t.loop_b)];
    });
    std::vector<Touch> cuts;
    for (std::size_t k = 0; k < touches.size(); ++k)
        if (is_in_a_ring(touches, k, work.n_loops())) cuts.push_back(touches[k]);
    return cuts;
}

/// The portion of a piece between two parameters of its curve; behind 1 where it is a whole turn.
Piece portion(const Piece& piece, double from, double to) {
    const auto t = [&](double s) { return piece.t_begin + s * (piece.t_end - piece.t_begin); };
    Piece cut{trimmed(piece.curve, from, to), piece.source, t(from), t(to)};
    if (std::holds_alternative<Arc>(cut.curve) || std::holds_alternative<EllipticArc>(cut.curve))
        shift_into_first_turn(cut.t_begin, cut.t_end);  // changes nothing on sources that are no full turn
    return cut;
}

/// The pieces cut at the given places, and which one follows which.
struct CutPieces {
    std::vector<Piece> pieces;
    std::vector<int> next;
    std::map<std::pair<int, double>, int> at;  ///< the cut piece that begins at a place
};

CutPieces cut_at(const Work& work, const std::set<std::pair<int, double>>& places) {
    CutPieces cut;
    for (std::size_t l = 0; l < work.n_loops(); ++l) {
        const auto first = cut.pieces.size();
        for (int p = work.first[l]; p < work.first[l + 1]; ++p) {
            const Piece& piece = work.pieces[static_cast<std::size_t>(p)];
            std::vector<double> t;
            for (auto it = places.lower_bound({p, 0.0}); it != places.end() && it->first == p; ++it) t.push_back(it->second);
            const bool turns = is_full(piece.curve) && !t.empty();
            if (!turns && (t.empty() || t.front() > 0)) t.insert(t.begin(), 0.0);
            t.push_back(turns ? 1 + t.front() : 1);
            for (std::size_t i = 0; i + 1 < t.size(); ++i) {
                cut.at[{p, t[i]}] = static_cast<int>(cut.pieces.size());
                cut.pieces.push_back(t.size() == 2 && !turns ? piece : portion(piece, t[i], t[i + 1]));
            }
        }
        for (std::size_t i = first; i < cut.pieces.size(); ++i)
            cut.next.push_back(static_cast<int>(i + 1 == cut.pieces.size() ? first : i + 1));
    }
    return cut;
}

std::vector<std::vector<Piece>> traced(const CutPieces& cut) {
    std::vector<std::vector<Piece>> loops;
    std::vector<bool> seen(cut.pieces.size());
    for (std::size_t start = 0; start < cut.pieces.size(); ++start) {
        std::vector<Piece> loop;
        for (std::size_t i = start; !seen[i]; i = static_cast<std::size_t>(cut.next[i])) {
            seen[i] = true;
            loop.push_back(cut.pieces[i]);
        }
        if (!loop.empty()) loops.push_back(std::move(loop));
    }
    return loops;
}

/// Does piece b go on where a ends, on the same source?
bool goes_on(const Piece& a, const Piece& b, const Curve& source, double merge) {
    if (a.source != b.source || (a.t_begin < a.t_end) != (b.t_begin < b.t_end)) return false;
    double gap = b.t_begin - a.t_end;
    if (is_full(source)) gap = std::remainder(gap, 1.0);
    return std::abs(gap) * length(source) <= merge;
}

/// Both pieces, the second of which goes on where the first ends, in one.
Piece joined(const Piece& a, const Piece& b, const Curve& source) {
    Piece both{{}, a.source, a.t_begin, a.t_end + (b.t_end - b.t_begin)};
    if (is_full(source)) shift_into_first_turn(both.t_begin, both.t_end);
    if (std::holds_alternative<Segment>(source))
        both.curve = Segment{point(a.curve, 0), point(b.curve, 1)};
    else if (both.t_begin < both.t_end)
        both.curve = trimmed(source, both.t_begin, both.t_end);
    else
        both.curve = reversed(trimmed(source, both.t_end, both.t_begin));
    return both;
}

/// Joins what was cut before and goes on along one source after all.
std::vector<Piece> rejoined(std::vector<Piece> loop, const std::vector<PlacedSource>& sources, double merge) {
    const auto source = [&](const Piece& piece) -> const Curve& {
        return sources[static_cast<std::size_t>(piece.source)].curve;
    };
    std::size_t start = 0;
    while (start < loop.size() &&
           goes_on(loop[(start + loop.size() - 1) % loop.size()], loop[start], source(loop[start]), merge))
        ++start;
    if (start == loop.size() && is_full(source(loop[0]))) {
        const bool along = loop[0].t_begin < loop[0].t_end;
        const Curve& whole = source(loop[0]);
        return {{along ? whole : reversed(whole), loop[0].source, along ? 0.0 : 1.0, along ? 1.0 : 0.0}};
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start % loop.size()), loop.end());
    std::vector<Piece> pieces;
    for (const Piece& piece : loop)
        if (!pieces.empty() && goes_on(pieces.back(), piece, source(piece), merge))
            pieces.back() = joined(pieces.back(), piece, source(piece));
        else
            pieces.push_back(piece);
    return pieces;
}

}  // namespace

std::vector<std::vector<Piece>> cut_pinches(std::vector<std::vector<Piece>> loops, const std::vector<PlacedSource>& sources) {
    const Work work = in_a_row(loops);
    std::vector<Touch> touches = find_touches(work);
    if (touches.empty()) return loops;
    touches = cutting(work, std::move(touches));
    std::set<std::pair<int, double>> places;
    std::erase_if(touches, [&](const Touch& t) {  // where three loops meet in a point, two of them change over
        const std::pair a(t.a.piece, t.a.t), b(t.b.piece, t.b.t);
        if (a == b || places.contains(a) || places.contains(b)) return true;
        places.insert({a, b});
        return false;
    });
    if (touches.empty()) return loops;
    CutPieces cut = cut_at(work, places);
    std::vector<int> before(cut.next.size());
    for (std::size_t i = 0; i < cut.next.size(); ++i) before[static_cast<std::size_t>(cut.next[i])] = static_cast<int>(i);
    for (const Touch& t : touches) {
        const int a = cut.at.at({t.a.piece, t.a.t}), b = cut.at.at({t.b.piece, t.b.t});
        std::swap(cut.next[static_cast<std::size_t>(before[static_cast<std::size_t>(a)])],
                  cut.next[static_cast<std::size_t>(before[static_cast<std::size_t>(b)])]);
    }
    loops = traced(cut);
    for (std::vector<Piece>& loop : loops) loop = rejoined(std::move(loop), sources, work.merge);
    return loops;
}

}  // namespace abut::geometry
