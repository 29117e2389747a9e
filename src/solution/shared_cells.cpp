// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/shared_cells.hpp"

#include <algorithm>
#include <cmath>

#include "src/base/index.hpp"

namespace abut {

namespace {

/// Cosine between outward normals of the two sides of a wall; faces that meet at a corner move along different directions.
constexpr double across_wall = -0.5;

}  // namespace

void note_faces(const PartOnGrid& g, const geometry::Chain& chain, double low, double high, FacesByCell& faces) {
    for (std::size_t k = 0; k < chain.edges.size(); ++k) {
        const auto e = at(chain.edges[k]);
        const geometry::Curve& curve = g.local.edges[e].curve;
        for (auto i = at(g.cells.first_piece[e]); i < at(g.cells.first_piece[e + 1]); ++i) {
            const geometry::BoundaryPiece& piece = g.cells.pieces[i];
            const double t = 0.5 * (piece.t0 + piece.t1);
            double s = chain.begin[k] + length(curve, 0, t);
            if (chain.closed) s += chain.length * std::ceil((low - s) / chain.length);
            if (s >= low && s <= high) faces[piece.cell].push_back(outward_normal(curve, t));
        }
    }
}

int faces_sharing(const PartOnGrid& g, const geometry::ChainPoint& p, const FacesByCell& faces) {
    const auto here = faces.find(piece_at(g.cells, p.edge, p.t).cell);
    if (here == faces.end()) return 1;
    const Vec2 normal = g.frame.vector_to_local(p.normal);
    const auto is_behind = [&](const Vec2& other) { return normal.dot(other) < across_wall; };
    return std::any_of(here->second.begin(), here->second.end(), is_behind) ? 2 : 1;
}

}  // namespace abut
