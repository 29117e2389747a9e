// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/assembly/assembly.hpp"

#include <gtest/gtest.h>

#include "tests/solver/splines/test_spaces.hpp"

namespace abut::solver::assembly_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::SpaceCase;

/// Integral of B'DB at the points of a finer rule, without extractions' products or one-dimensional matrices.
MatrixXd stiffness_by_points(const PartInput& part) {
    Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
    d << part.elasticity.d11, part.elasticity.d12, 0, part.elasticity.d12, part.elasticity.d11, 0, 0, 0, part.elasticity.d33;
    MatrixXd k = MatrixXd::Zero(2 * part.space.n_functions, 2 * part.space.n_functions);
    test::for_points(part, test::ell_boxes(part), part.space.x.degree + 2, [&](int cell, const Vec2& x, double w) {
        const PointBasis b = evaluate(part.space, cell, x);
        const auto n = static_cast<Index>(b.functions.size());
        MatrixXd strain = MatrixXd::Zero(3, 2 * n);
        std::vector<Index> at;
        for (Index i = 0; i < n; ++i) {
            strain.col(2 * i) << b.dx[i], 0, b.dy[i];
            strain.col(2 * i + 1) << 0, b.dy[i], b.dx[i];
            for (int c = 0; c < 2; ++c) at.push_back(2 * b.functions[static_cast<std::size_t>(i)] + c);
        }
        k(at, at) += part.thickness * w * strain.transpose() * d * strain;
    });
    return k;
}

double area_of(const PartInput& part) {
    double area = 0;
    for (const test::Box& b : test::ell_boxes(part)) area += b.area();
    return area;
}
Vec2 first_moment_of(const PartInput& part) {
    Vec2 moment = Vec2::Zero();
    for (const test::Box& b : test::ell_boxes(part)) moment += b.area() * Vec2(0.5 * (b.x0 + b.x1), 0.5 * (b.y0 + b.y1));
    return moment;
}

class Assembly : public testing::TestWithParam<SpaceCase> {
protected:
    PartInput part = test::ell(GetParam(), plane_strain(2000, 0.35), 1.7);
    Index n = part.space.n_functions;
};

}  // namespace

TEST(AssemblySideBySide, IsTheSameOnAnyNumberOfThreads) {
    const std::vector<double> x = test::grid_lines(0, 1.7, 80, false), y = test::grid_lines(0, 1.1, 70, false);
    PartInput part = test::part_of({{0, 0, 1.69, 0.5}, {0, 0.5, 0.8, 1.08}}, x, y, 2, Basis::web);
    ASSERT_FALSE(part.cut_rules.empty());
    const BlockMatrix alone = assemble_stiffness(part);
    ASSERT_GT(alone.n, 3000);  // else there are no three shares
    for (int threads : {2, 3, 16}) {
        part.threads = threads;
        const BlockMatrix together = assemble_stiffness(part);
        EXPECT_EQ(together.column, alone.column);
        EXPECT_EQ(together.block, alone.block) << threads;
    }
}

TEST_P(Assembly, StiffnessIsTheIntegralOfTheEnergy) {
    const MatrixXd k = test::dense(assemble_stiffness(part)), reference = stiffness_by_points(part);
    EXPECT_LT(test::relative_difference(k, reference), 1e-12);  // both exact: rounding only
    part.elasticity.d33 *= 1 + 1e-9;
    EXPECT_GT(test::relative_difference(test::dense(assemble_stiffness(part)), reference), 1e-12);
}

/// Equal cells are integrated once. Cells whose sides differ by more than rounding are not equal: a share of 1e-9, far below
/// what could be seen otherwise, is ten thousand times what the comparison allows.
TEST(AssemblyOfEqualCells, TakesCellsAsEqualOnlyWhereTheyDifferByRounding) {
    for (int degree = 1; degree <= 4; ++degree)
        for (double spread : {0.0, 1e-9, 1e-3})
            for (double offset : {0.0, 1e6}) {
                std::vector<double> x{offset}, y{-offset};
                for (int k = 0; k < 7; ++k) {
                    x.push_back(x.back() + 0.1 * (1 + spread * k));
                    y.push_back(y.back() + 0.3 * (1 - spread * k));
                }
                const test::Box box{x.front(), y.front(), x.back(), y.back()};
                const PartInput part = test::part_of({box}, x, y, degree, Basis::web);
                PartInput twin = part;  // the same with every cell called cut: by points
                for (std::size_t cell = 0; cell < 49; ++cell) {
                    std::vector<double> weights;
                    const std::size_t c = cell % 7, r = cell / 7;
                    const test::Box b{x[c], y[r], x[c + 1], y[r + 1]};
                    const std::vector<Vec2> points = test::rule_points(b, part.line_rule, weights);
                    twin.cut_rules.push_back({static_cast<int>(cell), points, weights});
                    twin.space.fraction[cell] = 0.999;
                }
                const MatrixXd k = test::dense(assemble_stiffness(part)), reference = test::dense(assemble_stiffness(twin));
                const double rounding = 1e-13 * (1 + offset / 0.1);  // of the grid lines, by their cells' sides
                EXPECT_LT(test::relative_difference(k, reference), rounding) << degree << " " << spread << " " << offset;
            }
}

TEST_P(Assembly, StiffnessIsSymmetricWithNonnegativeEnergy) {
    const BlockMatrix k = assemble_stiffness(part);
    const MatrixXd m = test::dense(k);
    for (int f = 0; f < k.n; ++f) {
        const Eigen::Matrix2d b = m.block<2, 2>(2 * f, 2 * f);
        EXPECT_NEAR(b(0, 1), b(1, 0), 1e-14 * m.cwiseAbs().maxCoeff());
    }
    const VectorXd energies = Eigen::SelfAdjointEigenSolver<MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_GT(energies[0], -1e-13 * energies[2 * n - 1]);
}

TEST_P(Assembly, StiffnessOfAnExtendedBasisHasNoOtherMotionThanTheRigidOnes) {
    if (GetParam().basis == Basis::plain) part = test::rectangle(2, 1, 4, 3, GetParam().degree, GetParam().uniform);
    MatrixXd m = test::dense(assemble_stiffness(part));
    const VectorXd s = m.diagonal().cwiseSqrt().cwiseInverse();
    m = s.asDiagonal() * m * s.asDiagonal();
    const VectorXd energies = Eigen::SelfAdjointEigenSolver<MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_LT(energies[2], 1e-12);
    EXPECT_GT(energies[3], 1e-6);  // condition numbers of degree 4 reach 1e5
}

TEST_P(Assembly, RigidMotionsCostNothing) {
    const BlockMatrix k = assemble_stiffness(part);
    const double scale = test::dense(k).cwiseAbs().maxCoeff();
    for (const RigidMotion& motion : {RigidMotion{{1, 0}, 0, {0, 0}}, {{0, 1}, 0, {0, 0}}, {{0, 0}, 1, {0.3, 0.8}}}) {
        const VectorXd u = coefficients_of(part.space, motion);
        EXPECT_LT(multiply(k, u).cwiseAbs().maxCoeff(), 1e-12 * scale);
        const VectorXd perturbed = u + 1e-6 * VectorXd::Unit(2 * n, n);
        EXPECT_GT(multiply(k, perturbed).cwiseAbs().maxCoeff(), 1e-12 * scale);
    }
}

TEST_P(Assembly, UniformStrainHasItsEnergy) {
    // u = (a x + b y, c x + e y)
    const double a = 0.01, b = -0.02, c = 0.005, e = 0.03;
    const VectorXd x = test::monomial(part.space, 1, 0), y = test::monomial(part.space, 0, 1);
    const VectorXd u = test::interleave(a * x + b * y, c * x + e * y);
    const Eigen::Vector3d strain(a, e, b + c);
    const Eigen::Vector3d stress = stress_of(part.elasticity, (Eigen::Matrix2d() << a, b, c, e).finished());
    const double energy = strain.dot(stress) * area_of(part) * part.thickness;
    EXPECT_NEAR(u.dot(multiply(assemble_stiffness(part), u)), energy, 1e-11 * energy);
}

TEST_P(Assembly, IntegralsOfTheFunctionsAddUpToThoseOfPolynomials) {
    const FunctionIntegrals f = integrate_functions(part);
    const VectorXd x = test::monomial(part.space, 1, 0), y = test::monomial(part.space, 0, 1);
    const double area = area_of(part);
    EXPECT_NEAR(f.value.sum(), area, 1e-12 * area);
    EXPECT_NEAR(f.value.dot(x), first_moment_of(part).x(), 1e-12 * area);
    EXPECT_NEAR(f.value.dot(y), first_moment_of(part).y(), 1e-12 * area);
    EXPECT_NEAR(f.dx.dot(x), area, 1e-12 * area);
    EXPECT_NEAR(f.dy.dot(y), area, 1e-12 * area);
    EXPECT_NEAR(f.dx.dot(y), 0, 1e-12 * area);
    EXPECT_NEAR(f.dy.dot(x), 0, 1e-12 * area);
}

TEST_P(Assembly, BodyLoadHasTheResultantOfItsField) {
    const VectorXd uniform = body_load(part, [](const Vec2&) { return Vec2(3, -2); });
    const double area = area_of(part) * part.thickness;
    const Vec2 center = first_moment_of(part) / area_of(part);
    const Resultant r = resultant_of(part.space, uniform);
    EXPECT_NEAR(r.force.x(), 3 * area, 1e-11 * area);
    EXPECT_NEAR(r.force.y(), -2 * area, 1e-11 * area);
    EXPECT_NEAR(r.moment, (center.x() * -2 - center.y() * 3) * area, 1e-11 * area);
    const VectorXd linear = body_load(part, [](const Vec2& x) { return Vec2(0, x.x()); });
    EXPECT_NEAR(resultant_of(part.space, linear).force.y(), center.x() * area, 1e-11 * area);
}

TEST_P(Assembly, BoundaryLoadHasTheResultantOfItsTractions) {
    // the right edge of the ell's foot, in cut cells
    const test::Box foot = test::ell_boxes(part)[0];
    const auto points =
        test::traction_on(part.space, {foot.x1, foot.y0}, {foot.x1, foot.y1}, {1, 0}, [](const Vec2&) { return Vec2(4, 5); });
    const Resultant r = resultant_of(part.space, boundary_load(part, points));
    const double length = (foot.y1 - foot.y0) * part.thickness;
    EXPECT_NEAR(r.force.x(), 4 * length, 1e-11 * length);
    EXPECT_NEAR(r.force.y(), 5 * length, 1e-11 * length);
    EXPECT_NEAR(r.moment, (5 * foot.x1 - 4 * 0.5 * (foot.y0 + foot.y1)) * length, 1e-11 * length);
}

TEST_P(Assembly, TractionsOfAUniformStressBalanceItsStiffnessForces) {
    // K u of a linear displacement equals the load of sigma n on all six edges
    const VectorXd x = test::monomial(part.space, 1, 0), y = test::monomial(part.space, 0, 1);
    const VectorXd u = test::interleave(0.01 * x + 0.03 * y, -0.02 * y);
    const Eigen::Vector3d s = stress_of(part.elasticity, (Eigen::Matrix2d() << 0.01, 0.03, 0, -0.02).finished());
    const test::Box foot = test::ell_boxes(part)[0], stem = test::ell_boxes(part)[1];
    VectorXd load = VectorXd::Zero(2 * n);
    const auto add = [&](const Vec2& from, const Vec2& to, const Vec2& normal) {
        load += boundary_load(part, test::traction_on(part.space, from, to, normal, [&](const Vec2&) {
                                  return Vec2(s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y());
                              }));
    };
    add({foot.x0, foot.y0}, {foot.x1, foot.y0}, {0, -1});
    add({foot.x1, foot.y0}, {foot.x1, foot.y1}, {1, 0});
    add({stem.x1, foot.y1}, {foot.x1, foot.y1}, {0, 1});
    add({stem.x1, stem.y0}, {stem.x1, stem.y1}, {1, 0});
    add({stem.x0, stem.y1}, {stem.x1, stem.y1}, {0, 1});
    add({foot.x0, foot.y0}, {foot.x0, stem.y1}, {-1, 0});
    EXPECT_LT((multiply(assemble_stiffness(part), u) - load).cwiseAbs().maxCoeff(), 1e-11 * load.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(All, Assembly, testing::ValuesIn(test::all_space_cases()),
                         [](const auto& given) { return test::name_of(given.param); });

TEST(Elasticity, FollowsFromTheInverseOfHookesLaw) {
    const double E = 70000, nu = 0.33;
    const Eigen::Matrix2d gradient = (Eigen::Matrix2d() << 1e-3, 2e-3, -5e-4, -3e-3).finished();
    const Eigen::Vector3d s = stress_of(plane_stress(E, nu), gradient);
    EXPECT_NEAR((s[0] - nu * s[1]) / E, 1e-3, 1e-15);
    EXPECT_NEAR((s[1] - nu * s[0]) / E, -3e-3, 1e-15);
    EXPECT_NEAR(s[2] * 2 * (1 + nu) / E, 1.5e-3, 1e-15);
    const Elasticity d = plane_strain(E, nu);
    const Eigen::Vector3d t = stress_of(d, gradient);
    const double zz = d.out_of_plane * (t[0] + t[1]);
    EXPECT_NEAR((t[0] - nu * (t[1] + zz)) / E, 1e-3, 1e-15);
    EXPECT_NEAR((t[1] - nu * (t[0] + zz)) / E, -3e-3, 1e-15);
    EXPECT_NEAR((zz - nu * (t[0] + t[1])) / E, 0, 1e-15);
    EXPECT_EQ(plane_stress(E, nu).out_of_plane, 0);
}

}  // namespace abut::solver::assembly_test
