// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/stiff_parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/contact/softer_parts.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/ensure.hpp"
#include "src/base/index.hpp"

namespace abut {

namespace {

/// Integrals of the pressure and of friction's traction.
Vec2 borne(const SolvedAssembly& solved, std::size_t contact, const solver::AssemblySolution& solution) {
    Vec2 sum(0, 0);
    for (const auto& [axis, interface] : {std::pair(0, solved.interface_of[contact]), std::pair(1, solved.shear_of[contact])}) {
        if (interface < 0) continue;
        const solver::Interface& face = solved.problem.interfaces[at(interface)];
        for (const solver::InterfacePoint& p : face.points)
            sum[axis] += p.weight * solver::pressure_at(face.pressure, solution.pressure[at(interface)], p.s);
    }
    return sum;
}

}  // namespace

std::vector<char> depend_on_stiffness(const SolvedAssembly& solved) {
    std::vector<char> depend(solved.contacts.size(), 0);
    const std::vector<char> is_static = given_by_statics(solved);
    for (std::size_t k = 0; k < depend.size(); ++k) {
        if (!solved.contacts[k].face.penalty.empty()) return std::vector<char>(depend.size(), 0);
        depend[k] =
            solved.interface_of[k] >= 0 && !solved.contacts[k].face.bilateral && !solved.stretches[k].empty() && !is_static[k];
    }
    return depend;
}

std::vector<double> shares_of_stiffness(const SolvedAssembly& solved, const std::vector<char>& depend,
                                        const std::vector<double>& missed, int threads) {
    const std::size_t n = solved.contacts.size();
    std::vector<double> shares(n, 0);
    if (missed.empty()) return shares;
    ENSURE(depend.size() == n && missed.size() == solved.grids.size(), "contacts depend on stiffness or not, parts miss some");
    const solver::AssemblySolution softer = solver::solve_with_softer_parts(solved.problem, solved.solution, missed, threads);
    for (std::size_t k = 0; softer.converged && k < n; ++k) {
        if (!depend[k]) continue;
        const Vec2 force = borne(solved, k, solved.solution), change = borne(solved, k, softer) - force;
        if (force.norm() > 0) shares[k] = std::min(1.0, change.norm() / force.norm());
    }
    return shares;
}

}  // namespace abut
