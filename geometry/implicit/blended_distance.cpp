// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/blended_distance.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "geometry/brep/edge_tree.hpp"
#include "geometry/implicit/boundary_side.hpp"
#include "geometry/implicit/cardinal_spline.hpp"
#include "geometry/implicit/field_shape.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

BlendedDistance completed(const Part& part, BlendedDistance options) {
    if (options.delta == 0) options.delta = strip_width(part);
    if (options.cell == 0) options.cell = std::max(2 * options.delta, bounding_box(part).diagonal() / finest_default_grid);
    ENSURE(std::isfinite(options.delta) && options.delta > 0, "the width of a blend is positive");
    ENSURE(std::isfinite(options.cell) && options.cell > 0, "the cells of a blend have a size");
    ENSURE(options.degree >= 1 && options.degree <= max_cardinal_degree, "the degree of a blend is 1 to 8");
    ENSURE(options.gamma >= 1 && options.m >= 1, "the exponents of a blend are 1 at least");
    return options;
}

/// Splines whose support comes within delta of the part: from `first`, n of them, in each direction.
struct SplineGrid {
    Vec2 origin{0, 0};
    int first[2] = {0, 0}, n[2] = {0, 0};

    bool holds(int kx, int ky) const {
        return kx >= first[0] && kx < first[0] + n[0] && ky >= first[1] && ky < first[1] + n[1];
    }
    std::size_t index(int kx, int ky) const {
        return static_cast<std::size_t>(ky - first[1]) * static_cast<std::size_t>(n[0]) +
               static_cast<std::size_t>(kx - first[0]);
    }
};

SplineGrid grid_of(const Box2& box, const BlendedDistance& options) {
    SplineGrid grid;
    grid.origin = box.min;
    const double margin = options.delta / options.cell;
    for (int axis = 0; axis < 2; ++axis) {
        grid.first[axis] = static_cast<int>(std::floor(-margin)) - options.degree - 1;
        const int last = static_cast<int>(std::ceil(box.size()[axis] / options.cell + margin));
        grid.n[axis] = last - grid.first[axis] + 1;
    }
    return grid;
}

class Blend {
public:
    /// of: the edges whose distance it is, with a sign where they are all of the part's.
    Blend(const Part& part, const Part& of, bool has_sides, const BlendedDistance& options)
        : options_(completed(part, options)),
          side_(boundary_side(part)),
          has_sides_(has_sides),
          grid_(grid_of(bounding_box(part), options_)) {
        for (const Edge& edge : of.edges) curves_.push_back(edge.curve);
        const EdgeTree tree(of);
        for (int ky = grid_.first[1]; ky < grid_.first[1] + grid_.n[1]; ++ky)
            for (int kx = grid_.first[0]; kx < grid_.first[0] + grid_.n[0]; ++kx)
                near_.push_back(tree.near(support(kx, ky), options_.delta));
    }

    template <class T>
    T operator()(const PointOf<T>& p) const {
        const Vec2 local = in_grid(position(p));
        const CardinalValues in_x = cardinal_splines(options_.degree, local.x());
        const CardinalValues in_y = cardinal_splines(options_.degree, local.y());
        Query<T> query{p, !has_sides_ || contains(side_.pieces, position(p)), {}};
        T sum(0);
        for (int j = 0; j <= options_.degree; ++j)
            for (int i = 0; i <= options_.degree; ++i)
                sum += spline<T>(in_x, in_y, i, j) * weight(in_x.first + i, in_y.first + j, query);
        return sum;
    }

private:
    /// A point, and what is known of it: most edges are near several splines, their distances are found once.
    template <class T>
    struct Query {
        PointOf<T> p;
        bool inside;
        std::vector<std::pair<int, NearCurve<T>>> known;
    };

    /// In units of cells. Beyond the grid no spline has edges near it, however far: what follows is counted in ints.
    Vec2 in_grid(const Vec2& p) const {
        Vec2 local = (p - grid_.origin) / options_.cell;
        for (int axis = 0; axis < 2; ++axis)
            local[axis] =
                std::clamp(local[axis], grid_.first[axis] - 1.0, grid_.first[axis] + grid_.n[axis] + options_.degree + 1.0);
        return local;
    }

    Box2 support(int kx, int ky) const {
        Box2 box;
        box.extend(grid_.origin + options_.cell * Vec2(kx, ky));
        box.extend(box.min + Vec2::Constant(options_.cell * (options_.degree + 1)));
        return box;
    }

    template <class T>
    T spline(const CardinalValues& in_x, const CardinalValues& in_y, int i, int j) const {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const double v = in_x.value[a] * in_y.value[b];
        if constexpr (std::is_same_v<T, Jet>) {
            const double c = 1 / options_.cell;
            return {v,
                    c * in_x.slope[a] * in_y.value[b],
                    c * in_x.value[a] * in_y.slope[b],
                    c * c * in_x.bend[a] * in_y.value[b],
                    c * c * in_x.slope[a] * in_y.slope[b],
                    c * c * in_x.value[a] * in_y.bend[b]};
        } else {
            return v;
        }
    }

    template <class T>
    NearCurve<T> distance(int edge, Query<T>& query) const {
        for (const auto& [e, near] : query.known)
            if (e == edge) return near;
        query.known.emplace_back(edge, curve_distance(curves_[static_cast<std::size_t>(edge)], query.p));
        return query.known.back().second;
    }

    /// w_k.
    template <class T>
    T weight(int kx, int ky, Query<T>& query) const {
        const double flat = options_.delta / options_.gamma;
        std::vector<NearCurve<T>> near;
        if (grid_.holds(kx, ky))
            for (const int edge : near_[grid_.index(kx, ky)]) near.push_back(distance(edge, query));
        if (near.empty()) return T(query.inside ? flat : -flat);
        const NearCurve<T> all = joined(near, options_.m);
        const T d = has_sides_ ? with_side(all, side_.on_edge, query.inside) : without_side(all, side_.on_edge);
        return d < T(0) ? T(-cut_off(T(-d))) : cut_off(d);
    }

    template <class T>
    T cut_off(const T& d) const {
        const double flat = options_.delta / options_.gamma;
        const T rest = 1 - d / options_.delta;
        return rest > T(0) ? T(flat * (1 - integer_power(rest, options_.gamma))) : T(flat);
    }

    BlendedDistance options_;
    BoundarySide side_;
    bool has_sides_;
    SplineGrid grid_;
    std::vector<Curve> curves_;
    std::vector<std::vector<int>> near_;
};

double largest_curvature(const Curve& curve) {
    if (std::holds_alternative<Segment>(curve)) return 0;
    std::vector<double> cuts = axis_extrema(curve);
    for (const double t : smoothness_breaks(curve)) cuts.push_back(t);
    cuts.push_back(0);
    cuts.push_back(1);
    std::sort(cuts.begin(), cuts.end());
    double largest = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        for (int s = 0; s <= n_curvature_samples; ++s)
            largest =
                std::max(largest, std::abs(curvature(curve, cuts[i] + (cuts[i + 1] - cuts[i]) * s / n_curvature_samples)));
    return largest;
}

}  // namespace

double strip_width(const Part& part) {
    double width = widest_strip_fraction * bounding_box(part).diagonal();
    for (const Edge& edge : part.edges) {
        const double k = largest_curvature(edge.curve);
        if (k > 0) width = std::min(width, 0.5 / k);
    }
    return width;
}

ImplicitField blended_distance(const Part& part, const BlendedDistance& options) {
    ENSURE(!part.edges.empty(), "a part has edges");
    return make_field(Blend(part, part, true, options));
}

ImplicitField blended_edge_distance(const Part& part, const std::vector<int>& edges, const BlendedDistance& options) {
    ENSURE(!edges.empty(), "a field is of some edges");
    Part chosen;
    for (const int e : edges) {
        ENSURE(e >= 0 && static_cast<std::size_t>(e) < part.edges.size(), "the edge is one of the part's");
        chosen.edges.push_back(part.edges[static_cast<std::size_t>(e)]);
    }
    return make_field(Blend(part, chosen, false, options));
}

}  // namespace abut::geometry
