// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/answers/contact_results.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/interfaces/interface_kind.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"
#include "src/contact/candidate_faces.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

constexpr int profile_points_per_interval = 6;
constexpr int profile_points_per_penalty_point = 2;  // they stand closer than a pressure spline's knots
constexpr double margin_fraction = 0.35;             // of the contact's length that a profile shows beyond its ends

struct Side {
    const ScenePart& part;
    const PartOnGrid& grid;
    const Eigen::VectorXd& displacement;

    std::string edge_name(int edge) const { return name_of_edge(part, edge); }
    double arc_length(const geometry::ChainPoint& p) const { return edge_arc_length(part.part.edges[at(p.edge)], p.t); }
    Vec2 displacement_at(const geometry::ChainPoint& p) const {
        const auto u = solver::displacement_at(grid.input, displacement, element_of(grid, p), grid.frame.to_local(p.x));
        return grid.frame.vector_to_global(u.value);
    }
};

Side side_of(const Scene& scene, const SolvedAssembly& solved, int part) {
    const int k = solved.solver_part[at(part)];
    return {scene.parts[at(part)], solved.grids[at(k)], solved.solution.displacement[at(k)]};
}

/// Where the profile is sampled: every pressure interval, up to the faces' own ends; where only the search ended the zone, up
/// to a margin beyond the contact.
std::vector<double> profile_places(const ContactInterface& contact, const std::vector<PressedStretch>& stretches) {
    const solver::KnotVector& k = contact.face.pressure;
    double low = k.breakpoints.front(), high = k.breakpoints.back();
    if (!stretches.empty()) {
        double longest = 0;
        for (const PressedStretch& r : stretches) longest = std::max(longest, r.end - r.begin);
        if (contact.zone.begin_is_limit || contact.zone.closed)
            low = std::max(low, stretches.front().begin - margin_fraction * longest);
        if (contact.zone.end_is_limit || contact.zone.closed)
            high = std::min(high, stretches.back().end + margin_fraction * longest);
    }
    const int n = contact.face.penalty.empty() ? profile_points_per_interval : profile_points_per_penalty_point;
    std::vector<double> places;
    for (int i = 0; i < k.n_intervals(); ++i) {
        const double a = std::max(low, k.breakpoints[at(i)]), b = std::min(high, k.breakpoints[at(i) + 1]);
        if (b <= a) continue;
        for (int j = 0; j < n; ++j) places.push_back(a + (b - a) * j / n);
    }
    places.push_back(high);
    return places;
}

/// The pressure that answers to a gap: the pressure spline's, or what the penalty makes of a penetration there (the nearest
/// point's beta).
double pressure_for(const ContactInterface& contact, const Eigen::VectorXd& pressure, double s, double gap) {
    const std::vector<solver::InterfacePoint>& points = contact.face.points;
    if (contact.face.bilateral) return solver::pressure_at(contact.face.pressure, pressure, s);
    if (contact.face.penalty.empty()) return std::max(0.0, solver::pressure_at(contact.face.pressure, pressure, s));
    const auto after = std::lower_bound(points.begin(), points.end(), s, [](const auto& p, double v) { return p.s < v; });
    auto k = static_cast<std::size_t>(after - points.begin());
    if (k == points.size() || (k > 0 && s - points[k - 1].s < points[k].s - s)) --k;
    return contact.face.penalty[k] * std::max(0.0, -gap);
}

const Eigen::VectorXd& shear_of(const SolvedAssembly& solved, std::size_t contact) {
    return solved.solution.pressure[at(solved.shear_of[contact])];
}

std::string word_of(FrictionState state) {
    if (state == FrictionState::open) return "open";
    return state == FrictionState::stick ? "stick" : "slip";
}

FrictionResult friction_result(const SolvedAssembly& solved, std::size_t k) {
    FrictionResult friction;
    friction.coefficient = friction_of(solved, k);
    const solver::FrictionOnWay& on_way = solved.solution.friction[at(solved.shear_of[k])];
    friction.dissipated = on_way.work;
    friction.dissipated_error = on_way.work_error;
    if (std::isinf(friction.coefficient)) {  // what a finite one would have done is not its own
        friction.dissipated_error += std::abs(on_way.work);
        friction.dissipated = 0;
    }
    if (solved.stretches[k].empty()) return friction;
    const FrictionSums sums = friction_sums(solved, k);
    friction.shear_force = sums.shear;
    friction.normal_force = sums.normal;
    friction.utilisation = sums.share_of_limit(friction.coefficient);
    const FrictionLengths lengths = friction_lengths(solved, k, stick_borders(solved, k));
    friction.stick_length = lengths.stick;
    friction.slip_length = lengths.slip;
    return friction;
}

void fill_profile(const Scene& scene, const SolvedAssembly& solved, std::size_t k, const Candidate& candidate,
                  ContactResult& result) {
    const ContactInterface& contact = solved.contacts[k];
    const Eigen::VectorXd& pressure = pressure_of(solved, k);
    const Side first = side_of(scene, solved, candidate.first), second = side_of(scene, solved, candidate.second);
    const bool is_open = solved.stretches[k].empty();  // but for rounding
    for (double s : profile_places(contact, solved.stretches[k])) {
        const geometry::FacingPair pair = pair_at(scene, contact, s);
        if (!pair.found) continue;
        const double drawn = (candidate.no_overlap ? std::max(0.0, pair.gap) : pair.gap) - candidate.closing();
        const Vec2 apart = second.displacement_at(pair.on2) - first.displacement_at(pair.on1);
        const double gap = drawn + pair.normal.dot(apart);
        const double p = is_open ? 0 : pressure_for(contact, pressure, s, gap);
        ContactProfile& profile = result.profile;
        profile.edge.push_back(first.edge_name(pair.on1.edge));
        profile.s.push_back(first.arc_length(pair.on1));
        profile.x.push_back(pair.on1.x.x());
        profile.y.push_back(pair.on1.x.y());
        profile.edge2.push_back(second.edge_name(pair.on2.edge));
        profile.s2.push_back(second.arc_length(pair.on2));
        profile.x2.push_back(pair.on2.x.x());
        profile.y2.push_back(pair.on2.x.y());
        profile.pressure.push_back(p);
        profile.gap.push_back(gap);
        if (solved.shear_of[k] >= 0)
            profile.shear.push_back(is_open ? 0 : solver::pressure_at(contact.face.pressure, shear_of(solved, k), s));
        if (friction_of(solved, k) > 0) {
            profile.slip.push_back(geometry::left_of(pair.normal).dot(apart));
            profile.state.push_back(is_open ? "open" : word_of(state_at(solved, k, s)));
        }
        result.max_penetration = std::max(result.max_penetration, -gap);
        if (p > result.max_pressure.value || profile.s.size() == 1) result.max_pressure = {p, pair.on1.x};
    }
}

/// Names of the edges met along a profile, in order, and the one that carries most: of the pressure, or of the length where
/// open.
void name_edges(const std::vector<std::string>& edge, const std::vector<double>& pressure, std::vector<std::string>& all,
                std::string& main) {
    std::map<std::string, double> share;
    const bool loaded = std::any_of(pressure.begin(), pressure.end(), [](double p) { return p != 0; });
    for (std::size_t i = 0; i < edge.size(); ++i) {
        if (std::find(all.begin(), all.end(), edge[i]) == all.end()) all.push_back(edge[i]);
        share[edge[i]] += loaded ? std::abs(pressure[i]) : 1;
    }
    double most = -1;
    for (const std::string& name : all)
        if (share[name] > most) {
            most = share[name];
            main = name;
        }
}

int edge_named(const ScenePart& part, const std::string& qualified) {
    for (std::size_t e = 0; e < part.part.edges.size(); ++e)
        if (part.name + "/" + part.part.edges[e].name == qualified) return static_cast<int>(e);
    return 0;
}

/// Of a pair that is not solved, as both its parts are rigid.
void name_faces(const Scene& scene, const Candidate& candidate, ContactResult& result) {
    const CandidateFaces faces = faces_of(scene, candidate);
    result.edges = edge_names(scene, candidate, faces);
    result.between = {name_of_edge(scene.parts[at(candidate.first)], faces.carrying[0]),
                      name_of_edge(scene.parts[at(candidate.second)], faces.carrying[1])};
    result.interface = faces.kind;
}

std::string interface_of(const Scene& scene, const Candidate& candidate, const std::array<std::string, 2>& between) {
    const ScenePart &a = scene.parts[at(candidate.first)], &b = scene.parts[at(candidate.second)];
    return geometry::interface_kind(a.part, edge_named(a, between[0]), b.part, edge_named(b, between[1]));
}

}  // namespace

std::string contact_status(const ContactInterface& contact, const std::vector<PressedStretch>& stretches) {
    if (contact.face.bilateral) return "closed";
    if (stretches.empty()) return "open";
    const bool whole = stretches.size() == 1 && stretches[0].from_start && stretches[0].to_end;
    return whole && !contact.zone.begin_is_limit && !contact.zone.end_is_limit ? "closed" : "partial";
}

ContactResult contact_result(const Scene& scene, const SolvedAssembly& solved, const Candidate& candidate,
                             std::size_t contact) {
    ENSURE(contact < solved.contacts.size(), "an answer is of a contact of the assembly");
    const ContactInterface& c = solved.contacts[contact];
    ContactResult result;
    result.part = {candidate.first, candidate.second};
    result.parts = {scene.parts[at(candidate.first)].name, scene.parts[at(candidate.second)].name};
    result.gap_min = candidate.zone.gap_min - candidate.interference;
    result.gap_max = candidate.zone.gap_max - candidate.interference;
    if (solved.interface_of[contact] < 0) {
        result.status = "open";
        name_faces(scene, candidate, result);
        return result;
    }
    result.status = contact_status(c, solved.stretches[contact]);
    result.contact_length = length_of(solved.stretches[contact]);
    for (const PressedEnd& end : pressed_ends(scene, solved, contact)) result.ends.push_back(end.pair.on1.x);
    if (c.face.bilateral) result.kind = "bonded";
    if (friction_of(solved, contact) > 0) result.friction = friction_result(solved, contact);
    fill_profile(scene, solved, contact, candidate, result);
    name_edges(result.profile.edge, result.profile.pressure, result.edges[0], result.between[0]);
    name_edges(result.profile.edge2, result.profile.pressure, result.edges[1], result.between[1]);
    result.interface = corner_kind(scene, candidate).value_or(interface_of(scene, candidate, result.between));
    if (result.status == "open") return result;
    const ContactForce total = contact_force(solved, contact);
    result.force = total.force;
    result.moment = total.moment;
    return result;
}

}  // namespace abut
