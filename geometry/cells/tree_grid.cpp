// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/cells/tree_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/brep/monotone.hpp"
#include "geometry/cells/contour_area.hpp"
#include "geometry/cells/grid_walk.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// What a node of the tree holds. Contours: of edges in the order of the walk, then right sides; none in cells that no edge
/// enters.
struct NodeCut {
    CellClass cell_class = CellClass::outer;
    std::vector<ContourPiece> contours{};

    std::size_t n_edges() const {
        std::size_t n = 0;
        while (n < contours.size() && contours[n].edge >= 0) ++n;
        return n;
    }
};
using Quarters = std::array<NodeCut, 4>;

/// Adds material along the right side of the lower and the upper quarter of one column.
void add_right_side(Quarters& quarters, std::size_t lower, double middle, double from, double to) {
    const auto add = [&](std::size_t quarter, double a, double b) {
        if (b > a) quarters[quarter].contours.push_back({static_cast<int>(quarter), -1, a, b});
    };
    add(lower, from, std::min(to, middle));
    add(lower + 2, std::max(from, middle), to);
}

/// Calls on_material(from, to) for the material along a line between low and high, which begins with it or without.
template <class OnMaterial>
void along_line(const std::vector<LineCrossing>& crossings, double low, double high, int winding, OnMaterial on_material) {
    double from = low;
    const auto pass = [&](double to) {
        if (winding > 0 && to > from) on_material(from, to);
        from = std::max(from, to);
    };
    for (const LineCrossing& c : crossings) {
        pass(std::clamp(c.y, low, high));
        winding += c.turn;
    }
    pass(high);
}

/// The upright middle line of a cell, of which so much has material on its left; middle: the ordinate between the quarters.
void add_middle_line(Quarters& quarters, std::vector<LineCrossing>& crossings, const Box2& box, double middle,
                     double material) {
    std::sort(crossings.begin(), crossings.end(), [](const LineCrossing& a, const LineCrossing& b) { return a.y < b.y; });
    const auto missed = [&](int winding) {
        double sum = 0;
        along_line(crossings, box.min.y(), box.max.y(), winding, [&](double a, double b) { sum += b - a; });
        return std::abs(sum - material);
    };
    along_line(crossings, box.min.y(), box.max.y(), missed(1) < missed(0) ? 1 : 0,
               [&](double a, double b) { add_right_side(quarters, 0, middle, a, b); });
}

void classify(NodeCut& cut, const Part& part, const Box2& box) {
    double sum = 0;
    if (cut.n_edges() == 0) {  // all of its side, or nothing of it
        for (const ContourPiece& c : cut.contours) sum += c.t1 - c.t0;
        cut.cell_class = sum > 0.5 * box.size().y() ? CellClass::inner : CellClass::outer;
        cut.contours.clear();
        return;
    }
    for (const ContourPiece& c : cut.contours) sum += area_share(part, c, box.min.x(), box.max.x());
    cut.cell_class = class_by(sum / (box.size().x() * box.size().y()));
}

/// The quarters of a cell that is cut.
Quarters quarters_of(const NodeCut& cut, const Part& part, const std::vector<int>& loop_of, const Box2& box,
                     const std::array<Box2, 4>& boxes) {
    Quarters quarters;
    const std::size_t n_edges = cut.n_edges();
    if (n_edges == 0) {
        for (NodeCut& q : quarters) q.cell_class = cut.cell_class;
        return quarters;
    }
    const Vec2 middle = boxes[0].max;
    GridWalk walk = walk_quarters(part, std::span(cut.contours).first(n_edges), loop_of, middle);
    double right_of_middle = 0;
    for (const ContourPiece& c : walk.contours) {
        quarters[at(c.cell)].contours.push_back(c);
        if (c.cell % 2 == 1) right_of_middle += c.to.y() - c.from.y();
    }
    for (std::size_t k = n_edges; k < cut.contours.size(); ++k) {
        const ContourPiece& side = cut.contours[k];
        add_right_side(quarters, 1, middle.y(), side.t0, side.t1);
        right_of_middle += side.t1 - side.t0;
    }
    add_middle_line(quarters, walk.crossings, box, middle.y(), right_of_middle);
    for (std::size_t k = 0; k < 4; ++k) classify(quarters[k], part, boxes[k]);
    return quarters;
}

/// The cells of a tree, cut while it grows or after.
class NodeCuts {
public:
    NodeCuts(const Part& part, const Grid& base) : part_(part), grid_{base.x, base.y}, loop_of_(loops_of_edges(part)) {
        CutCells cells = cut_cells(part, grid_);
        cuts_.resize(cells.cell_class.size());
        for (std::size_t c = 0; c < cuts_.size(); ++c) {
            cuts_[c].cell_class = cells.cell_class[c];
            const auto contour = [&](std::size_t i) { return cells.contours.begin() + cells.first_contour[i]; };
            cuts_[c].contours.assign(contour(c), contour(c + 1));
        }
        merge = cells.merge;
    }

    double merge;  ///< the part's merge length

    const NodeCut& cut(int node) const { return cuts_[at(node)]; }
    Box2 box(const TreeCell& c) const {
        return {{level_line(grid_.x, c.level, c.column), level_line(grid_.y, c.level, c.row)},
                {level_line(grid_.x, c.level, c.column + 1), level_line(grid_.y, c.level, c.row + 1)}};
    }
    /// Cuts the four children of a node, the next that the tree has made.
    void cut_children(const Quadtree& tree, int node) {
        const int first = tree.first_child(node);
        std::array<Box2, 4> boxes;
        for (int k = 0; k < 4; ++k) boxes[at(k)] = box(tree.cell(first + k));
        Quarters quarters = quarters_of(cut(node), part_, loop_of_, box(tree.cell(node)), boxes);
        if (cuts_.size() < at(first + 4)) cuts_.resize(at(first + 4));
        for (int k = 0; k < 4; ++k) cuts_[at(first + k)] = std::move(quarters[at(k)]);
    }

private:
    const Part& part_;
    Grid grid_;
    std::vector<int> loop_of_;
    std::vector<NodeCut> cuts_;
};

/// Halves cells so that neighbours are at most one level apart.
class Grower {
public:
    Grower(const Part& part, const Grid& base) : tree_(base.columns(), base.rows()), cuts_(part, base) {
        by_level_.emplace_back();
        for (int node = 0; node < tree_.n_nodes(); ++node) by_level_[0].push_back(node);
    }

    Quadtree grown(const WantsHalving& wants) {
        for (std::size_t level = 0; level < by_level_.size(); ++level)
            for (std::size_t k = 0; k < by_level_[level].size(); ++k) {  // grows at its end meanwhile
                const int node = by_level_[level][k];
                if (!tree_.is_leaf(node) || is_outer(node)) continue;
                if (wants(cuts_.box(tree_.cell(node)), static_cast<int>(level))) halve(node);
            }
        tree_.number_leaves();
        return std::move(tree_);
    }

private:
    bool is_outer(int node) const { return cuts_.cut(node).cell_class == CellClass::outer; }

    void halve(int node) {
        const TreeCell c = tree_.cell(node);
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) bring_to({c.level, c.column + dx, c.row + dy});
        tree_.halve(node);
        cuts_.cut_children(tree_, node);
        if (by_level_.size() < at(c.level + 2)) by_level_.emplace_back();
        for (int k = 0; k < 4; ++k) by_level_[at(c.level + 1)].push_back(tree_.first_child(node) + k);
    }
    /// Halves what covers a cell until there is that cell, or nothing.
    void bring_to(const TreeCell& c) {
        for (;;) {
            const int node = tree_.node_at(c);
            if (node < 0 || tree_.cell(node).level == c.level || is_outer(node)) return;
            halve(node);
        }
    }

    Quadtree tree_;
    NodeCuts cuts_;
    std::vector<std::vector<int>> by_level_;
};

/// The node that holds a point, so many halvings deep or a leaf.
int node_holding(const Grid& grid, const Vec2& p, int level) {
    int node = grid.cell(nearest_interval(grid.x, p.x()), nearest_interval(grid.y, p.y()));
    while (!grid.tree->is_leaf(node) && grid.tree->cell(node).level < level) {
        const TreeCell c = grid.tree->cell(node);
        node = grid.tree->first_child(node) + (p.x() >= level_line(grid.x, c.level + 1, 2 * c.column + 1)) +
               2 * (p.y() >= level_line(grid.y, c.level + 1, 2 * c.row + 1));
    }
    return node;
}

/// The pieces of the boundary by leaves, out of those by base cells.
class PieceSplitter {
public:
    PieceSplitter(const Part& part, const Grid& grid, double merge) : part_(part), grid_(grid), merge_(merge) {}

    std::vector<BoundaryPiece> pieces{};

    void add(const BoundaryPiece& piece, int level = 0) {
        const Curve& curve = part_.edges[at(piece.edge)].curve;
        const double t = 0.5 * (piece.t0 + piece.t1);
        const int node = node_holding(grid_, point(curve, t) - merge_ * outward_normal(curve, t), level);
        if (grid_.tree->is_leaf(node)) {
            pieces.push_back(piece);
            return;
        }
        const TreeCell c = grid_.tree->cell(node);
        const Vec2 middle(level_line(grid_.x, c.level + 1, 2 * c.column + 1), level_line(grid_.y, c.level + 1, 2 * c.row + 1));
        const Vec2 from = point(curve, piece.t0), to = point(curve, piece.t1);
        std::array<double, 3> ends{piece.t1, piece.t1, piece.t1};
        for (int axis : {0, 1}) {
            if ((from[axis] - middle[axis]) * (to[axis] - middle[axis]) >= 0) continue;
            const MonotonePiece whole = monotone_piece(piece.edge, curve, piece.t0, piece.t1, from, to);
            ends[at(axis)] = line_meeting(whole, axis, middle[axis], curve).t;
        }
        std::sort(ends.begin(), ends.end());
        double begin = piece.t0;
        for (const double end : ends) {
            if (!(end > begin)) continue;
            add({piece.edge, begin, end, -1}, level + 1);
            begin = end;
        }
    }

private:
    const Part& part_;
    const Grid& grid_;
    double merge_;
};

}  // namespace

Grid tree_grid(const Part& part, const Grid& base, const WantsHalving& wants) {
    ENSURE(!base.tree, "the base of a tree is a grid without one");
    Quadtree tree = Grower(part, base).grown(wants);
    return {base.x, base.y, std::make_shared<const Quadtree>(std::move(tree))};
}

CutCells cut_tree(const Part& part, const Grid& grid) {
    const Quadtree& tree = *grid.tree;
    NodeCuts cuts(part, grid);
    for (int node = 0; node < tree.n_nodes(); ++node)
        if (!tree.is_leaf(node)) cuts.cut_children(tree, node);
    CutCells cells;
    cells.grid = grid;
    cells.fraction.assign(at(tree.n_leaves()), 0.0);
    for (int leaf = 0; leaf < tree.n_leaves(); ++leaf) {
        const NodeCut& cut = cuts.cut(tree.node_of(leaf));
        cells.cell_class.push_back(cut.cell_class);
        for (ContourPiece c : cut.contours) {
            c.cell = leaf;
            cells.contours.push_back(c);
        }
    }
    PieceSplitter splitter(part, grid, cuts.merge);
    for (const BoundaryPiece& piece : walk_boundary(part, {grid.x, grid.y}).pieces) splitter.add(piece);
    cells.pieces = std::move(splitter.pieces);
    finish_cells(cells, part);
    return cells;
}

}  // namespace abut::geometry
