// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/splines/branches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace abut::solver::branches_test {

namespace {

/// The number of connected regions of the part as the grid sees them: 1 for a part that hangs together.
int count_connected(const ElementGraph& graph) {
    std::vector<char> seen(static_cast<std::size_t>(graph.n_elements()), 0);
    std::vector<int> front;
    int pieces = 0;
    for (int e = 0; e < graph.n_elements(); ++e) {
        if (!graph.has_material(e) || seen[static_cast<std::size_t>(e)]) continue;
        ++pieces;
        seen[static_cast<std::size_t>(e)] = 1;
        front.push_back(e);
        while (!front.empty()) {
            const int from = front.back();
            front.pop_back();
            graph.for_neighbours(from, [&](int other) {
                if (seen[static_cast<std::size_t>(other)]) return;
                seen[static_cast<std::size_t>(other)] = 1;
                front.push_back(other);
            });
        }
    }
    return pieces;
}

std::vector<double> lines(int n) {
    std::vector<double> x(static_cast<std::size_t>(n) + 1);
    std::iota(x.begin(), x.end(), 0.0);
    return x;
}

/// A U of full cells: a foot of one row and two arms beside a slot of one column, `arm` columns wide each.
std::vector<double> u_shape(int arm, int rows) {
    std::vector<double> fraction;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < 2 * arm + 1; ++c) fraction.push_back(r == 0 || c != arm);
    return fraction;
}

std::set<int> functions_of(const SplineSpace& s, int element) {
    const Extraction e = extraction(s, element);
    return {e.functions.begin(), e.functions.end()};
}

bool share_functions(const SplineSpace& s, int a, int b) {
    const std::set<int> fa = functions_of(s, a), fb = functions_of(s, b);
    return std::any_of(fa.begin(), fa.end(), [&](int f) { return fb.count(f) > 0; });
}

}  // namespace

TEST(Branches, OfAPartWithoutSlotsAreTheTensorFunctions) {
    const SplineSpace s = make_space(lines(6), lines(5), 3, 2, std::vector<double>(30, 1.0), Basis::web);
    EXPECT_TRUE(s.tensor_of_extra.empty());
    EXPECT_TRUE(s.branches.empty());
    EXPECT_EQ(s.n_functions, 9 * 7);
}

TEST(Branches, TakeTheArmsOfAUApart) {
    for (int degree : {1, 2, 3, 4, 6}) {
        constexpr int arm = 3, rows = 20, columns = 2 * arm + 1;
        const SplineSpace s = make_space(lines(columns), lines(rows), degree, degree, u_shape(arm, rows), Basis::web);
        ASSERT_EQ(s.failure, "");
        for (int r = 1; r < rows; ++r) {
            const int left = r * columns + arm - 1, right = left + 2;
            // functions that reach down into the foot are common to both arms: they end p rows above it
            EXPECT_EQ(share_functions(s, left, right), degree > 1 && r <= degree) << "degree " << degree << " row " << r;
        }
    }
}

TEST(Branches, OfASlotInsideACellLiveOnOneOfItsElementsEach) {
    // one column of cells, each in two pieces; only the lowest is whole
    constexpr int rows = 12;
    SpaceInput input{
        clamped_knots({0, 1}, 2), clamped_knots(lines(rows), 2), std::vector<double>(rows, 0.6), {}, Basis::web, {}};
    input.fraction[0] = 1;
    for (int r = 1; r < rows; ++r) {
        input.splits.cell_of_extra.push_back(r);
        input.fraction.push_back(0.4);
    }
    const auto extra = [](int r) { return rows + r - 1; };
    input.splits.neighbours[0] = {1, extra(1)};
    for (int r = 1; r < rows; ++r) {
        input.splits.neighbours[r] = {r - 1};
        input.splits.neighbours[extra(r)] = {r > 1 ? extra(r - 1) : 0};
        if (r + 1 < rows) {
            input.splits.neighbours[r].push_back(r + 1);
            input.splits.neighbours[extra(r)].push_back(extra(r + 1));
        }
    }
    const SplineSpace s = make_space(input);
    ASSERT_EQ(s.failure, "");
    for (int r = 1; r < rows; ++r) {
        EXPECT_EQ(share_functions(s, r, extra(r)), r <= 2) << r;
        EXPECT_EQ(functions_of(s, r).size(), 9u);
        EXPECT_EQ(functions_of(s, extra(r)).size(), 9u);
    }
    // three functions across, and along: those that reach the whole cell once, the rest for each arm
    EXPECT_EQ(s.n_functions, 3 * (3 + 2 * (rows + 2 - 3)));
    EXPECT_EQ(count_connected(ElementGraph(s.columns(), s.rows(), s.fraction, s.splits)), 1);
}

TEST(Branches, DoNotExtendAcrossASlotOnAGridLine) {
    // two columns, side by side without a common side but in the lowest row; the right one is thin above the second row
    constexpr int rows = 8;
    SpaceInput input{
        clamped_knots({0, 1, 2}, 1), clamped_knots(lines(rows), 1), std::vector<double>(2 * rows, 1.0), {}, Basis::web, {}};
    for (int r = 2; r < rows; ++r) input.fraction[static_cast<std::size_t>(2 * r + 1)] = 0.1;
    for (int r = 1; r < rows; ++r)
        for (int c = 0; c < 2; ++c) {
            std::vector<int>& n = input.splits.neighbours[2 * r + c];
            n.push_back(2 * (r - 1) + c);
            if (r + 1 < rows) n.push_back(2 * (r + 1) + c);
        }
    const SplineSpace s = make_space(input);
    ASSERT_EQ(s.failure, "");
    const std::set<int> top = functions_of(s, 2 * rows - 1), inner = functions_of(s, 3);
    EXPECT_TRUE(std::includes(inner.begin(), inner.end(), top.begin(), top.end()));
    // the same without the slot extends from the full cells on the left
    input.splits = {};
    const std::set<int> glued = functions_of(make_space(input), 2 * rows - 1);
    EXPECT_FALSE(glued.empty());
    EXPECT_NE(glued, top);
}

TEST(Branches, OfRandomPartsHoldLinearFunctionsAndAreConnected) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const int columns = 3 + trial % 7, rows = 3 + trial % 5, degree = 1 + trial % 4;
        std::vector<double> fraction;
        for (int k = 0; k < columns * rows; ++k) fraction.push_back(uniform(random) < 0.6 ? 0.3 + 0.7 * uniform(random) : 0.0);
        const SplineSpace s = make_space(lines(columns), lines(rows), degree, degree, fraction, Basis::web);
        ASSERT_EQ(s.failure, "");
        const ElementGraph graph(columns, rows, s.fraction, s.splits);
        for (int branch = 0; branch < s.n_tensor() + static_cast<int>(s.tensor_of_extra.size()); ++branch) {
            const std::vector<int> elements = support_elements(s, graph, branch);
            if (elements.empty()) continue;
            std::vector<double> only(fraction.size(), 0.0);
            for (int e : elements) only[static_cast<std::size_t>(e)] = 1;
            EXPECT_EQ(count_connected(ElementGraph(columns, rows, only, s.splits)), 1);
        }
        for (int cell = 0; cell < columns * rows; ++cell) {
            if (fraction[static_cast<std::size_t>(cell)] == 0) continue;
            const Vec2 x(cell % columns + 0.3, cell / columns + 0.8);
            const PointBasis b = evaluate(s, cell, x);
            double sum = 0;
            for (std::size_t i = 0; i < b.functions.size(); ++i)
                sum += b.value[static_cast<Eigen::Index>(i)] * Vec2(2, -3).dot(greville_point(s, b.functions[i]));
            EXPECT_NEAR(sum, 2 * x.x() - 3 * x.y(), 1e-11);
        }
    }
}

TEST(NormalizedBasis, ScalesCornerFunctionsToOneAndHoldsLinearFunctions) {
    // the right column is filled over a thousandth of its width
    constexpr double width = 1e-3;
    const auto outline = [](int cell) {
        const double y = cell / 3;
        return std::vector<Vec2>{{2, y}, {2 + width, y}, {2 + width, y + 1}, {2, y + 1}};
    };
    const std::vector<double> fraction{1, 1, width, 1, 1, width};
    const SplineSpace s =
        make_space({clamped_knots({0, 1, 2, 3}, 2), clamped_knots({0, 1, 2}, 2), fraction, {}, Basis::normalized, outline});
    ASSERT_FALSE(s.coefficient_of_one.empty());
    int scaled = 0;
    for (int cell : {2, 5})
        for (double v : {0.0, 0.4, 1.0}) {
            const Vec2 x(2 + width, cell / 3 + v);
            const PointBasis b = evaluate(s, cell, x);
            double one = 0, linear = 0;
            for (std::size_t i = 0; i < b.functions.size(); ++i) {
                const int f = b.functions[i];
                const double value = b.value[static_cast<Eigen::Index>(i)];
                one += value * coefficient_of_one(s, f);
                linear += value * coefficient_of_one(s, f) * Vec2(2, -3).dot(greville_point(s, f));
                scaled += coefficient_of_one(s, f) != 1;
                EXPECT_LE(value, 1 + 1e-12);
            }
            EXPECT_NEAR(one, 1, 1e-13);
            EXPECT_NEAR(linear, 2 * x.x() - 3 * x.y(), 1e-12);
        }
    EXPECT_GT(scaled, 0);
}

TEST(KnotVector, WithRepeatedKnotsSumsToOneAndIsAsSmoothAsItsKnots) {
    for (int degree = 1; degree <= max_degree; ++degree)
        for (int times = 1; times <= degree; ++times) {
            const KnotVector k = clamped_knots({0, 1, 2.5, 3}, degree, {1, times, 1, 1});
            EXPECT_EQ(k.n_functions(), degree + 3 + times - 1);
            for (int interval = 0; interval < 3; ++interval) {
                const double a = k.breakpoints[static_cast<std::size_t>(interval)],
                             b = k.breakpoints[static_cast<std::size_t>(interval) + 1];
                for (double t : {0.0, 0.3, 1.0}) {
                    LocalValues v, g;
                    evaluate(k, interval, a + t * (b - a), v, g);
                    EXPECT_NEAR(std::accumulate(v.begin(), v.begin() + degree + 1, 0.0), 1, 1e-13);
                    EXPECT_NEAR(std::accumulate(g.begin(), g.begin() + degree + 1, 0.0), 0, 1e-11);
                }
            }
            // at the repeated knot values agree from both sides; slopes too if it is repeated less than p times
            LocalValues left, dl, right, dr;
            evaluate(k, 0, 1, left, dl);
            evaluate(k, 1, 1, right, dr);
            for (int f = 0; f < k.n_functions(); ++f) {
                const auto on = [&](const LocalValues& v, std::size_t interval) {
                    const int i = f - k.first[interval];
                    return i >= 0 && i <= degree ? v[static_cast<std::size_t>(i)] : 0.0;
                };
                EXPECT_NEAR(on(left, 0), on(right, 1), 1e-12);
                if (times < degree) { EXPECT_NEAR(on(dl, 0), on(dr, 1), 1e-10); }
                for (int i = 0; i < 3; ++i) {
                    const IntervalRange r = support(k, f);
                    EXPECT_EQ(i >= r.begin && i < r.end,
                              f >= k.first[static_cast<std::size_t>(i)] && f <= k.first[static_cast<std::size_t>(i)] + degree);
                }
            }
        }
}

TEST(KnotVector, RefinedHoldsTheSameFunction) {
    for (int degree = 1; degree <= max_degree; ++degree) {
        const KnotVector coarse = clamped_knots({0, 1, 2.5, 3}, degree),
                         fine = clamped_knots({0, 0.2, 1, 2, 2.5, 3}, degree, {1, 1, degree, 1, 1, 1});
        std::vector<double> c;
        for (int i = 0; i < coarse.n_functions(); ++i) c.push_back(1 + (i * 7) % 5);
        std::vector<double> f;
        for (const RefinedCoefficient& row : refinement(coarse, fine)) {
            double sum = 0;
            for (int k = 0; k <= degree; ++k)
                sum += row.value[static_cast<std::size_t>(k)] * c[static_cast<std::size_t>(row.first + k)];
            f.push_back(sum);
        }
        const auto value = [degree](const KnotVector& k, const std::vector<double>& coefficients, double x) {
            const int i = interval_of(k, x);
            LocalValues v;
            evaluate(k, i, x, v);
            double sum = 0;
            for (int a = 0; a <= degree; ++a)
                sum += v[static_cast<std::size_t>(a)] *
                       coefficients[static_cast<std::size_t>(k.first[static_cast<std::size_t>(i)] + a)];
            return sum;
        };
        for (double x = 0.01; x < 3; x += 0.037)
            EXPECT_NEAR(value(coarse, c, x), value(fine, f, x), 1e-12) << degree << " " << x;
    }
}

}  // namespace abut::solver::branches_test
