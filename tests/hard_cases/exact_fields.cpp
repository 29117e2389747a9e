// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard_cases/exact_fields.hpp"

#include <cmath>
#include <numbers>

namespace abut::test {

namespace {

/// nu in plane stress, nu / (1 - nu) in plane strain.
double plane_ratio(const Elasticity& d) {
    return d.d12 / d.d11;
}

/// Kolosov's constant.
double kappa_of(const Elasticity& d) {
    return (3 - plane_ratio(d)) / (1 + plane_ratio(d));
}

/// From axes turned by (c, s).
Eigen::Vector3d turned_stress(const Eigen::Vector3d& t, double c, double s) {
    return {c * c * t[0] + s * s * t[1] - 2 * c * s * t[2], s * s * t[0] + c * c * t[1] + 2 * c * s * t[2],
            c * s * (t[0] - t[1]) + (c * c - s * s) * t[2]};
}

Vec2 kirsch_displacement(const Elasticity& d, const Vec2& p) {
    const double r = p.norm(), t = std::atan2(p.y(), p.x()), kappa = kappa_of(d);
    const double x = r * (kappa + 1) * std::cos(t) + 2 / r * ((1 + kappa) * std::cos(t) + std::cos(3 * t)) -
                     2 / (r * r * r) * std::cos(3 * t);
    const double y = r * (kappa - 3) * std::sin(t) + 2 / r * ((1 - kappa) * std::sin(t) + std::sin(3 * t)) -
                     2 / (r * r * r) * std::sin(3 * t);
    return Vec2(x, y) / (8 * d.d33);
}

Eigen::Vector3d kirsch_stress(const Vec2& p) {
    const double t = std::atan2(p.y(), p.x()), q = 1 / p.squaredNorm();
    return {1 - q * (1.5 * std::cos(2 * t) + std::cos(4 * t)) + 1.5 * q * q * std::cos(4 * t),
            -q * (0.5 * std::cos(2 * t) - std::cos(4 * t)) - 1.5 * q * q * std::cos(4 * t),
            -q * (0.5 * std::sin(2 * t) + std::sin(4 * t)) + 1.5 * q * q * std::sin(4 * t)};
}

constexpr double corner_factor = 0.543075578836737;  // Q
constexpr double l = corner_exponent;

/// In axes along and across the bisector, from which t counts.
Vec2 corner_displacement(const Elasticity& d, double r, double t) {
    const double kappa = kappa_of(d), q = corner_factor * (l + 1);
    return std::pow(r, l) / (2 * d.d33) *
           Vec2((kappa - q) * std::cos(l * t) - l * std::cos((l - 2) * t),
                (kappa + q) * std::sin(l * t) + l * std::sin((l - 2) * t));
}

Eigen::Vector3d corner_stress(double r, double t) {
    const double q = corner_factor * (l + 1), c1 = std::cos((l - 1) * t), c3 = std::cos((l - 3) * t);
    return l * std::pow(r, l - 1) *
           Eigen::Vector3d((2 - q) * c1 - (l - 1) * c3, (2 + q) * c1 + (l - 1) * c3,
                           (l - 1) * std::sin((l - 3) * t) + q * std::sin((l - 1) * t));
}

}  // namespace

ExactField constant_strain(const Elasticity& d, double exx, double eyy, double gxy) {
    Eigen::Matrix2d gradient;
    gradient << exx, gxy / 2, gxy / 2, eyy;
    const Eigen::Vector3d stress = stress_of(d, gradient);
    return {[gradient](const Vec2& p) -> Vec2 { return gradient * p; }, [stress](const Vec2&) { return stress; }, {}};
}

ExactField hanging_bar(double E, double nu, double length) {
    return {[=](const Vec2& p) -> Vec2 {
                return {-nu * p.x() * p.y() / E, (p.y() * p.y() + nu * p.x() * p.x() - length * length) / (2 * E)};
            },
            [](const Vec2& p) { return Eigen::Vector3d(0, p.y(), 0); }, [](const Vec2&) { return Vec2(0, -1); }};
}

ExactField plane_waves(const Elasticity& d, const std::vector<PlaneWave>& waves) {
    ExactField field;
    field.displacement = [waves](const Vec2& p) {
        Vec2 u(0, 0);
        for (const PlaneWave& w : waves) u += std::sin(w.wave.dot(p) + w.phase) * w.amplitude;
        return u;
    };
    field.stress = [d, waves](const Vec2& p) {
        Eigen::Vector3d s(0, 0, 0);
        for (const PlaneWave& w : waves)
            s += std::cos(w.wave.dot(p) + w.phase) * stress_of(d, w.amplitude * w.wave.transpose());
        return s;
    };
    field.body_force = [d, waves](const Vec2& p) {
        Vec2 f(0, 0);
        for (const PlaneWave& w : waves) {
            const Eigen::Vector3d s = stress_of(d, w.amplitude * w.wave.transpose());
            f += std::sin(w.wave.dot(p) + w.phase) *
                 Vec2(s[0] * w.wave.x() + s[2] * w.wave.y(), s[2] * w.wave.x() + s[1] * w.wave.y());
        }
        return f;
    };
    return field;
}

ExactField symmetric_waves(const Elasticity& d, const Vec2& k, double a) {
    return plane_waves(d, {{{0.5, 0.5 * a}, k, 0}, {{0.5, -0.5 * a}, {k.x(), -k.y()}, 0}});
}

ExactField kirsch(const Elasticity& d) {
    return {[d](const Vec2& p) { return kirsch_displacement(d, p); }, kirsch_stress, {}};
}

ExactField lame(const Elasticity& d, const Ring& ring) {
    const double a2 = ring.inner * ring.inner, b2 = ring.outer * ring.outer, k = ring.pressure * a2 / (b2 - a2);
    const double uniform = (1 - plane_ratio(d)) / (1 + plane_ratio(d));
    return {[=](const Vec2& p) -> Vec2 { return k / (2 * d.d33) * (uniform + b2 / p.squaredNorm()) * p; },
            [=](const Vec2& p) {
                const double q = b2 / p.squaredNorm(), r = p.norm();
                return turned_stress({k * (1 - q), k * (1 + q), 0}, p.x() / r, p.y() / r);
            },
            {}};
}

ExactField corner_mode(const Elasticity& d) {
    const double c = std::numbers::sqrt2 / 2;
    const auto angle = [](const Vec2& p) { return std::atan2(p.y() - p.x(), p.x() + p.y()); };
    return {[=](const Vec2& p) -> Vec2 {
                const Vec2 u = corner_displacement(d, p.norm(), angle(p));
                return {c * (u.x() - u.y()), c * (u.x() + u.y())};
            },
            [=](const Vec2& p) { return turned_stress(corner_stress(p.norm(), angle(p)), c, c); },
            {}};
}

}  // namespace abut::test
