// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/solution/contact_measures.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/contact/traction_arm.hpp"
#include "src/base/index.hpp"

namespace abut {

double energy_of_part(const SolvedAssembly& s, std::size_t part) {
    return s.part_energy.empty() ? strain_energy(s.problem.parts[part], s.solution.displacement[part]) : s.part_energy[part];
}

double energy_of(const SolvedAssembly& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.problem.parts.size(); ++i) sum += energy_of_part(s, i);
    return sum;
}

namespace {

/// Rounding of sums over stiffness matrices, the penalties of supports in them included.
constexpr double stiffness_rounding = 1e-9;

double largest_displacement(const SolvedAssembly& s, std::size_t part) {
    return s.solution.displacement[part].cwiseAbs().maxCoeff();
}
double stiffness_of(const SolvedAssembly& s, std::size_t part) {
    return s.grids[part].input.elasticity.d11 * s.grids[part].input.thickness;
}

}  // namespace

double energy_rounding_of(const SolvedAssembly& s) {
    double sum = 0;
    for (std::size_t i = 0; i < s.grids.size(); ++i) {
        const double moved = largest_displacement(s, i);
        sum += stiffness_rounding * stiffness_of(s, i) * moved * moved;
    }
    return sum;
}

double pressing_force(const SolvedAssembly& s, std::size_t contact) {
    double sum = 0;
    if (s.interface_of[contact] < 0) return sum;
    const solver::Interface& face = s.contacts[contact].face;
    for (const solver::InterfacePoint& p : face.points)
        sum += p.weight * face.thickness * solver::pressure_at(face.pressure, pressure_of(s, contact), p.s);
    return sum;
}

std::vector<PressedEnd> pressed_ends(const Scene& scene, const SolvedAssembly& solved, std::size_t contact) {
    std::vector<PressedEnd> ends;
    for (const PressedStretch& stretch : solved.stretches[contact])
        for (const auto& [s, end] : {std::pair(stretch.begin, stretch.at_begin), std::pair(stretch.end, stretch.at_end)})
            ends.push_back({s, end.kind, pair_at(scene, solved.contacts[contact], s)});
    return ends;
}

std::vector<Vec2> points_that_carry(const Scene& scene, const SolvedAssembly& s, std::size_t part) {
    std::set<int> carrying;  // supports
    const double least = std::max(solver::neutral_work_fraction * s.problem.load_scale,
                                  stiffness_rounding * stiffness_of(s, part) * largest_displacement(s, part));
    for (std::size_t k = 0; k < s.problem.constraints.size(); ++k)
        if (s.problem.constraints[k].part == static_cast<int>(part) && std::abs(s.solution.constraint_force[k]) > least)
            carrying.insert(s.problem.constraints[k].tag);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < scene.supports.size(); ++i) {
        const Support& support = scene.supports[i];
        const bool is_its = support.kind == Support::Kind::points && support.part == scene.parts[at(s.grids[part].part)].name;
        if (is_its && (s.grids[part].input.structure || s.grids[part].is_rigid || carrying.count(static_cast<int>(i)) > 0))
            points.insert(points.end(), support.at.begin(), support.at.end());
    }
    return points;
}

namespace {

void add_force(const Eigen::Vector3d& share, ContactForce& total) {
    total.force += share.head<2>();
    total.moment += share[2];
}

}  // namespace

Eigen::Matrix3Xd forces_of_pressure(const PartOnGrid& first, const solver::Interface& face, double begin, double end) {
    const solver::KnotVector& knots = face.pressure;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, knots.n_functions());
    for (const solver::InterfacePoint& p : face.points) {
        if (p.s < begin || p.s > end) continue;
        const Vec2 direction = -first.frame.vector_to_global(p.normal[0]);
        // moments of a ring's forces balance by themselves
        const double lever =
            first.input.axis ? 0 : geometry::cross(first.frame.to_global(p.x[0] + solver::traction_arm(face, p, 0)), direction);
        const int interval = solver::interval_of(knots, p.s);
        solver::LocalValues value;
        solver::evaluate(knots, interval, p.s, value);
        for (int k = 0; k <= knots.degree; ++k)
            forces.col(knots.first[static_cast<std::size_t>(interval)] + k) +=
                p.weight * face.thickness * value[static_cast<std::size_t>(k)] *
                Eigen::Vector3d(direction.x(), direction.y(), lever);
    }
    return forces;
}

ContactForce contact_force(const SolvedAssembly& solved, std::size_t contact) {
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    return contact_force_between(solved, contact, -anywhere, anywhere);
}

ContactForce contact_force_between(const SolvedAssembly& solved, std::size_t contact, double begin, double end) {
    ContactForce total;
    const ContactInterface& c = solved.contacts[contact];
    const PartOnGrid& grid = solved.grids[static_cast<std::size_t>(c.face.part[0])];
    add_force(forces_of_pressure(grid, c.face, begin, end) * pressure_of(solved, contact), total);
    if (const int shear = solved.shear_of[contact]; shear >= 0)
        add_force(forces_of_pressure(grid, solved.problem.interfaces[static_cast<std::size_t>(shear)], begin, end) *
                      solved.solution.pressure[static_cast<std::size_t>(shear)],
                  total);
    return total;
}

double half_plane_compliance(const PartOnGrid& g, double thickness) {
    const solver::Elasticity& d = g.input.elasticity;
    return g.is_rigid ? 0 : d.d11 / (d.d11 * d.d11 - d.d12 * d.d12) * thickness / g.input.thickness;
}

double compliance_of(const SolvedAssembly& solved, std::size_t contact) {
    const ContactInterface& c = solved.contacts[contact];
    double sum = 0;
    for (int part : c.face.part) sum += half_plane_compliance(solved.grids[static_cast<std::size_t>(part)], c.face.thickness);
    return sum;
}

double penetration_share(const SolvedAssembly& solved, std::size_t contact) {
    const ContactInterface& c = solved.contacts[contact];
    if (c.face.penalty.empty() || solved.stretches[contact].empty()) return 0;
    const double softest = *std::min_element(c.face.penalty.begin(), c.face.penalty.end());
    double half_width = 0;
    for (const PressedStretch& stretch : solved.stretches[contact])
        half_width = std::max(half_width, 0.5 * (stretch.end - stretch.begin));
    return 1 / (compliance_of(solved, contact) * softest * half_width);
}

bool any_stretch(const SolvedAssembly& s) {
    for (std::size_t k = 0; k < s.stretches.size(); ++k)
        if (!s.stretches[k].empty() && !s.contacts[k].face.bilateral) return true;
    return false;
}

}  // namespace abut
