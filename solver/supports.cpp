// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/supports.hpp"

#include <algorithm>

namespace abut::solver {

namespace {

using Eigen::Index;

/// d.u and d.t at a point as linear forms over the coefficients: (functions x 2), component by component.
struct PointForms {
    std::vector<int> functions;
    Eigen::MatrixX2d displacement, traction;
};

PointForms forms(const PartInput& input, const SupportPoint& p) {
    const PointBasis b = evaluate(input.space, p.cell, p.x);
    const Elasticity& e = input.elasticity;
    PointForms f{b.functions, Eigen::MatrixX2d(b.value.size(), 2), Eigen::MatrixX2d(b.value.size(), 2)};
    for (Index i = 0; i < b.value.size(); ++i) {
        f.displacement.row(i) = b.value[i] * p.direction.transpose();
        // traction of a unit coefficient in x and in y
        const Eigen::Vector3d sx(e.d11 * b.dx[i], e.d12 * b.dx[i], e.d33 * b.dy[i]);
        const Eigen::Vector3d sy(e.d12 * b.dy[i], e.d11 * b.dy[i], e.d33 * b.dx[i]);
        const auto along = [&](const Eigen::Vector3d& s) {
            return p.direction.dot(Vec2(s[0] * p.normal.x() + s[2] * p.normal.y(), s[2] * p.normal.x() + s[1] * p.normal.y()));
        };
        f.traction(i, 0) = along(sx);
        f.traction(i, 1) = along(sy);
    }
    return f;
}

double penalty(const PartInput& input, int cell) {
    const SplineSpace& s = input.space;
    const auto c = static_cast<std::size_t>(cell % s.columns()), r = static_cast<std::size_t>(cell / s.columns());
    const double h = std::min(s.x.breakpoints[c + 1] - s.x.breakpoints[c], s.y.breakpoints[r + 1] - s.y.breakpoints[r]);
    const double p = std::max(s.x.degree, s.y.degree);
    return nitsche_factor * p * p * input.elasticity.d11 / h;
}

double apply(const PointForms& f, const Eigen::MatrixX2d& form, const Eigen::VectorXd& u) {
    double sum = 0;
    for (std::size_t i = 0; i < f.functions.size(); ++i)
        sum += form.row(static_cast<Index>(i)).dot(u.segment<2>(2 * f.functions[i]));
    return sum;
}

}  // namespace

void add_nitsche(const PartInput& input, const SupportSet& set, BlockMatrix& stiffness, Eigen::VectorXd& load) {
    for (const SupportPoint& p : set.points) {
        const PointForms f = forms(input, p);
        const double gamma = penalty(input, p.cell), w = p.weight * input.thickness;
        for (std::size_t a = 0; a < f.functions.size(); ++a) {
            const auto i = static_cast<Index>(a);
            const Vec2 da = f.displacement.row(i), ta = f.traction.row(i);
            load.segment<2>(2 * f.functions[a]) += w * p.value * (gamma * da - ta);
            for (std::size_t b = 0; b < f.functions.size(); ++b) {
                if (f.functions[b] > f.functions[a]) continue;
                const auto j = static_cast<Index>(b);
                const Vec2 db = f.displacement.row(j), tb = f.traction.row(j);
                stiffness.at(f.functions[a], f.functions[b]) +=
                    w * (gamma * da * db.transpose() - da * tb.transpose() - ta * db.transpose());
            }
        }
    }
}

Resultant nitsche_reaction(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    Resultant sum;
    for (const SupportPoint& p : set.points) {
        const PointForms f = forms(input, p);
        const double u = apply(f, f.displacement, displacement), t = apply(f, f.traction, displacement);
        sum.add(p.x, p.weight * input.thickness * (t - penalty(input, p.cell) * (u - p.value)) * p.direction);
    }
    return sum;
}

double nitsche_energy(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    double sum = 0;
    for (const SupportPoint& p : set.points) {
        const PointForms f = forms(input, p);
        const double u = apply(f, f.displacement, displacement), t = apply(f, f.traction, displacement);
        sum += p.weight * input.thickness * (penalty(input, p.cell) * u - 2 * t) * u;
    }
    return sum;
}

namespace {

/// One outermost row of cells and functions, seen along its side.
struct SideRow {
    const SplineSpace& space;
    const KnotVector& along;
    bool vertical;
    int row;    // of functions, across the side
    int cells;  // of cells, across the side

    int tensor(int k) const { return vertical ? k * space.x.n_functions() + row : row * space.x.n_functions() + k; }
    int place(int tensor_function) const {
        return vertical ? tensor_function / space.x.n_functions() : tensor_function % space.x.n_functions();
    }
    bool is_outermost(int tensor_function) const { return tensor(place(tensor_function)) == tensor_function; }
    double fraction(int i) const {
        return space.fraction[static_cast<std::size_t>(vertical ? i * space.columns() + cells : cells * space.columns() + i)];
    }
};

SideRow row_of(const SplineSpace& s, GridSide side) {
    const bool vertical = side == GridSide::left || side == GridSide::right,
               first = side == GridSide::left || side == GridSide::bottom;
    const KnotVector& across = vertical ? s.x : s.y;
    return {s, vertical ? s.y : s.x, vertical, first ? 0 : across.n_functions() - 1, first ? 0 : across.n_intervals() - 1};
}

/// Held intervals of the row: along their whole length, or at all.
struct HeldIntervals {
    std::vector<char> wholly, partly;
};

HeldIntervals held_intervals(const KnotVector& along, const std::vector<Stretch>& stretches) {
    HeldIntervals held;
    for (int i = 0; i < along.n_intervals(); ++i) {
        const double a = along.breakpoints[static_cast<std::size_t>(i)], b = along.breakpoints[static_cast<std::size_t>(i) + 1];
        double covered = 0;
        for (const Stretch& s : stretches) covered += std::max(0.0, std::min(b, s.to) - std::max(a, s.from));
        // stretches end at the part's corners: rounding of the coordinates, not of the cell, decides
        const double rounding = 1e-9 * (along.breakpoints.back() - along.breakpoints.front());
        held.wholly.push_back(covered >= b - a - rounding);
        held.partly.push_back(covered > rounding);
    }
    return held;
}

}  // namespace

std::optional<std::vector<int>> functions_on_side(const SplineSpace& space, GridSide side,
                                                  const std::vector<Stretch>& stretches) {
    const SideRow row = row_of(space, side);
    const HeldIntervals held = held_intervals(row.along, stretches);
    const auto lives_on_held = [&](int k) {
        for (int i = std::max(0, k - row.along.degree); i <= std::min(k, row.along.n_intervals() - 1); ++i)
            if (held.partly[static_cast<std::size_t>(i)]) return true;
        return false;
    };
    std::vector<int> dropped;
    for (int k = 0; k < row.along.n_functions(); ++k) {
        if (!lives_on_held(k)) continue;
        for (int i = std::max(0, k - row.along.degree); i <= std::min(k, row.along.n_intervals() - 1); ++i)
            if (row.fraction(i) > 0 && !held.wholly[static_cast<std::size_t>(i)]) return std::nullopt;
        const auto t = static_cast<std::size_t>(row.tensor(k));
        for (int i = space.first[t]; i < space.first[t + 1]; ++i) {
            const int f = space.function[static_cast<std::size_t>(i)];
            const int tensor = space.tensor_of[static_cast<std::size_t>(f)];
            if (!row.is_outermost(tensor) || !lives_on_held(row.place(tensor))) return std::nullopt;
            dropped.push_back(f);
        }
    }
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    return dropped;
}

}  // namespace abut::solver
