// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/hold_axis.hpp"

#include <algorithm>
#include <optional>

namespace abut::solver {

namespace {

using Eigen::Index;

/// All functions that do not vanish on the first grid line; none where one of them reaches it as an extension only.
std::optional<std::vector<int>> functions_on_first_line(const SplineSpace& s) {
    if (s.tree) return functions_on_side(s, GridSide::left, {{s.y.breakpoints.front(), s.y.breakpoints.back()}});
    const int columns = s.x.n_functions();
    std::vector<int> found;
    for (int branch = 0; branch + 1 < static_cast<int>(s.first.size()); ++branch) {
        const int tensor = branch < s.n_tensor() ? branch : s.tensor_of_extra[static_cast<std::size_t>(branch - s.n_tensor())];
        if (tensor % columns != 0) continue;
        for (int i = s.first[static_cast<std::size_t>(branch)]; i < s.first[static_cast<std::size_t>(branch) + 1]; ++i) {
            const int f = s.function[static_cast<std::size_t>(i)];
            if (s.tensor_of[static_cast<std::size_t>(f)] % columns != 0) return std::nullopt;
            found.push_back(f);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// Elements of the first column that hold material.
std::vector<int> first_column(const PartInput& input) {
    std::vector<int> elements;
    const SplineSpace& space = input.space;
    const auto is_first = [&](int element) { return space.along_x(element).low() == space.x.breakpoints.front(); };
    for (int cell = 0; cell < space.n_cells(); ++cell)
        if (is_full(space, cell) && is_first(cell)) elements.push_back(cell);
    for (const CellRule& rule : input.cut_rules)
        if (is_first(rule.element)) elements.push_back(rule.element);
    return elements;
}

void add_penalty(PartSystem& s) {
    const SplineSpace& space = s.input.space;
    const double p = std::max(space.x.degree, space.y.degree);
    const double gamma = s.input.thickness * nitsche_factor * p * p * local_elasticity(s.input).d11;
    for (int element : first_column(s.input)) {
        const double y0 = space.low_corner(element).y(), h = space.cell_size(element).y();
        for (std::size_t q = 0; q < s.input.line_rule.points.size(); ++q) {
            const PointBasis b = evaluate(space, element, {*s.input.axis, y0 + h * s.input.line_rule.points[q]});
            const double w = gamma * h * s.input.line_rule.weights[q];
            for (std::size_t i = 0; i < b.functions.size(); ++i)
                for (std::size_t j = 0; j < b.functions.size(); ++j)
                    if (b.functions[j] <= b.functions[i])
                        s.stiffness.at(b.functions[i], b.functions[j])(0, 0) +=
                            w * b.value[static_cast<Index>(i)] * b.value[static_cast<Index>(j)];
        }
    }
}

}  // namespace

void hold_axis(PartSystem& s) {
    const auto functions = functions_on_first_line(s.input.space);
    if (!functions) {
        add_penalty(s);
        s.axis_hold = "penalty along the axis: the grid continues functions from there";
        return;
    }
    for (int f : *functions) {
        const auto dof = static_cast<std::size_t>(2 * f);
        if (s.dropped[dof] && s.prescribed[static_cast<Index>(dof)] != 0)
            s.failure = "a support moves the axis of revolution sideways; a ring of radius 0 stays where it is";
        s.dropped[dof] = 1;
    }
    s.axis_hold = "functions on the axis dropped: exact and free";
}

}  // namespace abut::solver
