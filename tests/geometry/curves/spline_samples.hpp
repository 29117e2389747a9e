// SPDX-License-Identifier: GPL-3.0-or-later
// Splines, drawn at random and otherwise, on which tests of their shapes run.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::test {

inline const SplineShape& shape_of(const Curve& curve) {
    return *std::get<Spline>(curve).shape;
}

/// Random splines: degree 1 to 8, clamped or not, knots of random multiplicity up to the degree, with weights or without.
struct RandomSplines {
    std::mt19937 random;
    explicit RandomSplines(unsigned seed) : random(seed) {}
    double unit() { return std::uniform_real_distribution<double>(0, 1)(random); }

    std::vector<double> knots(int degree, std::size_t n_points, bool clamped, bool multiple) {
        std::vector<double> list{unit()};
        while (list.size() < n_points + static_cast<std::size_t>(degree) + 1) {
            const int times = multiple && unit() < 0.4 ? 1 + static_cast<int>(unit() * degree) : 1;
            const double next = list.back() + 0.2 + unit();
            for (int k = 0; k < times; ++k) list.push_back(next);
        }
        list.resize(n_points + static_cast<std::size_t>(degree) + 1);
        if (!clamped) return list;
        const auto n = static_cast<std::ptrdiff_t>(degree);
        std::fill(list.begin(), list.begin() + n + 1, list.front() - 1);
        std::fill(list.end() - n - 1, list.end(), list[list.size() - static_cast<std::size_t>(n) - 2] + 1);
        return list;
    }
    Nurbs operator()(int degree, bool clamped, bool multiple, bool weighted) {
        Nurbs nurbs;
        nurbs.degree = degree;
        const std::size_t n_points = static_cast<std::size_t>(degree) + 1 + static_cast<std::size_t>(unit() * 8);
        do nurbs.knots = knots(degree, n_points, clamped, multiple);
        while (!(nurbs.knots[static_cast<std::size_t>(degree)] < nurbs.knots[n_points]));
        for (std::size_t i = 0; i < n_points; ++i) nurbs.points.push_back({4 * unit() - 2, 4 * unit() - 2});
        for (std::size_t i = 0; weighted && i < n_points; ++i) nurbs.weights.push_back(0.2 + 2 * unit());
        return nurbs;
    }
};

/// A full circle of radius 1 about the origin: the square of nine points.
inline Nurbs circle() {
    const double w = std::sqrt(0.5);
    return {2,
            {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
            {1, w, 1, w, 1, w, 1, w, 1}};
}

/// Clamped at 0 and 1, without weights.
inline Nurbs with_interior_knots(int degree, std::vector<double> interior, std::vector<Vec2> points) {
    Nurbs nurbs{degree, std::vector<double>(static_cast<std::size_t>(degree) + 1, 0.0), std::move(points), {}};
    nurbs.knots.insert(nurbs.knots.end(), interior.begin(), interior.end());
    nurbs.knots.insert(nurbs.knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
    return nurbs;
}

/// Length by the chords of n, 2n and 4n equal steps, extrapolated twice: the error is of the sixth order where u is smooth.
inline double length_by_chords(const SplineShape& shape, double u0, double u1, int n) {
    const auto chords = [&](int pieces) {
        const auto at = [&](int k) { return evaluate(shape, u0 + (u1 - u0) * k / pieces)[0]; };
        double sum = 0;
        for (int k = 0; k < pieces; ++k) sum += (at(k + 1) - at(k)).norm();
        return sum;
    };
    const double a = chords(n), b = chords(2 * n), c = chords(4 * n);
    const double first = (4 * b - a) / 3, second = (4 * c - b) / 3;
    return (16 * second - first) / 15;
}
inline double length_by_chords(const SplineShape& shape, int n) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < shape.breaks.size(); ++k)
        sum += length_by_chords(shape, shape.breaks[k], shape.breaks[k + 1], n);
    return sum;
}

}  // namespace abut::geometry::test
