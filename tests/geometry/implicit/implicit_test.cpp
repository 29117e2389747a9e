// SPDX-License-Identifier: GPL-3.0-or-later
// R-functions of geometry trees, on random trees in general position.
#include "geometry/implicit/implicit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/geometry/csg/csg_nodes.hpp"
#include "tests/geometry/csg/random_csg_scene.hpp"
#include "tests/geometry/implicit/field_checks.hpp"

namespace abut::geometry::implicit_test {

namespace {

using namespace csg_nodes;

constexpr double size = 10;  ///< of the square that the trees' leaves lie in

/// Trees of half planes, circles, rectangles, ellipses and the leaves that are known by their edges, up to four deep.
class TreeMaker {
public:
    explicit TreeMaker(unsigned seed) : random_(seed) {}

    CsgNode tree(int depth) {
        if (depth == 0 || below(5) == 0) return leaf();
        switch (below(4)) {
            case 0:
                return join(children(depth));
            case 1:
                return common({tree(depth - 1), leaf()});
            case 2:
                return less(children(depth));
            default:
                return place(tree(depth - 1), between(-180, 180), spot(2), spot(size), between(0.5, 1.5), mirror());
        }
    }

    /// Never unbounded, seldom empty.
    CsgNode bounded(int depth) { return common({tree(depth), circle(size / 2, size / 2, size)}); }

    /// The plane around the trees.
    Vec2 anywhere() { return {between(-size / 2, 1.5 * size), between(-size / 2, 1.5 * size)}; }

private:
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    Mirror mirror() {
        const int choice = below(4);
        return choice == 0 ? Mirror::x : choice == 1 ? Mirror::y : Mirror::none;
    }
    Vec2 spot(double range) {
        const double x = between(0, range), y = between(0, range);
        return {x, y};
    }
    std::vector<CsgNode> children(int depth) {
        std::vector<CsgNode> nodes;
        for (int n = 2 + below(2); n > 0; --n) nodes.push_back(tree(depth - 1));
        return nodes;
    }
    CsgNode leaf() {
        const Vec2 p = spot(size), d = spot(4) + Vec2(0.5, 0.5);
        switch (below(6)) {
            case 0:
                return half_plane(p.x(), p.y(), d.x() - 2.5, d.y() - 2.6);
            case 1:
                return rectangle(p.x(), p.y(), p.x() + d.x(), p.y() + d.y());
            case 2:
                return ellipse(p.x(), p.y(), d.x(), d.y(), between(0, 180));
            case 3:
                return slot(p.x(), p.y(), p.x() + d.x(), p.y() - d.y(), 0.3 * d.y());
            case 4:  // an arrow head: one corner is re-entrant
                return node(Polygon{{p, p + Vec2(d.x(), 0.2), p + Vec2(0.4 * d.x(), d.y()), p + Vec2(0.4, 0.3)}});
            default:
                return circle(p.x(), p.y(), d.x());
        }
    }

    std::mt19937 random_;
};

void expect_signs_of_the_set(int n_trees, unsigned seed) {
    TreeMaker make(seed);
    int n_inside = 0;
    for (int k = 0; k < n_trees; ++k) {
        const CsgNode tree = make.tree(k % 5);
        for (const double alpha : {0.0, 0.5, 1.0}) {
            const ImplicitField field = implicit_of(tree, alpha);
            for (int i = 0; i < 10; ++i) {
                const Vec2 p = make.anywhere();
                const bool inside = is_member(tree, p);
                n_inside += inside ? 1 : 0;
                ASSERT_EQ(value(field, p) > 0, inside) << tree_text(tree) << " at " << p.transpose() << " alpha " << alpha;
            }
        }
    }
    // neither side is left out
    EXPECT_GT(n_inside, 3 * n_trees);
    EXPECT_LT(n_inside, 27 * n_trees);
}

/// Zero to rounding, and the gradient is the inward normal to 1e-9, at three points of each edge of the evaluated tree. Nearest
/// singular point: a corner, where derivatives of the R-function change over the distance to it; points nearer than a
/// thousandth of the size to one are left to others.
void expect_unit_normal_derivatives(int n_trees, unsigned seed) {
    TreeMaker make(seed);
    int n_points = 0;
    for (int k = 0; k < n_trees; ++k) {
        const CsgNode tree = make.bounded(k % 5);
        const CsgResult result = evaluate(tree);
        if (!result.problems.empty()) continue;  // empty, mostly
        const ImplicitField smooth = implicit_of(tree, 0), other = implicit_of(tree, 0.5);
        for (const Edge& edge : result.part.edges) {
            if (length(edge.curve) < 4e-3 * size) continue;
            for (const double t : {0.3, 0.5, 0.8}) {
                const Vec2 p = point(edge.curve, t), inward = -outward_normal(edge.curve, t);
                for (const ImplicitField& field : {smooth, other}) {
                    const FieldValue w = evaluate(field, p);
                    ASSERT_LE(std::abs(w.value), 1e-13 * size) << tree_text(tree) << " " << edge.name << " " << t;
                    ASSERT_LE((w.gradient - inward).norm(), 1e-9) << tree_text(tree) << " " << edge.name << " " << t;
                }
                ++n_points;
            }
        }
    }
    EXPECT_GT(n_points, 6 * n_trees);
}

void expect_true_derivatives(int n_trees, unsigned seed) {
    TreeMaker make(seed);
    int n_telling = 0, n_points = 0;
    for (int k = 0; k < n_trees; ++k) {
        const CsgNode tree = make.tree(k % 5);
        for (const double alpha : {0.0, 0.5}) {
            const ImplicitField field = implicit_of(tree, alpha);
            for (int i = 0; i < 5; ++i) {
                const Vec2 p = make.anywhere();
                EXPECT_EQ(evaluate(field, p).value, value(field, p));
                const DerivativeErrors errors = derivative_errors([&](const Vec2& q) { return evaluate(field, q); }, p, size);
                ++n_points;
                if (!errors.tell_something()) continue;
                ++n_telling;
                ASSERT_TRUE(errors.right()) << tree_text(tree) << " at " << p.transpose();
            }
        }
    }
    EXPECT_GT(n_telling, n_points * 95 / 100);
}

}  // namespace

TEST(ImplicitCsg, SignIsSetMembership) {
    expect_signs_of_the_set(300, 11);
}

TEST(ImplicitCsg, VanishesOnTheBoundaryWithUnitNormalDerivative) {
    expect_unit_normal_derivatives(300, 12);
}

TEST(ImplicitCsg, GradientAndHessianAgreeWithDifferences) {
    expect_true_derivatives(300, 13);
}

TEST(LongImplicitCsg, SignIsSetMembership) {
    expect_signs_of_the_set(10000, 21);
}

TEST(LongImplicitCsg, VanishesOnTheBoundaryWithUnitNormalDerivative) {
    expect_unit_normal_derivatives(10000, 22);
}

TEST(LongImplicitCsg, GradientAndHessianAgreeWithDifferences) {
    expect_true_derivatives(10000, 23);
}

TEST(ImplicitCsg, TheHarnessSeesWrongDerivatives) {
    const ImplicitField field = implicit_of(less({rectangle(0, 0, 4, 3), circle(4, 3, 1)}));
    const Vec2 p(1.1, 1.7);
    const auto errors_with = [&](double gradient_error, double hessian_error) {
        return derivative_errors(
            [&](const Vec2& q) {
                FieldValue w = evaluate(field, q);
                w.gradient.x() += gradient_error;
                w.hessian(0, 1) += hessian_error;
                return w;
            },
            p, 5);
    };
    EXPECT_TRUE(errors_with(0, 0).right());
    EXPECT_TRUE(errors_with(0, 0).tell_something());
    EXPECT_FALSE(errors_with(1e-7, 0).right());
    EXPECT_FALSE(errors_with(0, 1e-7).right());
}

TEST(ImplicitCsg, PrimitivesAreTheirNormalisedFunctions) {
    const Vec2 p(0.7, -0.4);
    EXPECT_NEAR(value(implicit_of(circle(1, 2, 3)), p), (9 - (p - Vec2(1, 2)).squaredNorm()) / 6, 1e-15);
    EXPECT_NEAR(value(implicit_of(half_plane(1, 2, 0, 5)), p), 2.4, 1e-15);
    // with equal radii an ellipse is the circle, and goes over into it
    EXPECT_NEAR(value(implicit_of(ellipse(1, 2, 3, 3)), p), value(implicit_of(circle(1, 2, 3)), p), 1e-15);
    EXPECT_NEAR(value(implicit_of(ellipse(1, 2, 3, 3 + 1e-9)), p), value(implicit_of(circle(1, 2, 3)), p), 1e-8);
    // F / sqrt(|grad F|^2 + 2 F / A^2)
    const double a = 3, b = 2, x = p.x(), y = p.y(), f = (1 - x * x / (a * a) - y * y / (b * b)) / 2;
    const double slope = std::hypot(x / (a * a), y / (b * b));
    EXPECT_NEAR(value(implicit_of(ellipse(0, 0, a, b)), p), f / std::sqrt(slope * slope + 2 * f / (a * a)), 1e-15);
}

TEST(ImplicitCsg, AlphaOneTakesMinimumAndMaximum) {
    const CsgNode a = circle(0, 0, 2), b = half_plane(0.5, 0, 1, 0.2), c = ellipse(1, 0, 1, 0.5);
    PointsAround points(body({closed_polygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}})}), 5);
    for (int i = 0; i < 100; ++i) {
        const Vec2 p = points();
        const double wa = value(implicit_of(a), p), wb = value(implicit_of(b), p), wc = value(implicit_of(c), p);
        EXPECT_NEAR(value(implicit_of(common({a, b, c}), 1), p), std::min({wa, wb, wc}), 1e-14);
        EXPECT_NEAR(value(implicit_of(join({a, b, c}), 1), p), std::max({wa, wb, wc}), 1e-14);
        EXPECT_NEAR(value(implicit_of(less({a, b, c}), 1), p), std::min({wa, -wb, -wc}), 1e-14);
    }
}

TEST(ImplicitCsg, ScalesWithItsPlacement) {
    const CsgNode tree = less({join({rectangle(0, 0, 4, 2), slot(3, 1, 5, 2, 0.5)}), ellipse(1, 1, 0.6, 0.3, 20)});
    for (const double scale : {1e-3, 0.1, 25.4, 1e4}) {
        const ImplicitField field = implicit_of(tree), scaled = implicit_of(place(tree, 0, {0, 0}, {0, 0}, scale, Mirror::y));
        PointsAround points(body({closed_polygon({{0, 0}, {5, 0}, {5, 3}, {0, 3}})}), 6);
        for (int i = 0; i < 100; ++i) {
            const Vec2 p = points(), q = scale * Vec2(p.x(), -p.y());
            EXPECT_NEAR(value(scaled, q) / scale, value(field, p), 1e-12);
        }
    }
}

TEST(ImplicitCsg, CommonStretchesLoseTheNormalisationAsStated) {
    const CsgNode abutting = join({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)});
    EXPECT_EQ(value(implicit_of(abutting), {1, 0.5}), 0);
    EXPECT_NEAR(value(distance_field(good(abutting), 2), {1, 0.5}), 0.5, 0.25);
}

TEST(ImplicitCsg, RefusesWhatItCannotTell) {
    EXPECT_THROW(implicit_of(circle(0, 0, -1)), std::logic_error);
    EXPECT_THROW(implicit_of(join({})), std::logic_error);
    const CsgNode two = join({circle(0, 0, 1), circle(1, 0, 1)});
    EXPECT_THROW(implicit_of(two, -1), std::logic_error);
    EXPECT_THROW(implicit_of(two, 1.5), std::logic_error);
    EXPECT_THROW(conjunction(std::vector<ImplicitField>{}), std::logic_error);
}

}  // namespace abut::geometry::implicit_test
