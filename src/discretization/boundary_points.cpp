// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/discretization/boundary_points.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/curves/gauss.hpp"
#include "solver/assembly/ring.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

/// Integrals of a field over parts of a curve, by halving.
class Halving {
public:
    Halving(const geometry::Curve& curve, const EdgeField& field) : curve_(curve), field_(field) {}

    /// The parameters between t0 and t1 where quadrature has to begin anew, ascending.
    std::vector<double> cuts(double t0, double t1) {
        constexpr int pieces = 1 << least_depth;
        for (int k = 0; k < pieces; ++k)
            total_ += integral(std::lerp(t0, t1, k / double{pieces}), std::lerp(t0, t1, (k + 1) / double{pieces})).norm();
        if (total_ > 0 && std::isfinite(total_)) halve(t0, t1, integral(t0, t1), 0);
        return cuts_;
    }

private:
    static constexpr int least_depth = 9, most_depth = 24, points = 4;
    static constexpr double tolerance = 1e-6;  // of the whole

    Vec2 integral(double a, double b) const {
        const auto& rule = geometry::gauss_rule(points);
        Vec2 sum{0, 0};
        for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double t = std::lerp(a, b, rule.points[q]);
            sum +=
                rule.weights[q] * (b - a) * derivative(curve_, t).norm() * field_(point(curve_, t), outward_normal(curve_, t));
        }
        return sum;
    }

    /// The integral over a piece; cuts it where `whole`, by its own points, is not that.
    Vec2 halve(double a, double b, const Vec2& whole, int depth) {
        const double middle = 0.5 * (a + b);
        const std::size_t before = cuts_.size();
        Vec2 left = integral(a, middle), right = integral(middle, b);
        const auto is_whole = [&] { return (left + right - whole).norm() <= tolerance * total_; };
        if (depth >= most_depth || (depth >= least_depth && is_whole())) return left + right;
        left = halve(a, middle, left, depth + 1);
        const std::size_t in_left = cuts_.size();
        right = halve(middle, b, right, depth + 1);
        if (is_whole())
            cuts_.resize(before);
        else
            cuts_.insert(cuts_.begin() + static_cast<std::ptrdiff_t>(in_left), middle);
        return left + right;
    }

    const geometry::Curve& curve_;
    const EdgeField& field_;
    double total_ = 0;
    std::vector<double> cuts_;
};

}  // namespace

std::optional<int> grid_axis(const Vec2& local) {
    constexpr double parallel = 1e-12;  // sine of the angle that rounding leaves between a direction and a grid axis
    const int axis = std::abs(local.x()) > std::abs(local.y()) ? 0 : 1;
    return std::abs(local[1 - axis]) <= parallel ? std::optional<int>(axis) : std::nullopt;
}

std::vector<geometry::BoundaryPoint> boundary_points(const PartOnGrid& g, const EdgePortion& portion) {
    ENSURE(portion.edge >= 0 && at(portion.edge) < g.local.edges.size() && portion.t0 <= portion.t1,
           "a portion is one of the part's edges");
    const int degree = std::max(g.input.space.x.degree, g.input.space.y.degree);
    auto points = boundary_rule(g.local, g.cells, g.elements, portion.edge, portion.t0, portion.t1, degree + 2);
    if (g.input.axis)
        for (geometry::BoundaryPoint& p : points) p.weight *= std::max(0.0, solver::radius(g.input, p.x));
    return points;
}

std::vector<EdgePortion> cut_where_rough(const PartOnGrid& g, const EdgePortion& portion, const EdgeField& field) {
    std::vector<double> ends = Halving(g.local.edges[at(portion.edge)].curve, field).cuts(portion.t0, portion.t1);
    ends.insert(ends.begin(), portion.t0);
    ends.push_back(portion.t1);
    std::vector<EdgePortion> pieces;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) pieces.push_back({portion.part, portion.edge, ends[k], ends[k + 1]});
    return pieces;
}

}  // namespace abut
