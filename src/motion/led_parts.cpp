// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/motion/led_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

constexpr double within = 0.9;  // of a step

bool leads_at_all(const Lead& lead) {
    return lead.is_given[0] || lead.is_given[1] || lead.is_given[2];
}

}  // namespace

LedParts::LedParts(std::vector<Lead> leads, std::vector<Vec2> centers, std::vector<double> sizes, std::vector<int> bodies)
    : leads_(std::move(leads)),
      centers_(std::move(centers)),
      sizes_(std::move(sizes)),
      bodies_(std::move(bodies)),
      pushes_(leads_.size(), Eigen::Vector3d::Zero()),
      gets_there_(leads_.size(), 0) {
    ENSURE(centers_.size() == leads_.size() && sizes_.size() == leads_.size() && bodies_.size() == leads_.size(),
           "every part has a place, a size and a body");
}

bool LedParts::any() const {
    return std::any_of(leads_.begin(), leads_.end(), [](const Lead& lead) { return lead.goes_anywhere(); });
}

bool LedParts::is_led(std::size_t part) const {
    for (std::size_t i = 0; i < leads_.size(); ++i)
        if (bodies_[i] == bodies_[part] && leads_at_all(leads_[i])) return true;
    return false;
}

bool LedParts::has_way(std::size_t part) const {
    return steps_to(part, leads_[part]) > 0;
}

Eigen::Vector3d LedParts::gone(std::size_t part, const Placement& placement) const {
    return leads_[part].of(placement.of(centers_[part]) - centers_[part], placement.angle);
}

double LedParts::way_of(std::size_t part, const Lead& lead) const {
    Eigen::Vector3d way = lead.to;
    way[2] *= 0.5 * sizes_[part];
    for (int c = 0; c < 3; ++c)
        if (!lead.is_given[at(c)]) way[c] = 0;
    return way.norm();
}

double LedParts::steps_to(std::size_t part, const Lead& lead) const {
    return way_of(part, lead) / (within * step_fraction * sizes_[part]);
}

double LedParts::farthest_left(const std::vector<Placement>& placements) const {
    const std::vector<Lead> leads = left(placements);
    double farthest = 0;
    for (std::size_t i = 0; i < leads.size(); ++i) farthest = std::max(farthest, way_of(i, leads[i]));
    return farthest;
}

std::vector<Lead> LedParts::left(const std::vector<Placement>& placements) const {
    std::vector<Lead> leads = leads_;
    for (std::size_t i = 0; i < leads.size(); ++i) leads[i].to -= gone(i, placements[i]);
    return leads;
}

std::vector<Lead> LedParts::of_step(const std::vector<Placement>& placements, double share, double reach) const {
    std::vector<Lead> leads = left(placements);
    double longest = reach;
    for (std::size_t i = 0; i < leads.size(); ++i) longest = std::max(longest, steps_to(i, leads[i]));
    for (Lead& lead : leads) lead.to *= share * reach / longest;
    return leads;
}

bool LedParts::are_there(const std::vector<Placement>& placements) const {
    const std::vector<Lead> leads = left(placements);
    for (std::size_t i = 0; i < leads.size(); ++i)
        if (steps_to(i, leads[i]) * step_fraction > arrived_fraction) return false;
    return true;
}

void LedParts::end(std::vector<Placement>& placements) const {
    for (std::size_t part = 0; part < leads_.size(); ++part) {
        const Lead& lead = leads_[part];
        if (!leads_at_all(lead)) continue;
        Eigen::Vector3d by = gone(part, placements[part]);
        for (int c = 0; c < 3; ++c)
            if (lead.is_given[at(c)]) by[c] = lead.to[c];
        const Placement there = about_center(centers_[part], lead.translation(by.head<2>()), by[2]);
        for (std::size_t i = 0; i < placements.size(); ++i)
            if (bodies_[i] == bodies_[part]) placements[i] = there;
    }
}

bool LedParts::push_where_blocked(const MovingParts& moving, const Eigen::VectorXd& step, const std::vector<Lead>& asked,
                                  double share, double least_way) {
    constexpr double half = 0.5;     // soft leads against gaps do all of it, or next to nothing
    constexpr double strength = 10;  // beside all loads
    double loads = 0;
    for (const MovingPart& b : moving.list) loads += b.pull;
    bool any = false;
    for (const MovingPart& b : moving.list) {
        Lead& lead = leads_[at(b.part)];
        if (lead.way < 0 || !lead.is_given[at(lead.way)]) continue;
        const double way = asked[at(b.part)].to[lead.way],
                     goes = lead.of(b.motion(step).head<2>(), b.motion(step)[2])[lead.way], arm = lead.way == 2 ? b.arm : 1;
        if (arm * std::abs(way) <= within * least_way * b.size ||
            goes * way >= half * (gets_there_[at(b.part)] ? share : 1) * way * way)
            continue;
        lead.is_given[at(lead.way)] = false;
        const Eigen::Vector3d along = Eigen::Vector3d::Unit(lead.way) * (way > 0 ? 1 : -1);
        const Vec2 force = lead.translation(along.head<2>());
        pushes_[at(b.part)] = strength * (loads > 0 ? loads : 1) * Eigen::Vector3d(force.x(), force.y(), arm * along[2]);
        any = true;
    }
    return any;
}

bool LedParts::end_pushes(const MovingParts& moving, const Eigen::VectorXd& step, const std::vector<Placement>& placements) {
    bool any = false;
    for (const MovingPart& b : moving.list) {
        const std::size_t i = at(b.part);
        Lead& lead = leads_[i];
        if (pushes_[i].isZero(0)) continue;
        const double goes = lead.of(b.motion(step).head<2>(), b.motion(step)[2])[lead.way];
        if ((gone(i, placements[i])[lead.way] + goes) / lead.to[lead.way] < 1) continue;
        lead.is_given[at(lead.way)] = true;
        pushes_[i].setZero();
        gets_there_[i] = 1;
        any = true;
    }
    return any;
}

void LedParts::act_on(MovingParts& moving) const {
    for (MovingPart& b : moving.list) {
        const Eigen::Vector3d& push = pushes_[at(b.part)];
        if (push.isZero(0)) continue;
        b.load.force += push.head<2>();
        b.load.moment += push[2];
        b.pull = std::max({b.pull, push.head<2>().norm(), std::abs(push[2]) / b.arm});
        moving.pull = std::max(moving.pull, b.pull);
    }
}

}  // namespace abut
