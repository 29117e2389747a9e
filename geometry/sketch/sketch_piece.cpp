// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_piece.hpp"

#include <algorithm>
#include <cmath>

namespace abut::geometry {

namespace {

/// Of the slack: ends that rounding moved are seldom as far from a line as each other to within this.
constexpr double even_fraction = 0.05;

}  // namespace

double largest_slack(const std::vector<SketchPiece>& entities) {
    double most = 0;
    for (const SketchPiece& entity : entities) most = std::max(most, entity.slack);
    return most;
}

double reach_of_line(const SketchPiece& line, const SketchPiece& piece, double coincidence) {
    const auto *on = std::get_if<Segment>(&line.curve), *beside = std::get_if<Segment>(&piece.curve);
    if (line.slack <= coincidence || !on) return coincidence;
    if (!beside) return line.slack;
    const Vec2 along = (on->to - on->from).normalized();
    const double begin = cross(along, beside->from - on->from), end = cross(along, beside->to - on->from);
    const bool is_even = std::abs(begin - end) <= even_fraction * line.slack && std::abs(begin) > coincidence;
    return is_even ? coincidence : line.slack;
}

}  // namespace abut::geometry
