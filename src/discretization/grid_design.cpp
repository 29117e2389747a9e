// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/grid_design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/brep/monotone.hpp"
#include "src/base/ensure.hpp"

namespace abut {

namespace {

using geometry::Box2;
using geometry::Part;

constexpr double cells_over_diagonal = 14;  // of a plain part
constexpr double cells_over_extent = 4;     // at least, in each direction
constexpr double cells_across_wall = 4;
/// Cells along a wall are at most this many times as long as it is thick: quadratic splines are too stiff in bending beyond
/// (tip of a cantilever: 0.6 % at 7, 4 % at 21, 17 % at 71).
constexpr double longest_cell_per_wall = 5;
constexpr double cells_across_slot = 3;  // of a part's own slots: as many as a quadratic spline's support
constexpr double slot_floor = 0.001;     // of the largest cell: narrower slots are not resolved
constexpr double cells_per_radius = 3;
constexpr double cells_per_fillet_radius = 6;  // of holes and fillets: they raise the stress
constexpr double turn_of_feature = 0.25;       // radians of an edge's turning that get a size of their own
constexpr double corner_fraction = 0.1;        // of the largest cell, at re-entrant corners
constexpr double sharp_fraction = 1e-6;        // of the diagonal: what turns within less is a corner
constexpr double smallest_cell = 1e-12;        // of the coordinates: they keep two digits of it
constexpr int chords = 48;                     // scan lines in each direction that look for walls

/// A feature as one axis sees it.
struct SizeAlong {
    double low, high, size, growth;

    auto operator<=>(const SizeAlong&) const = default;
    double at(double v) const { return size + growth * std::max(0.0, std::max(low - v, v - high)); }
};

/// Those that ask for less than the largest cell somewhere between low and high, each once: thousands of places are looked at,
/// of which rows of like holes are one to an axis.
std::vector<SizeAlong> sizes_along(int axis, double low, double high, double largest,
                                   const std::vector<SizeFeature>& features) {
    std::vector<SizeAlong> sizes;
    for (const SizeFeature& f : features) {
        const SizeAlong along{f.box.min[axis], f.box.max[axis], f.size, f.growth};
        const double nearest = std::clamp(along.low, low, high), other = std::clamp(along.high, low, high);
        if (std::min(along.at(nearest), along.at(other)) < largest) sizes.push_back(along);
    }
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

double wanted_size(double v, double largest, const std::vector<SizeAlong>& sizes) {
    double size = largest;
    for (const SizeAlong& s : sizes) size = std::min(size, s.at(v));
    return size;
}

/// A crossing of the boundary with the line where coordinate 1 - axis is `at`.
struct Hit {
    double v, lean;  ///< where, and how that changes with `at`

    bool is_steep() const { return std::abs(lean) < 1; }
};

std::vector<Hit> hits(const std::vector<geometry::MonotonePiece>& pieces, int axis, double at) {
    std::vector<Hit> found;
    for (const geometry::MonotonePiece& p : pieces) {
        const int other = 1 - axis;
        if ((p.from[other] < at) == (p.to[other] < at)) continue;
        const double v = axis == 0 ? geometry::x_at(p, at) : geometry::y_at(p, at);
        const double lean = axis == 0 ? geometry::dx_dy(p, at) : geometry::dy_dx(p, at);
        found.push_back({v, lean});
    }
    std::sort(found.begin(), found.end(), [](const Hit& a, const Hit& b) { return a.v < b.v; });
    return found;
}

/// Material between two steep sides along scan lines: walls, which need cells across. Between them the part's own slots: a
/// spline that reaches across one would tie its arms together. Where the sides meet before the next scan line they make a
/// corner, and how far from it the line falls says nothing.
void append_walls(std::vector<SizeFeature>& features, const Part& local, int axis, double coarseness) {
    const Box2 box = bounding_box(local);
    const auto pieces = geometry::monotone_pieces(local);
    const std::array<double, 2> largest = largest_cells(local, coarseness);
    const double least = slot_floor * largest[static_cast<std::size_t>(axis)];
    const double half_strip = 0.5 * box.size()[1 - axis] / chords;
    for (int k = 0; k < chords; ++k) {
        const double at = box.min[1 - axis] + (k + 0.5) / chords * box.size()[1 - axis];
        const std::vector<Hit> found = hits(pieces, axis, at);
        for (std::size_t i = 0; i + 1 < found.size(); ++i) {
            const double width = found[i + 1].v - found[i].v, widening = found[i + 1].lean - found[i].lean;
            if (!found[i].is_steep() || !found[i + 1].is_steep() || std::abs(widening) * 2 * half_strip > width) continue;
            SizeFeature f;
            f.size = i % 2 == 0 ? coarseness * width / cells_across_wall : std::max(width / cells_across_slot, least);
            // only this axis is asked for: the other extent covers everything
            f.box = box;
            f.box.min[axis] = found[i].v;
            f.box.max[axis] = found[i + 1].v;
            f.box.min[1 - axis] = f.box.max[1 - axis] = std::numeric_limits<double>::infinity();
            features.push_back(f);
            const double longest = coarseness * longest_cell_per_wall * width;
            if (i % 2 != 0 || longest >= largest[static_cast<std::size_t>(1 - axis)]) continue;
            f.size = longest;
            f.box.min[1 - axis] = at - half_strip;
            f.box.max[1 - axis] = at + half_strip;
            f.box.min[axis] = f.box.max[axis] = std::numeric_limits<double>::infinity();
            features.push_back(f);
        }
    }
}

bool is_concave(const geometry::Curve& curve, double t0, double t1) {
    return curvature(curve, 0.5 * (t0 + t1)) < 0;
}

/// Lengths within which a curve's turning is not resolved: what bulges raises no stress; what is re-entrant does, however small
/// its radius, but a cusp has none.
struct NotResolved {
    double bulging, reentrant;
};

/// So many points of a portion of a curve for each radian that it turns, and its ends.
constexpr double points_per_radian = 4;

std::vector<Vec2> points_of(const geometry::Curve& curve, double t0, double t1, double turn) {
    const int n = 1 + static_cast<int>(points_per_radian * turn);
    std::vector<Vec2> points;
    for (int k = 0; k <= n; ++k) points.push_back(point(curve, t0 + (t1 - t0) * k / n));
    return points;
}

/// visit(box, radius, is_concave, t0, t1): a circle is one portion; other curves are halved until a portion turns so little
/// that its mean radius of curvature is all there is to know.
template <class Visit>
void for_curved_portions(const geometry::Curve& curve, double t0, double t1, const NotResolved& least, const Visit& visit) {
    if (const auto* arc = std::get_if<geometry::Arc>(&curve))
        return visit(bounding_box(curve), arc->radius, arc->sweep < 0, 0.0, 1.0);
    const double turn = turning(curve, t0, t1), size = length(curve, t0, t1);
    const bool concave = is_concave(curve, t0, t1);
    if (turn <= turn_of_feature) {
        if (turn > 0) visit(bounding_box(trimmed(curve, t0, t1)), size / turn, concave, t0, t1);
        return;
    }
    if (size <= (concave ? least.reentrant : least.bulging)) return;
    const double middle = 0.5 * (t0 + t1);
    for_curved_portions(curve, t0, middle, least, visit);
    for_curved_portions(curve, middle, t1, least, visit);
}

}  // namespace

std::vector<double> graded_lines(double low, double high, int axis, double largest, const std::vector<SizeFeature>& features) {
    ENSURE(low < high && largest > 0 && (axis == 0 || axis == 1), "lines are set between two ends along x or y");
    constexpr double steps_per_cell = 24;
    const double least = smallest_cell * std::max(std::abs(low), std::abs(high));
    const std::vector<SizeAlong> sizes = sizes_along(axis, low, high, largest, features);
    std::vector<double> v{low}, count{0};
    while (v.back() < high) {
        const double size = std::max(least, wanted_size(v.back(), largest, sizes));
        const double next = std::min(high, v.back() + size / steps_per_cell);
        const double middle = std::max(least, wanted_size(0.5 * (v.back() + next), largest, sizes));
        count.push_back(count.back() + (next - v.back()) / middle);
        v.push_back(next);
    }
    const int n = std::max(1, static_cast<int>(std::ceil(count.back() - 1e-9)));
    std::vector<double> lines{low};
    std::size_t i = 0;
    for (int k = 1; k < n; ++k) {
        const double target = count.back() * k / n;
        while (count[i + 1] < target) ++i;
        lines.push_back(v[i] + (target - count[i]) / (count[i + 1] - count[i]) * (v[i + 1] - v[i]));
    }
    lines.push_back(high);
    return lines;
}

ShapeFeatures shape_features(const Part& local, double coarseness) {
    ShapeFeatures features;
    for (int axis : {0, 1}) append_walls(features.walls, local, axis, coarseness);
    const auto largest = largest_cells(local, coarseness);
    const NotResolved least{slot_floor * std::min(largest[0], largest[1]), sharp_fraction * bounding_box(local).diagonal()};
    for (const geometry::Loop& loop : local.loops)
        for (std::size_t i = 0; i < loop.edges.size(); ++i) {
            const geometry::Edge& edge = local.edges[static_cast<std::size_t>(loop.edges[i])];
            const geometry::Edge& next = local.edges[static_cast<std::size_t>(loop.edges[(i + 1) % loop.edges.size()])];
            for_curved_portions(
                edge.curve, 0, 1, least, [&](const Box2& box, double radius, bool concave, double t0, double t1) {
                    features.places.push_back({box,
                                               coarseness * radius / (concave ? cells_per_fillet_radius : cells_per_radius),
                                               size_growth, points_of(edge.curve, t0, t1, turning(edge.curve, t0, t1))});
                });
            const double turn = geometry::cross(geometry::unit_tangent(edge.curve, 1), geometry::unit_tangent(next.curve, 0));
            if (turn < -0.1) {
                Box2 at;
                at.extend(geometry::point(edge.curve, 1));
                features.places.push_back({at, corner_fraction * std::min(largest[0], largest[1])});
            }
        }
    return features;
}

double reentrant_radius(const Part& local, const Box2& near) {
    const double sharp = sharp_fraction * bounding_box(local).diagonal();
    double smallest = std::numeric_limits<double>::infinity();
    for (const geometry::Edge& edge : local.edges)
        if (bounding_box(edge.curve).overlaps(near, 0))
            for_curved_portions(edge.curve, 0, 1, {sharp, sharp},
                                [&](const Box2& box, double radius, bool concave, double, double) {
                                    if (concave && box.overlaps(near, 0)) smallest = std::min(smallest, radius);
                                });
    return smallest;
}

std::array<double, 2> largest_cells(const Part& local, double coarseness) {
    const Box2 box = bounding_box(local);
    const double by_diagonal = box.diagonal() / cells_over_diagonal;
    return {coarseness * std::min(by_diagonal, box.size().x() / cells_over_extent),
            coarseness * std::min(by_diagonal, box.size().y() / cells_over_extent)};
}

}  // namespace abut
