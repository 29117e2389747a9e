// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/assumptions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/assembly/ring.hpp"
#include "solver/terms/solution_structure.hpp"
#include "src/analysis/singular_places.hpp"
#include "src/answers/field_results.hpp"
#include "src/base/index.hpp"
#include "src/contact/pair_rules.hpp"
#include "src/io/number_text.hpp"
#include "src/plan/left_out_parts.hpp"
#include "src/plan/plan.hpp"
#include "src/plan/rigid_parts.hpp"
#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"
#include "src/scene/dissertation_method.hpp"
#include "src/solution/contact_measures.hpp"
#include "src/solution/interface_points.hpp"

namespace abut {

namespace {

/// Rotations and strains beyond which linear kinematics and elasticity are in doubt: a warning.
constexpr double large_rotation = 0.05, large_strain = 0.05;
constexpr double large_motion = 0.05;  // of the part's size
constexpr double small_region = 0.01;  // of the part's size, around a singular place
/// Tension of a bonded pair, over its largest traction, that is more than the fit of the spline.
constexpr double noted_tension = 1e-3;
constexpr double rounded_tension = 1e-9;  // of the largest pressure of all
constexpr double noted_bond_gap = 1e-6;   // of its length
/// Rounding times condition number that counts: the error of the worst displacement field, seldom that of the loads' own.
constexpr double noted_rounding = 1e-3;

struct PlacedValue {
    double value = 0;
    Vec2 at{0, 0};  // in the part's frame

    void take(double other, const Vec2& x) {
        if (other <= value) return;
        value = other;
        at = x;
    }
};
struct LargestChange {
    PlacedValue rotation, strain;
};

/// Where a part is looked at: all along its boundary, in its cut cells, and in the middle of the others.
std::vector<std::pair<int, Vec2>> places_of(const PartOnGrid& g) {
    std::vector<std::pair<int, Vec2>> places = cut_cell_samples(g);
    for (std::size_t c = 0; c < g.cells.cell_class.size(); ++c) {
        if (g.cells.cell_class[c] != geometry::CellClass::inner) continue;
        const int cell = static_cast<int>(c);
        places.emplace_back(cell, g.cells.grid.box(cell).center());
    }
    for (std::size_t k = 0; k < g.cells.pieces.size(); ++k) {
        const geometry::BoundaryPiece& piece = g.cells.pieces[k];
        if (g.elements.of_piece[k] < 0) continue;
        const geometry::Curve& curve = g.local.edges[at(piece.edge)].curve;
        for (double t : {piece.t0, 0.5 * (piece.t0 + piece.t1)}) places.emplace_back(g.elements.of_piece[k], point(curve, t));
    }
    return places;
}

/// Where the stress has no limit both pass any bound in some small region, which changes nothing beyond it.
LargestChange largest_change(const PartOnGrid& g, const Eigen::VectorXd& displacement,
                             const std::vector<SingularPlace>& singular) {
    LargestChange largest;
    for (const auto& [element, x] : places_of(g)) {
        const Vec2 place = g.frame.to_global(x);
        if (std::any_of(singular.begin(), singular.end(),
                        [&](const SingularPlace& s) { return (s.at - place).norm() < small_region * g.size; }))
            continue;
        const auto u = solver::displacement_at(g.input, displacement, element, x);
        largest.rotation.take(0.5 * std::abs(u.gradient(1, 0) - u.gradient(0, 1)), x);
        const double hoop = g.input.axis ? solver::hoop_strain(g.input, x, u) : 0.0;
        largest.strain.take(std::hypot((0.5 * (u.gradient + u.gradient.transpose())).norm(), hoop), x);
    }
    return largest;
}

/// What would treat it is an effect of the plan that is off: there is no key for it.
void check_kinematics(const Scene& scene, const ResolvedConditions& conditions, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> motions, rotations, strains;
    const double size = model_size(result);
    for (std::size_t k = 0; k < solved.grids.size(); ++k) {
        const PartOnGrid& g = solved.grids[k];
        const Eigen::VectorXd &moved = solved.solution.displacement[k], &free = solved.problem.parts[k].input.stress_free;
        const auto& [rotation, strain] = largest_change(g, free.size() > 0 ? Eigen::VectorXd(moved - free) : moved,
                                                        singular_places(scene, conditions, solved, g.part));
        const std::string& name = scene.parts[at(g.part)].name;
        const ValueAt& motion = result.parts[at(g.part)].max_displacement;
        const double degrees = rotation.value * 180 / std::numbers::pi;
        if (motion.value > large_motion * g.size)
            motions.push_back({motion.value / g.size, name,
                               "large displacement would matter: part " + name + " moves by " + number_text(motion.value, 3) +
                                   " at " + place_text(motion.at, size) + "; contacts are paired where they are drawn",
                               name + " moves by " + percent_text(motion.value / g.size) + " of its size"});
        if (rotation.value > large_rotation)
            rotations.push_back({rotation.value, name,
                                 "large displacement would matter: rotation " + number_text(degrees, 3) + " degrees at part " +
                                     name + ", near " + place_text(g.frame.to_global(rotation.at), size) +
                                     "; the answer is that of small displacements",
                                 name + " turns by " + number_text(degrees, 2) + " degrees"});
        if (strain.value > large_strain)
            strains.push_back({strain.value, name,
                               "large strain: part " + name + " strains by up to " + number_text(100 * strain.value, 3) +
                                   " % near " + place_text(g.frame.to_global(strain.at), size) +
                                   "; the answer is that of linear elasticity",
                               name + " strains by " + percent_text(strain.value)});
    }
    tell(std::move(motions), "displacement", result);
    tell(std::move(rotations), "rotation", result);
    tell(std::move(strains), "strain", result);
}

void check_yield(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    const std::string stress = result_units(result).stress;
    const double size = model_size(result);
    for (const PartOnGrid& g : solved.grids) {
        const ScenePart& part = scene.parts[at(g.part)];
        const Material& material = scene.materials[at(part.material)];
        const ValueAt& reached = result.parts[at(g.part)].max_von_mises;
        if (!material.yield || !(reached.value > *material.yield)) continue;
        const std::string times = number_text(reached.value / *material.yield, 3) + " times ";
        findings.push_back({reached.value / *material.yield, part.name,
                            "yield exceeded: part " + part.name + " reaches a von Mises stress of " +
                                with_unit(reached.value, 4, stress) + " at " + place_text(reached.at, size) + ", " + times +
                                "the yield of " + material.name + " (" + with_unit(*material.yield, 4, stress) +
                                "); the answer is that of linear elasticity, without plasticity",
                            part.name + " at " + times + "its yield"});
    }
    tell(std::move(findings), "yield", result);
}

/// Bonded pairs that would open if they were contacts.
void check_bonds(const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    const auto largest = [](const ContactResult& c) {
        double most = 0;
        for (double v : c.profile.pressure) most = std::max(most, std::abs(v));
        return most;
    };
    double of_all = 0;
    for (const ContactResult& c : result.contacts) of_all = std::max(of_all, largest(c));
    for (std::size_t i = 0; i < result.contacts.size(); ++i) {
        const ContactResult& c = result.contacts[i];
        if (c.kind != "bonded" || carries_nothing(solved, i)) continue;
        const std::vector<double>& p = c.profile.pressure;
        const auto least = std::min_element(p.begin(), p.end());
        if (p.empty() || *least >= -std::max(noted_tension * largest(c), rounded_tension * of_all)) continue;
        const auto k = static_cast<std::size_t>(least - p.begin());
        const std::string pair = c.between[0] + " and " + c.between[1];
        findings.push_back({-*least, pair,
                            "bonded pair in tension: " + pair + " are pulled apart with up to " + number_text(-*least, 4) +
                                " at " + place_text({c.profile.x[k], c.profile.y[k]}, model_size(result)) +
                                "; a contact (kind \"contact\" in contacts.pairs) would open there"});
    }
    remark(std::move(findings), result);
}

/// A plane model spreads what a thin part presses a thick one with over the whole thickness of that, which yields less for it:
/// between half planes pressures grow with the root of what is left of their compliance.
void check_thickness(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const solver::Interface& face = solved.contacts[k].face;
        if (k >= solved.stretches.size() || solved.stretches[k].empty()) continue;
        const PartOnGrid *thin = &solved.grids[at(face.part[0])], *thick = &solved.grids[at(face.part[1])];
        if (thin->input.thickness > thick->input.thickness) std::swap(thin, thick);
        const double ratio = thick->input.thickness / thin->input.thickness;
        if (ratio == 1 || thick->is_rigid || face.bilateral) continue;
        const std::string& name = scene.parts[at(thick->part)].name;
        const double c1 = compliance(scene, *thin), c2 = compliance(scene, *thick);
        const double too_high = std::sqrt((c1 + c2) / (c1 + c2 / ratio)) - 1;
        findings.push_back({ratio, "contact " + contact_number(k),
                            "contact " + contact_number(k) + " presses part " + name + " over " +
                                number_text(thin->input.thickness, 3) + " of its thickness of " +
                                number_text(thick->input.thickness, 3) + ": beside it the stress of " + name +
                                " is an average, and up to " + number_text(ratio, 2) +
                                " times as large where it is pressed; where the contact is short beside that thickness its "
                                "largest pressure comes out too high, and its length too short, by up to " +
                                percent_text(too_high)});
    }
    remark(std::move(findings), result);
}

/// Parts whose contact reaches the end of what was searched: "a and b".
std::string pairs_beyond_search(const Scene& scene, const SolvedAssembly& s) {
    std::string names;
    for (std::size_t k = 0; k < s.stretches.size(); ++k) {
        const geometry::FacingZone& zone = s.contacts[k].zone;
        const auto ends_there = [&](const PressedStretch& stretch) {
            return (stretch.from_start && zone.begin_is_limit) || (stretch.to_end && zone.end_is_limit);
        };
        if (s.contacts[k].face.bilateral || std::none_of(s.stretches[k].begin(), s.stretches[k].end(), ends_there)) continue;
        const auto& [a, b] = s.contacts[k].part;
        names += (names.empty() ? ": " : ", ") + scene.parts[at(a)].name + " and " + scene.parts[at(b)].name;
    }
    return names;
}

/// Supports by weight functions do without the projection that nearly incompressible parts need: their stresses of degree 2 are
/// 4 % off at nu = 0.49 and as large as themselves at 0.4999 (the thick ring E10, eight cells across).
void warn_of_locking(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    std::vector<Finding> findings;
    for (const PartOnGrid& g : solved.grids) {
        const ScenePart& part = scene.parts[at(g.part)];
        const Material& material = scene.materials[at(part.material)];
        if (!g.is_rigid && !g.input.is_projected && is_nearly_incompressible(scene, material))
            findings.push_back(
                {material.nu, part.name,
                 "part " + part.name + " is nearly incompressible (nu = " + number_text(material.nu, 6) +
                     ") and held by a solution structure: its stresses converge slowly; take dirichlet \"nitsche\""});
    }
    remark(std::move(findings), result);
}

/// More than this out of balance is the rounding of a badly conditioned system.
constexpr double noted_imbalance = 1e-6;

/// The widest gap of bonded faces, where it is more than what drawings round.
double widest_bond(const Result& result) {
    double widest = 0;
    for (const ContactResult& c : result.contacts)
        if (c.kind == "bonded" && c.gap_max > noted_bond_gap * c.contact_length) widest = std::max(widest, c.gap_max);
    return widest;
}

void check_balance(Result& result) {
    const double off = std::max(result.equilibrium.relative_residual, result.equilibrium.relative_moment_residual);
    if (off <= noted_imbalance || result.status == "failed") return;  // what failed is not balanced, for other reasons
    const std::string text = "forces and moments balance only to " + number_text(off, 2) + " of the largest";
    const double gap = widest_bond(result);
    const std::string why = gap > 0 ? ": faces are bonded that are drawn up to " + with_unit(gap, 3, result.length_unit) +
                                          " apart, across which their shear has a moment; draw them touching"
                                    : ": rounding, of cells that are tiny beside their part";
    tell({{off, "", text + why, text}}, "balance", result);
}

/// Below the error aimed at rounding is none that matters.
void check_rounding(double target, Result& result) {
    const double rounding = std::min(1.0, std::numeric_limits<double>::epsilon() * result.solver.condition_estimate);
    if (rounding <= noted_rounding) return;
    const std::string words = "rounding may change this answer by up to " + number_text(100 * rounding, 1) + " %";
    tell({{0, "",
           words + " (condition number " + number_text(result.solver.condition_estimate, 2) +
               "): a part is very slender, or runs out in a very sharp tip",
           rounding > target ? words : ""}},
         "rounding", result);
}

/// Steps that let go give loads that are none on purpose.
void note_zero_loads(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    if (scene.in_steps || scene.loads.empty() || solved.problem.load_scale > 0 || !solved.preloads.empty()) return;
    result.notes.push_back(scene.loads.size() == 1 ? "the load is zero wherever it acts: it drives nothing"
                                                   : "all loads are zero wherever they act: they drive nothing");
}

void check_grids(const Scene& scene, const Outcome& out, Result& result) {
    if (out.solved.grids.empty())
        tell({{0, "", "nothing acts on any part: there is nothing to solve", "nothing acts on any part"}}, "idle", result);
    if (const std::string left_out = left_out_text(left_out_parts(result)); !left_out.empty())
        result.warnings.push_back(left_out);
    if (out.search_too_short)
        tell({{0, "",
               "contact reaches the end of what was searched" + pairs_beyond_search(scene, out.solved) + "; give " +
                   (is_by_dissertation(scene) ? "accuracy.cell_size" : "contacts.search_distance") + " a larger value",
               "contact reaches the end of what was searched"}},
             "search", result);
    if (out.solved.limited_grids > 0)
        result.warnings.push_back("grids of " + std::to_string(out.solved.limited_grids) +
                                  " part(s) are coarser than the contacts ask for, to bound the number of cells; more memory, "
                                  "asked for as the budget (--budget 16GB), allows more");
    if (out.solved.refined_for_walls > 0)
        result.warnings.push_back("grids of " + std::to_string(out.solved.refined_for_walls) +
                                  " part(s) were refined because a wall was thinner than a cell");
}

/// What a user did not ask for, or may expect, of parts that are rigid.
void warn_of_rigid_parts(const Scene& scene, const SolvedAssembly& solved, Result& result) {
    const bool has_weights = std::any_of(scene.loads.begin(), scene.loads.end(), [](const Load& l) {
        return l.kind == Load::Kind::gravity || l.kind == Load::Kind::spin;
    });
    std::vector<Finding> stiff, weightless;
    for (const PartOnGrid& g : solved.grids) {
        if (!g.is_rigid) continue;
        const ScenePart& part = scene.parts[at(g.part)];
        const bool is_asked_for = scene.materials[at(part.material)].rigid;
        if (!is_asked_for)
            stiff.push_back(
                {0, part.name,
                 "part " + part.name + " is computed as a rigid body (" + why_rigid(scene, g.part) + "): it has no stress"});
        if (is_asked_for && has_weights)
            weightless.push_back(
                {0, part.name,
                 "part " + part.name + " is rigid and weightless, gravity and spin do nothing to it: give it a force"});
    }
    remark(std::move(stiff), result);
    remark(std::move(weightless), result);
}

}  // namespace

void warn_of_unused_rules(const Scene& scene, const Outcome& out, Result& result) {
    const PairRules rules(scene);
    std::vector<Finding> apart, overruled;
    const auto name = [](int r) { return "contacts.pairs " + std::to_string(r); };
    for (int r = 0; r < static_cast<int>(scene.contacts.pairs.size()); ++r) {
        if (scene.contacts.pairs[at(r)].kind == PairRule::Kind::ignore ||
            std::any_of(out.candidates.begin(), out.candidates.end(), [&](const Candidate& c) { return c.rule == r; }))
            continue;
        const int later = rules.later_than(r);
        (later < 0 ? apart : overruled)
            .push_back({0, name(r),
                        name(r) + " has no effect: " +
                            (later < 0 ? (own_part(scene.contacts.pairs[at(r)]) < 0
                                              ? "these edges face each other nowhere within the search distance"
                                              : "these faces of one part are not brought together")
                                       : name(later) + ", which comes later, speaks of these edges, too")});
    }
    remark(std::move(apart), result);
    remark(std::move(overruled), result);
}

void check_assumptions(const Scene& scene, const ResolvedConditions& conditions, const Outcome& out, Result& result) {
    check_kinematics(scene, conditions, out.solved, result);
    check_yield(scene, out.solved, result);
    check_bonds(out.solved, result);
    note_zero_loads(scene, out.solved, result);
    check_thickness(scene, out.solved, result);
    warn_of_unused_rules(scene, out, result);
    check_grids(scene, out, result);
    check_rounding(out.target, result);
    check_balance(result);
    warn_of_locking(scene, out.solved, result);
    warn_of_rigid_parts(scene, out.solved, result);
}

}  // namespace abut
