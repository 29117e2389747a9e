// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/recovery.hpp"

#include <algorithm>
#include <tuple>

namespace abut::solver {

namespace {

using Eigen::Index;

struct NormalEquations {
    std::vector<std::tuple<int, int, double>> entries;  // (column, row >= column, value)
    Eigen::MatrixX3d rhs;
};

/// Adds one element's samples: dense within it, then its lower triangle.
void add_element(NormalEquations& eq, const PartInput& input, const SplineSpace& space, const Eigen::VectorXd& displacement,
                 int element, const std::vector<Vec2>& points) {
    const std::vector<int> functions = extraction(space, element).functions;
    const auto n = static_cast<Index>(functions.size());
    Eigen::MatrixXd b(static_cast<Index>(points.size()), n);
    Eigen::MatrixX3d s(b.rows(), 3);
    for (std::size_t k = 0; k < points.size(); ++k) {
        b.row(static_cast<Index>(k)) = evaluate(space, element, points[k]).value.transpose();
        s.row(static_cast<Index>(k)) =
            stress_of(input.elasticity, displacement_at(input, displacement, element, points[k]).gradient).transpose();
    }
    const Eigen::MatrixXd m = b.transpose() * b;
    const Eigen::MatrixX3d r = b.transpose() * s;
    for (Index j = 0; j < n; ++j) {
        eq.rhs.row(functions[static_cast<std::size_t>(j)]) += r.row(j);
        for (Index i = 0; i < n; ++i)
            if (functions[static_cast<std::size_t>(i)] >= functions[static_cast<std::size_t>(j)])
                eq.entries.emplace_back(functions[static_cast<std::size_t>(j)], functions[static_cast<std::size_t>(i)],
                                        m(i, j));
    }
}

SparseSymmetric assembled(std::vector<std::tuple<int, int, double>>& entries, int n) {
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    SparseSymmetric m;
    m.n = n;
    m.first.assign(static_cast<std::size_t>(n) + 1, 0);
    int last_column = -1;
    for (const auto& [column, row, value] : entries) {
        if (column == last_column && m.row.back() == row) {
            m.value.back() += value;
            continue;
        }
        last_column = column;
        m.row.push_back(row);
        m.value.push_back(value);
        ++m.first[static_cast<std::size_t>(column) + 1];
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(n); ++c) m.first[c + 1] += m.first[c];
    return m;
}

std::vector<Vec2> full_cell_points(const SplineSpace& s, int element, const std::vector<double>& inside) {
    const auto c = static_cast<std::size_t>(s.column_of(element)), r = static_cast<std::size_t>(s.row_of(element));
    const Vec2 a(s.x.breakpoints[c], s.y.breakpoints[r]), b(s.x.breakpoints[c + 1], s.y.breakpoints[r + 1]);
    std::vector<Vec2> points{a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    for (double v : inside)
        for (double u : inside) points.emplace_back(a.x() + u * (b.x() - a.x()), a.y() + v * (b.y() - a.y()));
    return points;
}

}  // namespace

StressField fit_stress(const PartInput& input, const Eigen::VectorXd& displacement, const std::vector<double>& inside,
                       const std::vector<SamplePoint>& cut) {
    const SplineSpace& from = input.space;
    StressField field;
    field.space = make_space({clamped_knots(from.x.breakpoints, std::max(1, from.x.degree - 1)),
                              clamped_knots(from.y.breakpoints, std::max(1, from.y.degree - 1)),
                              from.fraction,
                              from.splits,
                              Basis::web,
                              {}});
    field.out_of_plane = input.elasticity.out_of_plane;
    field.failure = field.space.failure;
    if (!field.failure.empty()) return field;

    NormalEquations eq{{}, Eigen::MatrixX3d::Zero(field.space.n_functions, 3)};
    std::vector<std::vector<Vec2>> points(from.fraction.size());
    for (std::size_t element = 0; element < from.fraction.size(); ++element)
        if (from.fraction[element] == 1) points[element] = full_cell_points(from, static_cast<int>(element), inside);
    for (const SamplePoint& p : cut) points[static_cast<std::size_t>(p.element)].push_back(p.x);
    for (std::size_t element = 0; element < points.size(); ++element)
        if (!points[element].empty())
            add_element(eq, input, field.space, displacement, static_cast<int>(element), points[element]);

    const Factorization factor(assembled(eq.entries, field.space.n_functions));
    if (!factor.ok()) {
        field.failure = "the stress fit is singular";
        return field;
    }
    field.coefficients.resize(field.space.n_functions, 3);
    for (Index k = 0; k < 3; ++k) field.coefficients.col(k) = factor.solve(eq.rhs.col(k));
    return field;
}

Eigen::Vector4d stress_at(const StressField& field, int element, const Vec2& x) {
    const PointBasis b = evaluate(field.space, element, x);
    Eigen::Vector3d s = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < b.functions.size(); ++i)
        s += b.value[static_cast<Index>(i)] * field.coefficients.row(b.functions[i]).transpose();
    return {s[0], s[1], s[2], field.out_of_plane * (s[0] + s[1])};
}

}  // namespace abut::solver
