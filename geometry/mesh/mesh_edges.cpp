// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_edges.hpp"

#include <algorithm>
#include <tuple>

namespace abut::geometry {

std::vector<MeshEdge> edges_of(const Mesh& mesh) {
    struct Entry {
        int from, to;
        EdgeSide side;
    };
    std::vector<Entry> entries;
    entries.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<int, 3>& triangle = mesh.triangles[t];
            const int a = triangle[k], b = triangle[(k + 1) % 3], apex = triangle[(k + 2) % 3];
            entries.push_back({std::min(a, b), std::max(a, b), {static_cast<int>(t), apex, a < b}});
        }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.from, a.to, a.side.triangle) < std::tie(b.from, b.to, b.side.triangle);
    });
    std::vector<MeshEdge> edges;
    edges.reserve(entries.size() / 2);
    for (const Entry& entry : entries) {
        if (edges.empty() || edges.back().from != entry.from || edges.back().to != entry.to)
            edges.push_back({entry.from, entry.to, {}});
        edges.back().sides.push_back(entry.side);
    }
    return edges;
}

}  // namespace abut::geometry
