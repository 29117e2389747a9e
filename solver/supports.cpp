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

std::optional<std::vector<int>> functions_on_side(const SplineSpace& space, GridSide side, double from, double to) {
    const int nx = space.x.n_functions(), ny = space.y.n_functions();
    const bool vertical = side == GridSide::left || side == GridSide::right;
    const KnotVector& along = vertical ? space.y : space.x;
    const int fixed = side == GridSide::left || side == GridSide::bottom ? 0 : (vertical ? nx : ny) - 1;
    const auto lives_there = [&](int tensor) {
        const auto k = static_cast<std::size_t>(vertical ? tensor / nx : tensor % nx);
        const bool outermost = (vertical ? tensor % nx : tensor / nx) == fixed;
        return outermost && along.knots[k] < to && from < along.knots[k + static_cast<std::size_t>(along.degree) + 1];
    };
    std::vector<int> dropped;
    for (int k = 0; k < along.n_functions(); ++k) {
        const int tensor = vertical ? k * nx + fixed : fixed * nx + k;
        if (!lives_there(tensor)) continue;
        for (int i = space.first[static_cast<std::size_t>(tensor)]; i < space.first[static_cast<std::size_t>(tensor) + 1]; ++i) {
            const int f = space.function[static_cast<std::size_t>(i)];
            if (!lives_there(space.tensor_of[static_cast<std::size_t>(f)])) return std::nullopt;
            dropped.push_back(f);
        }
    }
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    return dropped;
}

}  // namespace abut::solver
