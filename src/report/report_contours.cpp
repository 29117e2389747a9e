// SPDX-License-Identifier: GPL-3.0-or-later
// 1. Each patch is cut at the limits of the bands; the pieces' corners are rounded to a grid of a tenth of a pixel.
// 2. Every piece adds its directed edges to its band. Where two pieces meet, a->b and b->a cancel.
// 3. What is left has as many edges entering a point as leaving it: it falls into closed loops, which are the band's outline.
// A merged band has no seams inside; a thin stroke of its own colour closes the seams between bands.
#include "src/report/report_contours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "src/io/number_text.hpp"
#include "src/report/svg.hpp"

namespace abut::report {

namespace {

constexpr double steps_per_pixel = 10;
constexpr double largest_coordinate = 1e6;  ///< pixels; patches farther out cannot be seen

struct GridPoint {
    std::int32_t x, y;
    auto operator<=>(const GridPoint&) const = default;
};

struct DirectedEdge {
    GridPoint from, to;
    auto operator<=>(const DirectedEdge&) const = default;
};

struct Corner {
    Vec2 at{0, 0};
    double value = 0;
};

using BandEdges = std::array<std::vector<DirectedEdge>, n_bands>;

/// Convex: a triangle or quadrilateral cut twice, each time with at most one corner more. On the stack: there are millions.
struct Polygon {
    std::array<Corner, 6> corner;
    std::size_t n = 0;

    void add(const Corner& c) { corner[n++] = c; }
    const Corner& after(std::size_t i) const { return corner[i + 1 < n ? i + 1 : 0]; }
};

std::int32_t nearest_step(double v) {
    return static_cast<std::int32_t>(v < 0 ? v - 0.5 : v + 0.5);
}
GridPoint rounded(const Vec2& p) {
    return {nearest_step(p.x() * steps_per_pixel), nearest_step(p.y() * steps_per_pixel)};
}

int band_of(double value) {
    return std::clamp(static_cast<int>(std::floor(value * n_bands)), 0, n_bands - 1);
}

bool drawable(const Patch& patch) {
    if (!std::isfinite(patch.middle)) return false;
    for (std::size_t i = 0; i < 4; ++i) {
        if (!std::isfinite(patch.value[i]) || !patch.at[i].allFinite()) return false;
        if (patch.at[i].cwiseAbs().maxCoeff() > largest_coordinate) return false;
    }
    return true;
}

/// Patches of graded grids often are smaller than a step: their pieces leave no edge.
bool is_one_point(const Patch& patch) {
    const GridPoint first = rounded(patch.at[0]);
    return first == rounded(patch.at[1]) && first == rounded(patch.at[2]) && first == rounded(patch.at[3]);
}

void add_polygon(const Polygon& polygon, std::vector<DirectedEdge>& edges) {
    GridPoint a = rounded(polygon.corner[0].at);
    for (std::size_t i = 0; i < polygon.n; ++i) {
        const GridPoint b = rounded(polygon.after(i).at);
        if (a != b) edges.push_back({a, b});
        a = b;
    }
}

/// The point of the edge where the value is reached. Taken from the lower to the higher end, whichever way the edge is
/// walked: the two pieces that share it get the same point.
Vec2 crossing(const Corner& a, const Corner& b, double level) {
    const Corner &low = a.value < b.value ? a : b, &high = a.value < b.value ? b : a;
    return low.at + (level - low.value) / (high.value - low.value) * (high.at - low.at);
}

/// The part of a convex polygon with sign * (value - level) >= 0.
Polygon clipped(const Polygon& polygon, double level, double sign) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.n; ++i) {
        const Corner &a = polygon.corner[i], &b = polygon.after(i);
        const double da = sign * (a.value - level), db = sign * (b.value - level);
        if (da >= 0) kept.add(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.add({crossing(a, b, level), level});
    }
    return kept;
}

/// A polygon in which the field is as good as linear.
void add_cut(const Polygon& polygon, BandEdges& bands) {
    double low = polygon.corner[0].value, high = low;
    for (std::size_t i = 1; i < polygon.n; ++i) {
        low = std::min(low, polygon.corner[i].value);
        high = std::max(high, polygon.corner[i].value);
    }
    for (int band = band_of(low); band <= band_of(high); ++band) {
        Polygon piece = polygon;
        if (band > 0) piece = clipped(piece, static_cast<double>(band) / n_bands, 1);
        if (band + 1 < n_bands) piece = clipped(piece, static_cast<double>(band + 1) / n_bands, -1);
        if (piece.n > 2) add_polygon(piece, bands[static_cast<std::size_t>(band)]);
    }
}

/// Within half a band: triangles around the middle would show nothing else.
bool is_nearly_linear(const Patch& patch) {
    const auto& v = patch.value;
    constexpr double half_band = 0.5 / n_bands;
    return std::abs(v[0] - v[1] + v[2] - v[3]) < half_band &&
           std::abs(0.25 * (v[0] + v[1] + v[2] + v[3]) - patch.middle) < half_band;
}

void add_patch(const Patch& patch, BandEdges& bands) {
    if (is_one_point(patch)) return;
    Polygon corners;
    Corner middle{Vec2(0, 0), patch.middle};
    double twice_area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        corners.add({patch.at[i], patch.value[i]});
        middle.at += 0.25 * patch.at[i];
        twice_area += geometry::cross(patch.at[i], patch.at[(i + 1) % 4]);
    }
    if (twice_area < 0)
        std::reverse(corners.corner.begin(),
                     corners.corner.begin() + 4);  // edges cancel only between patches of one orientation
    const auto band = [&](std::size_t i) { return band_of(corners.corner[i].value); };
    if (band(0) == band(1) && band(0) == band(2) && band(0) == band(3) && band(0) == band_of(patch.middle)) {
        add_polygon(corners, bands[static_cast<std::size_t>(band(0))]);
        return;
    }
    if (is_nearly_linear(patch)) return add_cut(corners, bands);
    for (std::size_t i = 0; i < 4; ++i) add_cut({{corners.corner[i], corners.after(i), middle, {}, {}, {}}, 3}, bands);
}

constexpr std::uint32_t flip = 0x80000000u;  // makes unsigned numbers ordered like signed ones

std::uint64_t packed(const GridPoint& p) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.x) ^ flip) << 32 | (static_cast<std::uint32_t>(p.y) ^ flip);
}

GridPoint unpacked(std::uint64_t p) {
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(p >> 32) ^ flip),
            static_cast<std::int32_t>(static_cast<std::uint32_t>(p) ^ flip)};
}

/// How often edges ran one way more than the other, by the edge without its direction. Open addressing: of some ten thousand
/// edges few are left, and sorting all of them to find these was a third of a report's time.
class EdgeBalance {
public:
    explicit EdgeBalance(std::size_t n_edges) : slots_(std::bit_ceil(2 * n_edges + 1)) {}

    void add(const DirectedEdge& e) {
        const std::uint64_t a = packed(e.from), b = packed(e.to);
        Slot& slot = find(std::min(a, b), std::max(a, b));
        slot.balance += a < b ? 1 : -1;
    }

    /// The edges that are left, ordered by their first points.
    std::vector<DirectedEdge> left() const {
        std::vector<DirectedEdge> edges;
        for (const Slot& s : slots_) {
            if (s.balance == 0) continue;
            const GridPoint a = unpacked(s.low), b = unpacked(s.high);
            edges.insert(edges.end(), static_cast<std::size_t>(std::abs(s.balance)),
                         s.balance > 0 ? DirectedEdge{a, b} : DirectedEdge{b, a});
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    }

private:
    struct Slot {
        std::uint64_t low = 0, high = 0;  ///< equal: empty, since no edge is a point
        int balance = 0;
    };

    Slot& find(std::uint64_t low, std::uint64_t high) {
        const std::size_t mask = slots_.size() - 1;
        std::uint64_t hash = (low * 0x9E3779B97F4A7C15u) ^ (high * 0xC2B2AE3D27D4EB4Fu);
        hash ^= hash >> 32;
        for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
            Slot& s = slots_[i];
            if (s.low == low && s.high == high) return s;
            if (s.low == s.high) {
                s.low = low;
                s.high = high;
                return s;
            }
        }
    }

    std::vector<Slot> slots_;
};

/// What is left when opposite edges have cancelled, ordered by their first points.
std::vector<DirectedEdge> without_pairs(const std::vector<DirectedEdge>& edges) {
    EdgeBalance balance(edges.size());
    for (const DirectedEdge& e : edges) balance.add(e);
    return balance.left();
}

std::vector<std::vector<GridPoint>> closed_loops(const std::vector<DirectedEdge>& edges) {
    std::vector<bool> used(edges.size(), false);
    const auto leaving = [&](const GridPoint& p) {
        auto i =
            static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), p,
                                                      [](const DirectedEdge& e, const GridPoint& q) { return e.from < q; }) -
                                     edges.begin());
        while (i < edges.size() && edges[i].from == p && used[i]) ++i;
        return i < edges.size() && edges[i].from == p ? i : edges.size();
    };
    std::vector<std::vector<GridPoint>> loops;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (used[start]) continue;
        std::vector<GridPoint> loop;
        for (std::size_t i = start; i < edges.size(); i = leaving(edges[i].to)) {
            used[i] = true;
            loop.push_back(edges[i].from);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Points in the middle of a straight run say nothing.
std::vector<GridPoint> simplified(const std::vector<GridPoint>& loop) {
    std::vector<GridPoint> kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const GridPoint &a = loop[(i + loop.size() - 1) % loop.size()], &b = loop[i], &c = loop[(i + 1) % loop.size()];
        const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
        if (ux * vy != uy * vx || ux * vx + uy * vy < 0) kept.push_back(b);
    }
    return kept;
}

void append_number(std::string& path, std::int32_t value) {
    const char last = path.back();
    if (value >= 0 && last >= '0' && last <= '9') path += ' ';
    path += std::to_string(value);
}

std::string path_of(const std::vector<std::vector<GridPoint>>& loops) {
    std::string path;
    for (const auto& loop : loops) {
        const std::vector<GridPoint> points = simplified(loop);
        if (points.size() < 3) continue;
        path += "M";
        append_number(path, points[0].x);
        append_number(path, points[0].y);
        path += "l";
        for (std::size_t i = 1; i < points.size(); ++i) {
            append_number(path, points[i].x - points[i - 1].x);
            append_number(path, points[i].y - points[i - 1].y);
        }
        path += "z";
    }
    return path;
}

}  // namespace

std::string band_color(int band) {
    return map_color((band + 0.5) / n_bands);
}

std::string filled_bands(const std::vector<Patch>& patches) {
    BandEdges bands;
    for (const Patch& patch : patches)
        if (drawable(patch)) add_patch(patch, bands);
    std::string paths;
    for (int band = 0; band < n_bands; ++band) {
        const std::string path = path_of(closed_loops(without_pairs(bands[static_cast<std::size_t>(band)])));
        if (path.empty()) continue;
        const std::string color = band_color(band);
        paths += "<path fill=\"" + color + "\" stroke=\"" + color + "\" d=\"" + path + "\"/>\n";
    }
    if (paths.empty()) return "";
    return "<g transform=\"scale(" + number_text(1 / steps_per_pixel, 3) +
           ")\" stroke-width=\"12\" stroke-linejoin=\"round\">\n" + paths + "</g>\n";
}

}  // namespace abut::report
