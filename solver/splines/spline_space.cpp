// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/spline_space.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "solver/splines/branches.hpp"
#include "solver/splines/tree_space.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::solver {

namespace {

double distance_squared(const SplineSpace& s, int element, const Vec2& p) {
    return (s.low_corner(element) + 0.5 * s.cell_size(element) - p).squaredNorm();
}

Vec2 greville_of_tensor(const SplineSpace& s, int tensor) {
    return {greville(s.x, tensor % s.x.n_functions()), greville(s.y, tensor / s.x.n_functions())};
}

int tensor_of_branch(const SplineSpace& s, int branch) {
    return branch < s.n_tensor() ? branch : s.tensor_of_extra[at(branch - s.n_tensor())];
}

/// Squared distances that differ by less, relatively, are equal.
constexpr double equal_distance = 1e-9;

/// Walks from element to element through the part's material until it meets inner ones.
class InnerSearch {
public:
    InnerSearch(const SplineSpace& space, const ElementGraph& graph)
        : space_(space), graph_(graph), mark_(space.fraction.size(), -1) {}

    /// Of the inner elements in the fewest steps, or one more (a step to a diagonal neighbour takes two), those whose middles
    /// are closest to a point, ascending. Empty: none can be reached.
    const std::vector<int>& nearest(const std::vector<int>& from, const Vec2& to) {
        ++stamp_;
        front_ = from;
        for (int e : front_) mark_[at(e)] = stamp_;
        found_.clear();
        closest_ = std::numeric_limits<double>::infinity();
        for (int steps_left = 1; !front_.empty() && steps_left >= 0; step()) {
            for (int e : front_)
                if (space_.fraction[at(e)] >= inner_cell_fraction) take_if_near(e, distance_squared(space_, e, to));
            if (!found_.empty()) --steps_left;
        }
        std::sort(found_.begin(), found_.end());
        return found_;
    }

private:
    void take_if_near(int element, double distance) {
        if (distance > closest_ * (1 + equal_distance)) return;
        if (distance < closest_ * (1 - equal_distance)) found_.clear();
        closest_ = std::min(closest_, distance);
        found_.push_back(element);
    }

    void step() {
        next_.clear();
        for (int e : front_)
            graph_.for_neighbours(e, [&](int other) {
                if (mark_[at(other)] == stamp_) return;
                mark_[at(other)] = stamp_;
                next_.push_back(other);
            });
        front_.swap(next_);
    }

    const SplineSpace& space_;
    const ElementGraph& graph_;
    std::vector<int> mark_, front_, next_, found_;
    double closest_ = 0;
    int stamp_ = -1;
};

enum class Role : std::uint8_t { absent, own, extended };

std::vector<Role> roles(const SplineSpace& s) {
    std::vector<Role> role(at(s.n_tensor()) + s.tensor_of_extra.size(), Role::absent);
    LocalFunctions local;
    for (std::size_t e = 0; e < s.fraction.size(); ++e) {
        if (s.fraction[e] <= 0) continue;
        const bool inner = s.fraction[e] >= inner_cell_fraction || s.basis != Basis::web;
        const std::size_t n = local_functions(s, static_cast<int>(e), local);
        for (int branch : std::span<const int>(local.data(), n))
            if (role[at(branch)] != Role::own) role[at(branch)] = inner ? Role::own : Role::extended;
    }
    return role;
}

using RowEntries = std::vector<std::pair<int, double>>;  // function, coefficient

/// What continues an element's polynomials, times a factor.
void add_continuation(const SplineSpace& s, int branch, int from, double factor, const std::vector<int>& own, RowEntries& row) {
    const int nx = s.x.n_functions(), tensor = tensor_of_branch(s, branch);
    const LocalValues ex = extension_coefficients(s.x, s.column_of(from), tensor % nx),
                      ey = extension_coefficients(s.y, s.row_of(from), tensor / nx);
    const std::vector<int> local = tensor_functions(s, from);
    for (std::size_t k = 0; k < local.size(); ++k) {
        const auto p = at(s.x.degree + 1);
        const double e = ex[k % p] * ey[k / p];
        if (e != 0) row.emplace_back(own[at(local[k])], factor * e);
    }
}

/// Row of a branch that is continued from elements, equally from each: so the space of a mirrored part is the mirrored space.
void append_extended(SplineSpace& s, int branch, const std::vector<int>& from, const std::vector<int>& own) {
    RowEntries row;
    for (int element : from) add_continuation(s, branch, element, 1 / static_cast<double>(from.size()), own, row);
    std::sort(row.begin(), row.end());
    for (const auto& [function, coefficient] : row) {
        const bool is_new = static_cast<int>(s.function.size()) == s.first.back() || s.function.back() != function;
        if (is_new) {
            s.function.push_back(function);
            s.coefficient.push_back(0);
        }
        s.coefficient.back() += coefficient;
    }
    ++s.n_extended;
}

void number_functions(SplineSpace& s, const std::vector<Role>& role, std::vector<int>& own) {
    own.assign(role.size(), -1);
    for (std::size_t k = 0; k < role.size(); ++k)
        if (role[k] == Role::own) {
            own[k] = s.n_functions++;
            s.tensor_of.push_back(tensor_of_branch(s, static_cast<int>(k)));
        }
}

void make_rows(SplineSpace& s, const ElementGraph& graph, const std::vector<Role>& role, const std::vector<int>& own) {
    InnerSearch search(s, graph);
    s.first.push_back(0);
    for (std::size_t k = 0; k < role.size(); ++k) {
        const int branch = static_cast<int>(k);
        if (role[k] == Role::own) {
            s.function.push_back(own[k]);
            s.coefficient.push_back(1);
        } else if (role[k] == Role::extended) {
            const std::vector<int>& from =
                search.nearest(support_elements(s, graph, branch), greville_of_tensor(s, tensor_of_branch(s, branch)));
            if (from.empty())
                s.failure = "no cell is filled to a quarter where the part is thin: the grid is too coarse";
            else
                append_extended(s, branch, from, own);
        }
        s.first.push_back(static_cast<int>(s.function.size()));
    }
}

/// Divides the functions that live on one cut element only by their largest value there.
void normalize(SplineSpace& s, const ElementGraph& graph, const std::vector<int>& own,
               const std::function<std::vector<Vec2>(int)>& outline) {
    s.coefficient_of_one.assign(at(s.n_functions), 1);
    for (std::size_t branch = 0; branch < own.size(); ++branch) {
        if (own[branch] < 0) continue;
        const std::vector<int> elements = support_elements(s, graph, static_cast<int>(branch));
        if (elements.size() != 1 || s.fraction[at(elements[0])] == 1) continue;
        const int tensor = tensor_of_branch(s, static_cast<int>(branch)), nx = s.x.n_functions();
        const int c = s.column_of(elements[0]), r = s.row_of(elements[0]);
        double largest = 0;
        for (const Vec2& p : outline(elements[0])) {
            LocalValues vx, vy;
            evaluate(s.x, c, p.x(), vx);
            evaluate(s.y, r, p.y(), vy);
            largest = std::max(largest, vx[at(tensor % nx - s.x.first[at(c)])] * vy[at(tensor / nx - s.y.first[at(r)])]);
        }
        if (largest <= 0) continue;
        s.coefficient[at(s.first[branch])] = 1 / largest;
        s.coefficient_of_one[at(own[branch])] = largest;
    }
}

}  // namespace

int SplineSpace::n_intervals(int axis) const {
    const KnotVector& knots = axis == 0 ? x : y;
    if (!tree) return knots.n_intervals();
    return static_cast<int>(level_intervals[at(axis)].knots.size()) / (2 * std::max(1, knots.degree));
}

IntervalKnots SplineSpace::interval(int axis, int i) const {
    const KnotVector& knots = axis == 0 ? x : y;
    if (!tree) return knots.interval(i);
    const int each_way = std::max(1, knots.degree);
    return {knots.degree, level_intervals[at(axis)].knots.data() + (2 * i + 1) * each_way - 1};
}

int SplineSpace::cell_at(const Vec2& p) const {
    const int base = solver::interval_of(y, p.y()) * columns() + solver::interval_of(x, p.x());
    if (!tree) return base;
    int node = base;
    while (!tree->is_leaf(node)) {
        const TreeCell c = tree->cell(node);
        node = tree->first_child(node) + (p.x() >= level_line(x.breakpoints, c.level + 1, 2 * c.column + 1)) +
               2 * (p.y() >= level_line(y.breakpoints, c.level + 1, 2 * c.row + 1));
    }
    return tree->leaf_of(node);
}

SplineSpace make_space(SpaceInput input) {
    if (input.tree) return make_tree_space(std::move(input));
    SplineSpace s;
    s.x = std::move(input.x);
    s.y = std::move(input.y);
    s.basis = input.basis;
    s.fraction = std::move(input.fraction);
    s.splits = std::move(input.splits);
    ENSURE(s.fraction.size() == static_cast<std::size_t>(s.n_cells()) + s.splits.cell_of_extra.size(),
           "every element of a space has a filled fraction");
    const ElementGraph graph(s.columns(), s.rows(), s.fraction, s.splits);
    Branches branches = find_branches(s.x, s.y, graph);
    s.tensor_of_extra = std::move(branches.tensor_of_extra);
    s.branches = std::move(branches.of_element);
    const std::vector<Role> role = roles(s);
    std::vector<int> own;
    number_functions(s, role, own);
    make_rows(s, graph, role, own);
    if (s.basis == Basis::normalized) normalize(s, graph, own, input.outline);
    return s;
}

SplineSpace make_space(std::vector<double> x_lines, std::vector<double> y_lines, int degree_x, int degree_y,
                       std::vector<double> fraction, Basis basis) {
    return make_space({clamped_knots(std::move(x_lines), degree_x),
                       clamped_knots(std::move(y_lines), degree_y),
                       std::move(fraction),
                       {},
                       basis,
                       {}});
}

std::size_t local_functions(const SplineSpace& space, int element, LocalFunctions& result) {
    if (space.tree) {
        const int n = space.n_local();
        for (int k = 0; k < n; ++k) result[at(k)] = element * n + k;
        return at(n);
    }
    if (!space.branches.empty()) {
        const auto own = space.branches.find(element);
        if (own != space.branches.end()) {
            std::copy(own->second.begin(), own->second.end(), result.begin());
            return own->second.size();
        }
    }
    const int c = space.x.first[at(space.column_of(element))], r = space.y.first[at(space.row_of(element))];
    std::size_t n = 0;
    for (int b = 0; b <= space.y.degree; ++b)
        for (int a = 0; a <= space.x.degree; ++a) result[n++] = (r + b) * space.x.n_functions() + c + a;
    return n;
}

std::vector<int> tensor_functions(const SplineSpace& space, int element) {
    LocalFunctions local;
    const std::size_t n = local_functions(space, element, local);
    return {local.begin(), local.begin() + static_cast<std::ptrdiff_t>(n)};
}

namespace {

/// Whether branches are functions of the space themselves: then which.
bool are_functions(const SplineSpace& space, std::span<const int> branches, std::vector<int>& functions) {
    functions.resize(branches.size());
    for (std::size_t k = 0; k < branches.size(); ++k) {
        const auto row = at(space.first[at(branches[k])]);
        if (at(space.first[at(branches[k]) + 1]) != row + 1 || space.coefficient[row] != 1) return false;
        functions[k] = space.function[row];
    }
    return true;
}

}  // namespace

Extraction extraction(const SplineSpace& space, int element) {
    LocalFunctions local;
    const std::span<const int> branches(local.data(), local_functions(space, element, local));
    Extraction e;
    e.identity = are_functions(space, branches, e.functions);
    if (e.identity) return e;
    e.functions.clear();
    for (int branch : branches)
        e.functions.insert(e.functions.end(), space.function.begin() + space.first[at(branch)],
                           space.function.begin() + space.first[at(branch) + 1]);
    std::sort(e.functions.begin(), e.functions.end());
    e.functions.erase(std::unique(e.functions.begin(), e.functions.end()), e.functions.end());
    e.matrix.setZero(static_cast<Eigen::Index>(branches.size()), static_cast<Eigen::Index>(e.functions.size()));
    for (std::size_t row = 0; row < branches.size(); ++row)
        for (int k = space.first[at(branches[row])]; k < space.first[at(branches[row]) + 1]; ++k) {
            const auto column = std::lower_bound(e.functions.begin(), e.functions.end(), space.function[at(k)]);
            e.matrix(static_cast<Eigen::Index>(row), column - e.functions.begin()) = space.coefficient[at(k)];
        }
    return e;
}

PointBasis evaluate(const SplineSpace& space, int element, const Vec2& p) {
    LocalValues vx, gx, vy, gy;
    evaluate(space.along_x(element), p.x(), vx, gx);
    evaluate(space.along_y(element), p.y(), vy, gy);
    const Extraction e = extraction(space, element);
    const Eigen::Index n = space.n_local();
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
    return space.tree ? space.place[at(function)] : greville_of_tensor(space, space.tensor_of[at(function)]);
}

}  // namespace abut::solver
