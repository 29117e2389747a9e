// SPDX-License-Identifier: GPL-3.0-or-later
// Friction where the way of the loads counts though there are no steps: a rigid cylinder that holds what spreads under it
// (F14), cylinders whose loads grow together (F15).
#include <algorithm>
#include <cmath>

#include "src/verification/verify_contact_answers.hpp"

namespace abut {

namespace verify_friction_path {

/// A rigid cylinder on a half plane. As the load grows the contact keeps its shape, so that what sticks at x has been strained
/// in proportion to |x| [Spence75]: with that the equations of the surface for pressure and traction [Johnson85, eq 2.25] are
/// linear in both but for where slip begins, from where the traction goes on without a kink. beta = 0.375, mu = 0.3; by
/// collocation on 140 and 280 graded elements, which agree to four digits.
struct Indented {
    double half_width, hertz_load, peak, stick, shear_at_a_fifth;
};
constexpr Indented indented{0.132142, 1.06871, 0.70772, 0.42984, 0.6709};

double half_width_of(const ContactResult& c) {
    return 0.5 * c.contact_length;
}

/// The traction over its bound at x, in the mean of both sides.
double shear_over_bound(const ContactResult& c, double x) {
    const ContactProfile& p = c.profile;
    double sum = 0;
    for (const double at : {-x, x})
        for (std::size_t k = 0; k + 1 < p.x.size(); ++k) {
            if ((p.x[k] - at) * (p.x[k + 1] - at) > 0 || p.x[k] == p.x[k + 1]) continue;
            const double t = (at - p.x[k]) / (p.x[k + 1] - p.x[k]);
            const auto between = [&](const std::vector<double>& v) { return (1 - t) * v[k] + t * v[k + 1]; };
            sum += std::abs(between(p.shear)) / (c.friction->coefficient * between(p.pressure));
            break;
        }
    return 0.5 * sum;
}

VerifyProblem indenter() {
    constexpr double load = 50;
    const double a = indented.half_width / std::sqrt(indented.hertz_load);
    return {"F14-indenter",
            "a rigid cylinder pressed on a block: friction holds it from spreading",
            {{"verification/friction_indenter.json"}},
            {{"half width", [](const Answers& r) { return half_width_of(contact_of(r)); }, a, 0.005},
             {"largest pressure times half width over load", [=](const Answers& r) { return peak(r) * a / load; },
              indented.peak, 0.01},
             {"stick zone over a", [=](const Answers& r) { return 0.5 * contact_of(r).friction->stick_length / a; },
              indented.stick, 0.02, 1},
             {"shear over mu p at a / 5", [=](const Answers& r) { return shear_over_bound(contact_of(r), 0.2 * a); },
              indented.shear_at_a_fifth, 0.02, 1}}};
}

/// All of it sticks, with the traction in proportion to the pressure.
VerifyProblem in_proportion() {
    const auto error = [](const Answers& r) {
        const ContactProfile& p = contact_of(r).profile;
        std::vector<double> shear, bound;
        for (std::size_t k = 0; k < p.shear.size(); ++k) {
            shear.push_back(std::abs(p.shear[k]));
            bound.push_back(0.5 * 0.3 * p.pressure[k]);
        }
        return relative_error_norm(shear, bound);
    };
    return {
        "F15-proportional",
        "equal cylinders pressed and sheared by loads that grow together",
        {{"verification/friction_proportional.json"}},
        {{"shear over a share of mu p, L2 error", error, 0, 0.01, 1},
         {"length that slips over a", [](const Answers& r) { return contact_of(r).friction->slip_length / 0.01; }, 0, 0.02, 1},
         {"work of friction over mu P a",
          [](const Answers& r) { return contact_of(r).friction->dissipated / (0.3 * 7.854 * 0.01); }, 0, 1e-6, 1}}};
}

}  // namespace verify_friction_path

std::vector<VerifyProblem> load_path_problems() {
    using namespace verify_friction_path;
    return {indenter(), in_proportion()};
}

}  // namespace abut
