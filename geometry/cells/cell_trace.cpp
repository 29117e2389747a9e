// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/cell_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "geometry/cells/contour_area.hpp"

namespace abut::geometry {

namespace {

/// The largest rounding of a component's fraction: what is negative by more says that strands have been joined wrongly.
constexpr double fraction_rounding = 1e-11;

// ---- the order of the strands' ends along the perimeter ----

/// From index 1 on: an end that does not alternate changes places with the next other one within rounding. False where there is
/// none.
bool make_alternate(std::vector<StrandEnd>& ends, double rounding) {
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const auto other = std::find_if(ends.begin() + static_cast<std::ptrdiff_t>(i), ends.end(),
                                        [&](const StrandEnd& e) { return e.leaves != ends[i - 1].leaves; });
        if (other == ends.end() || other->at - ends[i].at > rounding) return false;
        std::rotate(ends.begin() + static_cast<std::ptrdiff_t>(i), other, other + 1);
    }
    return true;
}

double rounding_along(const CellContours& cell) {
    return cell.crossing_length / cell.box.size().minCoeff();
}

bool sort_ends(std::vector<StrandEnd>& ends, double rounding) {
    std::sort(ends.begin(), ends.end(), [](const StrandEnd& a, const StrandEnd& b) {
        return a.at != b.at           ? a.at < b.at
               : a.leaves != b.leaves ? b.leaves
                                      : a.strand < b.strand;  // at a pinch, first what enters
    });
    std::vector<StrandEnd> sorted = ends;
    if (make_alternate(ends, rounding)) return true;
    // the first one may be the one that is out of place
    ends = std::move(sorted);
    const auto other =
        std::find_if(ends.begin(), ends.end(), [&](const StrandEnd& e) { return e.leaves != ends.front().leaves; });
    if (other == ends.end() || other->at - ends.front().at > rounding) return false;
    std::rotate(ends.begin(), other, other + 1);
    return make_alternate(ends, rounding);
}

// ---- stretches of the sides ----

/// Coordinate along the side of a position on the perimeter, u in [0, 1] from the side's counter-clockwise beginning.
double coordinate(const Box2& box, int side, double u) {
    const int axis = side % 2;
    if (side >= 2) u = 1 - u;
    return u == 0 ? box.min[axis] : u == 1 ? box.max[axis] : box.min[axis] + u * box.size()[axis];
}

/// Counter-clockwise from one position to another.
void append_stretch(std::vector<SideStretch>& stretches, const Box2& box, int component, double from, double to) {
    if (to < from) to += 4;
    for (int side = 0; side < 8; ++side) {
        const double a = std::max(from, static_cast<double>(side)) - side, b = std::min(to, side + 1.0) - side;
        if (b <= a) continue;
        const double p = coordinate(box, side % 4, a), q = coordinate(box, side % 4, b);
        stretches.push_back({component, static_cast<CellSide>(side % 4), std::min(p, q), std::max(p, q)});
    }
}

void append_perimeter(std::vector<SideStretch>& stretches, const Box2& box, int component) {
    append_stretch(stretches, box, component, 0, 4);
}

/// Length of the contours of the right side.
double right_length(std::span<const ContourPiece> sides) {
    return std::accumulate(sides.begin(), sides.end(), 0.0,
                           [](double sum, const ContourPiece& c) { return sum + c.t1 - c.t0; });
}

double right_length(const std::vector<SideStretch>& stretches) {
    double sum = 0;
    for (const SideStretch& s : stretches)
        if (s.side == CellSide::right) sum += s.to - s.from;
    return sum;
}

// ---- components ----

/// Strands joined along the perimeter get one number each cycle; ends alternate. Returns how many.
int join_along_perimeter(Strands& all, CellTrace& trace, const CellContours& cell) {
    const std::size_t n = all.ends.size();
    std::vector<std::size_t> next(all.strands.size());  // the strand that the perimeter leads to
    for (std::size_t i = 0; i < n; ++i)
        if (all.ends[i].leaves) next[all.ends[i].strand] = all.ends[(i + 1) % n].strand;
    int n_found = 0;
    for (std::size_t c = 0; c < all.strands.size(); ++c) {
        if (all.strands[c].closed || all.strands[c].component >= 0) continue;
        for (std::size_t k = c; all.strands[k].component < 0; k = next[k]) all.strands[k].component = n_found;
        ++n_found;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const StrandEnd &from = all.ends[i], &to = all.ends[(i + 1) % n];
        if (from.leaves) append_stretch(trace.stretches, cell.box, all.strands[from.strand].component, from.at, to.at);
    }
    return n_found;
}

/// Do the stretches have as much of the right side as its contours say? They do not where the order of ends was rounding.
bool agrees_with_right_side(const CellTrace& trace, const CellContours& cell, std::span<const ContourPiece> sides,
                            std::size_t n_ends) {
    const double rounding = (2.0 + static_cast<double>(n_ends)) * cell.crossing_length;
    return std::abs(right_length(trace.stretches) - right_length(sides)) <= rounding;
}

/// Joined in the order of their positions; a single strand that leaves and enters at one place, the other way round where that
/// agrees with the right side. Empty-handed (-1): unclear.
int components_of_strands(Strands& all, CellTrace& trace, const CellContours& cell, std::span<const ContourPiece> sides) {
    const double rounding = rounding_along(cell);
    if (!sort_ends(all.ends, rounding)) return -1;
    const int n = join_along_perimeter(all, trace, cell);
    if (agrees_with_right_side(trace, cell, sides, all.ends.size())) return n;
    if (all.ends.size() != 2) return -1;
    const double apart = std::abs(all.ends[0].at - all.ends[1].at);
    if (std::min(apart, 4 - apart) > rounding) return -1;
    trace.stretches.clear();
    if (right_length(sides) > 0.5 * cell.box.size().y()) append_perimeter(trace.stretches, cell.box, 0);
    return n;
}

/// The nearest x >= p.x - crossing_length at which a contour of an edge has p's y; infinite if none.
double x_beyond(const CellContours& cell, std::size_t k, const Vec2& p) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const Vec2 a = cell.begin[k], b = cell.end[k];
    // the ends of neighbouring edges are one corner up to the merge length
    const double slack = cell.crossing_length / crossing_fraction;
    if (p.y() < std::min(a.y(), b.y()) - slack || p.y() > std::max(a.y(), b.y()) + slack) return none;
    if (std::max(a.x(), b.x()) < p.x() - cell.crossing_length) return none;
    double x = std::abs(p.y() - a.y()) < std::abs(p.y() - b.y()) ? a.x() : b.x();
    const std::vector<double> at = crossings(trimmed(cell.curve(k), cell[k].t0, cell[k].t1), 1, p.y());
    if (!at.empty()) x = point(trimmed(cell.curve(k), cell[k].t0, cell[k].t1), at.front()).x();
    return x < p.x() - cell.crossing_length ? none : x;
}

/// Component of the stretch of the right side that holds y, or is nearest to it within rounding; -1 if none is.
int component_on_right(const CellTrace& trace, double y, double rounding) {
    double least = rounding;
    int component = -1;
    for (const SideStretch& s : trace.stretches) {
        const double distance = std::max({s.from - y, y - s.to, 0.0});
        if (s.side != CellSide::right || distance >= least) continue;
        least = distance;
        component = s.component;
    }
    return component;
}

struct Hole {
    std::size_t strand;
    Vec2 rightmost;
};

std::vector<Hole> holes_from_the_right(const Strands& all, const CellContours& cell) {
    std::vector<Hole> holes;
    std::vector<std::size_t> hole_of(all.strands.size());
    for (std::size_t c = 0; c < all.strands.size(); ++c) {
        hole_of[c] = holes.size();
        if (all.strands[c].component < 0) holes.push_back({c, cell.box.min});
    }
    for (std::size_t k = 0; k < all.of_contour.size(); ++k) {
        const std::size_t c = all.of_contour[k];
        if (c == no_strand || all.strands[c].component >= 0) continue;
        Vec2& rightmost = holes[hole_of[c]].rightmost;
        for (const Vec2& p : {cell.begin[k], cell.end[k]})
            if (p.x() > rightmost.x()) rightmost = p;
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const Hole& a, const Hole& b) { return a.rightmost.x() > b.rightmost.x(); });
    return holes;
}

/// What lies to the right of a hole's rightmost point is the material around it, up to the first contour there. That one
/// belongs to the component, or to a hole farther to the right of it. False where none is found.
bool assign_holes(Strands& all, const CellTrace& trace, const CellContours& cell) {
    for (const Hole& hole : holes_from_the_right(all, cell)) {
        double nearest = std::numeric_limits<double>::infinity();
        int component = component_on_right(trace, hole.rightmost.y(), cell.crossing_length);
        for (std::size_t k = 0; k < all.of_contour.size(); ++k) {
            if (all.of_contour[k] == hole.strand || all.of_contour[k] == no_strand) continue;
            const double x = x_beyond(cell, k, hole.rightmost);
            if (x >= nearest) continue;
            nearest = x;
            component = all.strands[all.of_contour[k]].component;
        }
        if (component < 0) return false;
        all.strands[hole.strand].component = component;
    }
    return true;
}

/// Closed strands that run counter-clockwise are components, numbered from n on. Returns how many there are then.
int number_islands(Strands& all, const CellContours& cell, int n) {
    for (std::size_t k = 0; k < all.of_contour.size(); ++k) {
        const std::size_t c = all.of_contour[k];
        if (c != no_strand && all.strands[c].closed)
            all.strands[c].area += area_share(*cell.part, cell[k], cell.box.min.x(), cell.box.max.x());
    }
    for (Strand& strand : all.strands)
        if (strand.closed && strand.area > 0) strand.component = n++;
    return n;
}

/// A contour of the right side as long as a rounding lies before a tip that only reaches the side: the component of the contour
/// that leaves through the side nearest to it.
int component_of_tip(const Strands& all, const CellContours& cell, double y) {
    double least = std::numeric_limits<double>::infinity();
    int component = -1;
    for (std::size_t k = 0; k < cell.n_edges; ++k) {
        const double distance = std::abs(cell.end[k].y() - y);
        if (cell[k].leaves != CellSide::right || all.of_contour[k] == no_strand || distance >= least) continue;
        least = distance;
        component = all.strands[all.of_contour[k]].component;
    }
    return component;
}

int component_of_contour(const CellTrace& trace, const Strands& all, const CellContours& cell, std::size_t k) {
    const ContourPiece& c = cell[k];
    if (c.edge >= 0) return all.of_contour[k] == no_strand ? -1 : all.strands[all.of_contour[k]].component;
    const double middle = 0.5 * (c.t0 + c.t1);
    const int on_stretch = component_on_right(trace, middle, cell.crossing_length);
    return on_stretch < 0 && c.t1 - c.t0 <= cell.crossing_length ? component_of_tip(all, cell, middle) : on_stretch;
}

/// Fractions and components of contours; false where a contour belongs nowhere or a component has less than no area.
bool fill_components(CellTrace& trace, const Strands& all, const CellContours& cell, int n) {
    trace.fraction.assign(static_cast<std::size_t>(n), 0.0);
    for (std::size_t k = 0; k < cell.contours.size(); ++k) {
        const ContourPiece& c = cell[k];
        const int component = component_of_contour(trace, all, cell, k);
        trace.of_contour[k] = component;
        if (component >= 0)
            trace.fraction[static_cast<std::size_t>(component)] +=
                area_share(*cell.part, cell[k], cell.box.min.x(), cell.box.max.x()) / cell.box.size().prod();
        else if (c.edge < 0 && c.t1 - c.t0 > cell.crossing_length)
            return false;
    }
    return *std::min_element(trace.fraction.begin(), trace.fraction.end()) > -fraction_rounding;
}

/// The largest first, slivers left out.
void rank_components(CellTrace& trace) {
    std::vector<int> order(trace.fraction.size()), rank(order.size(), -1);
    std::iota(order.begin(), order.end(), 0);
    const auto fraction = [&](int c) { return trace.fraction[static_cast<std::size_t>(c)]; };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return fraction(a) > fraction(b); });
    std::vector<double> ranked;
    for (int c : order) {
        if (!ranked.empty() && fraction(c) < sliver_fraction) break;
        rank[static_cast<std::size_t>(c)] = static_cast<int>(ranked.size());
        ranked.push_back(fraction(c));
    }
    trace.fraction = std::move(ranked);
    const auto renumber = [&](int& c) { c = c < 0 ? -1 : rank[static_cast<std::size_t>(c)]; };
    for (int& c : trace.of_contour) renumber(c);
    for (SideStretch& s : trace.stretches) renumber(s.component);
}

void take_as_one(CellTrace& trace, const CellContours& cell) {
    trace.unclear = true;
    trace.fraction.clear();
    trace.stretches.clear();
    std::fill(trace.of_contour.begin(), trace.of_contour.end(), 0);
    append_perimeter(trace.stretches, cell.box, 0);
}

/// False: unclear.
bool trace_strands(CellTrace& trace, Strands& all, const CellContours& cell) {
    int n = 0;
    if (!all.ends.empty()) {
        n = components_of_strands(all, trace, cell, cell.right_sides());
        if (n < 0) return false;
    } else if (right_length(cell.right_sides()) > 0.5 * cell.box.size().y()) {
        append_perimeter(trace.stretches, cell.box, n++);
    }
    n = number_islands(all, cell, n);
    if (n <= 1) return true;
    if (!assign_holes(all, trace, cell) || !fill_components(trace, all, cell, n)) return false;
    rank_components(trace);
    return true;
}

}  // namespace

void trace_cell(CellTrace& trace, const Part& part, const CutCells& cells, const std::vector<int>& loop_of, int c) {
    set_cell(trace.cell, part, cells, c);
    find_strands(trace.strands, trace.cell, loop_of);
    trace.unclear = false;
    trace.fraction.clear();
    trace.stretches.clear();
    trace.of_contour.assign(trace.cell.contours.size(), 0);
    if (!trace_strands(trace, trace.strands, trace.cell)) take_as_one(trace, trace.cell);
    std::sort(trace.stretches.begin(), trace.stretches.end(),
              [](const SideStretch& a, const SideStretch& b) { return a.side != b.side ? a.side < b.side : a.from < b.from; });
}

}  // namespace abut::geometry
