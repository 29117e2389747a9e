// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/terms/finite_motion.hpp"

#include "solver/assembly/ring.hpp"
#include "solver/terms/stress.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::VectorXd;

Matrix2d matrix_of(const Eigen::Vector3d& stress) {
    Matrix2d m;
    m << stress[0], stress[2], stress[2], stress[1];
    return m;
}

/// The stress of the quadratic strain of a displacement whose hoop strain (0 without an axis) is `hoop`.
Matrix2d quadratic_stress(const Elasticity& d, const Matrix2d& G, double hoop) {
    const Matrix2d strain = 0.5 * G.transpose() * G;
    return matrix_of(stress_of(d, strain)) + 0.5 * d.d12 * hoop * hoop * Matrix2d::Identity();
}

double strain_of(const Matrix2d& G) {
    return (0.5 * (G + G.transpose())).norm();
}

/// A displacement's gradient and stress at a point, and what they weigh in integrals over the part.
struct PointOfPart {
    int element;
    Vec2 x;
    double weight;
    DisplacementAt u;
    Matrix2d stress;
};

/// The displacement that strains the part: without that of its pulls.
VectorXd straining(const PartInput& input, const VectorXd& displacement) {
    const VectorXd own = elastic_displacement(input, displacement);
    return own.size() > 0 ? own : displacement;
}

/// Calls f(rule, points) for every element.
template <class F>
void for_all_points(const PartInput& input, const VectorXd& displacement, const StressOf& stress, const F& f) {
    ENSURE(!input.structure, "weighted functions have no loads of the second order");
    const VectorXd elastic = straining(input, displacement);
    std::vector<PointOfPart> points;
    for_all_cells(input, [&](const CellRule& rule) {
        const LocalSpline<2> u(input.space, rule.element, [&](int k) { return elastic.segment<2>(2 * k); });
        points.clear();
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            const SplineAt<2> here = u.at(rule.points[k]);
            const DisplacementAt at{here.value, here.gradient};
            points.push_back({rule.element, rule.points[k], input.thickness * rule.weights[k], at,
                              matrix_of(stress(rule.element, rule.points[k], at))});
        }
        f(rule, points);
    });
}

/// Strains above are those of sharp corners, where linear elasticity has no limit: what they leave out moves the corner's own
/// cells, by far, and nothing else. A tenth, and what all of the part is strained by on top.
double largest_strain(const PartInput& input, const VectorXd& displacement) {
    constexpr double large = 0.1, beside_mean = 3;
    const VectorXd elastic = straining(input, displacement);
    double sum = 0, area = 0;
    for_all_cells(input, [&](const CellRule& rule) {
        const LocalSpline<2> u(input.space, rule.element, [&](int k) { return elastic.segment<2>(2 * k); });
        for (std::size_t k = 0; k < rule.points.size(); ++k) {
            sum += rule.weights[k] * strain_of(u.at(rule.points[k]).gradient);
            area += rule.weights[k];
        }
    });
    return large + beside_mean * sum / area;
}

}  // namespace

VectorXd finite_motion_load(const PartInput& input, const VectorXd& displacement) {
    const StressOf stress(input, displacement);
    const Elasticity& d = input.elasticity;
    const double most = largest_strain(input, displacement);
    VectorXd load = VectorXd::Zero(2 * input.space.n_functions);
    Sampled at;
    for_all_points(input, displacement, stress, [&](const CellRule& rule, const std::vector<PointOfPart>& points) {
        sample(input.space, rule.element, rule.points, at);
        const auto n = static_cast<Index>(points.size());
        Eigen::MatrixXd second(n, 4);  // xx, xy, yx, yy
        VectorXd of_hoop = VectorXd::Zero(n);
        for (Index k = 0; k < n; ++k) {
            const PointOfPart& p = points[static_cast<std::size_t>(k)];
            const Matrix2d& G = p.u.gradient;
            if (strain_of(G) > most) {
                second.row(k).setZero();
                continue;
            }
            const double hoop = input.axis ? hoop_strain(input, p.x, p.u) : 0;
            const Matrix2d P = p.weight * (G * p.stress + quadratic_stress(d, G, hoop));
            second.row(k) << P(0, 0), P(0, 1), P(1, 0), P(1, 1);
            if (!input.axis) continue;
            const double zz = hoop * stress.zz(p.element, p.x) + 0.5 * (d.d11 * hoop * hoop + d.d12 * G.squaredNorm());
            of_hoop[k] = p.weight * zz / radius(input, p.x);
        }
        const Extraction e = extraction(input.space, rule.element);
        add_to_component(load, 0, e, -at.dx.transpose() * second.col(0) - at.dy.transpose() * second.col(1));
        add_to_component(load, 1, e, -at.dx.transpose() * second.col(2) - at.dy.transpose() * second.col(3));
        if (input.axis) add_to_component(load, 0, e, -at.value.transpose() * of_hoop);
    });
    return load;
}

Matrix2d stress_integral(const PartInput& input, const VectorXd& displacement) {
    const StressOf stress(input, displacement);
    Matrix2d sum = Matrix2d::Zero();
    for_all_points(input, displacement, stress, [&](const CellRule&, const std::vector<PointOfPart>& points) {
        for (const PointOfPart& p : points) sum += p.weight * p.stress;
    });
    return sum;
}

double stretching_work(const PartInput& input, const VectorXd& displacement, const VectorXd& added) {
    const StressOf stress(input, displacement);
    const double most = largest_strain(input, displacement);
    double work = 0;
    for_all_points(input, displacement, stress, [&](const CellRule& rule, const std::vector<PointOfPart>& points) {
        const LocalSpline<2> v(input.space, rule.element, [&](int k) { return added.segment<2>(2 * k); });
        for (const PointOfPart& p : points) {
            const Matrix2d& G = p.u.gradient;
            if (strain_of(G) > most) continue;
            const SplineAt<2> more = v.at(p.x);
            double hoop = 0, of_added = 0;
            if (input.axis) {
                hoop = hoop_strain(input, p.x, p.u);
                of_added = hoop_strain(input, p.x, {more.value, more.gradient});
            }
            const Matrix2d tension = quadratic_stress(input.elasticity, G, hoop) +
                                     matrix_of(stress_of(input.elasticity, more.gradient)) +
                                     input.elasticity.d12 * of_added * Matrix2d::Identity();
            work += p.weight * (G * tension).cwiseProduct(G).sum();
        }
    });
    return work;
}

}  // namespace abut::solver
