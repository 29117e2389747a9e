// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a space on one element, as combinations of its B-splines: what many points of one element share is done once, and
// no memory is asked for.
#pragma once
#include <array>

#include "solver/splines/spline_space.hpp"

namespace abut::solver {

/// N fields at a point; gradients by row.
template <int N>
struct SplineAt {
    Eigen::Matrix<double, N, 1> value;
    Eigen::Matrix<double, N, 2> gradient;
};

/// The B-splines of one direction at an abscissa.
struct LineValues {
    LocalValues value, slope;
};

template <int N>
/// N fields of a space on one element; the space must outlive it.
class LocalSpline {
public:
    using Values = Eigen::Matrix<double, N, 1>;

    /// coefficient(f): (N) of function f of the space. Cost: the entries of the element's rows.
    template <class Coefficient>
    LocalSpline(const SplineSpace& space, int element, const Coefficient& coefficient)
        : x_(space.along_x(element)), y_(space.along_y(element)) {
        LocalFunctions branches;
        const std::size_t n = local_functions(space, element, branches);
        for (std::size_t k = 0; k < n; ++k) {
            const auto branch = static_cast<std::size_t>(branches[k]);
            factor_[k].setZero();
            for (auto e = static_cast<std::size_t>(space.first[branch]); e < static_cast<std::size_t>(space.first[branch + 1]);
                 ++e)
                factor_[k] += space.coefficient[e] * coefficient(space.function[e]);
        }
    }

    Values value(const Vec2& x) const {
        LocalValues vx, vy;
        evaluate(x_, x.x(), vx);
        evaluate(y_, x.y(), vy);
        return value(vx, vy);
    }

    /// The value where the B-splines of the element's column and row are at hand.
    Values value(const LocalValues& along_x, const LocalValues& along_y) const {
        Values sum = Values::Zero();
        const Factor* factor = factor_.data();
        for (std::size_t b = 0; b <= degree(y_); ++b) sum += along_y[b] * combined(along_x, factor);
        return sum;
    }

    SplineAt<N> at(const Vec2& x) const {
        LineValues along_x, along_y;
        evaluate(x_, x.x(), along_x.value, along_x.slope);
        evaluate(y_, x.y(), along_y.value, along_y.slope);
        return at(along_x, along_y);
    }

    /// The value and gradient where the B-splines of the element's column and row are at hand.
    SplineAt<N> at(const LineValues& along_x, const LineValues& along_y) const {
        const auto& [vx, gx] = along_x;
        const auto& [vy, gy] = along_y;
        SplineAt<N> result{Values::Zero(), Eigen::Matrix<double, N, 2>::Zero()};
        const Factor* factor = factor_.data();
        for (std::size_t b = 0; b <= degree(y_); ++b) {
            const Factor* row = factor;
            result.gradient.col(0) += vy[b] * combined(gx, row);
            const Values along = combined(vx, factor);
            result.value += vy[b] * along;
            result.gradient.col(1) += gy[b] * along;
        }
        return result;
    }

private:
    using Factor = Values;

    static std::size_t degree(const IntervalKnots& knots) { return static_cast<std::size_t>(knots.degree); }
    /// The sum over one row of B-splines; factor goes on to the next.
    Values combined(const LocalValues& values, const Factor*& factor) const {
        Values sum = Values::Zero();
        for (std::size_t a = 0; a <= degree(x_); ++a) sum += values[a] * *factor++;
        return sum;
    }

    IntervalKnots x_, y_;
    std::array<Factor, (max_degree + 1) * (max_degree + 1)> factor_;
};

}  // namespace abut::solver
