// SPDX-License-Identifier: GPL-3.0-or-later
// On uniform grids near the contact the pressure converges like h in the L2 norm, for any degree: it ends like a root. The
// energy norm of the displacements converges like h^1.5.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/hard_cases/hard_contact.hpp"
#include "tests/hard_cases/pin_sweep.hpp"

namespace abut::test::contact_rates_test {
namespace {

/// Relative L2 error of the pressure against Hertz, over twice the contact; half width 1/100 of the radius, so that the
/// theory's own error is 1e-4.
double hertz_error(const DiscOnBlock& d, const SolvedAssembly& solved, const ContactCase& c) {
    const solver::KnotVector& k = solved.contacts[0].face.pressure;
    const double peak = hertz_peak(d);
    double error = 0, norm = 0;
    for (const solver::InterfacePoint& p : solved.contacts[0].face.points) {
        const geometry::FacingPair pair = pair_at(c.scene, solved.contacts[0], p.s);
        const double x = 0.5 * (pair.on1.x + pair.on2.x).x() / d.half_width;
        const double exact = std::abs(x) < 1 ? peak * std::sqrt(1 - x * x) : 0.0;
        error += p.weight * std::pow(solver::pressure_at(k, pressure_of(solved, 0), p.s) - exact, 2);
        norm += p.weight * exact * exact;
    }
    return std::sqrt(error / norm);
}

/// Strain energy less the work of the loads: it is off by half the square of the error's energy norm.
double potential(const SolvedAssembly& solved) {
    double sum = 0;
    for (std::size_t i = 0; i < solved.problem.parts.size(); ++i)
        sum += strain_energy(solved.problem.parts[i], solved.solution.displacement[i]) -
               solved.problem.parts[i].load.dot(solved.solution.displacement[i]);
    return sum;
}

/// Of a pin with clearance, the same at every size: contact over half a right angle to either side.
double pin_potential(double cell, double sliver) {
    PinSetup setup{cell, 1e-3, 1};
    setup.sliver = {Vec2(sliver, 0.4), Vec2(0.7, sliver)};
    SolvedAssembly solved = solve_case(pin_case(setup));
    scale_loads(solved, 1e-3);
    EXPECT_TRUE(solved.solution.converged);
    return potential(solved);
}

double slope(const std::vector<double>& h, const std::vector<double>& error) {
    double mx = 0, my = 0, sxy = 0, sxx = 0;
    const auto n = static_cast<double>(h.size());
    for (std::size_t k = 0; k < h.size(); ++k) {
        mx += std::log(h[k]) / n;
        my += std::log(error[k]) / n;
    }
    for (std::size_t k = 0; k < h.size(); ++k) {
        sxy += (std::log(h[k]) - mx) * (std::log(error[k]) - my);
        sxx += std::pow(std::log(h[k]) - mx, 2);
    }
    return sxy / sxx;
}

TEST(LongContactRates, EnergyNormConvergesWithSlopeOneAndAHalf) {
    const std::vector<double> slivers{0.1, 0.45, 0.8};
    double exact = 0;
    for (double sliver : slivers) exact += pin_potential(1.0 / 48, sliver) / static_cast<double>(slivers.size());
    std::vector<double> h, error;
    for (double cells : {4.0, 8.0, 16.0}) {
        double sum = 0;
        for (double sliver : slivers)
            sum += 2 * std::abs(pin_potential(1 / cells, sliver) - exact) / static_cast<double>(slivers.size());
        h.push_back(1 / cells);
        error.push_back(std::sqrt(sum / std::abs(exact)));
    }
    EXPECT_NEAR(slope(h, error), 1.5, 0.25) << error[0] << " " << error[1] << " " << error[2];
}

TEST(LongContactRates, PressureConvergesWithSlopeOne) {
    std::vector<double> h, error;
    // the mean of several places of the grid: how far the end of contact is from a knot makes the error of one uneven
    for (double cells : {3.0, 6.0, 12.0, 24.0}) {
        double sum = 0;
        const std::vector<double> slivers{0.05, 0.3, 0.55, 0.8};
        for (double sliver : slivers) {
            DiscOnBlock d{1, 0, 0.01, cells * (1 + 0.1 * sliver), 0, sliver};
            const ContactCase c = disc_on_block(d);
            const SolvedAssembly solved = solve_case(c);
            ASSERT_TRUE(solved.solution.converged);
            sum += hertz_error(d, solved, c) / static_cast<double>(slivers.size());
        }
        h.push_back(1 / cells);
        error.push_back(sum);
    }
    EXPECT_NEAR(slope(h, error), 1, 0.15) << error[0] << " " << error[1] << " " << error[2] << " " << error[3];
    EXPECT_LT(error.back(), 0.02);
}

}  // namespace
}  // namespace abut::test::contact_rates_test
