// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/cell_strands.hpp"

#include <algorithm>
#include <variant>

namespace abut::geometry {

namespace {

/// Does the boundary leave the cell after contour k and come back with contour next (the loop's following one in the cell)
/// without having been farther away than rounding?
bool is_rounding(const CellContours& cell, std::size_t k, std::size_t next) {
    if ((cell.end[k] - cell.begin[next]).norm() > cell.crossing_length) return false;
    const ContourPiece &a = cell[k], &b = cell[next];
    const double allowed = 4 * cell.crossing_length;  // there and back, around a corner of the cell
    if (a.edge == b.edge && a.t1 <= b.t0) return length(cell.curve(k), a.t1, b.t0) <= allowed;
    if ((point(cell.curve(k), 1) - point(cell.curve(next), 0)).norm() > allowed) return false;
    return length(cell.curve(k), a.t1, 1) + length(cell.curve(next), 0, b.t0) <= allowed;
}

/// Is a height above the lower side (a distance from the left one) so little that material up to it does not count?
bool is_sliver(const CellContours& cell, int axis, double height) {
    return height <= sliver_fraction * cell.box.size()[axis];
}

/// The side among those that belong to the cell (bottom and left) on which a point lies; none.
CellSide own_side_at(const CellContours& cell, const Vec2& p) {
    if (is_sliver(cell, 1, p.y() - cell.box.min.y())) return CellSide::bottom;
    return is_sliver(cell, 0, p.x() - cell.box.min.x()) ? CellSide::left : CellSide::none;
}

/// Does contour k run along one of these sides, clockwise around the cell? The side, or none.
CellSide side_run_along(const CellContours& cell, std::size_t k) {
    if (!std::holds_alternative<Segment>(cell.curve(k))) return CellSide::none;
    const Vec2 a = cell.begin[k] - cell.box.min, b = cell.end[k] - cell.box.min;
    if (is_sliver(cell, 1, std::max(a.y(), b.y())) && b.x() < a.x()) return CellSide::bottom;
    if (is_sliver(cell, 0, std::max(a.x(), b.x())) && b.y() > a.y()) return CellSide::left;
    return CellSide::none;
}

/// Does a tip of the outside, between contour k and the next one, just reach the cell's lower or left side? The side, or none.
CellSide side_touched(const CellContours& cell, std::size_t k, std::size_t next) {
    const Vec2 tip = cell.begin[next], from = cell.begin[k], to = cell.end[next];
    const CellSide side = own_side_at(cell, tip);
    if (side == CellSide::none || cross(tip - from, to - tip) >= 0) return CellSide::none;
    const int axis = side == CellSide::bottom ? 1 : 0;
    return is_sliver(cell, axis, std::min(from[axis], to[axis]) - cell.box.min[axis]) ? CellSide::none : side;
}

/// Those of one loop; contours along a side left out.
void walked_contours(std::vector<WalkedContour>& walked, const CellContours& cell, std::size_t begin, std::size_t end) {
    walked.clear();
    CellSide along_first = CellSide::none;  // run along before the first contour that is kept
    for (std::size_t k = begin; k < end; ++k) {
        const ContourPiece& c = cell[k];
        const CellSide along = side_run_along(cell, k);
        if (along == CellSide::none) {
            walked.push_back({k, c.enters, c.leaves});
            continue;
        }
        if (c.enters == CellSide::none && !walked.empty() && walked.back().leaves == CellSide::none)
            walked.back().leaves = along;
        if (c.enters == CellSide::none && walked.empty()) along_first = along;
    }
    if (walked.empty()) return;
    if (walked.back().leaves == CellSide::none) walked.back().leaves = along_first;
    const std::size_t n = walked.size();
    for (std::size_t i = 0; i < n; ++i) {
        WalkedContour &here = walked[i], &next = walked[(i + 1) % n];
        if (here.leaves == CellSide::none && next.enters == CellSide::none)
            here.leaves = next.enters = side_touched(cell, here.contour, next.contour);
        else if (next.enters == CellSide::none)
            next.enters = own_side_at(cell, cell.begin[next.contour]);
        else if (here.leaves == CellSide::none)
            here.leaves = own_side_at(cell, cell.end[here.contour]);
    }
}

/// The loop's way from one contour to the next: on inside the cell (also past a tip of material that only reaches the side);
/// to the side and back where a tip of the outside reaches it, which parts the material; or out of the cell.
enum class Passage { on, pinch, away };

Passage passage(const CellContours& cell, const WalkedContour& here, const WalkedContour& next) {
    if (here.leaves == CellSide::none) return Passage::on;
    const std::size_t k = here.contour, l = next.contour;
    if (!is_rounding(cell, k, l)) return Passage::away;
    return cross(cell.end[k] - cell.begin[k], cell.end[l] - cell.begin[l]) < 0 ? Passage::pinch : Passage::on;
}

double position(const CellContours& cell, CellSide side, const Vec2& p) {
    const Vec2 u = (p - cell.box.min).cwiseQuotient(cell.box.size()).cwiseMax(0).cwiseMin(1);
    switch (side) {
        case CellSide::bottom:
            return u.x();
        case CellSide::right:
            return 1 + u.y();
        case CellSide::top:
            return 3 - u.x();
        default:
            return 4 - u.y();
    }
}

void add_end(Strands& all, const CellContours& cell, const WalkedContour& last) {
    all.ends.push_back({position(cell, last.leaves, cell.end[last.contour]), all.strands.size() - 1, true});
}
/// Of a pinched strand: where the one before it, whose last contour is given, leaves.
void add_begin(Strands& all, const CellContours& cell, const WalkedContour& c, bool pinched) {
    const double at = pinched ? position(cell, c.leaves, cell.end[c.contour]) : position(cell, c.enters, cell.begin[c.contour]);
    all.ends.push_back({at, all.strands.size() - 1, false});
}

/// Of one loop.
void append_strands(Strands& all, const CellContours& cell, const std::vector<WalkedContour>& walked) {
    const std::size_t n = walked.size();
    std::size_t start = 0;  // the first contour after a break
    while (start < n && passage(cell, walked[start], walked[(start + 1) % n]) == Passage::on) ++start;
    const bool closed = start == n;
    start = closed ? 0 : start + 1;
    for (std::size_t i = 0; i < n; ++i) {
        const WalkedContour &here = walked[(start + i) % n], &before = walked[(start + i + n - 1) % n];
        const Passage way = closed ? Passage::on : passage(cell, before, here);
        if (i == 0 || way != Passage::on) {
            if (!closed && i > 0) add_end(all, cell, before);
            all.strands.push_back({closed});
            if (!closed) add_begin(all, cell, way == Passage::pinch ? before : here, way == Passage::pinch);
        }
        all.of_contour[here.contour] = all.strands.size() - 1;
    }
    if (!closed && n > 0) add_end(all, cell, walked[(start + n - 1) % n]);
}

/// The corner after contour k is that of the loop's next contour, as for monotone pieces; its edges meet within the merge
/// length. The next contour follows in the cell's list, or the loop begins there and the list has it farther before.
void join_end(CellContours& cell, std::size_t k) {
    const double merge = cell.crossing_length / crossing_fraction;
    const auto is_next = [&](std::size_t next) {
        return cell[next].enters == CellSide::none && (cell.begin[next] - cell.end[k]).norm() <= merge;
    };
    std::size_t next = k + 1;
    if (next == cell.n_edges || !is_next(next))
        for (next = 0; next < k && !is_next(next);) ++next;
    if (next < cell.n_edges && next != k) cell.end[k] = cell.begin[next];
}

}  // namespace

void set_cell(CellContours& cell, const Part& part, const CutCells& cells, int c) {
    const auto first = static_cast<std::size_t>(cells.first_contour[static_cast<std::size_t>(c)]);
    const auto last = static_cast<std::size_t>(cells.first_contour[static_cast<std::size_t>(c) + 1]);
    cell.part = &part;
    cell.contours = std::span(cells.contours).subspan(first, last - first);
    cell.box = cells.grid.box(c);
    cell.crossing_length = crossing_fraction * cells.merge;
    cell.begin.clear();
    cell.end.clear();
    for (std::size_t k = 0; k < cell.contours.size() && cell[k].edge >= 0; ++k) {
        const bool goes_on = k > 0 && cell[k - 1].edge == cell[k].edge && cell[k - 1].t1 == cell[k].t0;
        cell.begin.push_back(goes_on ? cell.end.back() : point(cell.curve(k), cell[k].t0));
        cell.end.push_back(point(cell.curve(k), cell[k].t1));
    }
    cell.n_edges = cell.begin.size();
    for (std::size_t k = 0; k < cell.n_edges; ++k)
        if (cell[k].leaves == CellSide::none) join_end(cell, k);
}

void find_strands(Strands& all, const CellContours& cell, const std::vector<int>& loop_of) {
    all.strands.clear();
    all.ends.clear();
    all.of_contour.assign(cell.n_edges, no_strand);
    const auto loop = [&](std::size_t k) { return loop_of[static_cast<std::size_t>(cell[k].edge)]; };
    for (std::size_t begin = 0, end = 0; begin < cell.n_edges; begin = end) {
        while (end < cell.n_edges && loop(end) == loop(begin)) ++end;
        walked_contours(all.walked, cell, begin, end);
        append_strands(all, cell, all.walked);
    }
}

}  // namespace abut::geometry
