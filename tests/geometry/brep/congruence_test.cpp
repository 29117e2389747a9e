// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/brep/congruence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/curves/spline_shape.hpp"

namespace abut::geometry::congruence_test {
namespace {

Part of_curves(const std::vector<Curve>& curves) {
    Part part;
    part.loops.emplace_back();
    for (const Curve& curve : curves) {
        part.loops.back().edges.push_back(static_cast<int>(part.edges.size()));
        part.edges.push_back({curve, "", ""});
    }
    return part;
}

/// A line, a bulge of another kind of curve, a line, and the way back.
std::vector<Part> shapes() {
    const Vec2 a(0, 0), b(3, 0), c(3, 2), d(0, 1);
    std::vector<Part> parts;
    for (const Curve& right : std::vector<Curve>{Segment{b, c}, Arc{{3, 1}, 1, -M_PI / 2, M_PI},
                                                 EllipticArc{{3, 1}, {0.5, 0}, {0, 1}, -M_PI / 2, M_PI},
                                                 bezier_curve({b, {4, 0.5}, {3.5, 2}, c}, {})})
        parts.push_back(of_curves({Segment{a, b}, right, Segment{c, d}, Segment{d, a}}));
    parts.push_back(of_curves({Arc{{1, 2}, 0.7, 0.3, 2 * M_PI}}));
    return parts;
}

TEST(Congruence, TakesAPartToEveryCopyOfIt) {
    for (const Part& part : shapes())
        for (const double angle : {0.0, 0.3, -2.0, M_PI})
            for (const Vec2& shift : {Vec2(0, 0), Vec2(-70, 300)}) {
                const Part copy = transformed(part, std::cos(angle), std::sin(angle), shift);
                const std::optional<Similarity> map = congruence(part, copy);
                ASSERT_TRUE(map) << part.edges.size() << " " << angle;
                EXPECT_NEAR(std::remainder(std::atan2(map->s, map->c) - angle, 2 * M_PI), 0, 1e-12);
                for (std::size_t k = 0; k < part.edges.size(); ++k)
                    EXPECT_LT(((*map)(point(part.edges[k].curve, 0.4)) - point(copy.edges[k].curve, 0.4)).norm(), 1e-12);
            }
}

TEST(Congruence, OtherShapesAreNoCopies) {
    const std::vector<Part> parts = shapes();
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < parts.size(); ++j) EXPECT_EQ(congruence(parts[i], parts[j]).has_value(), i == j);
    Part changed = parts[0];
    std::get<Segment>(changed.edges[1].curve).to.x() += 1e-9;
    std::get<Segment>(changed.edges[2].curve).from.x() += 1e-9;
    EXPECT_FALSE(congruence(parts[0], changed)) << "other than by rounding";
    for (const Part& part : {parts[0], parts[3]}) {
        Part mirrored = part;
        for (Edge& e : mirrored.edges) e.curve = transformed(e.curve, Similarity{1, 0, {0, 0}, 1, true});
        EXPECT_FALSE(congruence(part, mirrored));
        Part larger = part;
        for (Edge& e : larger.edges) e.curve = transformed(e.curve, Similarity{1, 0, {0, 0}, 1.001});
        EXPECT_FALSE(congruence(part, larger));
    }
    EXPECT_FALSE(congruence(Part{}, Part{}));
}

}  // namespace
}  // namespace abut::geometry::congruence_test
