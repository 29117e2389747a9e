// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_algebra/dissection.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "solver/linear_algebra/index.hpp"

namespace abut::solver {

namespace {

using Nodes = std::vector<int>;

struct Line {
    std::size_t direction;
    int number;
    std::ptrdiff_t n_nodes;  // on it
};

class Dissection {
public:
    Dissection(const Neighbours& graph, const std::vector<GridPlace>& place, int least)
        : graph_(graph), place_(place), least_(at(std::max(least, 2))), piece_(place.size(), -1), level_(place.size(), 0) {}

    /// The nodes are cut again after the cuts at hand: level 1 is the first.
    void cut(const Nodes& nodes, int level) {
        if (nodes.size() < least_) return;
        const std::optional<Line> line = best_line(nodes);
        if (!line) return;
        const auto [before, after] = halves(nodes, *line, level);
        cut(before, level + 1);
        cut(after, level + 1);
    }

    /// From the last level to the first.
    std::vector<int> ascending() && {
        const int deepest = *std::max_element(level_.begin(), level_.end());
        for (int& level : level_) level = level > 0 ? deepest + 1 - level : 0;
        return std::move(level_);
    }

private:
    int number(int node, std::size_t direction) const { return place_[at(node)][direction]; }

    /// The line in the nodes' middle; none where all of them lie on one.
    std::optional<Line> middle_line(Nodes nodes, std::size_t direction) const {
        const auto middle = nodes.begin() + static_cast<std::ptrdiff_t>(nodes.size() / 2);
        const auto before = [&](int a, int b) { return number(a, direction) < number(b, direction); };
        std::nth_element(nodes.begin(), middle, nodes.end(), before);
        const int line = number(*middle, direction);
        if (number(*std::min_element(nodes.begin(), middle + 1, before), direction) == line) return std::nullopt;
        return Line{direction, line,
                    std::count_if(nodes.begin(), nodes.end(), [&](int n) { return number(n, direction) == line; })};
    }

    std::optional<Line> best_line(const Nodes& nodes) const {
        const std::optional<Line> x = middle_line(nodes, 0), y = middle_line(nodes, 1);
        return !y || (x && x->n_nodes <= y->n_nodes) ? x : y;
    }

    /// Marks the separator with its level; the nodes before it and after it.
    std::array<Nodes, 2> halves(const Nodes& nodes, const Line& line, int level) {
        ++turn_;
        std::array<Nodes, 2> half;
        for (int n : nodes)
            if (number(n, line.direction) < line.number) {
                piece_[at(n)] = turn_;
                half[0].push_back(n);
            }
        const auto is_before = [&](int n) { return piece_[at(n)] == turn_; };
        for (int n : nodes) {
            if (is_before(n)) continue;
            const auto begin = graph_.node.begin() + graph_.first[at(n)], end = graph_.node.begin() + graph_.first[at(n) + 1];
            if (std::any_of(begin, end, is_before))
                level_[at(n)] = level;
            else
                half[1].push_back(n);
        }
        return half;
    }

    const Neighbours& graph_;
    const std::vector<GridPlace>& place_;
    std::size_t least_;
    std::vector<int> piece_;  // the turn at which a node was last before the line
    std::vector<int> level_;  // of separators
    int turn_ = 0;
};

}  // namespace

std::vector<int> dissect(const Neighbours& graph, const std::vector<GridPlace>& place, int least) {
    if (place.empty()) return {};
    Nodes all(place.size());
    std::iota(all.begin(), all.end(), 0);
    Dissection dissection(graph, place, least);
    dissection.cut(all, 1);
    return std::move(dissection).ascending();
}

}  // namespace abut::solver
