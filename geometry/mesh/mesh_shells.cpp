// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh_shells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "geometry/mesh/mesh_edges.hpp"

namespace abut::geometry {

namespace {

using std::size_t;

Vec3 first_corner(const Mesh& mesh, size_t triangle) {
    return mesh.vertices[static_cast<size_t>(mesh.triangles[triangle][0])];
}

void turn(std::array<int, 3>& triangle) {
    std::swap(triangle[1], triangle[2]);
}

// ---- 1 and 2: orientation ----

/// Turns the smaller side of one patch; `turned` of each of its triangles is relative to the first.
void turn_minority(Mesh& mesh, const std::vector<int>& patch, const std::vector<char>& turned, Shells& shells) {
    const auto n = std::count_if(patch.begin(), patch.end(), [&](int t) { return turned[static_cast<size_t>(t)] == 1; });
    const char minority = 2 * n > static_cast<std::ptrdiff_t>(patch.size()) ? 0 : 1;
    for (int t : patch) {
        if (turned[static_cast<size_t>(t)] != minority) continue;
        turn(mesh.triangles[static_cast<size_t>(t)]);
        if (shells.n_turned++ == 0) shells.turned_at = first_corner(mesh, static_cast<size_t>(t));
    }
}

void agree_across_edges(Mesh& mesh, Shells& shells) {
    struct Neighbour {
        int triangle;
        char is_opposed;  ///< runs along the edge the same way: one of the two must turn
    };
    std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
    for (const MeshEdge& edge : edges_of(mesh)) {
        if (edge.sides.size() != 2) continue;
        const EdgeSide &a = edge.sides[0], &b = edge.sides[1];
        const char opposed = a.is_forward == b.is_forward ? 1 : 0;
        neighbours[static_cast<size_t>(a.triangle)].push_back({b.triangle, opposed});
        neighbours[static_cast<size_t>(b.triangle)].push_back({a.triangle, opposed});
    }
    std::vector<char> turned(mesh.triangles.size(), -1);
    for (size_t first = 0; first < turned.size(); ++first) {
        if (turned[first] >= 0) continue;
        turned[first] = 0;
        std::vector<int> patch{static_cast<int>(first)};
        for (size_t k = 0; k < patch.size(); ++k) {
            const auto t = static_cast<size_t>(patch[k]);
            for (const Neighbour& next : neighbours[t]) {
                char& its = turned[static_cast<size_t>(next.triangle)];
                if (its >= 0) continue;
                its = static_cast<char>(turned[t] ^ next.is_opposed);
                patch.push_back(next.triangle);
            }
        }
        turn_minority(mesh, patch, turned, shells);
    }
}

void turn_all(Mesh& mesh) {
    for (std::array<int, 3>& t : mesh.triangles) turn(t);
}

void note_inverted(const Mesh& mesh, Shells& shells) {
    if (shells.n_inverted++ == 0) shells.inverted_at = first_corner(mesh, 0);
}

// ---- 3: wedges about an edge ----

struct Side {
    double angle;
    bool ends;  ///< does a wedge of material end here (the angle growing)?
    int triangle;
};

/// The sides about the edge, from the widest empty sector on; of coincident ones those first that end a wedge.
std::vector<Side> around(const Mesh& mesh, const MeshEdge& edge) {
    const Vec3 &from = mesh.vertices[static_cast<size_t>(edge.from)], &to = mesh.vertices[static_cast<size_t>(edge.to)];
    const Vec3 axis = (to - from).normalized();
    const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
    std::vector<Side> sides;
    for (const EdgeSide& side : edge.sides) {
        const Vec3 r = mesh.vertices[static_cast<size_t>(side.apex)] - from;
        sides.push_back({std::atan2(r.dot(y), r.dot(x)), side.is_forward, side.triangle});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.angle < b.angle; });
    const size_t n = sides.size();
    size_t widest = 0;
    double width = -1;
    for (size_t k = 0; k < n; ++k) {
        const double gap =
            k > 0 ? sides[k].angle - sides[k - 1].angle : sides[0].angle + 2 * std::numbers::pi - sides[n - 1].angle;
        if (gap > width) widest = k, width = gap;
    }
    std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(widest), sides.end());
    const auto step = [&](size_t k) {
        const double d = sides[k].angle - sides[k - 1].angle;
        return d < 0 ? d + 2 * std::numbers::pi : d;
    };
    for (size_t first = 0, last = 1; first < n; first = last++) {
        while (last < n && step(last) <= coincident_angle) ++last;
        std::stable_partition(sides.begin() + static_cast<std::ptrdiff_t>(first),
                              sides.begin() + static_cast<std::ptrdiff_t>(last), [](const Side& s) { return s.ends; });
    }
    return sides;
}

/// Pairs of triangles that bound the same wedge of material; nothing if the wedges do not follow one after the other.
std::optional<std::vector<std::pair<int, int>>> wedges(const Mesh& mesh, const MeshEdge& edge) {
    const std::vector<Side> sides = around(mesh, edge);
    const size_t n = sides.size();
    if (n % 2 != 0) return std::nullopt;
    for (size_t k = 0; k < n; ++k)
        if (sides[k].ends == sides[(k + 1) % n].ends) return std::nullopt;
    std::vector<std::pair<int, int>> pairs;
    for (size_t k = 0; k < n; ++k)
        if (!sides[k].ends) pairs.push_back({sides[k].triangle, sides[(k + 1) % n].triangle});
    return pairs;
}

// ---- 4: what hangs together ----

class Union {
public:
    explicit Union(size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int i) {
        while (parent_[static_cast<size_t>(i)] != i) {
            int& up = parent_[static_cast<size_t>(i)];
            up = parent_[static_cast<size_t>(up)];
            i = up;
        }
        return i;
    }
    void join(int i, int j) {
        i = root(i), j = root(j);
        parent_[static_cast<size_t>(std::max(i, j))] = std::min(i, j);
    }

private:
    std::vector<int> parent_;
};

/// Triangles in one sense less those in the other, by shell.
std::map<int, int> balance(const MeshEdge& edge, Union& shells) {
    std::map<int, int> sum;
    for (const EdgeSide& side : edge.sides) sum[shells.root(side.triangle)] += side.is_forward ? 1 : -1;
    return sum;
}

void note(EdgeFault& fault, const Mesh& mesh, const MeshEdge& edge) {
    const Vec3 &a = mesh.vertices[static_cast<size_t>(edge.from)], &b = mesh.vertices[static_cast<size_t>(edge.to)];
    if (fault.n++ == 0) fault.at = 0.5 * (a + b);
    fault.length = std::max(fault.length, (b - a).norm());
}

struct Connected {
    Union shells;
    std::vector<bool> is_open;  ///< by root
    EdgeFault open, branching;
};

Connected connect(const Mesh& mesh, Shells& shells) {
    const std::vector<MeshEdge> edges = edges_of(mesh);
    Connected found{Union(mesh.triangles.size()), std::vector<bool>(mesh.triangles.size(), false), {}, {}};
    for (const MeshEdge& edge : edges)
        if (edge.sides.size() == 2) found.shells.join(edge.sides[0].triangle, edge.sides[1].triangle);
    for (const MeshEdge& edge : edges) {
        if (edge.sides.size() <= 2) continue;
        const auto pairs = wedges(mesh, edge);
        if (!pairs) continue;
        for (const auto& [a, b] : *pairs) found.shells.join(a, b);
        if (shells.n_told_apart++ == 0) shells.told_apart_at = mesh.vertices[static_cast<size_t>(edge.from)];
    }
    std::vector<int> open_triangles;
    for (const MeshEdge& edge : edges) {
        bool is_balanced = true;
        for (const auto& [root, sum] : balance(edge, found.shells)) {
            if (sum == 0) continue;
            is_balanced = false;
            for (const EdgeSide& side : edge.sides)
                if (found.shells.root(side.triangle) == root) open_triangles.push_back(side.triangle);
        }
        if (!is_balanced) note(edge.sides.size() == 1 ? found.open : found.branching, mesh, edge);
    }
    for (int t : open_triangles) found.is_open[static_cast<size_t>(found.shells.root(t))] = true;
    return found;
}

// ---- 5: volumes and cavities ----

Vec3 corner(const Mesh& mesh, const std::array<int, 3>& t, size_t k) {
    return mesh.vertices[static_cast<size_t>(t[k])];
}

/// How often the shell winds around the point (solid angles by van Oosterom and Strackee).
double winding_number(const Mesh& shell, const Vec3& p) {
    double sum = 0;
    for (const std::array<int, 3>& t : shell.triangles) {
        const Vec3 a = corner(shell, t, 0) - p, b = corner(shell, t, 1) - p, c = corner(shell, t, 2) - p;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        const double volume = a.dot(b.cross(c));
        sum += std::atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (2 * std::numbers::pi);
}

void append_triangles(Mesh& to, const Mesh& from) {
    const int shift = static_cast<int>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (const std::array<int, 3>& t : from.triangles) to.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

/// The smallest of the shells of positive volume around a point; -1 if none is.
int shell_around(const std::vector<Shell>& shells, const std::vector<double>& volumes, const Vec3& p) {
    int best = -1;
    for (size_t k = 0; k < shells.size(); ++k) {
        if (!shells[k].is_closed || volumes[k] <= 0) continue;
        if (best >= 0 && volumes[k] >= volumes[static_cast<size_t>(best)]) continue;
        if (winding_number(shells[k].mesh, p) > 0.5) best = static_cast<int>(k);
    }
    return best;
}

void settle_cavities(Shells& found) {
    std::vector<double> volumes;
    for (const Shell& shell : found.shells) volumes.push_back(signed_volume(shell.mesh));
    std::vector<int> around(found.shells.size(), -1);
    for (size_t k = 0; k < found.shells.size(); ++k) {
        Shell& shell = found.shells[k];
        if (!shell.is_closed || volumes[k] >= 0) continue;
        const std::array<int, 3>& t = shell.mesh.triangles.front();
        const Vec3 p = (corner(shell.mesh, t, 0) + corner(shell.mesh, t, 1) + corner(shell.mesh, t, 2)) / 3;
        around[k] = shell_around(found.shells, volumes, p);
        if (around[k] >= 0) continue;
        turn_all(shell.mesh);
        note_inverted(shell.mesh, found);
    }
    for (size_t k = 0; k < around.size(); ++k)
        if (around[k] >= 0) append_triangles(found.shells[static_cast<size_t>(around[k])].mesh, found.shells[k].mesh);
    size_t k = 0;
    std::erase_if(found.shells, [&](const Shell&) { return around[k++] >= 0; });
}

/// Adds triangles of a mesh to shells and renumbers their vertices.
class ShellBuilder {
public:
    explicit ShellBuilder(const Mesh& mesh) : mesh_(mesh), place_(mesh.vertices.size(), -1) {}
    /// One shell is built at a time.
    Mesh build(const std::vector<int>& triangles) {
        Mesh shell;
        std::vector<int> used;
        for (int index : triangles) {
            std::array<int, 3> t = mesh_.triangles[static_cast<size_t>(index)];
            for (int& i : t) {
                int& to = place_[static_cast<size_t>(i)];
                if (to < 0) {
                    to = static_cast<int>(shell.vertices.size());
                    shell.vertices.push_back(mesh_.vertices[static_cast<size_t>(i)]);
                    used.push_back(i);
                }
                i = to;
            }
            shell.triangles.push_back(t);
        }
        for (int i : used) place_[static_cast<size_t>(i)] = -1;
        return shell;
    }

private:
    const Mesh& mesh_;
    std::vector<int> place_;
};

}  // namespace

double signed_volume(const Mesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const Vec3 origin = mesh.vertices.front();  // near, so that a body far from the origin keeps its digits
    double sum = 0;
    for (const std::array<int, 3>& t : mesh.triangles)
        sum += (corner(mesh, t, 0) - origin).dot((corner(mesh, t, 1) - origin).cross(corner(mesh, t, 2) - origin));
    return sum / 6;
}

Shells split_shells(const Mesh& given) {
    Shells found;
    Mesh mesh = given;
    agree_across_edges(mesh, found);
    if (signed_volume(mesh) < 0) {
        turn_all(mesh);
        note_inverted(mesh, found);
    }
    Connected connected = connect(mesh, found);
    std::vector<std::vector<int>> closed;
    std::vector<int> open, index(mesh.triangles.size(), -1);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto root = static_cast<size_t>(connected.shells.root(static_cast<int>(t)));
        if (connected.is_open[root]) {
            open.push_back(static_cast<int>(t));
            continue;
        }
        if (index[root] < 0) {
            index[root] = static_cast<int>(closed.size());
            closed.emplace_back();
        }
        closed[static_cast<size_t>(index[root])].push_back(static_cast<int>(t));
    }
    ShellBuilder builder(mesh);
    for (const std::vector<int>& triangles : closed) found.shells.push_back({builder.build(triangles), true, {}, {}});
    settle_cavities(found);
    if (!open.empty()) found.shells.push_back({builder.build(open), false, connected.open, connected.branching});
    return found;
}

}  // namespace abut::geometry
