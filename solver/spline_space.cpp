// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spline_space.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace abut::solver {

namespace {

struct Range {
    int begin, end;
};

/// Intervals on which a univariate function lives.
Range support(const KnotVector& knots, int i) {
    return {std::max(0, i - knots.degree), std::min(knots.n_intervals(), i + 1)};
}

template <class OnCell>
void for_support_cells(const SplineSpace& s, int tensor, OnCell on_cell) {
    const Range columns = support(s.x, tensor % s.x.n_functions()), rows = support(s.y, tensor / s.x.n_functions());
    for (int r = rows.begin; r < rows.end; ++r)
        for (int c = columns.begin; c < columns.end; ++c) on_cell(r * s.columns() + c);
}

double distance_squared(const SplineSpace& s, int cell, const Vec2& p) {
    const int c = cell % s.columns(), r = cell / s.columns();
    const auto middle = [](const std::vector<double>& b, int i) {
        return 0.5 * (b[static_cast<std::size_t>(i)] + b[static_cast<std::size_t>(i) + 1]);
    };
    return (Vec2(middle(s.x.breakpoints, c), middle(s.y.breakpoints, r)) - p).squaredNorm();
}

/// The inner cell to extend from: the nearest in steps from cell to cell inside the part (so that no function is continued from
/// across a slot); of several the one whose middle is closest. -1: none can be reached.
int nearest_inner_cell(const SplineSpace& s, int tensor, std::vector<int>& mark, int stamp) {
    std::vector<int> front, next;
    for_support_cells(s, tensor, [&](int cell) {
        if (s.fraction[static_cast<std::size_t>(cell)] <= 0) return;
        front.push_back(cell);
        mark[static_cast<std::size_t>(cell)] = stamp;
    });
    const Vec2 middle(greville(s.x, tensor % s.x.n_functions()), greville(s.y, tensor / s.x.n_functions()));
    while (!front.empty()) {
        int best = -1;
        double closest = std::numeric_limits<double>::infinity();
        next.clear();
        for (int cell : front) {
            if (s.fraction[static_cast<std::size_t>(cell)] >= inner_cell_fraction &&
                distance_squared(s, cell, middle) < closest) {
                closest = distance_squared(s, cell, middle);
                best = cell;
            }
            const int c = cell % s.columns(), r = cell / s.columns();
            for (int dr = -1; dr <= 1; ++dr)
                for (int dc = -1; dc <= 1; ++dc) {
                    if (c + dc < 0 || c + dc >= s.columns() || r + dr < 0 || r + dr >= s.rows()) continue;
                    const int other = cell + dr * s.columns() + dc;
                    if (mark[static_cast<std::size_t>(other)] == stamp || s.fraction[static_cast<std::size_t>(other)] <= 0)
                        continue;
                    mark[static_cast<std::size_t>(other)] = stamp;
                    next.push_back(other);
                }
        }
        if (best >= 0) return best;
        front.swap(next);
    }
    return -1;
}

enum class Role : std::uint8_t { absent, own, extended };

std::vector<Role> roles(const SplineSpace& s, Basis basis) {
    std::vector<Role> role(static_cast<std::size_t>(s.x.n_functions() * s.y.n_functions()), Role::absent);
    for (std::size_t k = 0; k < role.size(); ++k)
        for_support_cells(s, static_cast<int>(k), [&](int cell) {
            const double f = s.fraction[static_cast<std::size_t>(cell)];
            if (f >= inner_cell_fraction || (f > 0 && basis == Basis::plain))
                role[k] = Role::own;
            else if (f > 0 && role[k] == Role::absent)
                role[k] = Role::extended;
        });
    return role;
}

void append_extended(SplineSpace& s, int tensor, int from_cell, const std::vector<int>& own) {
    const int nx = s.x.n_functions(), c = from_cell % s.columns(), r = from_cell / s.columns();
    const LocalValues ex = extension_coefficients(s.x, c, tensor % nx), ey = extension_coefficients(s.y, r, tensor / nx);
    for (int b = 0; b <= s.y.degree; ++b)
        for (int a = 0; a <= s.x.degree; ++a) {
            const double e = ex[static_cast<std::size_t>(a)] * ey[static_cast<std::size_t>(b)];
            if (e == 0) continue;
            s.function.push_back(own[static_cast<std::size_t>((r + b) * nx + c + a)]);
            s.coefficient.push_back(e);
        }
    ++s.n_extended;
}

}  // namespace

SplineSpace make_space(std::vector<double> x_lines, std::vector<double> y_lines, int degree_x, int degree_y,
                       std::vector<double> fraction, Basis basis) {
    SplineSpace s;
    s.x = clamped_knots(std::move(x_lines), degree_x);
    s.y = clamped_knots(std::move(y_lines), degree_y);
    s.fraction = std::move(fraction);
    const std::vector<Role> role = roles(s, basis);
    std::vector<int> own(role.size(), -1);
    for (std::size_t k = 0; k < role.size(); ++k)
        if (role[k] == Role::own) {
            own[k] = s.n_functions++;
            s.tensor_of.push_back(static_cast<int>(k));
        }
    std::vector<int> mark(s.fraction.size(), -1);
    s.first.push_back(0);
    for (std::size_t k = 0; k < role.size(); ++k) {
        if (role[k] == Role::own) {
            s.function.push_back(own[k]);
            s.coefficient.push_back(1);
        } else if (role[k] == Role::extended) {
            const int from = nearest_inner_cell(s, static_cast<int>(k), mark, static_cast<int>(k));
            if (from < 0)
                s.failure = "no cell is filled to a quarter where the part is thin: the grid is too coarse";
            else
                append_extended(s, static_cast<int>(k), from, own);
        }
        s.first.push_back(static_cast<int>(s.function.size()));
    }
    return s;
}

std::vector<int> tensor_functions(const SplineSpace& space, int cell) {
    const int c = cell % space.columns(), r = cell / space.columns();
    std::vector<int> result;
    result.reserve(static_cast<std::size_t>((space.x.degree + 1) * (space.y.degree + 1)));
    for (int b = 0; b <= space.y.degree; ++b)
        for (int a = 0; a <= space.x.degree; ++a) result.push_back((r + b) * space.x.n_functions() + c + a);
    return result;
}

Extraction extraction(const SplineSpace& space, int cell) {
    const std::vector<int> tensors = tensor_functions(space, cell);
    Extraction e;
    e.identity = true;
    for (int t : tensors) {
        const auto begin = static_cast<std::size_t>(space.first[static_cast<std::size_t>(t)]);
        const auto end = static_cast<std::size_t>(space.first[static_cast<std::size_t>(t) + 1]);
        e.identity = e.identity && end == begin + 1 && space.tensor_of[static_cast<std::size_t>(space.function[begin])] == t;
        e.functions.insert(e.functions.end(), space.function.begin() + static_cast<std::ptrdiff_t>(begin),
                           space.function.begin() + static_cast<std::ptrdiff_t>(end));
    }
    if (e.identity) return e;
    std::sort(e.functions.begin(), e.functions.end());
    e.functions.erase(std::unique(e.functions.begin(), e.functions.end()), e.functions.end());
    e.matrix.setZero(static_cast<Eigen::Index>(tensors.size()), static_cast<Eigen::Index>(e.functions.size()));
    for (std::size_t row = 0; row < tensors.size(); ++row) {
        const auto t = static_cast<std::size_t>(tensors[row]);
        for (int k = space.first[t]; k < space.first[t + 1]; ++k) {
            const auto at =
                std::lower_bound(e.functions.begin(), e.functions.end(), space.function[static_cast<std::size_t>(k)]);
            e.matrix(static_cast<Eigen::Index>(row), at - e.functions.begin()) = space.coefficient[static_cast<std::size_t>(k)];
        }
    }
    return e;
}

PointBasis evaluate(const SplineSpace& space, int cell, const Vec2& p) {
    const int c = cell % space.columns(), r = cell / space.columns();
    LocalValues vx, gx, vy, gy;
    evaluate(space.x, c, p.x(), vx, gx);
    evaluate(space.y, r, p.y(), vy, gy);
    const Extraction e = extraction(space, cell);
    const Eigen::Index n = (space.x.degree + 1) * (space.y.degree + 1);
    Eigen::VectorXd value(n), dx(n), dy(n);
    Eigen::Index k = 0;
    for (int b = 0; b <= space.y.degree; ++b)
        for (int a = 0; a <= space.x.degree; ++a, ++k) {
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
            value[k] = vx[i] * vy[j];
            dx[k] = gx[i] * vy[j];
            dy[k] = vx[i] * gy[j];
        }
    if (e.identity) return {e.functions, value, dx, dy};
    return {e.functions, e.matrix.transpose() * value, e.matrix.transpose() * dx, e.matrix.transpose() * dy};
}

Vec2 greville_point(const SplineSpace& space, int function) {
    const int tensor = space.tensor_of[static_cast<std::size_t>(function)];
    return {greville(space.x, tensor % space.x.n_functions()), greville(space.y, tensor / space.x.n_functions())};
}

}  // namespace abut::solver
