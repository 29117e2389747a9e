// SPDX-License-Identifier: GPL-3.0-or-later
// One answer against another.
#include <algorithm>
#include <cmath>
#include <limits>

#include "src/study/study_reference.hpp"

namespace abut {

namespace {

using Contact = StudyAnswer::Contact;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Vec2 point_of(const Contact& c, std::size_t i) {
    return {c.x[i], c.y[i]};
}

/// Pressure at the point of the profile's polyline that is nearest to x.
double pressure_near(const Contact& c, const Vec2& x) {
    double nearest = std::numeric_limits<double>::infinity(), pressure = 0;
    for (std::size_t i = 0; i + 1 < c.x.size(); ++i) {
        const Vec2 from = point_of(c, i), along = point_of(c, i + 1) - from;
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp((x - from).dot(along) / length, 0.0, 1.0) : 0.0;
        const double distance = (from + t * along - x).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        pressure = (1 - t) * c.pressure[i] + t * c.pressure[i + 1];
    }
    return pressure;
}

struct Sums {
    double difference = 0, reference = 0;
    double relative() const { return reference > 0 ? std::sqrt(difference / reference) : unknown; }
    void add(double weight, double value, double exact) {
        difference += weight * (value - exact) * (value - exact);
        reference += weight * exact * exact;
    }
};

void add_pressures(const Contact& c, const Contact& reference, Sums& sums) {
    for (std::size_t i = 0; i + 1 < reference.x.size(); ++i) {
        const Vec2 a = point_of(reference, i), b = point_of(reference, i + 1);
        const double exact = 0.5 * (reference.pressure[i] + reference.pressure[i + 1]);
        sums.add((b - a).norm(), pressure_near(c, 0.5 * (a + b)), exact);
    }
}

bool has_same_contacts(const StudyAnswer& a, const StudyAnswer& b) {
    return std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                      [](const Contact& c, const Contact& d) { return c.between == d.between; });
}

void add_contact_differences(const StudyAnswer& a, const StudyAnswer& b, std::vector<double>& list) {
    Sums pressure, peak, force;
    const bool comparable = has_same_contacts(a, b);
    for (std::size_t k = 0; comparable && k < b.contacts.size(); ++k) {
        const Contact &c = a.contacts[k], &d = b.contacts[k];
        add_pressures(c, d, pressure);
        peak.add(1, c.peak, d.peak);
        for (int i : {0, 1}) force.add(1, c.force[i], d.force[i]);
    }
    for (const Sums& sums : {pressure, peak, force}) list.push_back(comparable ? sums.relative() : unknown);
}

double relative_difference(double value, double exact) {
    return exact != 0 ? std::abs(value - exact) / std::abs(exact) : unknown;
}

}  // namespace

std::vector<StudyMeasure> measures_of(const StudyAnswer& reference) {
    std::vector<StudyMeasure> measures;
    if (!reference.contacts.empty())
        measures = {{"contact pressure, L2 along the edges"}, {"largest pressure"}, {"contact forces"}};
    measures.push_back({"strain energy"});
    if (!reference.probes.empty()) measures.push_back({"displacement of the probes"});
    measures.push_back({"largest von Mises stress"});
    return measures;
}

std::vector<double> differences(const StudyAnswer& answer, const StudyAnswer& reference) {
    std::vector<double> list;
    if (!reference.contacts.empty()) add_contact_differences(answer, reference, list);
    list.push_back(relative_difference(answer.energy, reference.energy));
    if (!reference.probes.empty()) {
        Sums probes;
        const bool comparable = answer.probes.size() == reference.probes.size();
        for (std::size_t k = 0; comparable && k < reference.probes.size(); ++k)
            for (int i : {0, 1}) probes.add(1, answer.probes[k][i], reference.probes[k][i]);
        list.push_back(comparable ? probes.relative() : unknown);
    }
    list.push_back(relative_difference(answer.stress, reference.stress));
    return list;
}

}  // namespace abut
