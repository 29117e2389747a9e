// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/fronts.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// The fronts in nodes: what each of them has below its own, by position, ascending; and the front above.
struct NodeFronts {
    std::vector<std::vector<int>> below;
    std::vector<int> parent;  ///< -1: none
};

/// Piece of each position.
std::vector<int> owners(const std::vector<int>& first) {
    std::vector<int> owner(at(first.back()));
    for (std::size_t s = 0; s + 1 < first.size(); ++s)
        std::fill(owner.begin() + first[s], owner.begin() + first[s + 1], static_cast<int>(s));
    return owner;
}

/// A front's rows are those of its nodes and those that the fronts below it leave.
NodeFronts node_fronts(const Neighbours& graph, const DissectedNodes& d) {
    const std::vector<int> position = inverse_order(d.order), owner = owners(d.first);
    NodeFronts f{std::vector<std::vector<int>>(at(d.n_pieces())), std::vector<int>(at(d.n_pieces()), -1)};
    std::vector<int> seen(position.size(), -1), last_child(f.parent), sibling(f.parent);
    for (int s = 0; s < d.n_pieces(); ++s) {
        std::vector<int>& below = f.below[at(s)];
        const int end = d.first[at(s) + 1];
        const auto take = [&](int p) {
            if (p < end || seen[at(p)] == s) return;
            seen[at(p)] = s;
            below.push_back(p);
        };
        for (int k = d.first[at(s)]; k < end; ++k) {
            const int node = d.order[at(k)];
            for (int n = graph.first[at(node)]; n < graph.first[at(node) + 1]; ++n) take(position[at(graph.node[at(n)])]);
        }
        for (int c = last_child[at(s)]; c >= 0; c = sibling[at(c)])
            for (int p : f.below[at(c)]) take(p);
        if (below.empty()) continue;
        std::sort(below.begin(), below.end());
        const int parent = owner[at(below.front())];
        f.parent[at(s)] = parent;
        sibling[at(s)] = std::exchange(last_child[at(parent)], s);
    }
    return f;
}

/// Rows of the matrix in place of nodes.
void expand(Fronts& f, const NodeFronts& nodes, const MergedPattern& pattern, const DissectedNodes& d) {
    f.order = expanded(pattern, d.order);
    std::vector<int> begin(d.order.size() + 1, 0);  // of each node's rows among the positions
    for (std::size_t k = 0; k < d.order.size(); ++k)
        begin[k + 1] = begin[k] + pattern.first_column[at(d.order[k]) + 1] - pattern.first_column[at(d.order[k])];
    f.first_column = f.first_row = f.first_value = {0};
    for (int s = 0; s < d.n_pieces(); ++s) {
        const auto append = [&](int node) {
            for (int p = begin[at(node)]; p < begin[at(node) + 1]; ++p) f.row.push_back(p);
        };
        for (int k = d.first[at(s)]; k < d.first[at(s) + 1]; ++k) append(k);
        f.first_column.push_back(begin[at(d.first[at(s) + 1])]);
        for (int p : nodes.below[at(s)]) append(p);
        f.first_row.push_back(static_cast<int>(f.row.size()));
        f.first_value.push_back(f.first_value.back() + f.rows(s) * f.width(s));
    }
}

void link(Fronts& f, const std::vector<int>& parent) {
    f.first_child.assign(parent.size() + 1, 0);
    for (int p : parent)
        if (p >= 0) ++f.first_child[at(p) + 1];
    std::partial_sum(f.first_child.begin(), f.first_child.end(), f.first_child.begin());
    f.child.resize(at(f.first_child.back()));
    std::vector<int> next = f.first_child;
    for (std::size_t s = 0; s < parent.size(); ++s)
        if (parent[s] >= 0) f.child[at(next[at(parent[s])]++)] = static_cast<int>(s);
}

void find_runs(Fronts& f, const std::vector<int>& parent) {
    f.first_run.push_back(0);
    for (int s = 0; s < f.n_fronts(); ++s) {
        const int above = parent[at(s)], first = f.first_row[at(s)] + f.width(s);
        int place = 0;
        for (int r = first; r < f.first_row[at(s) + 1]; ++r, ++place) {
            const int before = place;
            while (f.row[at(f.first_row[at(above)] + place)] != f.row[at(r)]) ++place;
            if (r == first || place > before || place == f.width(above)) f.run.push_back({r - first, 0, place});
            f.run.back().end = r - first + 1;
        }
        f.first_run.push_back(static_cast<int>(f.run.size()));
    }
}

/// The entries of two nodes, `row` not before `column` in the matrix; offset: of their first row in the column's first column.
struct NodePair {
    int column, row, offset;
};

template <class F>
void for_pairs(const MergedPattern& p, F f) {
    for (int node = 0; node < p.n_nodes(); ++node) {
        int offset = 0;
        for (int k = p.first[at(node)]; k < p.first[at(node) + 1]; ++k) {
            const int row = p.row[at(k)];
            f(NodePair{node, row, offset});
            offset += p.first_column[at(row) + 1] - p.first_column[at(row)];
        }
    }
}

/// Sets the targets of two nodes' entries. local: where the rows stand in the front, by position.
void set_targets(Fronts& f, const SparseSymmetric& m, const MergedPattern& p, const NodePair& pair, int front,
                 const std::vector<int>& position, const std::vector<int>& local) {
    for (int c = p.first_column[at(pair.column)]; c < p.first_column[at(pair.column) + 1]; ++c) {
        const int column_in_node = c - p.first_column[at(pair.column)];
        int k = m.first[at(c)] + pair.offset - column_in_node;
        for (int r = p.first_column[at(pair.row)]; r < p.first_column[at(pair.row) + 1]; ++r, ++k) {
            if (r < c) continue;
            const auto [left, below] = std::minmax(local[at(position[at(c)])], local[at(position[at(r)])]);
            f.target[at(k)] = f.first_value[at(front)] + left * f.rows(front) + below;
        }
    }
}

/// Pairs of nodes are sorted by front, then each finds its rows in a table of the front's.
void find_targets(Fronts& f, const SparseSymmetric& m, const MergedPattern& p) {
    const std::vector<int> position = inverse_order(f.order), owner = owners(f.first_column);
    const auto front = [&](const NodePair& pair) {
        return at(
            owner[at(std::min(position[at(p.first_column[at(pair.column)])], position[at(p.first_column[at(pair.row)])]))]);
    };
    std::vector<int> next(at(f.n_fronts()) + 1, 0);
    for_pairs(p, [&](const NodePair& pair) { ++next[front(pair) + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<NodePair> pairs(p.row.size());
    for_pairs(p, [&](const NodePair& pair) { pairs[at(next[front(pair)]++)] = pair; });
    f.target.resize(m.row.size());
    std::vector<int> local(at(m.n));
    std::size_t k = 0;
    for (int s = 0; s < f.n_fronts(); ++s) {
        for (int r = 0; r < f.rows(s); ++r) local[at(f.row[at(f.first_row[at(s)] + r)])] = r;
        for (; k < at(next[at(s)]); ++k) set_targets(f, m, p, pairs[k], s, position, local);
    }
}

}  // namespace

int Fronts::width(int front) const {
    return first_column[at(front) + 1] - first_column[at(front)];
}

int Fronts::rows(int front) const {
    return first_row[at(front) + 1] - first_row[at(front)];
}

SupernodePattern Fronts::pattern() const {
    return {first_column, first_row, first_value, row, order};
}

Fronts make_fronts(const SparseSymmetric& matrix, const MergedPattern& pattern, const DissectedNodes& dissection) {
    const NodeFronts nodes = node_fronts(neighbours(pattern), dissection);
    Fronts f;
    expand(f, nodes, pattern, dissection);
    link(f, nodes.parent);
    find_runs(f, nodes.parent);
    find_targets(f, matrix, pattern);
    return f;
}

}  // namespace abut::solver
