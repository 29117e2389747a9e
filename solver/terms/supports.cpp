// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/supports.hpp"

#include <algorithm>

#include "solver/assembly/ring.hpp"
#include "solver/terms/solution_structure.hpp"
#include "solver/terms/stress.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

/// d.u and d.t at a point as linear forms over the coefficients: (functions x 2), component by component; and what they are
/// without any (of phi, with a solution structure).
struct PointForms {
    std::vector<int> functions;
    Eigen::MatrixX2d displacement, traction;
    double displacement_of_data = 0, traction_of_data = 0;
};

/// direction . traction of a stress (xx, yy, xy).
double traction_along(const SupportPoint& p, const Eigen::Vector3d& s) {
    return p.direction.dot(Vec2(s[0] * p.normal.x() + s[2] * p.normal.y(), s[2] * p.normal.x() + s[1] * p.normal.y()));
}

PointForms forms(const PartInput& input, const SupportPoint& p) {
    const DisplacementBasis b = displacement_basis(input, p.element, p.x);
    const PointBasis &x = b.of(0), &y = b.of(1);
    const Elasticity e = local_elasticity(input);
    PointForms f{x.functions, Eigen::MatrixX2d(x.value.size(), 2), Eigen::MatrixX2d(x.value.size(), 2)};
    f.displacement << p.direction.x() * x.value, p.direction.y() * y.value;
    for (Index i = 0; i < x.value.size(); ++i) {
        // traction of a unit coefficient in x and in y
        f.traction(i, 0) = traction_along(p, {e.d11 * x.dx[i], e.d12 * x.dx[i], e.d33 * x.dy[i]});
        f.traction(i, 1) = traction_along(p, {e.d12 * y.dy[i], e.d11 * y.dy[i], e.d33 * y.dx[i]});
    }
    if (input.axis && !is_on_axis(input, p.x))
        for (Index i = 0; i < x.value.size(); ++i) {
            const double hoop = e.d12 * x.value[i] / radius(input, p.x);
            f.traction(i, 0) += traction_along(p, {hoop, hoop, 0});
        }
    f.displacement_of_data = p.direction.dot(b.data.value);
    f.traction_of_data = traction_along(p, stress_of(e, b.data.gradient));
    if (input.free_strain) f.traction_of_data -= e.expansion * input.free_strain(p.x) * p.direction.dot(p.normal);
    return f;
}

double penalty(const PartInput& input, int element) {
    const SplineSpace& s = input.space;
    const double h = s.cell_size(element).minCoeff();
    const double p = std::max(s.x.degree, s.y.degree);
    return nitsche_factor * p * p * local_elasticity(input).d11 / h;
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
        const double gamma = penalty(input, p.element), w = p.weight * input.thickness;
        const double value = p.value - f.displacement_of_data;
        for (std::size_t a = 0; a < f.functions.size(); ++a) {
            const auto i = static_cast<Index>(a);
            const Vec2 da = f.displacement.row(i), ta = f.traction.row(i);
            load.segment<2>(2 * f.functions[a]) += w * value * (gamma * da - ta) + w * f.traction_of_data * da;
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

namespace {

Vec2 traction_at(const PartInput& input, const SupportPoint& p, const StressOf& stress, const Eigen::VectorXd& displacement) {
    const DisplacementAt u = displacement_at(input, displacement, p.element, p.x);
    const double t = traction_along(p, stress(p.element, p.x, u));
    return (t - penalty(input, p.element) * (p.direction.dot(u.value) - p.value)) * p.direction;
}

}  // namespace

std::vector<Vec2> nitsche_tractions(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    const StressOf stress(input, displacement);
    std::vector<Vec2> tractions;
    for (const SupportPoint& p : set.points) tractions.push_back(traction_at(input, p, stress, displacement));
    return tractions;
}

Resultant nitsche_reaction(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    const std::vector<Vec2> tractions = nitsche_tractions(input, set, displacement);
    Resultant sum;
    for (std::size_t k = 0; k < set.points.size(); ++k)
        sum.add(set.points[k].x, set.points[k].weight * input.thickness * tractions[k]);
    return sum;
}

double nitsche_energy(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    double sum = 0;
    for (const SupportPoint& p : set.points) {
        const PointForms f = forms(input, p);
        const double u = apply(f, f.displacement, displacement), t = apply(f, f.traction, displacement);
        sum += p.weight * input.thickness * (penalty(input, p.element) * u - 2 * t) * u;
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

/// How much of an interval is held.
double covered(double low, double high, const std::vector<Stretch>& stretches) {
    double sum = 0;
    for (const Stretch& s : stretches) sum += std::max(0.0, std::min(high, s.to) - std::max(low, s.from));
    return sum;
}

/// Stretches end at the part's corners: rounding of the coordinates, not of the cell, decides.
double rounding_along(const KnotVector& along) {
    return 1e-9 * (along.breakpoints.back() - along.breakpoints.front());
}

HeldIntervals held_intervals(const KnotVector& along, const std::vector<Stretch>& stretches) {
    HeldIntervals held;
    const double rounding = rounding_along(along);
    for (int i = 0; i < along.n_intervals(); ++i) {
        const double a = along.breakpoints[static_cast<std::size_t>(i)], b = along.breakpoints[static_cast<std::size_t>(i) + 1];
        const double sum = covered(a, b, stretches);
        held.wholly.push_back(sum >= b - a - rounding);
        held.partly.push_back(sum > rounding);
    }
    return held;
}

/// Of several branches some may live on an arm that is not held.
bool has_branches(const SplineSpace& space, int tensor) {
    const auto& extra = space.tensor_of_extra;
    return std::find(extra.begin(), extra.end(), tensor) != extra.end();
}

/// The functions that are not zero on a side along an element's cell, which touches it: of its outermost B-splines.
void append_functions_along(const SplineSpace& space, int element, GridSide side, std::vector<int>& functions) {
    const int nx = space.x.degree + 1, ny = space.y.degree + 1;
    const bool vertical = side == GridSide::left || side == GridSide::right;
    const int outermost = side == GridSide::right ? nx - 1 : side == GridSide::top ? ny - 1 : 0;
    for (int i = 0; i < (vertical ? ny : nx); ++i) {
        const int row = element * space.n_local() + (vertical ? i * nx + outermost : outermost * nx + i);
        const auto begin = space.function.begin();
        functions.insert(functions.end(), begin + space.first[at(row)], begin + space.first[at(row) + 1]);
    }
}

/// Does an element hold material in a cell on a side?
bool is_along(const SplineSpace& space, int element, GridSide side) {
    if (!(space.fraction[at(element)] > 0)) return false;
    const TreeCell& c = space.tree->leaf(space.cell_of(element));
    switch (side) {
        case GridSide::left:
            return c.column == 0;
        case GridSide::right:
            return c.column + 1 == space.columns() << c.level;
        case GridSide::bottom:
            return c.row == 0;
        default:
            return c.row + 1 == space.rows() << c.level;
    }
}

/// functions_on_side() of a space with a tree: element by element along the side.
std::optional<std::vector<int>> functions_on_side_of_tree(const SplineSpace& space, GridSide side,
                                                          const std::vector<Stretch>& stretches) {
    const int axis = side == GridSide::left || side == GridSide::right ? 1 : 0;
    const double rounding = rounding_along(axis == 1 ? space.y : space.x);
    std::vector<int> dropped, elsewhere;
    for (int e = 0; e < static_cast<int>(space.fraction.size()); ++e) {
        if (!is_along(space, e, side)) continue;
        const double low = space.low_corner(e)[axis], high = low + space.cell_size(e)[axis];
        const double sum = covered(low, high, stretches);
        if (sum > rounding &&
            std::binary_search(space.splits.cell_of_extra.begin(), space.splits.cell_of_extra.end(), space.cell_of(e)))
            return std::nullopt;
        if (sum > rounding) append_functions_along(space, e, side, dropped);
        if (sum < high - low - rounding) append_functions_along(space, e, side, elsewhere);
    }
    std::sort(dropped.begin(), dropped.end());
    dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
    for (int f : dropped)
        if ((space.on_sides[at(f)] >> static_cast<int>(side) & 1) == 0) return std::nullopt;
    for (int f : elsewhere)
        if (std::binary_search(dropped.begin(), dropped.end(), f)) return std::nullopt;
    return dropped;
}

}  // namespace

std::optional<std::vector<int>> functions_on_side(const SplineSpace& space, GridSide side,
                                                  const std::vector<Stretch>& stretches) {
    if (space.tree) return functions_on_side_of_tree(space, side, stretches);
    const SideRow row = row_of(space, side);
    const HeldIntervals held = held_intervals(row.along, stretches);
    const auto lives_on_held = [&](int k) {
        const IntervalRange lives = support(row.along, k);
        for (int i = lives.begin; i < lives.end; ++i)
            if (held.partly[static_cast<std::size_t>(i)]) return true;
        return false;
    };
    std::vector<int> dropped;
    for (int k = 0; k < row.along.n_functions(); ++k) {
        if (!lives_on_held(k)) continue;
        if (has_branches(space, row.tensor(k))) return std::nullopt;
        const IntervalRange lives = support(row.along, k);
        for (int i = lives.begin; i < lives.end; ++i)
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
