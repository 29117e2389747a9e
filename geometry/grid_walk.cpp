// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/grid_walk.hpp"

#include <algorithm>

#include "geometry/monotone.hpp"

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

void walk_piece(GridWalk& walk, Steps& steps, const Grid& grid, const MonotonePiece& piece, const Curve& curve) {
    steps.clear();
    append_steps(steps, piece, curve, 0, grid.x);
    append_steps(steps, piece, curve, 1, grid.y);
    sort_by_progress(steps);
    int column = interval_of(grid.x, piece.from.x()), row = interval_of(grid.y, piece.from.y());
    double t = piece.t0;
    const auto record = [&](double until) {
        if (until <= t) return;
        if (inside(grid, column, row)) walk.contours.push_back({grid.cell(column, row), piece.edge, t, until});
        walk.pieces.push_back({piece.edge, t, until, -1});
        t = until;
    };
    for (const Step& step : steps) {
        record(step.meeting.t);
        if (step.d_column != 0)
            walk.crossings.push_back({step.d_column > 0 ? column + 1 : column, step.meeting.at.y(), step.d_column});
        column += step.d_column;
        row += step.d_row;
    }
    record(piece.t1);
}

}  // namespace

GridWalk walk_boundary(const Part& part, const Grid& grid) {
    GridWalk walk;
    Steps steps;
    for (const MonotonePiece& piece : monotone_pieces(part))
        walk_piece(walk, steps, grid, piece, part.edges[static_cast<std::size_t>(piece.edge)].curve);
    return walk;
}

}  // namespace abut::geometry
