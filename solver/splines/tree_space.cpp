// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/tree_space.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "solver/splines/tree_pieces.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

/// Steps through the part from leaf to leaf in which nearer leaves are still looked for after a first one: neighbours are one
/// level apart, so that the next larger sizes lie within as many.
constexpr int steps_beyond_first = 3;

/// Squared distances in sizes of a leaf that differ by less, relatively, are equal.
constexpr double equally_near = 1e-9;

LevelIntervals intervals_of(const Quadtree& tree, const KnotVector& base, int axis) {
    std::map<std::pair<int, int>, int> number;  // by level and place
    const auto key = [&](int node) {
        const TreeCell& c = tree.cell(node);
        return std::pair(c.level, axis == 0 ? c.column : c.row);
    };
    for (int node = 0; node < tree.n_nodes(); ++node) number.try_emplace(key(node), 0);
    LevelIntervals result;
    int n = 0;
    for (auto& [place, its] : number) {
        its = n++;
        const std::vector<double> knots = level_knots(base, place.first, place.second);
        result.knots.insert(result.knots.end(), knots.begin(), knots.end());
    }
    for (int node = 0; node < tree.n_nodes(); ++node) result.of_node.push_back(number.at(key(node)));
    return result;
}

/// One entry of a row: a function and its coefficient.
struct RowEntry {
    int function;
    double coefficient;
};

/// A B-spline of a level: its first function's number along each axis.
struct LevelFunction {
    int level, x, y;
};

/// What a B-spline of a node is to the hierarchy; otherwise the number of the function that it is.
constexpr int not_yet = -1, is_coarse = -2, is_passed_on = -3;

class TreeSpaceMaker {
public:
    TreeSpaceMaker(SplineSpace& space, const std::function<std::vector<Vec2>(int)>& outline)
        : s_(space),
          tree_(*space.tree),
          graph_(space.columns(), space.rows(), space.fraction, space.splits, space.tree.get()),
          all_(find_pieces(tree_, graph_)),
          outline_(outline),
          n_local_(space.n_local()) {}

    void run() {
        find_functions();
        make_rows();
        find_inner();
        number_functions();
        extend();
        write_rows();
    }

private:
    // ---- which B-splines are functions ----

    int first_along(int axis, int level, int interval) const { return level_first(axis == 0 ? s_.x : s_.y, level, interval); }
    /// Local number of a B-spline on a node of its level; -1: it does not live there.
    int local_number(int node, const LevelFunction& f) const {
        const TreeCell& c = tree_.cell(node);
        const int a = f.x - first_along(0, c.level, c.column), b = f.y - first_along(1, c.level, c.row);
        return a < 0 || a > s_.x.degree || b < 0 || b > s_.y.degree ? -1 : b * (s_.x.degree + 1) + a;
    }
    LevelFunction function_of(int piece, int local) const {
        const TreeCell& c = tree_.cell(all_.pieces[at(piece)].node);
        const int p = s_.x.degree + 1;
        return {c.level, first_along(0, c.level, c.column) + local % p, first_along(1, c.level, c.row) + local / p};
    }
    /// Does a B-spline live on any of its own level's cells in a node of a coarser one?
    bool reaches(const LevelFunction& f, int node) const {
        const TreeCell& c = tree_.cell(node);
        const int down = f.level - c.level;
        const auto overlaps = [&](int axis, int coarse, int function, int degree) {
            for (int i = coarse << down; i < (coarse + 1) << down; ++i) {
                const int first = first_along(axis, f.level, i);
                if (first <= function && function <= first + degree) return true;
            }
            return false;
        };
        return overlaps(0, c.column, f.x, s_.x.degree) && overlaps(1, c.row, f.y, s_.y.degree);
    }

    int& state(int piece, int local) { return state_[at(piece) * at(n_local_) + at(local)]; }

    /// The pieces of a B-spline's support that hang together with one of them; marks them.
    const std::vector<int>& support(int start, int local) {
        const LevelFunction f = function_of(start, local);
        ++stamp_;
        support_.assign(1, start);
        mark_[at(start)] = stamp_;
        for (std::size_t i = 0; i < support_.size(); ++i)
            for (const int other : all_.beside[at(support_[i])]) {
                if (mark_[at(other)] == stamp_ || local_number(all_.pieces[at(other)].node, f) < 0) continue;
                mark_[at(other)] = stamp_;
                support_.push_back(other);
            }
        return support_;
    }

    void find_functions() {
        state_.assign(all_.pieces.size() * at(n_local_), not_yet);
        mark_.assign(all_.pieces.size(), -1);
        for (const std::vector<int>& level : all_.of_level)
            for (const int piece : level)
                for (int k = 0; k < n_local_; ++k)
                    if (state(piece, k) == not_yet) decide(piece, k);
        count_apart();
    }

    /// How many functions share their B-spline with another.
    void count_apart() {
        std::vector<std::array<int, 3>> splines;
        for (const auto& [piece, local] : home_) {
            const LevelFunction f = function_of(piece, local);
            splines.push_back({f.level, f.x, f.y});
        }
        std::sort(splines.begin(), splines.end());
        s_.n_apart = static_cast<int>(splines.end() - std::unique(splines.begin(), splines.end()));
    }

    void decide(int piece, int local) {
        const LevelFunction f = function_of(piece, local);
        bool coarse = false, has_leaf = false;
        for (const int p : support(piece, local)) {
            has_leaf = has_leaf || all_.pieces[at(p)].element >= 0;
            for (const int leaf : all_.coarser[at(p)]) coarse = coarse || reaches(f, all_.pieces[at(leaf)].node);
        }
        int its = is_coarse;
        if (!coarse) its = has_leaf ? static_cast<int>(home_.size()) : is_passed_on;
        if (its >= 0) home_.push_back({piece, local});
        for (const int p : support_) state(p, local_number(all_.pieces[at(p)].node, f)) = its;
    }

    // ---- rows ----

    IntervalKnots along(int axis, int node) const { return s_.interval(axis, s_.level_intervals[at(axis)].of_node[at(node)]); }

    /// Knot insertion along an axis: coefficient of the parent's function j in the child's function i at i * (p + 1) + j.
    std::vector<double> insertion(int axis, int parent, int child) const {
        const IntervalKnots coarse = along(axis, parent), fine = along(axis, child);
        std::vector<double> result;
        for (int i = 0; i <= fine.degree; ++i) {
            const LocalValues row = blossom(coarse, fine.inner_knots(i));
            result.insert(result.end(), row.begin(), row.begin() + fine.degree + 1);
        }
        return result;
    }

    void make_rows() {
        row_.resize(all_.pieces.size() * at(n_local_));
        sum_.assign(home_.size(), 0.0);
        for (const std::vector<int>& level : all_.of_level)
            for (const int piece : level) make_rows(piece);
    }

    void make_rows(int piece) {
        const int parent = all_.pieces[at(piece)].parent;
        std::vector<double> ex, ey;
        for (int k = 0; k < n_local_; ++k) {
            const int its = state(piece, k);
            if (its >= 0) row(piece, k).push_back({its, 1});
            if (its != is_coarse) continue;
            ENSURE(parent >= 0, "B-splines of the coarsest level are all there");
            if (ex.empty()) {
                ex = insertion(0, all_.pieces[at(parent)].node, all_.pieces[at(piece)].node);
                ey = insertion(1, all_.pieces[at(parent)].node, all_.pieces[at(piece)].node);
            }
            const int p = s_.x.degree + 1;
            combine(row(piece, k), parent,
                    [&](int j) { return ex[at(k % p * p + j % p)] * ey[at(k / p * (s_.y.degree + 1) + j / p)]; });
        }
    }

    std::vector<RowEntry>& row(int piece, int local) { return row_[at(piece) * at(n_local_) + at(local)]; }

    /// The sum of a piece's rows, each times its factor.
    template <class Factor>
    void combine(std::vector<RowEntry>& result, int from, Factor factor) {
        touched_.clear();
        for (int j = 0; j < n_local_; ++j) {
            const double e = factor(j);
            if (e == 0) continue;
            for (const RowEntry& entry : row(from, j)) {
                if (sum_[at(entry.function)] == 0) touched_.push_back(entry.function);
                sum_[at(entry.function)] += e * entry.coefficient;
            }
        }
        std::sort(touched_.begin(), touched_.end());
        touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
        for (const int f : touched_) {
            if (const double c = std::exchange(sum_[at(f)], 0.0); c != 0) result.push_back({f, c});
        }
    }

    // ---- inner and outer functions ----

    bool is_inner(int element) const { return s_.basis != Basis::web || s_.fraction[at(element)] >= inner_cell_fraction; }

    void find_inner() {
        inner_.assign(home_.size(), 0);
        for (const TreePiece& piece : all_.pieces) {
            if (piece.element < 0 || !is_inner(piece.element)) continue;
            const int number = static_cast<int>(&piece - all_.pieces.data());
            for (int k = 0; k < n_local_; ++k)
                for (const RowEntry& e : row(number, k)) inner_[at(e.function)] = 1;
        }
    }

    /// In the order in which leaves come across them.
    void number_functions() {
        number_.assign(home_.size(), -1);
        for (const int piece : all_.of_element)
            for (int k = 0; piece >= 0 && k < n_local_; ++k)
                for (const RowEntry& e : row(piece, k))
                    if (inner_[at(e.function)] && number_[at(e.function)] < 0) add_function(e.function);
    }

    void add_function(int f) {
        number_[at(f)] = s_.n_functions++;
        const auto& [piece, local] = home_[at(f)];
        const int node = all_.pieces[at(piece)].node;
        s_.place.emplace_back(greville(along(0, node), local % (s_.x.degree + 1)),
                              greville(along(1, node), local / (s_.x.degree + 1)));
        const LevelFunction its = function_of(piece, local);
        const auto last = [&](int axis, const KnotVector& knots) {
            return first_along(axis, its.level, (knots.n_intervals() << its.level) - 1) + knots.degree;
        };
        // in the order of GridSide: left, right, bottom, top
        s_.on_sides.push_back(static_cast<std::uint8_t>((its.x == 0) + 2 * (its.x == last(0, s_.x)) + 4 * (its.y == 0) +
                                                        8 * (its.y == last(1, s_.y))));
    }

    /// The leaves' pieces that the middle of an outer function is nearest to, in sizes of the leaf, of those that are reached
    /// through the part in few steps.
    std::vector<int> nearest(int f) {
        const auto& [piece, local] = home_[at(f)];
        const int node = all_.pieces[at(piece)].node;
        const Vec2 to(greville(along(0, node), local % (s_.x.degree + 1)), greville(along(1, node), local / (s_.x.degree + 1)));
        std::vector<int> front, next, found;
        for (const int p : support(piece, local))
            if (all_.pieces[at(p)].element >= 0) front.push_back(all_.pieces[at(p)].element);
        if (seen_.empty()) seen_.assign(s_.fraction.size(), -1);
        for (const int e : front) seen_[at(e)] = f;
        double closest = std::numeric_limits<double>::infinity();
        for (int steps_left = steps_beyond_first; !front.empty() && steps_left >= 0;) {
            for (const int e : front)
                if (is_inner(e)) take_if_near(e, to, closest, found);
            if (!found.empty()) --steps_left;
            next.clear();
            for (const int e : front)
                graph_.for_neighbours(e, [&](int other) {
                    if (std::exchange(seen_[at(other)], f) != f) next.push_back(other);
                });
            front.swap(next);
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    void take_if_near(int element, const Vec2& to, double& closest, std::vector<int>& found) const {
        const Vec2 size = s_.cell_size(element);
        const double distance = (s_.low_corner(element) + 0.5 * size - to).cwiseQuotient(size).squaredNorm();
        if (distance > closest * (1 + equally_near)) return;
        if (distance < closest * (1 - equally_near)) found.clear();
        closest = std::min(closest, distance);
        found.push_back(element);
    }

    /// Makes the rows of outer functions; of inner ones they are themselves.
    void extend() {
        extension_.resize(home_.size());
        for (int f = 0; f < static_cast<int>(home_.size()); ++f) {
            if (inner_[at(f)]) continue;
            ++s_.n_extended;
            const std::vector<int> from = nearest(f);
            if (from.empty()) s_.failure = "no cell is filled to a quarter where the part is thin: the grid is too coarse";
            const auto& [piece, local] = home_[at(f)];
            const int node = all_.pieces[at(piece)].node, p = s_.x.degree + 1;
            for (const int element : from) {
                const int leaf = all_.of_element[at(element)], its = all_.pieces[at(leaf)].node;
                const LocalValues ex = blossom(along(0, its), along(0, node).inner_knots(local % p)),
                                  ey = blossom(along(1, its), along(1, node).inner_knots(local / p));
                const double share = 1 / static_cast<double>(from.size());
                combine(extension_[at(f)], leaf, [&](int j) { return share * ex[at(j % p)] * ey[at(j / p)]; });
            }
        }
    }

    void write_rows() {
        std::vector<std::pair<int, double>> entries;
        s_.first.push_back(0);
        for (const int piece : all_.of_element)
            for (int k = 0; k < n_local_; ++k) {
                entries.clear();
                for (std::size_t i = 0; piece >= 0 && i < row(piece, k).size(); ++i) {
                    const RowEntry& e = row(piece, k)[i];
                    if (inner_[at(e.function)]) entries.emplace_back(number_[at(e.function)], e.coefficient);
                    for (const RowEntry& x : extension_[at(e.function)])
                        entries.emplace_back(number_[at(x.function)], e.coefficient * x.coefficient);
                }
                std::sort(entries.begin(), entries.end());
                append_row(entries);
            }
        if (s_.basis == Basis::normalized) normalize();
    }

    void append_row(const std::vector<std::pair<int, double>>& entries) {
        for (const auto& [function, coefficient] : entries) {
            if (static_cast<int>(s_.function.size()) == s_.first.back() || s_.function.back() != function) {
                s_.function.push_back(function);
                s_.coefficient.push_back(0);
            }
            s_.coefficient.back() += coefficient;
        }
        s_.first.push_back(static_cast<int>(s_.function.size()));
    }

    /// Divides the functions that live on one cut element only by their largest value there.
    void normalize() {
        s_.coefficient_of_one.assign(at(s_.n_functions), 1);
        for (std::size_t f = 0; f < home_.size(); ++f) {
            const auto& [piece, local] = home_[f];
            const int element = all_.pieces[at(piece)].element;
            if (support(piece, local).size() != 1 || element < 0 || s_.fraction[at(element)] == 1) continue;
            double largest = 0;
            for (const Vec2& x : outline_(element)) {
                LocalValues vx, vy;
                evaluate(s_.along_x(element), x.x(), vx);
                evaluate(s_.along_y(element), x.y(), vy);
                largest = std::max(largest, vx[at(local % (s_.x.degree + 1))] * vy[at(local / (s_.x.degree + 1))]);
            }
            if (largest <= 0) continue;
            s_.coefficient[at(s_.first[at(element * n_local_ + local)])] = 1 / largest;
            s_.coefficient_of_one[at(number_[f])] = largest;
        }
    }

    SplineSpace& s_;
    const Quadtree& tree_;
    ElementGraph graph_;
    TreePieces all_;
    const std::function<std::vector<Vec2>(int)>& outline_;
    int n_local_;
    std::vector<std::pair<int, int>> home_;  // of each function: a piece that it lives on, and its local number there
    std::vector<int> state_, mark_, support_;
    int stamp_ = -1;
    std::vector<std::vector<RowEntry>> row_, extension_;
    std::vector<double> sum_;
    std::vector<int> touched_, number_, seen_;
    std::vector<char> inner_;
};

}  // namespace

SplineSpace make_tree_space(SpaceInput input) {
    SplineSpace s;
    s.x = std::move(input.x);
    s.y = std::move(input.y);
    s.tree = std::move(input.tree);
    s.basis = input.basis;
    s.fraction = std::move(input.fraction);
    s.splits = std::move(input.splits);
    ENSURE(s.tree->columns() == s.columns() && s.tree->rows() == s.rows(), "the tree is one of the space's grid");
    ENSURE(s.fraction.size() == at(s.n_cells()) + s.splits.cell_of_extra.size(),
           "every element of a space has a filled fraction");
    s.level_intervals = {intervals_of(*s.tree, s.x, 0), intervals_of(*s.tree, s.y, 1)};
    TreeSpaceMaker(s, input.outline).run();
    return s;
}

}  // namespace abut::solver
