// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/verification/verify_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut {

namespace {

/// The points of the answer that belong to the parts, and of their boundaries: samples of cut cells reach beyond.
std::vector<FieldSample> points_of(const Result& result) {
    std::vector<FieldSample> points;
    for (std::size_t i = 0; i < result.fields.size(); ++i) {
        for (const FieldSample& s : result.fields[i].samples)
            if (contains(result.geometry[i], s.at)) points.push_back(s);
        for (const auto& loop : result.fields[i].boundary) points.insert(points.end(), loop.begin(), loop.end());
    }
    return points;
}

double size_of(const Stress& s) {
    return std::sqrt(s.xx * s.xx + s.yy * s.yy + 2 * s.xy * s.xy);
}

Stress difference(const Stress& a, const Stress& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, 0};
}

}  // namespace

double largest_displacement_error(const Result& result, const ExactDisplacement& exact) {
    double error = 0, size = 0;
    for (const FieldSample& s : points_of(result)) {
        error = std::max(error, (s.displacement - exact(s.at)).norm());
        size = std::max(size, exact(s.at).norm());
    }
    return error / size;
}

double largest_stress_error(const Result& result, const ExactStress& exact) {
    double error = 0, size = 0;
    for (const FieldSample& s : points_of(result)) {
        error = std::max(error, size_of(difference(s.stress, exact(s.at))));
        size = std::max(size, size_of(exact(s.at)));
    }
    return error / size;
}

double largest_on_circle(const Result& result, double radius, const std::function<double(const FieldSample&)>& value) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < result.fields.size(); ++i)
        for (const auto& loop : result.fields[i].boundary)
            for (const FieldSample& s : loop)
                if (std::abs(s.at.norm() - radius) < geometry::merge_length(result.geometry[i]))
                    largest = std::max(largest, value(s));
    return largest;
}

double radial_stress(const FieldSample& sample) {
    const Vec2 n = sample.at.normalized();
    const Stress& s = sample.stress;
    return s.xx * n.x() * n.x() + s.yy * n.y() * n.y() + 2 * s.xy * n.x() * n.y();
}

double hoop_stress(const FieldSample& sample) {
    return sample.stress.xx + sample.stress.yy - radial_stress(sample);
}

double radial_displacement(const FieldSample& sample) {
    return sample.displacement.dot(sample.at.normalized());
}

}  // namespace abut
