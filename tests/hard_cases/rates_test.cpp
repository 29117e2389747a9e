// SPDX-License-Identifier: GPL-3.0-or-later
// On smooth fields the displacement converges like h^(p+1) and the energy norm like h^p, on grids that do not fit the part, with
// every kind of support; at a re-entrant corner like h^0.54. Fields that the splines hold come out exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/hard_cases/curve_plot.hpp"
#include "tests/hard_cases/part_problem.hpp"
#include "tests/hard_cases/shapes.hpp"

namespace abut::test {
namespace {

constexpr double slope_tolerance = 0.2;

struct RateProblem {
    std::string name;
    PartProblem problem;
    double coarsest;  ///< cell size of the first grid
};

RateProblem kirsch_plate() {
    RateProblem r{"Kirsch", {}, 0.25};
    r.problem.part = plate_quarter(2.5);
    r.problem.exact = kirsch(elasticity_of(r.problem));
    r.problem.held = {{3, 0}, {0, 1}};
    return r;
}

RateProblem lame_ring() {
    RateProblem r{"Lame", {}, 0.15};
    r.problem.part = ring_quarter(1, 2);
    r.problem.exact = lame(elasticity_of(r.problem), {1, 2, 1});
    r.problem.held = {{2, 0}, {0, 1}};
    return r;
}

RateProblem splines_and_holes() {
    RateProblem r{"waves", {}, 0.12};
    r.problem.part = plate_with_splines();
    r.problem.exact = symmetric_waves(elasticity_of(r.problem), {2.1, 2.6}, -0.7);
    r.problem.held = {{3, 0}, {0, 1}};
    return r;
}

std::vector<RateProblem> rate_problems() {
    return {kirsch_plate(), lame_ring(), splines_and_holes()};
}

struct Study {
    std::vector<double> h;
    std::vector<PartAnswer> answers;
    /// Least-squares slope of the logarithms.
    double slope(double PartAnswer::* error) const {
        double mx = 0, my = 0, sxy = 0, sxx = 0;
        const auto n = static_cast<double>(h.size());
        for (std::size_t k = 0; k < h.size(); ++k) {
            mx += std::log(h[k]) / n;
            my += std::log(answers[k].*error) / n;
        }
        for (std::size_t k = 0; k < h.size(); ++k) {
            sxy += (std::log(h[k]) - mx) * (std::log(answers[k].*error) - my);
            sxx += (std::log(h[k]) - mx) * (std::log(h[k]) - mx);
        }
        return sxy / sxx;
    }
};

/// Grids finer by the root of 2 each. No line lies on the boundary, but where supports are to be aligned.
Study study(RateProblem r, Hold hold, int degree, int grids) {
    r.problem.hold = hold;
    r.problem.degree = degree;
    Study s;
    double h = r.coarsest;
    for (int k = 0; k < grids; ++k, h /= std::sqrt(2.0)) {
        const Vec2 offset = hold == Hold::aligned ? Vec2(0, 0) : Vec2(h * Vec2(0.3141, 0.2718));
        s.h.push_back(h);
        s.answers.push_back(solve_part(r.problem, even_grid(r.problem, h, offset)));
    }
    return s;
}

solver::SupportMethod method_of(Hold hold) {
    if (hold == Hold::aligned) return solver::SupportMethod::aligned;
    return hold == Hold::structure ? solver::SupportMethod::structure : solver::SupportMethod::nitsche;
}

constexpr int rate_grids = 4;
constexpr std::array<Hold, 4> all_holds{Hold::rigid, Hold::nitsche, Hold::aligned, Hold::structure};

class Rates : public testing::TestWithParam<Hold> {};

TEST_P(Rates, SmoothFieldsConvergeAtFullOrder) {
    for (const RateProblem& r : rate_problems())
        for (int degree = 1; degree <= 4; ++degree) {
            SCOPED_TRACE(r.name + ", degree " + std::to_string(degree));
            const Study s = study(r, GetParam(), degree, rate_grids);
            for (const PartAnswer& a : s.answers) {
                ASSERT_EQ(a.failure, "");
                EXPECT_EQ(a.methods.size(), GetParam() == Hold::rigid ? 0u : 2u);
                for (solver::SupportMethod m : a.methods) EXPECT_EQ(m, method_of(GetParam()));
            }
            EXPECT_NEAR(s.slope(&PartAnswer::displacement), degree + 1, slope_tolerance);
            EXPECT_NEAR(s.slope(&PartAnswer::energy), degree, slope_tolerance);
        }
}

INSTANTIATE_TEST_SUITE_P(Holds, Rates, testing::ValuesIn(all_holds),
                         [](const testing::TestParamInfo<Hold>& info) { return name_of(info.param); });

}  // namespace

TEST(Explore, Rates) {
    for (const RateProblem& r : rate_problems())
        for (Hold hold : all_holds) {
            for (int p = 1; p <= 4; ++p) {
                const Study s = study(r, hold, p, 4);
                std::printf("%s %s p=%d: L2 %.2f energy %.2f   ", r.name.c_str(), name_of(hold).c_str(), p,
                            s.slope(&PartAnswer::displacement), s.slope(&PartAnswer::energy));
                for (const PartAnswer& a : s.answers)
                    std::printf(" %d %.1e/%.1e c%.0e", a.unknowns, a.displacement, a.energy, a.condition);
                for (const PartAnswer& a : s.answers) std::printf("%s", a.failure.c_str());
                std::printf("\n");
            }
        }
}

}  // namespace abut::test
