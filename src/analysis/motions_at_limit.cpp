// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/motions_at_limit.hpp"

#include <cmath>
#include <vector>

#include "solver/linear_algebra/dense.hpp"
#include "solver/parts/free_motions.hpp"
#include "src/analysis/static_forces.hpp"
#include "src/answers/motion_text.hpp"
#include "src/base/index.hpp"
#include "src/results/findings.hpp"
#include "src/solution/contact_interface.hpp"
#include "src/solution/contact_states.hpp"

namespace abut {

namespace {

using Eigen::Index;

/// Of the motion that is resisted most, rotations measured at the part's size: what works less in a motion resists nothing in
/// it.
constexpr double resists_nothing = 1e-3;

/// A unit force that could act on a part.
struct UnitForce {
    Vec2 at, force;
};

bool is_at_limit(const SolvedAssembly& solved, std::size_t contact) {
    const double friction = friction_of(solved, contact);
    if (friction == 0) return true;
    const FrictionSums sums = friction_sums(solved, contact);
    return std::abs(sums.shear) >= (1 - slip_fraction) * friction * sums.normal;
}

/// What contacts resist motions of a part by, sliding along them left out where friction bears no more. Round faces on others
/// press at one place; in hollow ones the pressure moves along as it has to: a joint about the centre of the body inside.
std::vector<UnitForce> resisting(const Scene& scene, const SolvedAssembly& solved, std::size_t part) {
    std::vector<UnitForce> forces;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (at(c.face.part[0]) != part && at(c.face.part[1]) != part) continue;
        const bool slides = is_at_limit(solved, k) && !c.face.bilateral;
        for (const PressedStretch& stretch : solved.stretches[k])
            for (const double share : {0.0, 0.5, 1.0}) {
                const geometry::FacingPair pair = pair_at(scene, c, stretch.begin + share * (stretch.end - stretch.begin));
                if (!pair.found) continue;
                const double k1 = pair.on1.curvature, k2 = pair.on2.curvature;
                const bool is_hollow = k1 < 0 || k2 < 0;
                if ((is_hollow || k1 + k2 > 0) && share != 0.5) continue;
                const Vec2 aside = geometry::left_of(pair.normal);
                const double inner = k1 < 0 ? k2 : k1;
                const Vec2 middle = inner > 0 ? Vec2(pair.on1.x + (k1 < 0 ? 1 : -1) / inner * pair.normal) : pair.on1.x;
                if (is_hollow) forces.insert(forces.end(), {{middle, pair.normal}, {middle, aside}});
                if (!is_hollow) forces.push_back({pair.on1.x, pair.normal});
                if (!slides) forces.push_back({pair.on1.x, aside});
            }
    }
    return forces;
}

/// The motions of a part that are in no contact's way but for friction at its limit.
std::vector<solver::PartMotion> motions_at_limit(const Scene& scene, const SolvedAssembly& solved, std::size_t part) {
    const std::vector<solver::RigidMotion> free = motions_left_to_contacts(solved, part);
    const std::vector<UnitForce> forces = resisting(scene, solved, part);
    if (free.empty() || forces.empty()) return {};
    const Frame& frame = solved.grids[part].frame;
    Eigen::MatrixXd work(static_cast<Index>(forces.size()), static_cast<Index>(free.size()));
    for (Index f = 0; f < work.rows(); ++f)
        for (Index m = 0; m < work.cols(); ++m) {
            const auto& [place, force] = forces[at(static_cast<int>(f))];
            work(f, m) = frame.vector_to_local(force).dot(free[at(static_cast<int>(m))].at(frame.to_local(place)));
        }
    const auto [values, vectors] = solver::right_singular_vectors(work);
    std::vector<solver::PartMotion> motions;
    for (Index k = 0; k < work.cols(); ++k) {
        if (k < values.size() && values[k] > resists_nothing * values[0]) continue;
        motions.push_back({static_cast<int>(part), solver::sum_of_motions(free, vectors.col(k))});
    }
    return motions;
}

bool slips_somewhere(const SolvedAssembly& solved, std::size_t part) {
    for (std::size_t k = 0; k < solved.contacts.size(); ++k)
        for (const int of : solved.contacts[k].face.part)
            if (at(of) == part && !solved.stretches[k].empty() && friction_of(solved, k) > 0) return true;
    return false;
}

}  // namespace

bool any_at_limit(const Scene& scene, const SolvedAssembly& solved) {
    for (std::size_t part = 0; part < solved.grids.size(); ++part)
        if (slips_somewhere(solved, part) && !motions_at_limit(scene, solved, part).empty()) return true;
    return false;
}

void warn_of_motions_at_limit(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    for (std::size_t part = 0; part < solved.grids.size(); ++part) {
        if (!slips_somewhere(solved, part)) continue;
        for (const solver::PartMotion& motion : motions_at_limit(scene, solved, part)) {
            const std::string& name = scene.parts[at(solved.grids[part].part)].name;
            findings.push_back(
                {0, name,
                 "friction bears all it can wherever it is in the way of this: " + motion_text(scene, solved, motion) +
                     "; how far it does so is open within bounds, and so is how slip, and the work done in it, "
                     "are shared among the contacts of " +
                     name});
        }
    }
    remark(std::move(findings), result);
}

}  // namespace abut
