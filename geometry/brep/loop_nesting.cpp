// SPDX-License-Identifier: GPL-3.0-or-later
// From the leftmost point of a loop a ray to the left: what it meets first is the left side of the loop around it, or the right
// side of one that lies inside the same loop as itself. Loops are taken from left to right, so that the other one is known.
#include "geometry/brep/loop_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/brep/monotone.hpp"

namespace abut::geometry {

namespace {

std::vector<Box2> boxes_of(const std::vector<MonotonePiece>& pieces) {
    std::vector<Box2> boxes(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        boxes[i].extend(pieces[i].from);
        boxes[i].extend(pieces[i].to);
    }
    return boxes;
}

class Rays {
public:
    explicit Rays(const Part& part)
        : pieces_(monotone_pieces(part)), tree_(boxes_of(pieces_)), box_(bounding_box(part)), loop_of_edge_(part.edges.size()) {
        for (std::size_t l = 0; l < part.loops.size(); ++l)
            for (const int e : part.loops[l].edges) loop_of_edge_[static_cast<std::size_t>(e)] = static_cast<int>(l);
        leftmost_.assign(part.loops.size(), box_.max);
        for (const MonotonePiece& piece : pieces_) {
            Vec2& left = leftmost_[static_cast<std::size_t>(loop_of(piece))];
            if (piece.from.x() <= left.x()) left = piece.from;
        }
    }

    const Vec2& leftmost(int loop) const { return leftmost_[static_cast<std::size_t>(loop)]; }

    /// What the ray from a loop's leftmost point meets first: a loop, and is the point inside it? Loop -1: nothing.
    struct Met {
        int loop = -1;
        bool inside = false;
    };
    Met first_met(int loop) const {
        const Vec2 p = leftmost(loop);
        // longer and longer rays, so that a short one does where loops are many
        for (double reach = box_.diagonal() / std::sqrt(static_cast<double>(pieces_.size()));; reach *= 2) {
            const double end = std::max(p.x() - reach, box_.min.x());
            const Met met = met_until(loop, p, end);
            if (met.loop >= 0 || end == box_.min.x()) return met;
        }
    }

private:
    int loop_of(const MonotonePiece& piece) const { return loop_of_edge_[static_cast<std::size_t>(piece.edge)]; }

    /// On the ray from p to x = end.
    Met met_until(int loop, const Vec2& p, double end) const {
        Box2 ray;
        ray.extend(p);
        ray.extend(Vec2(end, p.y()));
        Met met;
        double nearest = end;
        for (const int i : tree_.near(ray, 0)) {
            const MonotonePiece& piece = pieces_[static_cast<std::size_t>(i)];
            // half open, as everywhere: shared ends count once
            if (loop_of(piece) == loop || (piece.from.y() < p.y()) == (piece.to.y() < p.y())) continue;
            const double x = x_at(piece, p.y());
            if (x < nearest || x >= p.x()) continue;
            nearest = x;
            met = {loop_of(piece), piece.to.y() < piece.from.y()};
        }
        return met;
    }

    std::vector<MonotonePiece> pieces_;
    EdgeTree tree_;
    Box2 box_;
    std::vector<int> loop_of_edge_;
    std::vector<Vec2> leftmost_;
};

}  // namespace

std::vector<int> hole_of(const Part& part) {
    const std::size_t n = part.loops.size();
    const Rays rays(part);
    std::vector<int> order(n), around(n, -1), depth(n, 0);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rays.leftmost(a).x() < rays.leftmost(b).x(); });
    for (const int loop : order) {
        const auto [other, inside] = rays.first_met(loop);
        const auto l = static_cast<std::size_t>(loop);
        if (other >= 0) around[l] = inside ? other : around[static_cast<std::size_t>(other)];
        if (around[l] >= 0) depth[l] = depth[static_cast<std::size_t>(around[l])] + 1;
    }
    for (std::size_t l = 0; l < n; ++l)
        if (depth[l] % 2 == 0) around[l] = -1;
    return around;
}

}  // namespace abut::geometry
