// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/session/contact_reader.hpp"

#include <algorithm>
#include <cmath>

#include "src/answers/contact_results.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

constexpr int samples_per_interval = 6;  // as profiles of results have

bool reaches_limit(const ContactInterface& c, const std::vector<PressedStretch>& stretches) {
    return !c.face.bilateral && std::any_of(stretches.begin(), stretches.end(), [&](const PressedStretch& stretch) {
        return (stretch.from_start && c.zone.begin_is_limit) || (stretch.to_end && c.zone.end_is_limit);
    });
}

}  // namespace

ContactReader::ContactReader(const Scene& scene, const SolvedAssembly& solved, std::size_t contact, const ContactResult& told)
    : solved_(solved), contact_(contact) {
    told_.parts = told.parts;
    told_.between = told.between;
    told_.kind = told.kind;
    told_.status = "open";
    auto places = std::make_shared<ContactPlaces>();
    told_.places = places;
    if (solved.interface_of[contact] < 0) return;
    const ContactInterface& c = solved.contacts[contact];
    const PartOnGrid& first = solved.grids[at(c.face.part[0])];
    forces_ = forces_of_pressure(first, c.face);
    if (const int shear = solved.shear_of[contact]; shear >= 0)
        shear_forces_ = forces_of_pressure(first, solved.problem.interfaces[at(shear)]);
    const std::vector<double>& knots = c.face.pressure.breakpoints;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double step = (knots[i + 1] - knots[i]) / samples_per_interval;
        for (int j = 0; j < samples_per_interval; ++j) add_sample(scene, knots[i] + j * step, step, *places);
    }
    add_sample(scene, knots.back(), 0, *places);
}

void ContactReader::add_sample(const Scene& scene, double s, double weight, ContactPlaces& places) {
    const ContactInterface& c = solved_.contacts[contact_];
    const geometry::FacingPair pair = pair_at(scene, c, s);
    if (!pair.found) return;
    const ScenePart& part = scene.parts[at(c.part[0])];
    const geometry::Edge& edge = part.part.edges[at(pair.on1.edge)];
    places.edge.push_back(part.name + "/" + edge.name);
    places.s.push_back(edge_arc_length(edge, pair.on1.t));
    places.x.push_back(pair.on1.x.x());
    places.y.push_back(pair.on1.x.y());
    const solver::KnotVector& knots = c.face.pressure;
    const int interval = solver::interval_of(knots, s);
    Sample sample{knots.first[at(interval)], {}, weight};
    solver::evaluate(knots, interval, s, sample.value);
    samples_.push_back(sample);
}

double ContactReader::value_of(const Sample& sample, const Eigen::VectorXd& coefficients) const {
    double sum = 0;
    for (int i = 0; i <= solved_.contacts[contact_].face.pressure.degree; ++i)
        sum += sample.value[at(i)] * coefficients[sample.first + i];
    return sum;
}

ReadContact ContactReader::read(const solver::LoadAnswer& answer, double load_scale) const {
    ReadContact read{told_};
    ContactAnswer& told = read.answer;
    told.pressure.assign(samples_.size(), 0);
    if (solved_.interface_of[contact_] < 0) return read;
    const ContactInterface& c = solved_.contacts[contact_];
    const Eigen::VectorXd& pressure = answer.pressure[at(solved_.interface_of[contact_])];
    const std::vector<PressedStretch> stretches = stretches_of(solved_, contact_, pressure, load_scale);
    told.status = contact_status(c, stretches);
    read.leaves_search = reaches_limit(c, stretches);
    if (stretches.empty() || samples_.empty()) return read;
    const bool may_pull = c.face.bilateral;
    std::size_t largest = 0;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        const Sample& sample = samples_[k];
        const double p = value_of(sample, pressure);
        told.pressure[k] = may_pull ? p : std::max(0.0, p);
        read.norm += sample.weight * p * p;
        if (told.pressure[k] > told.pressure[largest]) largest = k;
    }
    read.norm = std::sqrt(read.norm);
    if (const int shear = solved_.shear_of[contact_]; shear >= 0)
        for (const Sample& sample : samples_) told.shear.push_back(value_of(sample, answer.pressure[at(shear)]));
    told.max_pressure = {told.pressure[largest], {told.places->x[largest], told.places->y[largest]}};
    Eigen::Vector3d force = forces_ * pressure;
    if (const int shear = solved_.shear_of[contact_]; shear >= 0) force += shear_forces_ * answer.pressure[at(shear)];
    told.force = force.head<2>();
    told.moment = force[2];
    told.contact_length = length_of(stretches);
    for (const PressedStretch& stretch : stretches)
        read.end_error = std::hypot(read.end_error, stretch.at_begin.error, stretch.at_end.error);
    return read;
}

}  // namespace abut
