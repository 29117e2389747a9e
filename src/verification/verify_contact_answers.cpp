// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/verification/verify_contact_answers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace abut {

namespace {

/// Places this little beyond the ends, as a fraction of the range, are the ends: rounding.
constexpr double end_rounding = 1e-9;

/// Value at a place by straight lines between points in any order.
double interpolated(const std::vector<double>& place, const std::vector<double>& value, double at) {
    std::vector<std::size_t> order(place.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    if (order.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double first = place[order.front()], last = place[order.back()], slack = end_rounding * (last - first);
    if (!(at >= first - slack && at <= last + slack)) return std::numeric_limits<double>::quiet_NaN();
    if (at <= first) return value[order.front()];
    if (at >= last) return value[order.back()];
    const auto after = std::lower_bound(order.begin(), order.end(), at, [&](std::size_t k, double v) { return place[k] < v; });
    const std::size_t b = *after, a = *(after - 1);
    return value[a] + (at - place[a]) / (place[b] - place[a]) * (value[b] - value[a]);
}

}  // namespace

double Hertz::pressure(double x) const {
    return std::abs(x) < a ? p0 * std::sqrt(1 - x * x / (a * a)) : 0.0;
}

Hertz hertz(double radius, double modulus, double load) {
    const double a = std::sqrt(4 * load * radius / (std::numbers::pi * modulus));
    return {a, 2 * load / (std::numbers::pi * a)};
}

double okubo_pressure(double x) {
    constexpr std::array<double, 9> b{-0.417, -0.152, 0.634, -2.006, 0.817, 2.062, -0.798, -0.916, -0.482};
    double sum = 0;
    for (std::size_t n = b.size(); n-- > 0;) sum = sum * x * x + b[n];
    return 0.5 - sum;  // the printed stress p (-1/2 + sigma_y) is negative in compression
}

const ContactResult& contact_of(const Answers& answers) {
    return answers.at(0).contacts.at(0);
}

double peak(const Answers& answers) {
    return contact_of(answers).max_pressure.value;
}

double force(const Answers& answers) {
    return contact_of(answers).force.norm();
}

double vertical_force(const Answers& answers) {
    return std::abs(contact_of(answers).force.y());
}

double half_width(const ContactResult& contact) {
    double width = 0;
    for (const Vec2& end : contact.ends) width = std::max(width, std::abs(end.x()));
    return width;
}

double pressure_at_x(const ContactResult& contact, double x) {
    return interpolated(contact.profile.x, contact.profile.pressure, x);
}

double pressure_at_y(const ContactResult& contact, double y) {
    return interpolated(contact.profile.y, contact.profile.pressure, y);
}

double gap_at_y(const ContactResult& contact, double y) {
    return interpolated(contact.profile.y, contact.profile.gap, y);
}

double gap_at_top(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    return p.gap.at(static_cast<std::size_t>(std::max_element(p.y.begin(), p.y.end()) - p.y.begin()));
}

double mean_pressure(const ContactResult& contact) {
    const ContactProfile& p = contact.profile;
    double sum = 0, length = 0;
    for (std::size_t k = 0; k + 1 < p.x.size(); ++k) {
        const double piece = std::hypot(p.x[k + 1] - p.x[k], p.y[k + 1] - p.y[k]);
        sum += 0.5 * piece * (p.pressure[k] + p.pressure[k + 1]);
        length += piece;
    }
    return sum / length;
}

double least_pressure(const ContactResult& contact) {
    return *std::min_element(contact.profile.pressure.begin(), contact.profile.pressure.end());
}

double pressure_error(const ContactResult& contact, double exact) {
    double worst = 0;
    for (double p : contact.profile.pressure) worst = std::max(worst, std::abs(p - exact));
    return worst / exact;
}

double relative_error_norm(const std::vector<double>& value, const std::vector<double>& exact) {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
        difference += (value[k] - exact[k]) * (value[k] - exact[k]);
        size += exact[k] * exact[k];
    }
    return std::sqrt(difference / size);
}

}  // namespace abut
