// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/grid_dissection.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

struct IndexBox {
    std::array<int, 2> low, high;
    int extent(std::size_t axis) const { return high[axis] - low[axis] + 1; }
};

class Dissector {
public:
    Dissector(const GridPlaces& places, int leaf) : places_(places), leaf_(leaf) {
        result_.order.resize(places.at.size());
        std::iota(result_.order.begin(), result_.order.end(), 0);
    }

    DissectedNodes run() {
        split(0, static_cast<int>(places_.at.size()));
        return std::move(result_);
    }

private:
    int place(int node, std::size_t axis) const { return places_.at[at(node)][axis]; }

    IndexBox box(int begin, int end) const {
        IndexBox b{places_.at[at(result_.order[at(begin)])], places_.at[at(result_.order[at(begin)])]};
        for (int k = begin; k < end; ++k)
            for (std::size_t axis : {0u, 1u}) {
                const int v = place(result_.order[at(k)], axis);
                b.low[axis] = std::min(b.low[axis], v);
                b.high[axis] = std::max(b.high[axis], v);
            }
        return b;
    }

    /// The first of the lines that are taken out: those that leave most in the smaller half, for few nodes of their own. None:
    /// a half would be empty.
    std::optional<int> cut(int begin, int end, std::size_t axis, const IndexBox& b) {
        before_.assign(at(b.extent(axis)) + 1, 0);  // nodes on lines before
        for (int k = begin; k < end; ++k) ++before_[at(place(result_.order[at(k)], axis) - b.low[axis]) + 1];
        std::partial_sum(before_.begin(), before_.end(), before_.begin());
        std::optional<int> best;
        int largest = 0;
        for (int line = 1; line + places_.reach < b.extent(axis); ++line) {
            const int first = before_[at(line)], second = end - begin - before_[at(line + places_.reach)];
            const int gain = std::min(first, second) - (end - begin - first - second);
            if (first == 0 || second == 0 || (best && gain <= largest)) continue;
            best = b.low[axis] + line;
            largest = gain;
        }
        return best;
    }

    void split(int begin, int end) {
        if (begin == end) return;
        if (end - begin <= leaf_) return finish(end);
        const IndexBox b = box(begin, end);
        const std::size_t axis = b.extent(0) >= b.extent(1) ? 0 : 1;
        const std::optional<int> line = cut(begin, end, axis, b);
        if (!line) return finish(end);
        const auto part = [&](int node) {
            const int v = place(node, axis);
            return v < *line ? 0 : v < *line + places_.reach ? 2 : 1;
        };
        const auto node = [&](int k) { return result_.order.begin() + k; };
        const auto second = std::stable_partition(node(begin), node(end), [&](int n) { return part(n) == 0; });
        const auto taken = std::stable_partition(second, node(end), [&](int n) { return part(n) == 1; });
        const int middle = static_cast<int>(second - node(0)), last = static_cast<int>(taken - node(0));
        split(begin, middle);
        split(middle, last);
        finish(end);
    }

    /// What is left up to `end` is a piece.
    void finish(int end) {
        if (end > result_.first.back()) result_.first.push_back(end);
    }

    const GridPlaces& places_;
    int leaf_;
    DissectedNodes result_;
    std::vector<int> before_;
};

}  // namespace

DissectedNodes dissected(const GridPlaces& places, int leaf) {
    return Dissector(places, leaf).run();
}

}  // namespace abut::solver
