// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/tree_pieces.hpp"

#include <algorithm>
#include <numeric>

#include "src/base/index.hpp"

namespace abut::solver {

namespace {

/// A piece of the finer of two levels, or of the same, and one that it shares a side with.
using Link = std::pair<int, int>;

class PieceFinder {
public:
    PieceFinder(const Quadtree& tree, const ElementGraph& graph) : tree_(tree), parent_of_(at(tree.n_nodes()), -1) {
        for (int node = 0; node < tree.n_nodes(); ++node)
            for (int k = 0; !tree.is_leaf(node) && k < 4; ++k) parent_of_[at(tree.first_child(node) + k)] = node;
        result_.of_level.resize(at(tree.levels() + 1));
        links_.resize(result_.of_level.size());
        add_leaves(graph);
    }

    TreePieces run() {
        for (int level = tree_.levels(); level >= 0; --level) {
            note_links(level);
            if (level > 0) join(level);
        }
        return std::move(result_);
    }

private:
    int level_of(int piece) const { return tree_.cell(result_.pieces[at(piece)].node).level; }
    int add(int node, int element) {
        const int piece = static_cast<int>(result_.pieces.size());
        result_.pieces.push_back({node, -1, element});
        result_.of_level[at(tree_.cell(node).level)].push_back(piece);
        result_.beside.emplace_back();
        result_.coarser.emplace_back();
        return piece;
    }

    void add_leaves(const ElementGraph& graph) {
        result_.of_element.assign(at(graph.n_elements()), -1);
        for (int e = 0; e < graph.n_elements(); ++e)
            if (graph.has_material(e)) result_.of_element[at(e)] = add(tree_.node_of(graph.cell_of(e)), e);
        for (int e = 0; e < graph.n_elements(); ++e) {
            const int own = result_.of_element[at(e)];
            if (own < 0) continue;
            graph.for_neighbours(e, [&](int other) {
                const int beside = result_.of_element[at(other)];
                if (beside >= 0 && level_of(beside) <= level_of(own)) links_[at(level_of(own))].emplace_back(own, beside);
            });
        }
    }

    void note_links(int level) {
        std::vector<Link>& links = links_[at(level)];
        std::sort(links.begin(), links.end());
        links.erase(std::unique(links.begin(), links.end()), links.end());
        for (const auto& [piece, other] : links)
            (level_of(other) == level ? result_.beside : result_.coarser)[at(piece)].push_back(other);
    }

    /// Makes the pieces of the nodes whose children's pieces are of a level, and their links.
    void join(int level) {
        const std::vector<int>& own = result_.of_level[at(level)];
        const auto node_above = [&](int piece) { return parent_of_[at(result_.pieces[at(piece)].node)]; };
        for (const int start : own) {
            if (result_.pieces[at(start)].parent >= 0) continue;
            const int parent = add(node_above(start), -1);
            std::vector<int> front{start};
            result_.pieces[at(start)].parent = parent;
            while (!front.empty()) {
                const int piece = front.back();
                front.pop_back();
                for (const int other : result_.beside[at(piece)]) {
                    if (result_.pieces[at(other)].parent >= 0 || node_above(other) != node_above(piece)) continue;
                    result_.pieces[at(other)].parent = parent;
                    front.push_back(other);
                }
            }
        }
        for (const auto& [piece, other] : links_[at(level)]) {
            const int above = result_.pieces[at(piece)].parent;
            const int beside = level_of(other) == level ? result_.pieces[at(other)].parent : other;
            if (above != beside) links_[at(level - 1)].emplace_back(above, beside);
            // a leaf beside the parent has the parent beside it
            if (above != beside && beside == other) links_[at(level - 1)].emplace_back(beside, above);
        }
        std::erase_if(links_[at(level - 1)], [&](const Link& l) { return level_of(l.first) != level - 1; });
    }

    const Quadtree& tree_;
    std::vector<int> parent_of_;
    std::vector<std::vector<Link>> links_;  // by level of the first
    TreePieces result_;
};

}  // namespace

TreePieces find_pieces(const Quadtree& tree, const ElementGraph& graph) {
    return PieceFinder(tree, graph).run();
}

}  // namespace abut::solver
