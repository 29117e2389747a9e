// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parts/part_system.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "solver/parts/free_motions.hpp"
#include "solver/parts/hold_axis.hpp"
#include "solver/parts/on_springs.hpp"
#include "solver/parts/pins.hpp"
#include "solver/parts/row_hints.hpp"
#include "solver/parts/structure_reactions.hpp"
#include "solver/terms/dilatation.hpp"
#include "solver/terms/free_strain.hpp"
#include "solver/terms/stress.hpp"
#include "src/base/ensure.hpp"

namespace abut::solver {

namespace {

using Eigen::Index;

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Drops the functions of an aligned set. What stands against it: the basis, an earlier set with another value, or a weight.
/// Empty: done.
std::string drop_aligned(PartSystem& s, SupportRecord& record) {
    const auto component = static_cast<std::size_t>(record.set.component);
    if (s.input.structure && s.input.structure->weight[component]) return "another support weights this displacement component";
    const auto functions = functions_on_side(s.input.space, *record.set.side, record.set.stretches);
    if (!functions) return "dropping functions there would hold more than this edge";
    const auto prescribed = [&](int f) { return coefficient_of_one(s.input.space, f) * record.set.value; };
    const auto dof = [&](int f) { return static_cast<std::size_t>(2 * f + record.set.component); };
    for (int f : *functions)
        if (s.dropped[dof(f)] && s.prescribed[static_cast<Index>(dof(f))] != prescribed(f))
            return "an adjacent support prescribes another value";
    for (int f : *functions) {
        if (s.dropped[dof(f)]) continue;
        s.dropped[dof(f)] = 1;
        s.prescribed[static_cast<Index>(dof(f))] = prescribed(f);
        record.dropped.push_back(f);
    }
    return "";
}

void apply_support(PartSystem& s, SupportRecord& record) {
    if (record.set.by_structure) {
        record.method = SupportMethod::structure;
        record.why = record.set.note;
        return;
    }
    record.why = record.set.note.empty() ? "does not lie along the grid's outermost lines" : record.set.note;
    if (record.set.side) {
        record.why = drop_aligned(s, record);
        if (record.why.empty()) {
            record.method = SupportMethod::aligned;
            record.why = "lies along the grid's outermost lines: exact and free";
            return;
        }
    }
    record.method = SupportMethod::nitsche;
    add_nitsche(s.input, record.set, s.stiffness, s.held_load);
}

void apply_supports(PartSystem& s, std::vector<SupportSet> sets) {
    for (SupportSet& set : sets) {
        s.supports.push_back({std::move(set), SupportMethod::nitsche, {}, {}});
        apply_support(s, s.supports.back());
    }
    if (s.springs.empty()) return;
    const auto begin = std::chrono::steady_clock::now();
    for (const SpringSet& set : s.springs) add_springs(s.input, set, s.stiffness, s.held_load);
    s.seconds.springs = seconds_since(begin);
}

/// soft: motions that are held like free ones.
void number_unknowns(PartSystem& s, const Eigen::MatrixXd& soft) {
    Eigen::MatrixXd held(s.modes.rows(), s.modes.cols() + soft.cols());
    held << s.modes, soft;
    const std::vector<Index> pinned = pins(s, held);
    s.number.assign(s.dropped.size(), -1);
    for (std::size_t i = 0; i < s.dropped.size(); ++i) {
        const bool is_pin = std::find(pinned.begin(), pinned.end(), static_cast<Index>(i)) != pinned.end();
        if (!s.dropped[i] && !is_pin) s.number[i] = s.n_kept++;
    }
}

/// The weighted functions of a component hold none of its rigid motions: a motion that is free must not move it. False where
/// one does.
bool follow_structure(PartSystem& s, double size) {
    constexpr double rounding = 1e-6;  // of unit motion: what the eigenvectors of the Gram matrix leave
    for (RigidMotion& m : s.free_motions)
        for (int c = 0; c < 2; ++c) {
            if (!s.input.structure->weight[static_cast<std::size_t>(c)]) continue;
            if (std::abs(m.translation[c]) > rounding || std::abs(m.rotation) * size > rounding) return false;
            m.translation[c] = m.rotation = 0;
        }
    return true;
}

/// The stiffness before any support but the structure.
void assemble(PartSystem& s) {
    if (s.input.structure) {
        WeightedStiffness k = assemble_weighted(s.input);
        s.stiffness = std::move(k.stiffness);
        s.held_load = std::move(k.load);
    } else {
        s.stiffness = assemble_stiffness(s.input);
        s.held_load = Eigen::VectorXd::Zero(2 * s.n());
    }
    if (s.input.free_strain) s.held_load += free_strain_load(s.input);
    ENSURE(s.input.pulls.empty() || !(s.input.structure || s.input.is_projected), "pulls have the plain stiffness");
    for (const Eigen::VectorXd& pull : s.input.pulls) s.pulls.push_back(make_pull(s.stiffness, pull));
}

void set_loads(PartSystem& s, Eigen::VectorXd applied, const Eigen::VectorXd& weighted) {
    ENSURE(applied.size() == 2 * s.n(), "a load has two numbers for every function");
    s.applied = std::move(applied);
    s.load = (s.input.structure ? weighted : s.applied) + s.held_load;
}

/// Coefficients of motions that no dropped function takes part in.
Eigen::MatrixXd beside_dropped(const PartSystem& s, Eigen::MatrixXd motions) {
    for (std::size_t i = 0; i < s.dropped.size(); ++i)
        if (s.dropped[i]) motions.row(static_cast<Index>(i)).setZero();
    return motions;
}

/// The projection of the volume strain, which Nitsche's supports have a share in.
void project_dilatation(PartSystem& s) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<const SupportSet*> by_nitsche;
    for (const SupportRecord& record : s.supports)
        if (record.method == SupportMethod::nitsche) by_nitsche.push_back(&record.set);
    s.input.dilatation = make_dilatation(s.input, by_nitsche);
    s.failure = s.input.dilatation->failure;
    if (s.failure.empty()) s.held_load += volume_load(*s.input.dilatation);
    s.seconds.dilatation = seconds_since(begin);
}

Factorization factorized(const PartSystem& s) {
    SparseSymmetric a = restricted(s.stiffness, s.number, s.n_kept);
    if (!s.input.is_projected) return Factorization(std::move(a), row_hints(s.input, s.number), s.input.threads);
    return Factorization(with_pressures(a, *s.input.dilatation, s.number), s.input.dilatation->space.n_functions);
}

/// What a pivot that is not positive means here, and what to do about it.
std::string failure_text(const PartSystem& s) {
    const std::string text = "the stiffness matrix is not positive definite to working precision: ";
    if (s.input.structure && s.springs.empty())
        return text +
               "the weight functions of its supports leave too little there; take dirichlet \"nitsche\", or smaller cells";
    if (s.input.structure)
        return text + "its springs are too soft against its material to hold it; make them stiffer, or add a support";
    if (s.input.space.basis != Basis::web)
        return text + "functions of the basis hardly reach into the part there; take basis \"web\", or move the grid lines";
    return text +
           "part of it hangs on too little there to carry anything, or it is so slender (some 1000 times as long as thick) "
           "that no "
           "digits are left; look for a stray sliver, or refine the grid";
}

void note_failure(PartSystem& s) {
    s.failure = failure_text(s);
    for (std::size_t i = 0; i < s.number.size(); ++i)
        if (s.number[i] >= 0 && s.number[i] == s.factor.failed_at()) {
            const auto dof = static_cast<int>(i);
            s.failed_at = FailedPivot{greville_point(s.input.space, dof / 2), dof % 2};
        }
}

void ensure_rules(const PartInput& input) {
    for (const CellRule& rule : input.cut_rules) {
        ENSURE(rule.element >= 0 && static_cast<std::size_t>(rule.element) < input.space.fraction.size(),
               "a quadrature rule is of an element of the space");
        ENSURE(rule.points.size() == rule.weights.size(), "every point of a quadrature rule has a weight");
        ENSURE(std::all_of(rule.weights.begin(), rule.weights.end(), [](double w) { return std::isfinite(w); }),
               "weights of quadrature are numbers");
    }
}

}  // namespace

void set_shortening(PartSystem& system, const Eigen::VectorXd& shortening) {
    ENSURE(shortening.size() == static_cast<Index>(system.pulls.size()), "every pull is shortened by something");
    system.input.stress_free = Eigen::VectorXd::Zero(system.pulls.empty() ? 0 : 2 * system.n());
    for (std::size_t k = 0; k < system.pulls.size(); ++k) {
        Pull& pull = system.pulls[k];
        const double change = shortening[static_cast<Index>(k)] - pull.shortening;
        pull.shortening += change;
        system.held_load += change * pull.load;
        system.load += change * pull.load;
        system.input.stress_free += pull.shortening * pull.displacement;
    }
}

Eigen::VectorXd coefficients_of(const SplineSpace& space, const RigidMotion& motion) {
    Eigen::VectorXd c(2 * space.n_functions);
    for (int f = 0; f < space.n_functions; ++f)
        c.segment<2>(2 * f) = coefficient_of_one(space, f) * motion.at(greville_point(space, f));
    return c;
}

Eigen::MatrixXd coefficients_of(const SplineSpace& space, const std::vector<RigidMotion>& motions) {
    Eigen::MatrixXd modes(2 * space.n_functions, static_cast<Index>(motions.size()));
    for (std::size_t k = 0; k < motions.size(); ++k) modes.col(static_cast<Index>(k)) = coefficients_of(space, motions[k]);
    return modes;
}

PartSystem make_part_system(PartInput input, std::vector<SupportSet> supports, Eigen::VectorXd applied, const Vec2& center,
                            double size, std::vector<SpringSet> springs, const Eigen::VectorXd& weighted) {
    const auto begin = std::chrono::steady_clock::now();
    ensure_rules(input);
    PartSystem s;
    s.input = std::move(input);
    s.springs = std::move(springs);
    if (s.input.structure && s.input.is_projected) {
        s.failure = "supports by weight functions do not go with a nearly incompressible material; take dirichlet \"nitsche\"";
        return s;
    }
    if (s.input.structure && (s.input.free_strain || s.input.axis)) {
        s.failure = std::string("supports by weight functions do not go with ") +
                    (s.input.axis ? "an axisymmetric analysis" : "a temperature") + "; take dirichlet \"nitsche\"";
        return s;
    }
    assemble(s);
    s.dropped.assign(static_cast<std::size_t>(2 * s.n()), 0);
    s.prescribed = Eigen::VectorXd::Zero(2 * s.n());
    apply_supports(s, std::move(supports));
    if (s.input.is_projected) project_dilatation(s);
    set_loads(s, std::move(applied), weighted);
    if (s.input.touches_axis) hold_axis(s);
    if (!s.failure.empty()) return s;
    UnheldMotions unheld = unheld_motions(s, center, size);
    s.free_motions = std::move(unheld.free);
    if (s.input.structure && !follow_structure(s, size)) {
        s.failure =
            "its supports leave it a rigid motion that weight functions cannot follow (one point, or one straight edge held "
            "along itself); hold points that leave it no motion, or edges in place of points, with dirichlet \"nitsche\"";
        return s;
    }
    s.modes = beside_dropped(s, coefficients_of(s.input.space, s.free_motions));
    if (s.input.structure) unheld.on_springs.clear();  // they are no motions of weighted functions
    const Eigen::MatrixXd soft = beside_dropped(s, soft_motions(s, unheld.on_springs));
    number_unknowns(s, soft);
    const double before = seconds_since(begin);
    s.factor = factorized(s);
    s.seconds.all = seconds_since(begin);
    s.seconds.factorisation = s.seconds.all - before;
    if (!s.factor.ok())
        note_failure(s);
    else if (soft.cols() > 0)
        s.sprung = sprung_motions(s, soft);
    else if (s.input.structure && !s.springs.empty() && condition_estimate(s) > largest_spring_condition)
        s.failure = failure_text(s);
    return s;
}

PartSystem with_loads(const PartSystem& system, Eigen::VectorXd applied, const Eigen::VectorXd& weighted) {
    PartSystem s = system;
    set_loads(s, std::move(applied), weighted);
    return s;
}

Eigen::VectorXd stiffness_times(const PartSystem& system, const Eigen::VectorXd& displacement) {
    if (system.body) return Eigen::VectorXd::Zero(displacement.size());
    Eigen::VectorXd forces = multiply(system.stiffness, displacement);
    if (system.input.is_projected) forces += volume_forces(*system.input.dilatation, displacement);
    return forces;
}

Eigen::VectorXd load_beside_prescribed(const PartSystem& system, const Eigen::VectorXd& load) {
    ENSURE(load.size() == 2 * system.n(), "a load has two numbers for every function");
    if (system.body || system.prescribed.isZero(0)) return load;
    return load - stiffness_times(system, system.prescribed);
}

Eigen::VectorXd kept_entries(const PartSystem& system, const Eigen::VectorXd& load) {
    Eigen::VectorXd b(system.n_kept);
    for (std::size_t i = 0; i < system.number.size(); ++i)
        if (system.number[i] >= 0) b[system.number[i]] = load[static_cast<Index>(i)];
    return b;
}

Eigen::VectorXd solve(const PartSystem& system, const Eigen::VectorXd& load) {
    return system.prescribed + response(system, load_beside_prescribed(system, load));
}

Eigen::VectorXd response(const PartSystem& system, const Eigen::VectorXd& load) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(load.size());
    if (load.size() == 0) return u;
    if (!system.body) {
        const Eigen::VectorXd x = system.factor.solve(kept_entries(system, load));
        for (std::size_t i = 0; i < system.number.size(); ++i)
            if (system.number[i] >= 0) u[static_cast<Index>(i)] = x[system.number[i]];
    }
    if (system.sprung.cols() > 0) u += system.sprung * (system.sprung.transpose() * load);
    return u;
}

namespace {

double new_condition_estimate(const PartSystem& system) {
    if (system.input.is_projected) return system.factor.condition_estimate();
    return system.factor.condition_estimate([&](const Eigen::VectorXd& x) {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(2 * system.n());
        for (std::size_t i = 0; i < system.number.size(); ++i)
            if (system.number[i] >= 0) all[static_cast<Index>(i)] = x[system.number[i]];
        const Eigen::VectorXd product = multiply(system.stiffness, all);
        Eigen::VectorXd kept(system.n_kept);
        for (std::size_t i = 0; i < system.number.size(); ++i)
            if (system.number[i] >= 0) kept[system.number[i]] = product[static_cast<Index>(i)];
        return kept;
    });
}

}  // namespace

double condition_estimate(const PartSystem& system) {
    if (system.body || !system.factor.ok()) return 1;
    return system.condition([&] { return new_condition_estimate(system); });
}

namespace {

Resultant dropped_reaction(const PartSystem& system, const SupportRecord& record, const Eigen::VectorXd& residual) {
    Resultant sum;
    for (int f : record.dropped) {
        Vec2 force = Vec2::Zero();
        force[record.set.component] = residual[2 * f + record.set.component];
        sum.add(greville_point(system.input.space, f), coefficient_of_one(system.input.space, f) * force);
    }
    return sum;
}

}  // namespace

std::vector<Resultant> support_reactions(const PartSystem& system, const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& load, const Eigen::VectorXd& plain) {
    ENSURE(displacement.size() == 2 * system.n() && load.size() == 2 * system.n(),
           "displacements and loads have two numbers for every function");
    const Eigen::VectorXd residual = stiffness_times(system, displacement) - load;
    std::vector<Resultant> reactions;
    for (const SupportRecord& record : system.supports)
        reactions.push_back(record.method == SupportMethod::nitsche ? nitsche_reaction(system.input, record.set, displacement)
                                                                    : dropped_reaction(system, record, residual));
    if (system.input.structure) add_structure_reactions(system, displacement, plain, reactions);
    return reactions;
}

Resultant traction_resultant(const PartInput& input, const SupportSet& set, const Eigen::VectorXd& displacement) {
    const StressOf stress(input, displacement);
    Resultant sum;
    for (const SupportPoint& p : set.points) {
        const Eigen::Vector3d s = stress(p.element, p.x);
        const Vec2 traction(s[0] * p.normal.x() + s[2] * p.normal.y(), s[2] * p.normal.x() + s[1] * p.normal.y());
        sum.add(p.x, p.weight * input.thickness * p.direction.dot(traction) * p.direction);
    }
    return sum;
}

Resultant resultant_of(const SplineSpace& space, const Eigen::VectorXd& load) {
    Resultant sum;
    for (int f = 0; f < space.n_functions; ++f)
        sum.add(greville_point(space, f), coefficient_of_one(space, f) * load.segment<2>(2 * f));
    return sum;
}

double virial_of(const SplineSpace& space, const Eigen::VectorXd& load, const Vec2& center) {
    Eigen::VectorXd aside = load;  // turned left: its moment is the sum
    for (Index f = 0; f + 1 < aside.size(); f += 2) aside.segment<2>(f) = Vec2(-load[f + 1], load[f]);
    const Resultant turned = resultant_of(space, aside);
    return turned.moment - (center.x() * turned.force.y() - center.y() * turned.force.x());
}

double strain_energy(const PartSystem& system, const Eigen::VectorXd& total) {
    if (system.body) return 0;
    const Eigen::VectorXd elastic = elastic_displacement(system.input, total);
    const Eigen::VectorXd& displacement = elastic.size() > 0 ? elastic : total;
    if (system.input.structure) return weighted_strain_energy(system.input, displacement);
    if (system.input.free_strain || system.input.axis ||
        system.sprung.cols() > 0)  // else K's rounding in what springs give way by
        return elastic_energy(system.input, displacement) +
               (system.input.is_projected ? volume_energy(*system.input.dilatation, displacement) : 0);
    double twice = displacement.dot(multiply(system.stiffness, displacement));
    for (const SpringSet& set : system.springs) twice -= 2 * spring_answer(system.input, set, displacement).energy;
    for (const SupportRecord& record : system.supports)
        if (record.method == SupportMethod::nitsche) twice -= nitsche_energy(system.input, record.set, displacement);
    const double of_volume = system.input.is_projected ? volume_energy(*system.input.dilatation, displacement) : 0;
    return 0.5 * twice + of_volume;
}

double largest_displacement(const PartInput& input, const Eigen::VectorXd& displacement) {
    if (input.structure) return largest_weighted_displacement(input, displacement);
    double largest = 0;
    for (Index f = 0; f + 1 < displacement.size(); f += 2) largest = std::max(largest, displacement.segment<2>(f).norm());
    return largest;
}

}  // namespace abut::solver
