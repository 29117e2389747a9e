// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/structure_reactions.hpp"

#include <algorithm>
#include <limits>

namespace abut::solver {

namespace {

using Eigen::VectorXd;

/// Forces of the other supports and of the springs, on the plain functions.
VectorXd other_forces(const PartSystem& s, const VectorXd& u) {
    std::vector<TractionPoint> points;
    for (const SupportRecord& record : s.supports)
        if (record.method == SupportMethod::nitsche) {
            const std::vector<Vec2> tractions = nitsche_tractions(s.input, record.set, u);
            for (std::size_t k = 0; k < tractions.size(); ++k) {
                const SupportPoint& p = record.set.points[k];
                points.push_back({p.element, p.x, p.weight, tractions[k]});
            }
        }
    for (const SpringSet& set : s.springs)
        for (const SpringPoint& p : set.points)
            points.push_back(
                {p.element, p.x, p.weight, spring_traction(set, p, displacement_at(s.input, u, p.element, p.x).value)});
    return boundary_load(s.input, points);
}

double distance(const SupportSet& set, const Vec2& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const SupportPoint& p : set.points) least = std::min(least, (p.x - x).norm());
    return least;
}

/// 0 below undivided_share, 1 above its complement.
double smooth_share(double own, double other) {
    if (own + other == 0) return 0.5;
    const double t = std::clamp((other / (own + other) - undivided_share) / (1 - 2 * undivided_share), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Shares of the sets in what a function at x carries; they sum up to 1.
std::vector<double> shares(const std::vector<const SupportSet*>& sets, const Vec2& x) {
    std::vector<double> d;
    for (const SupportSet* set : sets) d.push_back(distance(*set, x));
    std::vector<double> share(sets.size(), 1);
    double sum = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        for (std::size_t j = 0; j < sets.size(); ++j)
            if (j != k) share[k] = std::min(share[k], smooth_share(d[k], d[j]));
        sum += share[k];
    }
    for (double& v : share) v /= sum;
    return share;
}

}  // namespace

void add_structure_reactions(const PartSystem& system, const VectorXd& displacement, const VectorXd& plain,
                             std::vector<Resultant>& reactions) {
    VectorXd residual = internal_forces(system.input, displacement) - system.applied - other_forces(system, displacement);
    if (plain.size() > 0) residual -= plain;
    for (int component = 0; component < 2; ++component) {
        std::vector<const SupportSet*> sets;
        std::vector<std::size_t> of;
        for (std::size_t k = 0; k < system.supports.size(); ++k) {
            const SupportRecord& record = system.supports[k];
            if (record.method != SupportMethod::structure || record.set.component != component) continue;
            sets.push_back(&record.set);
            of.push_back(k);
        }
        if (sets.empty()) continue;
        for (int f = 0; f < system.n(); ++f) {
            const Vec2 x = greville_point(system.input.space, f);
            const std::vector<double> share = shares(sets, x);
            Vec2 force(0, 0);
            force[component] = coefficient_of_one(system.input.space, f) * residual[2 * f + component];
            for (std::size_t k = 0; k < sets.size(); ++k) reactions[of[k]].add(x, share[k] * force);
        }
    }
}

}  // namespace abut::solver
