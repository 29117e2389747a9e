// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/stiff_parts.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/softer_parts.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/base/index.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

double pressed(const solver::Interface& face, const Eigen::VectorXd& coefficients) {
    double sum = 0;
    for (const solver::InterfacePoint& p : face.points) sum += p.weight * solver::pressure_at(face.pressure, coefficients, p.s);
    return sum;
}

}  // namespace

std::vector<double> shares_of_stiffness(const SolvedAssembly& solved, const std::vector<double>& missed, int threads) {
    const std::size_t n = solved.contacts.size();
    std::vector<double> shares(n, 0);
    std::vector<char> asks(n, 0);
    const std::vector<char> is_static = given_by_statics(solved);
    for (std::size_t k = 0; k < n; ++k) {
        if (friction_of(solved, k) > 0 || !solved.contacts[k].face.penalty.empty()) return shares;
        asks[k] =
            solved.interface_of[k] >= 0 && !solved.contacts[k].face.bilateral && !solved.stretches[k].empty() && !is_static[k];
    }
    if (missed.size() != solved.grids.size() || std::count(asks.begin(), asks.end(), 1) == 0) return shares;
    const solver::AssemblySolution softer = solver::solve_with_softer_parts(solved.problem, solved.solution, missed, threads);
    for (std::size_t k = 0; softer.converged && k < n; ++k) {
        if (!asks[k]) continue;
        const solver::Interface& face = solved.contacts[k].face;
        const double force = pressed(face, pressure_of(solved, k));
        if (!(force > 0)) continue;
        const double change = pressed(face, softer.pressure[at(solved.interface_of[k])]) - force;
        shares[k] = std::min(1.0, std::abs(change) / force);
    }
    return shares;
}

}  // namespace abut
