// SPDX-License-Identifier: GPL-3.0-or-later
// Golovin's curved bar under pure bending (Timoshenko, Goodier, Theory of Elasticity, section 29): stresses right at every
// point that is shown, cut cells and slivers included.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/verification/scene_answers.hpp"

namespace abut::bent_ring_test {
namespace {

constexpr double a = 10, b = 15, moment = 1000;

/// The hoop stress is even + log * ln r + square / r^2, the radial one logs_radial + log * ln r - square / r^2.
struct Golovin {
    double scale, square, log, even, even_radial;
};

Golovin golovin() {
    const double l = std::log(b / a), n = std::pow(b * b - a * a, 2) - 4 * a * a * b * b * l * l, k = -4 * moment / n;
    const double logs = -b * b * std::log(b) + a * a * std::log(a);
    return {k, -k * a * a * b * b * l, k * (b * b - a * a), k * (logs + b * b - a * a), k * logs};
}

double von_mises_at(const Vec2& x) {
    const Golovin g = golovin();
    const double r = std::clamp(x.norm(), a, b);
    const double hoop = g.even + g.log * std::log(r) + g.square / (r * r);
    const double radial = g.even_radial + g.log * std::log(r) - g.square / (r * r);
    return std::sqrt(hoop * hoop + radial * radial - hoop * radial);
}

/// A quarter of the ring from an angle on, its ends loaded as they are in it.
Result bent_quarter(double degrees, int degree) {
    const double from = degrees * std::numbers::pi / 180, to = from + std::numbers::pi / 2;
    const Golovin g = golovin();
    std::ostringstream scene;
    scene.precision(17);
    const auto at = [](double r, double angle) { return test::pair_text(r * std::cos(angle), r * std::sin(angle)); };
    const auto traction = [&](double x, double y) {
        std::ostringstream text;
        text.precision(17);
        const auto component = [&](double v) {
            text << "\"(" << g.even << " + (" << g.log << ") * 0.5 * log(x^2 + y^2) + (" << g.square << ") / (x^2 + y^2)) * ("
                 << v << ")\"";
        };
        text << "[";
        component(x);
        text << ", ";
        component(y);
        text << "]";
        return text.str();
    };
    scene << R"({"abut": 1, "materials": {"m": {"E": 210000, "nu": 0.3}}, "parts": [{"name": "q", "material": "m",
        "geometry": {"loops": [[{"line": {"from": )"
          << at(a, from) << R"(, "to": )" << at(b, from) << R"(}, "name": "begin"}, {"arc": {"from": )" << at(b, from)
          << R"(, "to": )" << at(b, to) << R"(, "center": [0, 0]}, "name": "outer"}, {"line": {"from": )" << at(b, to)
          << R"(, "to": )" << at(a, to) << R"(}, "name": "end"}, {"arc": {"from": )" << at(a, to) << R"(, "to": )"
          << at(a, from) << R"(, "center": [0, 0], "ccw": false}, "name": "inner"}]]}}],
        "supports": [{"part": "q", "rigid": {"translation": [0, 0], "rotation": 0}}],
        "loads": [{"on": "q/begin", "traction": )"
          << traction(std::sin(from), -std::cos(from)) << R"(}, {"on": "q/end", "traction": )"
          << traction(-std::sin(to), std::cos(to)) << R"(}], "accuracy": {"degree": )" << degree << "}}";
    return test::answer(scene.str());
}

}  // namespace

/// The accuracy asked for is 1 % in the energy norm; single points may be off by twice that, of the largest stress.
TEST(BentRing, StressesAreRightAtEveryPointShown) {
    double peak = 0;
    for (double r = a; r <= b; r += 0.01) peak = std::max(peak, von_mises_at({r, 0}));
    for (int degree : {2, 3})
        for (double degrees : {0.0, 3.0, 17.0, 31.0, 44.0}) {
            const Result r = bent_quarter(degrees, degree);
            ASSERT_EQ(r.status, "ok") << r.message;
            double worst = 0;
            for (const FieldSample& s : r.fields.at(0).samples) {
                if (s.at.norm() < a || s.at.norm() > b) continue;  // of boundary cells
                const auto& [xx, yy, xy, zz] = s.stress;
                worst = std::max(worst, std::abs(std::sqrt(xx * xx - xx * yy + yy * yy + 3 * xy * xy) - von_mises_at(s.at)));
            }
            EXPECT_LT(worst / peak, 0.02) << degree << " " << degrees;
            EXPECT_NEAR(r.parts.at(0).max_von_mises.value, peak, 0.02 * peak) << degree << " " << degrees;
            EXPECT_GT(r.fields.at(0).samples.size(), 1000u);
        }
}

}  // namespace abut::bent_ring_test
