// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/grid_walk.hpp"

#include <algorithm>
#include <limits>

#include "geometry/brep/monotone.hpp"

namespace abut::geometry {

namespace {

/// One step of the walk along a monotone piece: the point where it enters the next column or row.
struct Step {
    LineMeeting meeting;
    int d_column, d_row;
    double progress;  // from the start of the piece: grows along it, since it is monotone in x and in y
};

/// The steps of one piece; kept over pieces, so that most of them allocate nothing.
using Steps = std::vector<Step>;

void append_steps(Steps& steps, const MonotonePiece& piece, const Curve& curve, int axis, const std::vector<double>& lines) {
    const int a = interval_of(lines, piece.from[axis]), b = interval_of(lines, piece.to[axis]);
    const int d = b > a ? 1 : -1;
    for (int i = a; i != b; i += d) {
        const double c = lines[static_cast<std::size_t>(d > 0 ? i + 1 : i)];
        const LineMeeting m = line_meeting(piece, axis, c, curve);
        steps.push_back({m, axis == 0 ? d : 0, axis == 0 ? 0 : d, (m.at - piece.from).cwiseAbs().sum()});
    }
}

/// Stable, and without the buffer that std::stable_sort allocates, for the one or two steps that most pieces have.
void sort_by_progress(Steps& steps) {
    constexpr std::size_t few = 8;
    const auto before = [](const Step& a, const Step& b) { return a.progress < b.progress; };
    if (steps.size() > few) return std::stable_sort(steps.begin(), steps.end(), before);
    for (auto it = steps.begin(); it != steps.end(); ++it)
        std::rotate(std::upper_bound(steps.begin(), it, *it, before), it, it + 1);
}

bool inside(const Grid& grid, int column, int row) {
    return column >= 0 && column < grid.columns() && row >= 0 && row < grid.rows();
}

CellSide side_of(const Step& step) {
    if (step.d_column != 0) return step.d_column > 0 ? CellSide::right : CellSide::left;
    return step.d_row > 0 ? CellSide::top : CellSide::bottom;
}

/// Through which sides the walk around one loop goes. Cells in which it leaves no piece do not count: a piece is left through
/// the side of the first step after it, and entered through that of the last step before it.
struct Trail {
    int first = -1, last = -1;           // contours: the loop's first piece; that of the cell in which the walk is
    bool begun = false;                  // has the loop any piece yet?
    CellSide entered = CellSide::none;   // since the last piece
    CellSide departed = CellSide::none;  // by the first step, where that comes before the first piece
};

void note_step(Trail& trail, GridWalk& walk, CellSide side) {
    if (trail.last >= 0) walk.contours[static_cast<std::size_t>(trail.last)].leaves = side;
    if (!trail.begun && trail.departed == CellSide::none) trail.departed = side;
    trail.last = -1;
    trail.entered = opposite(side);
}

void add_contour(Trail& trail, GridWalk& walk, ContourPiece piece) {
    piece.enters = trail.entered;
    trail.last = static_cast<int>(walk.contours.size());
    if (!trail.begun) trail.first = trail.last;
    trail.begun = true;
    trail.entered = CellSide::none;
    walk.contours.push_back(piece);
}

/// The loop's last piece and its first one are neighbours, too.
void close_loop(const Trail& trail, GridWalk& walk) {
    if (trail.last >= 0) walk.contours[static_cast<std::size_t>(trail.last)].leaves = trail.departed;
    if (trail.first < 0 || trail.departed != CellSide::none) return;
    ContourPiece& first = walk.contours[static_cast<std::size_t>(trail.first)];
    if (first.enters == CellSide::none) first.enters = trail.entered;
}

void walk_piece(GridWalk& walk, Trail& trail, Steps& steps, const Grid& grid, const MonotonePiece& piece, const Curve& curve) {
    steps.clear();
    append_steps(steps, piece, curve, 0, grid.x);
    append_steps(steps, piece, curve, 1, grid.y);
    sort_by_progress(steps);
    int column = interval_of(grid.x, piece.from.x()), row = interval_of(grid.y, piece.from.y());
    double t = piece.t0;
    Vec2 from = piece.from;
    const auto record = [&](double until, const Vec2& to) {
        if (until <= t) return;
        if (inside(grid, column, row))
            add_contour(trail, walk, {grid.cell(column, row), piece.edge, t, until, CellSide::none, CellSide::none, from, to});
        trail.begun = true;
        walk.pieces.push_back({piece.edge, t, until, -1});
        t = until;
        from = to;
    };
    for (const Step& step : steps) {
        record(step.meeting.t, step.meeting.at);
        if (step.d_column != 0)
            walk.crossings.push_back({step.d_column > 0 ? column + 1 : column, step.meeting.at.y(), step.d_column});
        note_step(trail, walk, side_of(step));
        column += step.d_column;
        row += step.d_row;
    }
    record(piece.t1, piece.to);
}

}  // namespace

std::vector<int> loops_of_edges(const Part& part) {
    std::vector<int> loop_of(part.edges.size(), part.loops.empty() ? 0 : -1);
    for (std::size_t l = 0; l < part.loops.size(); ++l)
        for (int e : part.loops[l].edges) loop_of[static_cast<std::size_t>(e)] = static_cast<int>(l);
    return loop_of;
}

GridWalk walk_quarters(const Part& part, std::span<const ContourPiece> edges, const std::vector<int>& loop_of,
                       const Vec2& middle) {
    constexpr double far = std::numeric_limits<double>::infinity();
    const Grid quarters{{-far, middle.x(), far}, {-far, middle.y(), far}};
    GridWalk walk;
    Steps steps;
    Trail trail;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const ContourPiece& c = edges[k];
        const auto e = static_cast<std::size_t>(c.edge);
        if (k > 0 && loop_of[e] != loop_of[static_cast<std::size_t>(edges[k - 1].edge)]) {
            close_loop(trail, walk);
            trail = {};
        }
        if (c.enters != CellSide::none) {
            trail.last = -1;
            trail.entered = c.enters;
        }
        const Curve& curve = part.edges[e].curve;
        walk_piece(walk, trail, steps, quarters, monotone_piece(c.edge, curve, c.t0, c.t1, c.from, c.to), curve);
        if (c.leaves == CellSide::none) continue;
        note_step(trail, walk, c.leaves);
        trail.entered = CellSide::none;
    }
    close_loop(trail, walk);
    return walk;
}

GridWalk walk_boundary(const Part& part, const Grid& grid) {
    GridWalk walk;
    Steps steps;
    Trail trail;
    const std::vector<int> loop_of = loops_of_edges(part);
    int loop = 0;
    for (const MonotonePiece& piece : monotone_pieces(part)) {
        const auto e = static_cast<std::size_t>(piece.edge);
        if (loop_of[e] != loop) {
            close_loop(trail, walk);
            trail = {};
            loop = loop_of[e];
        }
        walk_piece(walk, trail, steps, grid, piece, part.edges[e].curve);
    }
    close_loop(trail, walk);
    return walk;
}

}  // namespace abut::geometry
