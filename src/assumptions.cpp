// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/assumptions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/contact_measures.hpp"
#include "src/field_results.hpp"
#include "src/plan.hpp"
#include "src/svg.hpp"

namespace abut {

namespace {

/// Rotations and strains beyond which linear kinematics and elasticity are in doubt: a warning.
constexpr double large_rotation = 0.05, large_strain = 0.05;
constexpr double large_motion = 0.05;  // of the part's size
/// Rounding times condition number that counts: the error of the worst displacement field, seldom that of the loads' own.
constexpr double noted_rounding = 1e-3;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

struct LargestChange {
    double rotation = 0, strain = 0;
};

LargestChange largest_change(const PartOnGrid& g, const Eigen::VectorXd& displacement) {
    LargestChange largest;
    for (const auto& [element, x] : cut_cell_samples(g)) {
        const auto u = solver::displacement_at(g.input, displacement, element, x);
        largest.rotation = std::max(largest.rotation, 0.5 * std::abs(u.gradient(1, 0) - u.gradient(0, 1)));
        largest.strain = std::max(largest.strain, (0.5 * (u.gradient + u.gradient.transpose())).norm());
    }
    return largest;
}

void check_kinematics(const Scene& scene, const SolvedAssembly& solved, std::size_t k, Result& result) {
    const PartOnGrid& g = solved.grids[k];
    const LargestChange largest = largest_change(g, solved.solution.displacement[k]);
    const std::string& name = scene.parts[at(g.part)].name;
    const double motion = result.parts[at(g.part)].max_displacement.value;
    if (motion > large_motion * g.size)
        result.warnings.push_back("large displacement: part " + name + " moves by " + number_text(motion, 3) +
                                  "; contacts are paired where they are drawn");
    if (largest.rotation > large_rotation)
        result.warnings.push_back("large displacement: part " + name + " turns by up to " +
                                  number_text(largest.rotation * 180 / std::numbers::pi, 3) +
                                  " degrees; the answer is that of small displacements");
    if (largest.strain > large_strain)
        result.warnings.push_back("large strain: part " + name + " strains by up to " + number_text(100 * largest.strain, 3) +
                                  " %; the answer is that of linear elasticity");
}

void check_rules(const Scene& scene, const Outcome& out, Result& result) {
    for (std::size_t r = 0; r < scene.contacts.pairs.size(); ++r) {
        const bool used = std::any_of(out.candidates.begin(), out.candidates.end(),
                                      [&](const Candidate& c) { return c.rule == static_cast<int>(r); });
        if (!used && scene.contacts.pairs[r].kind != PairRule::Kind::ignore)
            result.warnings.push_back("contacts.pairs " + std::to_string(r) +
                                      " has no effect: these edges face each other nowhere within the search distance");
    }
}

/// Supports by weight functions do without the projection that nearly incompressible parts need: their stresses of degree 2 are
/// 4 % off at nu = 0.49 and as large as themselves at 0.4999 (the thick ring E10, eight cells across).
void warn_of_locking(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    for (const PartOnGrid& g : solved.grids) {
        const ScenePart& part = scene.parts[at(g.part)];
        const Material& material = scene.materials[at(part.material)];
        if (!g.input.is_projected && is_nearly_incompressible(scene, material))
            result.warnings.push_back(
                "part " + part.name + " is nearly incompressible (nu = " + number_text(material.nu, 6) +
                ") and held by a solution structure: its stresses converge slowly; take dirichlet \"nitsche\"");
    }
}

void check_rounding(Result& result) {
    const double rounding = std::numeric_limits<double>::epsilon() * result.solver.condition_estimate;
    if (rounding > noted_rounding)
        result.warnings.push_back("rounding may change this answer by up to " + number_text(100 * std::min(rounding, 1.0), 1) +
                                  " % (condition number " + number_text(result.solver.condition_estimate, 2) +
                                  "): a part is very slender, or runs out in a very sharp tip");
}

void check_grids(const Outcome& out, Result& result) {
    if (out.solved.grids.empty()) result.warnings.push_back("nothing acts on any part: there is nothing to solve");
    if (out.search_too_short)
        result.warnings.push_back("contact reaches the end of what was searched; give contacts.search_distance a larger value");
    if (out.solved.limited_grids > 0)
        result.warnings.push_back(
            "grids of " + std::to_string(out.solved.limited_grids) +
            " part(s) are coarser than the contacts ask for, to bound the number of cells; \"fine\" allows more");
    if (out.solved.refined_for_walls > 0)
        result.warnings.push_back("grids of " + std::to_string(out.solved.refined_for_walls) +
                                  " part(s) were refined because a wall was thinner than a cell");
}

}  // namespace

void check_assumptions(const Scene& scene, const Outcome& out, Result& result) {
    for (std::size_t k = 0; k < out.solved.grids.size(); ++k) check_kinematics(scene, out.solved, k, result);
    check_rules(scene, out, result);
    check_grids(out, result);
    check_rounding(result);
    warn_of_locking(scene, out.solved, result);
}

}  // namespace abut
