// SPDX-License-Identifier: GPL-3.0-or-later
// A number with its gradient and Hessian in the plane: forward automatic differentiation of second order.
//
// Six doubles, nothing on the heap. Eigen's AutoDiffScalar nested in itself gives the same (the tests compare the two) in about
// the same time; it keeps both halves of the Hessian and the gradient twice, generic code must fend off its expression types,
// and this header would draw Eigen's unsupported modules into every file with a field.
#pragma once
#include <cmath>

namespace abut::geometry {

/// A number with its first and second derivatives. Where an operation has no derivative (sqrt, pow at 0) the derivatives are
/// not finite; the value is always right.
struct Jet {
    double v = 0;
    double x = 0, y = 0;            ///< gradient
    double xx = 0, xy = 0, yy = 0;  ///< Hessian

    Jet() = default;
    Jet(double value) : v(value) {}  // NOLINT(google-explicit-constructor): constants mix with jets as with doubles
    Jet(double value, double gx, double gy, double hxx, double hxy, double hyy)
        : v(value), x(gx), y(gy), xx(hxx), xy(hxy), yy(hyy) {}

    Jet& operator+=(const Jet& b) { return *this = {v + b.v, x + b.x, y + b.y, xx + b.xx, xy + b.xy, yy + b.yy}; }
    Jet& operator-=(const Jet& b) { return *this = {v - b.v, x - b.x, y - b.y, xx - b.xx, xy - b.xy, yy - b.yy}; }
};

/// f(a), given f and its first two derivatives at a.v.
inline Jet chained(const Jet& a, double f, double df, double ddf) {
    return {f, df * a.x, df * a.y, df * a.xx + ddf * a.x * a.x, df * a.xy + ddf * a.x * a.y, df * a.yy + ddf * a.y * a.y};
}

inline Jet operator-(const Jet& a) {
    return {-a.v, -a.x, -a.y, -a.xx, -a.xy, -a.yy};
}
inline Jet operator+(Jet a, const Jet& b) {
    return a += b;
}
inline Jet operator-(Jet a, const Jet& b) {
    return a -= b;
}
inline Jet operator*(const Jet& a, const Jet& b) {
    return {a.v * b.v,
            a.x * b.v + a.v * b.x,
            a.y * b.v + a.v * b.y,
            a.xx * b.v + 2 * a.x * b.x + a.v * b.xx,
            a.xy * b.v + a.x * b.y + a.y * b.x + a.v * b.xy,
            a.yy * b.v + 2 * a.y * b.y + a.v * b.yy};
}
inline Jet operator*(double s, const Jet& a) {
    return {s * a.v, s * a.x, s * a.y, s * a.xx, s * a.xy, s * a.yy};
}
inline Jet operator*(const Jet& a, double s) {
    return s * a;
}
/// The quotient by a plain number; its value is that of doubles bit for bit.
inline Jet operator/(const Jet& a, double s) {
    Jet quotient = (1 / s) * a;
    quotient.v = a.v / s;
    return quotient;
}
/// The quotient q, from a = q b: its derivatives without those of 1/b.
inline Jet operator/(const Jet& a, const Jet& b) {
    const double w = 1 / b.v, q = a.v * w;
    const double qx = (a.x - q * b.x) * w, qy = (a.y - q * b.y) * w;
    return {a.v / b.v,
            qx,
            qy,
            (a.xx - q * b.xx - 2 * qx * b.x) * w,
            (a.xy - q * b.xy - qx * b.y - qy * b.x) * w,
            (a.yy - q * b.yy - 2 * qy * b.y) * w};
}

inline bool operator<(const Jet& a, const Jet& b) {
    return a.v < b.v;
}
inline bool operator>(const Jet& a, const Jet& b) {
    return a.v > b.v;
}

inline Jet sqrt(const Jet& a) {
    const double root = std::sqrt(a.v), df = 0.5 / root;
    return chained(a, root, df, -0.5 * df / a.v);
}
inline Jet pow(const Jet& a, double p) {
    const double f = std::pow(a.v, p);
    return chained(a, f, p * f / a.v, p * (p - 1) * f / (a.v * a.v));
}

/// A point whose coordinates are doubles (for values) or jets (for values with derivatives).
template <class T>
struct PointOf {
    T x, y;
};

}  // namespace abut::geometry
