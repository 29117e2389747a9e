// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace abut::geometry {

namespace {

/// Moves below this part of weld_length() are rounding, and not told.
constexpr double rounding_share = 1e-3;

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
    std::size_t operator()(const Cell& c) const {
        std::uint64_t h = 0;
        for (std::int64_t i : c) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15ull, h ^= h >> 29;
        return static_cast<std::size_t>(h);
    }
};

bool is_before(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// For each vertex the first one at exactly the same place.
std::vector<int> exact_twins(const std::vector<Vec3>& vertices) {
    std::vector<int> order(vertices.size()), twin(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](int i) -> const Vec3& { return vertices[static_cast<std::size_t>(i)]; };
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        if (is_before(at(i), at(j))) return true;
        return !is_before(at(j), at(i)) && i < j;
    });
    int first = -1;
    for (int i : order) {
        if (first < 0 || at(first) != at(i)) first = i;
        twin[static_cast<std::size_t>(i)] = first;
    }
    return twin;
}

/// A cell is so many times as wide as the length: points have few cells within the length then, mostly their own, and cells
/// few points.
constexpr double cell_width = 8;

/// Points kept so far, by cells.
class Grid {
public:
    Grid(const std::vector<Vec3>& vertices, double length) : vertices_(vertices), length_(length) {}

    /// The kept vertex nearest to the place, no farther than the length (of several as near the first); -1: none.
    int nearest(const Vec3& p) const {
        int best = -1;
        double least = length_;
        const Cell low = cell_of(p - Vec3::Constant(length_)), high = cell_of(p + Vec3::Constant(length_));
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t z = low[2]; z <= high[2]; ++z) look_into({x, y, z}, p, best, least);
        return best;
    }
    void keep(int i) { cells_[cell_of(vertices_[static_cast<std::size_t>(i)])].push_back(i); }

private:
    void look_into(const Cell& cell, const Vec3& p, int& best, double& least) const {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return;
        for (int i : found->second) {
            const double d = (vertices_[static_cast<std::size_t>(i)] - p).norm();
            if (d < least || (d == least && (best < 0 || i < best))) best = i, least = d;
        }
    }
    Cell cell_of(const Vec3& p) const {
        Cell c;
        for (int k = 0; k < 3; ++k)
            c[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / (cell_width * length_)));
        return c;
    }
    const std::vector<Vec3>& vertices_;
    double length_;
    std::unordered_map<Cell, std::vector<int>, CellHash> cells_;
};

/// For each vertex the one that it becomes.
std::vector<int> join(const std::vector<Vec3>& vertices, Weld& done) {
    std::vector<int> becomes = exact_twins(vertices);
    const double length = weld_length(vertices);
    if (!(length > 0)) return becomes;  // all at the origin
    Grid kept(vertices, length);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (becomes[i] != static_cast<int>(i)) {
            becomes[i] = becomes[static_cast<std::size_t>(becomes[i])];
            continue;
        }
        const int near = kept.nearest(vertices[i]);
        if (near < 0) {
            kept.keep(static_cast<int>(i));
            continue;
        }
        becomes[i] = near;
        const double moved = (vertices[static_cast<std::size_t>(near)] - vertices[i]).norm();
        if (moved <= rounding_share * length) continue;
        if (done.n_joined++ == 0) done.at = vertices[i];
        done.moved = std::max(done.moved, moved);
    }
    return becomes;
}

void remove_degenerate(Mesh& mesh, Weld& done) {
    std::erase_if(mesh.triangles, [&](const std::array<int, 3>& t) {
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) return false;
        if (done.n_degenerate++ == 0) done.degenerate_at = mesh.vertices[static_cast<std::size_t>(t[0])];
        return true;
    });
}

void remove_doubled(Mesh& mesh, Weld& done) {
    std::vector<std::pair<std::array<int, 3>, std::size_t>> keys;
    keys.reserve(mesh.triangles.size());
    for (std::array<int, 3> t : mesh.triangles) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        keys.push_back({t, keys.size()});
    }
    std::sort(keys.begin(), keys.end());
    std::vector<bool> goes(keys.size(), false);
    for (std::size_t k = 1; k < keys.size(); ++k)
        if (keys[k].first == keys[k - 1].first) goes[keys[k].second] = true;
    std::vector<std::array<int, 3>> kept;
    kept.reserve(keys.size());
    for (std::size_t k = 0; k < goes.size(); ++k) {
        if (!goes[k])
            kept.push_back(mesh.triangles[k]);
        else if (done.n_doubled++ == 0)
            done.doubled_at = mesh.vertices[static_cast<std::size_t>(mesh.triangles[k][0])];
    }
    mesh.triangles = std::move(kept);
}

void drop_unused_vertices(Mesh& mesh) {
    std::vector<int> place(mesh.vertices.size(), -1);
    std::vector<Vec3> used;
    for (std::array<int, 3>& t : mesh.triangles)
        for (int& i : t) {
            int& to = place[static_cast<std::size_t>(i)];
            if (to < 0) {
                to = static_cast<int>(used.size());
                used.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
            }
            i = to;
        }
    mesh.vertices = std::move(used);
}

}  // namespace

double weld_length(const std::vector<Vec3>& vertices) {
    if (vertices.empty()) return 0;
    Vec3 low = vertices.front(), high = low;
    for (const Vec3& v : vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    return std::max(weld_fraction * (high - low).norm(), 2 * single_rounding * largest);
}

Weld weld(Mesh& mesh) {
    Weld done;
    const std::vector<int> becomes = join(mesh.vertices, done);
    for (std::array<int, 3>& t : mesh.triangles)
        for (int& i : t) i = becomes[static_cast<std::size_t>(i)];
    remove_degenerate(mesh, done);
    remove_doubled(mesh, done);
    drop_unused_vertices(mesh);
    return done;
}

}  // namespace abut::geometry
