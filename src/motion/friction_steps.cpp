// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/friction_steps.hpp"

#include <algorithm>
#include <iterator>

#include "solver/contact/friction.hpp"
#include "solver/contact/rigid_settle.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// As spring_closing, of steps in which states of friction are sought: springs a hundred times as soft.
constexpr double friction_closing = 1e-7;

bool is_closed(const ClosingRow& row, double touching) {
    return row.gap <= touching;
}
std::vector<ClosingRow> closed_among(std::vector<ClosingRow> rows, double touching) {
    std::erase_if(rows, [&](const ClosingRow& row) { return !is_closed(row, touching); });
    return rows;
}

/// A step of one group with friction in closed gaps.
solver::ContactQpResult solve_group(const DrivenGroup& group, const std::vector<Lead>& leads, const Resisted& by,
                                    const std::vector<double>& across) {
    solver::ContactQp qp = step_problem(group.moving, group.gaps, leads, by, across);
    int along = static_cast<int>(group.gaps.size());
    for (std::size_t k = 0; k < group.gaps.size(); ++k)
        if (by.sticks[k])
            qp.friction.push_back({static_cast<int>(k), along++, std::min(group.gaps[k].friction, solver::rough_coefficient)});
    qp.compliance = Eigen::MatrixXd(qp.foundation.cwiseInverse().asDiagonal());
    return solve_held_with_friction(qp);
}

/// The amplitudes of a step with friction in closed gaps; nothing where they are not found.
std::optional<VectorXd> step_with_friction(const MovingParts& moving, const std::vector<ClosingRow>& gaps,
                                           const std::vector<Lead>& leads, Resisted by, double touching) {
    constexpr double found = 1e-5;  // of forces and gaps: rounding, with springs as unlike as gaps and drags
    VectorXd step = VectorXd::Zero(moving.n);
    for (const DrivenGroup& group : driven_groups(moving, gaps, leads)) {
        by.sticks.clear();
        std::transform(group.gaps.begin(), group.gaps.end(), std::back_inserter(by.sticks),
                       [&](const ClosingRow& row) { return is_closed(row, touching) && row.friction > 0; });
        solver::ContactQpResult result = solve_group(group, leads, by, {});
        if (!(result.residual <= found)) return std::nullopt;
        const std::vector<double> across = stiffness_across(group.gaps, result.multipliers);
        if (std::any_of(across.begin(), across.end(), [](double c) { return c > 0; })) {
            result = solve_group(group, leads, by, across);
            if (!(result.residual <= found)) return std::nullopt;
        }
        put(group, result.amplitudes(), moving, step);
    }
    return step;
}

/// The amplitudes of a step on the closed gaps; what little drives is dragged less. across_loads: as of Resisted.
std::optional<VectorXd> slow_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                  const std::vector<Lead>& leads, double across_loads, double touching) {
    constexpr double short_step = 0.5;
    Resisted by{friction_closing, 1};
    by.across_loads = across_loads;
    while (true) {
        std::optional<VectorXd> step = step_with_friction(moving, closed_among(rows, touching), leads, by, touching);
        const double far = step ? farthest_in_steps(moving, *step) : 0;
        if (!step || far > short_step || by.drag <= least_drag) return step;
        by.drag = std::max(least_drag, by.drag * std::max(far, drag_step));
    }
}

}  // namespace

std::vector<ClosingRow> rolling_rows(const std::vector<ClosingRow>& rows, double touching) {
    constexpr double same_normal = 1e-3;  // a corner may touch two faces in one place
    constexpr double same_side = 0.05;    // of a hollow, in which a round part rolls from one place to the next
    const auto is_in_hollow = [](const ClosingRow& row) { return row.pivot1 != row.x1 || row.pivot2 != row.x2; };
    const auto is_same = [&](const ClosingRow& a, const ClosingRow& b) {
        if (a.first != b.first || a.second != b.second) return false;
        const double apart = (a.x1 - b.x1).norm() + (a.x2 - b.x2).norm(), turned = (a.normal - b.normal).norm();
        return (apart <= touching && turned <= same_normal) ||
               (is_in_hollow(a) && is_in_hollow(b) && (a.x1 - a.x2 - (b.x1 - b.x2)).norm() <= touching && turned <= same_side);
    };
    std::vector<ClosingRow> by_gap = rows, rolling;
    std::stable_sort(by_gap.begin(), by_gap.end(), [](const ClosingRow& a, const ClosingRow& b) { return a.gap < b.gap; });
    for (const ClosingRow& row : by_gap)
        if (!row.is_beside &&
            std::none_of(rolling.begin(), rolling.end(), [&](const ClosingRow& r) { return is_same(row, r); }))
            rolling.push_back(row);
    return rolling;
}

std::optional<VectorXd> driven_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                    const std::vector<Lead>& leads, double touching) {
    // loads take parts as slowly as they can; what they do not work on goes along, such as a part that another carries
    constexpr double hardly_dragged = 1e-3;
    std::optional<VectorXd> step = slow_step(moving, rows, leads, hardly_dragged, touching);
    // what would slide just as fast as it is carried may do either, and no state is found: all dragged alike, it does one
    return step ? step : slow_step(moving, rows, leads, 1, touching);
}

std::optional<VectorXd> led_step(const MovingParts& moving, const std::vector<ClosingRow>& rows, const std::vector<Lead>& leads,
                                 double leading, double touching) {
    Resisted by{friction_closing, least_drag};
    by.leading = leading;
    return step_with_friction(moving, closed_among(rows, touching), leads, by, touching);
}

VectorXd until_touch(const MovingParts& moving, const std::vector<ClosingRow>& rows, const std::vector<Lead>& leads,
                     VectorXd step, double touching) {
    step /= std::max(1.0, farthest_in_steps(moving, step));
    const VectorXd rate = step_problem(moving, rows, leads, {spring_closing, 1}).modes * step;
    double share = 1;
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (const double to = rate[static_cast<Index>(k)]; !is_closed(rows[k], touching) && to < 0)
            share = std::min(share, rows[k].gap / -to);
    return share * step;
}

std::optional<VectorXd> held_step(const MovingParts& moving, const std::vector<ClosingRow>& rows,
                                  const std::vector<Lead>& leads, double touching) {
    constexpr double at_rest = 10;  // times what is touched: gaps close by as much, and turn parts
    std::optional<VectorXd> step = step_with_friction(moving, rows, leads, {friction_closing, least_drag}, touching);
    const auto is_held = [&](const MovingPart& b) { return b.own(*step).norm() <= at_rest * touching; };
    if (step && !std::all_of(moving.list.begin(), moving.list.end(), is_held)) step.reset();
    return step;
}

bool are_all_pressed(const MovingParts& moving, const std::vector<ClosingRow>& rows, const std::vector<Lead>& leads,
                     double touching) {
    constexpr double pressed = 1e-3;  // of its loads
    const std::vector<ClosingRow> closed = closed_among(rows, touching);
    const VectorXd forces = settle_rigidly(step_problem(moving, closed, leads, {spring_closing, 1})).multipliers;
    return std::all_of(moving.list.begin(), moving.list.end(), [&](const MovingPart& b) {
        const auto is_of_body = [&](int part) {
            const int own = moving.of_part[at(part)];
            return own >= 0 && moving.list[at(own)].first == b.first;
        };
        bool is_pressed = b.pull == 0;
        for (std::size_t k = 0; k < closed.size() && !is_pressed; ++k)
            is_pressed = (is_of_body(closed[k].first) || is_of_body(closed[k].second)) &&
                         forces[static_cast<Index>(k)] > pressed * b.pull;
        return is_pressed;
    });
}

}  // namespace abut
