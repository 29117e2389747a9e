// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/ordering.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// Whether column c + 1 has the rows of column c below the diagonal.
bool same_below(const SparseSymmetric& m, int c) {
    const auto begin = m.row.begin() + m.first[at(c)], middle = m.row.begin() + m.first[at(c) + 1];
    return std::equal(begin + 1, middle, middle, m.row.begin() + m.first[at(c) + 2]);
}

/// For each row how many entries it has left of the diagonal, and in how many of their columns the row before has one, too.
struct LeftOfDiagonal {
    std::vector<int> own, shared;

    explicit LeftOfDiagonal(const SparseSymmetric& m) : own(at(m.n), 0), shared(at(m.n), 0) {
        for (int c = 0; c < m.n; ++c)
            for (int k = m.first[at(c)] + 1; k < m.first[at(c) + 1]; ++k) {
                const int row = m.row[at(k)], before = m.row[at(k) - 1];
                ++own[at(row)];
                if (before == row - 1 && before > c) ++shared[at(row)];
            }
    }
    /// Has a row the columns of the row before, and that of its diagonal?
    bool follows(int row) const { return own[at(row)] == own[at(row) - 1] + 1 && shared[at(row)] == own[at(row) - 1]; }
};

/// Breadth-first levels of one component, neighbours in ascending order of their degree.
struct Levels {
    std::vector<int> order;      ///< nodes, level by level
    std::size_t last_level = 0;  ///< where the last level begins in `order`
    int depth = 0;               ///< steps to the last level
};

class Search {
public:
    explicit Search(const Neighbours& graph) : graph_(graph), stamp_(graph.first.size() - 1, -1) {}

    Levels from(int start) {
        ++turn_;
        Levels levels{{start}, 0, 0};
        stamp_[at(start)] = turn_;
        for (std::size_t begin = 0, end = 1; begin < end; begin = end, end = levels.order.size()) {
            levels.last_level = begin;
            levels.depth += begin > 0;
            for (std::size_t k = begin; k < end; ++k) append_neighbours(levels.order, levels.order[k]);
        }
        return levels;
    }

    bool reached(int node) const { return stamp_[at(node)] >= 0; }
    int degree(int node) const { return graph_.first[at(node) + 1] - graph_.first[at(node)]; }

private:
    void append_neighbours(std::vector<int>& order, int node) {
        const auto begin = static_cast<std::ptrdiff_t>(order.size());
        for (int k = graph_.first[at(node)]; k < graph_.first[at(node) + 1]; ++k) {
            const int other = graph_.node[at(k)];
            if (stamp_[at(other)] == turn_) continue;
            stamp_[at(other)] = turn_;
            order.push_back(other);
        }
        std::sort(order.begin() + begin, order.end(),
                  [&](int a, int b) { return degree(a) != degree(b) ? degree(a) < degree(b) : a < b; });
    }

    const Neighbours& graph_;
    std::vector<int> stamp_;
    int turn_ = -1;
};

/// Levels from a node that is as far from another as can be found by going to the end again and again.
Levels from_an_end(Search& search, int start) {
    Levels levels = search.from(start);
    for (;;) {
        const int end =
            *std::min_element(levels.order.begin() + static_cast<std::ptrdiff_t>(levels.last_level), levels.order.end(),
                              [&](int a, int b) { return search.degree(a) < search.degree(b); });
        Levels further = search.from(end);
        if (further.depth <= levels.depth) return further;
        levels = std::move(further);
    }
}

}  // namespace

MergedPattern merged_pattern(const SparseSymmetric& m) {
    MergedPattern p;
    std::vector<int> node(at(m.n));
    const LeftOfDiagonal left(m);
    for (int c = 0; c < m.n; ++c) {
        const bool joins = c > 0 && left.follows(c) && same_below(m, c - 1);
        if (!joins) p.first_column.push_back(c);
        node[at(c)] = static_cast<int>(p.first_column.size()) - 1;
    }
    p.first.push_back(0);
    for (int c : p.first_column) {
        for (int k = m.first[at(c)]; k < m.first[at(c) + 1]; ++k) {
            const int r = node[at(m.row[at(k)])];
            if (k == m.first[at(c)] || r != p.row.back()) p.row.push_back(r);
        }
        p.first.push_back(static_cast<int>(p.row.size()));
    }
    p.first_column.push_back(m.n);
    return p;
}

std::vector<int> expanded(const MergedPattern& pattern, const std::vector<int>& node_order) {
    std::vector<int> rows;
    rows.reserve(at(pattern.first_column.back()));
    for (int node : node_order)
        for (int c = pattern.first_column[at(node)]; c < pattern.first_column[at(node) + 1]; ++c) rows.push_back(c);
    return rows;
}

std::vector<int> inverse_order(const std::vector<int>& order) {
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position[at(order[k])] = static_cast<int>(k);
    return position;
}

Neighbours neighbours(const MergedPattern& p) {
    Neighbours g;
    g.first.assign(at(p.n_nodes()) + 1, 0);
    const auto for_pairs = [&](auto f) {
        for (int c = 0; c < p.n_nodes(); ++c)
            for (int k = p.first[at(c)] + 1; k < p.first[at(c) + 1]; ++k) f(c, p.row[at(k)]);
    };
    for_pairs([&](int a, int b) {
        ++g.first[at(a) + 1];
        ++g.first[at(b) + 1];
    });
    std::partial_sum(g.first.begin(), g.first.end(), g.first.begin());
    g.node.resize(at(g.first.back()));
    std::vector<int> next(g.first.begin(), g.first.end() - 1);
    for_pairs([&](int a, int b) {
        g.node[at(next[at(a)]++)] = b;
        g.node[at(next[at(b)]++)] = a;
    });
    return g;
}

std::vector<int> reverse_cuthill_mckee(const Neighbours& graph) {
    Search search(graph);
    std::vector<int> order;
    for (int node = 0; at(node) + 1 < graph.first.size(); ++node) {
        if (search.reached(node)) continue;
        const Levels levels = from_an_end(search, node);
        order.insert(order.end(), levels.order.begin(), levels.order.end());
    }
    std::reverse(order.begin(), order.end());
    return order;
}

int least_bandwidth(const Neighbours& graph) {
    Search search(graph);
    int least = 0;
    for (int node = 0; at(node) + 1 < graph.first.size(); ++node) {
        if (search.reached(node)) continue;
        const Levels levels = search.from(node);
        const int n = static_cast<int>(levels.order.size());
        if (n > 1) least = std::max(least, (n - 2) / (2 * levels.depth) + 1);  // (n - 1) / diameter, rounded up
    }
    return least;
}

int bandwidth(const SparseSymmetric& m, const std::vector<int>& position) {
    int widest = 0;
    for (int c = 0; c < m.n; ++c)
        for (int k = m.first[at(c)]; k < m.first[at(c) + 1]; ++k)
            widest = std::max(widest, std::abs(position[at(c)] - position[at(m.row[at(k)])]));
    return widest;
}

}  // namespace abut::solver
