// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/branches.hpp"

#include <algorithm>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

template <class OnElement>
void for_support(const KnotVector& x, const KnotVector& y, const ElementGraph& graph, int tensor, OnElement on_element) {
    const IntervalRange columns = support(x, tensor % x.n_functions()), rows = support(y, tensor / x.n_functions());
    for (int r = rows.begin; r < rows.end; ++r)
        for (int c = columns.begin; c < columns.end; ++c) graph.for_elements_of(r * x.n_intervals() + c, on_element);
}

/// Most supports: full rectangles of plain cells, in one piece.
bool is_in_one_piece(const IntervalRange& columns, const IntervalRange& rows, int n_columns, const ElementGraph& graph) {
    for (int r = rows.begin; r < rows.end; ++r)
        for (int c = columns.begin; c < columns.end; ++c)
            if (!graph.is_plain(r * n_columns + c)) return false;
    return true;
}

/// Connected pieces of a few elements, kept over functions.
class SupportPieces {
public:
    explicit SupportPieces(const ElementGraph& graph) : graph_(graph), place_(at(graph.n_elements()), -1) {}

    /// Elements and, parallel, the number of the piece that each belongs to; numbered in the order of their first elements.
    std::vector<int> elements, piece;
    int n_pieces = 0;

    void find() {
        for (std::size_t k = 0; k < elements.size(); ++k) place_[at(elements[k])] = static_cast<int>(k);
        piece.assign(elements.size(), -1);
        n_pieces = 0;
        for (std::size_t k = 0; k < elements.size(); ++k)
            if (piece[k] < 0) fill(static_cast<int>(k), n_pieces++);
        for (int e : elements) place_[at(e)] = -1;
    }

private:
    void fill(int start, int number) {
        front_.assign(1, start);
        piece[at(start)] = number;
        while (!front_.empty()) {
            const int k = front_.back();
            front_.pop_back();
            graph_.for_neighbours(elements[at(k)], [&](int other) {
                const int place = place_[at(other)];
                if (place < 0 || piece[at(place)] >= 0) return;
                piece[at(place)] = number;
                front_.push_back(place);
            });
        }
    }

    const ElementGraph& graph_;
    std::vector<int> place_, front_;
};

/// Local number of a tensor function on an element's cell.
std::size_t local_number(const KnotVector& x, const KnotVector& y, int cell, int tensor) {
    const int c = cell % x.n_intervals(), r = cell / x.n_intervals(), nx = x.n_functions();
    return at((tensor / nx - y.first[at(r)]) * (x.degree + 1) + tensor % nx - x.first[at(c)]);
}

std::vector<int> first_branches(const KnotVector& x, const KnotVector& y, int cell) {
    const int c = x.first[at(cell % x.n_intervals())], r = y.first[at(cell / x.n_intervals())];
    std::vector<int> result;
    result.reserve(at((x.degree + 1) * (y.degree + 1)));
    for (int b = 0; b <= y.degree; ++b)
        for (int a = 0; a <= x.degree; ++a) result.push_back((r + b) * x.n_functions() + c + a);
    return result;
}

}  // namespace

Branches find_branches(const KnotVector& x, const KnotVector& y, const ElementGraph& graph) {
    Branches result;
    const int n_tensor = x.n_functions() * y.n_functions();
    SupportPieces pieces(graph);
    std::vector<IntervalRange> columns, rows;  // of the functions in either direction
    for (int i = 0; i < x.n_functions(); ++i) columns.push_back(support(x, i));
    for (int i = 0; i < y.n_functions(); ++i) rows.push_back(support(y, i));
    for (int k = 0; k < n_tensor; ++k) {
        if (is_in_one_piece(columns[at(k % x.n_functions())], rows[at(k / x.n_functions())], x.n_intervals(), graph)) continue;
        pieces.elements.clear();
        for_support(x, y, graph, k, [&](int e) { pieces.elements.push_back(e); });
        if (pieces.elements.size() < 2) continue;
        pieces.find();
        if (pieces.n_pieces < 2) continue;
        const int extra = n_tensor + static_cast<int>(result.tensor_of_extra.size()) - 1;
        for (int p = 1; p < pieces.n_pieces; ++p) result.tensor_of_extra.push_back(k);
        for (std::size_t i = 0; i < pieces.elements.size(); ++i) {
            if (pieces.piece[i] == 0) continue;
            const int cell = graph.cell_of(pieces.elements[i]);
            const auto [own, is_new] = result.of_element.try_emplace(pieces.elements[i]);
            if (is_new) own->second = first_branches(x, y, cell);
            own->second[local_number(x, y, cell, k)] = extra + pieces.piece[i];
        }
    }
    return result;
}

std::vector<int> support_elements(const SplineSpace& space, const ElementGraph& graph, int branch) {
    const int tensor = branch < space.n_tensor() ? branch : space.tensor_of_extra[at(branch - space.n_tensor())];
    std::vector<int> elements;
    for_support(space.x, space.y, graph, tensor, [&](int e) {
        const auto own = space.branches.find(e);
        const int here =
            own == space.branches.end() ? tensor : own->second[local_number(space.x, space.y, graph.cell_of(e), tensor)];
        if (here == branch) elements.push_back(e);
    });
    return elements;
}

}  // namespace abut::solver
